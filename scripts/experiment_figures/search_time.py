# SPDX-License-Identifier: BSD-3-Clause
"""Travel time against search time."""
import pathlib
import statistics

import matplotlib.ticker

from . import style
from .style import error_bars, name_of, plt, save, spread_label, world_name
from .tables import mean_and_error, read_results, read_settings


def label_of(settings, path):
    """What limits the search of a results file, of its settings."""
    if settings["max_trials"] > 0:
        return f"{settings['max_trials']:g} trials"
    if settings["search_time"] > 0:
        return f"{1e3 * settings['search_time']:g} ms"
    return pathlib.Path(path).stem


def plot_search_time(options):
    series = {}  # (world, people, planner): [(search time, travel time, error, label)]
    for path in options.files:
        label = label_of(read_settings(path), path)
        cells = {}
        for row in read_results([path]):
            key = (row["world"], int(row["pedestrians"]), row["planner"])
            cells.setdefault(key, []).append((row["mean_search_time_s"], row["travel_time_s"]))
        for key, values in cells.items():
            search = 1e3 * statistics.mean(value[0] for value in values)
            series.setdefault(key, []).append(
                (search, *mean_and_error([value[1] for value in values]), label))
    figure, axes = plt.subplots(figsize=(4.8, 3.3), constrained_layout=True)
    for k, ((world, people, planner), points) in enumerate(series.items()):
        points.sort()
        search, travel, errors, labels = zip(*points)
        axes.errorbar(search, travel, yerr=error_bars(errors),
                      color=style.COLOURS[k % len(style.COLOURS)],
                      marker=style.MARKERS[k % len(style.MARKERS)], markersize=5,
                      markeredgecolor=style.INK,
                      markeredgewidth=0.5, linewidth=1.2, capsize=2.5,
                      label=f"{name_of(planner)}, {world_name(world)}, {people} people")
        if k == 0:  # what limits the search
            for x, _, _, label in points:
                axes.annotate(label, (x, 0.02), xytext=(-2, 0), textcoords="offset points",
                              xycoords=axes.get_xaxis_transform(), rotation=90, fontsize=7,
                              ha="right", va="bottom", color=style.INK)
    axes.set_xscale("log")
    axes.margins(x=0.1, y=0.12)
    ticks = matplotlib.ticker.LogLocator(subs=(1.0, 2.0, 5.0))
    axes.xaxis.set_major_locator(ticks)
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    axes.set_xlabel("search for a decision, mean [ms]")
    spread = spread_label([error for points in series.values() for _, _, error, _ in points],
                          "one run")
    axes.set_ylabel(f"travel time [s]\n{spread}")
    axes.grid(True, color="#dddddd", linewidth=0.6)
    figure.legend(ncol=1 if len(series) < 3 else 2, **style.ABOVE)
    save(figure, options.output)
