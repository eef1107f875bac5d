# SPDX-License-Identifier: BSD-3-Clause
"""By how much trips are shorter than those of a baseline."""
from command_line.refusal import Refusal

from . import style
from .style import error_bars, name_of, plt, save, spread_label, world_name
from .tables import in_order, mean_and_error, read_results


def plot_reduction(options):
    rows = read_results(options.files)
    times = {}
    for row in rows:
        key = (row["file"], row["world"], int(row["pedestrians"]), row["planner"])
        times.setdefault(key, {})[row["seed"]] = row["travel_time_s"]
    cells = {}  # (world, planner, people): shares saved, in pairs
    for (file, world, people, planner), own in times.items():
        base = times.get((file, world, people, options.baseline), {})
        if planner == options.baseline:
            continue
        saved = [100.0 * (1.0 - own[seed] / base[seed]) for seed in own if base.get(seed, 0) > 0]
        if saved:
            cells.setdefault((world, planner, people), []).extend(saved)
    if not cells:
        raise Refusal(f"{options.files[0]}: no pairs with the baseline '{options.baseline}'")
    worlds = in_order(key[0] for key in cells)
    planners = in_order(key[1] for key in cells)
    crowds = sorted({key[2] for key in cells})
    figure, panels = plt.subplots(1, len(worlds), squeeze=False, sharey=True,
                                  constrained_layout=True,
                                  figsize=(max(3.4, 2.3 * len(worlds) + 0.5), 2.6))
    summaries = {key: mean_and_error(saved) for key, saved in cells.items()}
    width = 0.8 / len(planners)
    for axes, world in zip(panels[0], worlds):
        for k, planner in enumerate(planners):
            shown = [i for i, people in enumerate(crowds) if (world, planner, people) in summaries]
            if not shown:
                continue
            summary = [summaries[world, planner, crowds[i]] for i in shown]
            places = [i + (k - 0.5 * (len(planners) - 1)) * width for i in shown]
            axes.bar(places, [mean for mean, _ in summary], width * 0.94,
                     yerr=error_bars([error for _, error in summary]), color=style.COLOURS[k],
                     hatch=style.HATCHES[k],
                     edgecolor=style.INK, linewidth=0.6,
                     error_kw={"elinewidth": 0.9, "capsize": 2.0},
                     label=name_of(planner))
        axes.axhline(0.0, color=style.INK, linewidth=0.7)
        axes.set_title(world_name(world))
        axes.set_xticks(range(len(crowds)))
        axes.set_xticklabels([str(people) for people in crowds])
        axes.set_xlabel("people")
        axes.yaxis.grid(True, color="#dddddd", linewidth=0.6)
        axes.set_axisbelow(True)
    spread = spread_label([error for _, error in summaries.values()], "one pair")
    panels[0][0].set_ylabel(f"shorter than {name_of(options.baseline)} [%]\n{spread}")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, ncol=len(planners), **style.ABOVE)
    save(figure, options.output)
