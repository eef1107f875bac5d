#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figures of experiments.

  plot_experiments.py trails trails.csv --pedestrians 400 --output trails.png trails.pdf
      where the robot drove in all runs: a row for each world, a column for each planner
  plot_experiments.py reduction results.csv --output reduction.png
      by how much each planner's trips are shorter than 1d_astar's among the same people
  plot_experiments.py decision decision.json --output decision.png
      the search tree of one decision
  plot_experiments.py search-time t20.csv t50.csv t200.csv --output search_time.png
      travel time against search time, a point for each results file

Results and trails come from run_experiments, decisions from export_decision. Each figure goes to the
files after --output, in the format of their ending: png, pdf or svg. Exit status 2 and one line for
a file that is none of these.
"""
import argparse
import contextlib
import csv
import json
import math
import pathlib
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker  # noqa: E402
import yaml  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

NAMES = {"1d_astar": "1D-A*", "2d_fmm": "2D-FMM", "2d_prm": "2D-PRM", "2d_nhv": "2D-NHV",
         "2d_nhv_fm2": "2D-NHV-FM²", "2d_straight": "2D-straight"}
# Okabe and Ito's colours, which the colour-blind tell apart, by falling darkness; hatches and markers
# tell them apart without colour.
COLOURS = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00"]
HATCHES = ["", "///", "...", "xxx", "\\\\\\", "+++"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
INK = "#222222"
OBSTACLE = {"facecolor": "#9a9a9a", "edgecolor": INK, "linewidth": 0.8}
FORMATS = ("png", "pdf", "svg")
STYLE = {"font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8,
         "xtick.labelsize": 8, "ytick.labelsize": 8, "axes.edgecolor": INK, "axes.linewidth": 0.7,
         "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
         "savefig.dpi": 180, "pdf.fonttype": 42, "svg.fonttype": "none", "hatch.linewidth": 0.6}

# Places of a legend outside the figure, which grows to hold it when it is saved.
ABOVE = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0)}
BELOW = {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0)}


class Refusal(Exception):
    """What is wrong, in one line."""


@contextlib.contextmanager
def expecting(what, path):
    """Refuses content that lacks something or has something of another kind."""
    try:
        yield
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        detail = f", there is no {error}" if isinstance(error, KeyError) else ""
        raise Refusal(f"{path}: expected {what}{detail}") from None


def read_text(path):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise Refusal(f"{path}: the file cannot be read: {reason}") from None


def read_rows(path, numbers):
    """Rows of a CSV file with the columns of an episode and the given ones, which are numbers."""
    reader = csv.reader(read_text(path).splitlines())
    header = next(reader, [])
    wanted = ["world", "pedestrians", "planner", "seed", *numbers]
    for name in wanted:
        if name not in header:
            raise Refusal(f"{path}:1: there is no column '{name}'")
    rows = []
    for number, cells in enumerate(reader, 2):
        if len(cells) != len(header):
            raise Refusal(f"{path}:{number}: expected {len(header)} cells as in the header, "
                          f"got {len(cells)}")
        row = dict(zip(header, cells))
        row["file"] = path
        for name in ("pedestrians", "seed", *numbers):
            try:
                row[name] = float(row[name])
            except ValueError:
                raise Refusal(f"{path}:{number}: {name}: expected a number, "
                              f"got '{row[name]}'") from None
            if not math.isfinite(row[name]):
                raise Refusal(f"{path}:{number}: {name}: expected a finite number")
        rows.append(row)
    if not rows:
        raise Refusal(f"{path}:2: expected a row, there is none")
    return rows


def read_all(paths, numbers):
    return [row for path in paths for row in read_rows(path, numbers)]


RESULTS = ("reached", "travel_time_s", "unsafe_ticks_0_5m", "mean_search_time_s")


def read_results(paths):
    """Episodes that arrived and were safe by the rule of the authors' code."""
    rows = read_all(paths, RESULTS)
    kept = [row for row in rows if row["reached"] == 1 and row["unsafe_ticks_0_5m"] == 0]
    if not kept:
        raise Refusal(f"{paths[0]}: no episode arrived safely")
    return kept


def read_settings(path):
    """What limited the search of a results file, 0 where it is not known."""
    beside = pathlib.Path(f"{path}.settings.json")
    settings = read_json(beside) if beside.exists() else {}
    with expecting("settings of run_experiments", beside):
        return {name: float(settings.get(name, 0)) for name in ("max_trials", "search_time")}


def read_json(path):
    try:
        return json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise Refusal(f"{path}:{error.lineno}: {error.msg}") from None


def in_order(values):
    return list(dict.fromkeys(values))


def name_of(planner):
    return NAMES.get(planner, planner)


def world_name(world):
    stem = pathlib.Path(world).stem
    return stem.replace("scenario_", "Scenario ")


def config_folder():
    """That of the sources or of the installation that this script lies in."""
    folder = pathlib.Path(__file__).resolve().parent
    installed = folder.parent.parent / "share/pomdp_crowd_nav/config"
    return installed if installed.is_dir() else folder.parent / "config"


def numbers(values, count):
    if len(values) != count:
        raise ValueError
    return [float(value) for value in values]


def world_file(world, config):
    path = pathlib.Path(world)
    is_file = path.suffix in (".yaml", ".yml") or len(path.parts) > 1
    path = path if is_file else config / "worlds" / f"{world}.yaml"
    try:
        description = yaml.safe_load(read_text(path))
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f":{mark.line + 1}" if mark else ""
        raise Refusal(f"{path}{where}: expected a world in yaml") from None
    with expecting("a world in yaml", path):
        bounds = description["bounds"]
        return {"bounds": [numbers(bounds["min"], 2), numbers(bounds["max"], 2)],
                "start": numbers(description["start"], 3), "goal": numbers(description["goal"], 2),
                "circles": [numbers(circle, 3) for circle in description.get("circles", [])],
                "polygons": [{"vertices": [numbers(place, 2) for place in polygon["vertices"]],
                              "closed": polygon.get("closed", True)}
                             for polygon in description.get("polygons", [])]}


def draw_world(axes, world):
    (left, bottom), (right, top) = world["bounds"]
    axes.add_patch(plt.Rectangle((left, bottom), right - left, top - bottom, fill=False,
                                 edgecolor=INK, linewidth=0.8, zorder=3))
    for x, y, radius in world["circles"]:
        axes.add_patch(plt.Circle((x, y), radius, zorder=2, **OBSTACLE))
    for polygon in world["polygons"]:
        if polygon.get("closed", True):
            axes.add_patch(plt.Polygon(polygon["vertices"], zorder=2, **OBSTACLE))
        else:
            axes.plot(*zip(*polygon["vertices"]), color=INK, linewidth=1.5, zorder=2)
    axes.set_aspect("equal")


def mark_ends(axes, start, goal):
    axes.plot(*start[:2], "o", color="white", markeredgecolor=INK, markersize=6, zorder=6,
              clip_on=False)
    axes.plot(*goal[:2], "*", color=COLOURS[1], markeredgecolor=INK, markersize=11, zorder=6,
              clip_on=False)


def save(figure, outputs):
    for output in outputs:
        try:
            figure.savefig(output, bbox_inches="tight", pad_inches=0.04)
        except OSError as error:
            raise Refusal(f"--output: cannot write '{output}': {error.strerror}") from None


def plot_trails(options):
    rows = read_all(options.files, ("time_s", "x_m", "y_m"))
    crowds = sorted({int(row["pedestrians"]) for row in rows})
    people = options.pedestrians if options.pedestrians is not None else crowds[-1]
    rows = [row for row in rows if row["pedestrians"] == people]
    if not rows:
        raise Refusal(f"--pedestrians: no trail among {people} people, there are: "
                      + ", ".join(map(str, crowds)))
    worlds = in_order(row["world"] for row in rows)
    planners = in_order(row["planner"] for row in rows)
    descriptions = {world: world_file(world, options.config) for world in worlds}
    trails = {}
    for row in rows:
        key = (row["world"], row["planner"])
        trails.setdefault(key, {}).setdefault((row["file"], row["seed"]), []).append(
            (row["x_m"], row["y_m"]))
    figure, panels = plt.subplots(len(worlds), len(planners), squeeze=False, constrained_layout=True,
                                  figsize=(2.3 * len(planners) + 0.3, 2.35 * len(worlds) + 0.3))
    for i, world in enumerate(worlds):
        for j, planner in enumerate(planners):
            axes = panels[i][j]
            draw_world(axes, descriptions[world])
            paths = list(trails.get((world, planner), {}).values())
            alpha = min(0.9, max(0.18, 6.0 / max(1, len(paths))))
            axes.add_collection(LineCollection(paths, colors=COLOURS[0], linewidths=0.7,
                                               alpha=alpha, zorder=4))
            mark_ends(axes, descriptions[world]["start"], descriptions[world]["goal"])
            (left, bottom), (right, top) = descriptions[world]["bounds"]
            axes.set_xlim(left, right)
            axes.set_ylim(bottom, top)
            for spine in axes.spines.values():
                spine.set_visible(False)
            axes.tick_params(length=2)
            if i == 0:
                axes.set_title(name_of(planner))
            if j == 0:
                axes.set_ylabel(f"{world_name(world)}\ny [m]")
            else:
                axes.tick_params(labelleft=False)
            if i == len(worlds) - 1:
                axes.set_xlabel("x [m]")
            else:
                axes.tick_params(labelbottom=False)
    save(figure, options.output)


def mean_and_error(values):
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else 0.0
    return statistics.mean(values), error


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
    width = 0.8 / len(planners)
    for axes, world in zip(panels[0], worlds):
        for k, planner in enumerate(planners):
            shown = [i for i, people in enumerate(crowds) if (world, planner, people) in cells]
            if not shown:
                continue
            summary = [mean_and_error(cells[world, planner, crowds[i]]) for i in shown]
            places = [i + (k - 0.5 * (len(planners) - 1)) * width for i in shown]
            axes.bar(places, [mean for mean, _ in summary], width * 0.94,
                     yerr=[error for _, error in summary], color=COLOURS[k], hatch=HATCHES[k],
                     edgecolor=INK, linewidth=0.6, error_kw={"elinewidth": 0.9, "capsize": 2.0},
                     label=name_of(planner))
        axes.axhline(0.0, color=INK, linewidth=0.7)
        axes.set_title(world_name(world))
        axes.set_xticks(range(len(crowds)))
        axes.set_xticklabels([str(people) for people in crowds])
        axes.set_xlabel("people")
        axes.yaxis.grid(True, color="#dddddd", linewidth=0.6)
        axes.set_axisbelow(True)
    panels[0][0].set_ylabel(f"shorter than {name_of(options.baseline)} [%]\n(mean ± standard error)")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, ncol=len(planners), **ABOVE)
    save(figure, options.output)


def extent_of(decision, margin):
    """A square about everything that the search looked at."""
    points = [decision["robot"]["position"]]
    points += [end for edge in decision["tree"] for end in (edge["from"], edge["to"])]
    points += [person["position"] for person in decision["people"] if person["attended"]]
    xs, ys = zip(*points)
    half = 0.5 * max(max(xs) - min(xs), max(ys) - min(ys), 10.0) + margin
    x, y = 0.5 * (min(xs) + max(xs)), 0.5 * (min(ys) + max(ys))
    return x - half, x + half, y - half, y + half


def draw_person(axes, person, destinations):
    x, y = person["position"]
    colour = COLOURS[0] if person["attended"] else "#8c8c8c"
    predicted = person["predicted"] if person["attended"] else []
    for k, place in enumerate(predicted):
        axes.add_patch(plt.Circle(place, 0.3, fill=False, edgecolor=colour, linewidth=0.9,
                                  alpha=1.0 - 0.15 * k, zorder=4))
    for probability, (to_x, to_y) in zip(person["belief"], destinations):
        length = math.hypot(to_x - x, to_y - y)
        if person["attended"] and length > 0.0:
            reach = 2.5 * probability / length
            axes.plot([x, x + reach * (to_x - x)], [y, y + reach * (to_y - y)], color=colour,
                      linewidth=1.4, zorder=5, solid_capstyle="round")
    axes.add_patch(plt.Circle((x, y), 0.3, facecolor=colour, edgecolor=INK, linewidth=0.6,
                              zorder=6))


def draw_tree(axes, decision):
    edges = sorted(decision["tree"], key=lambda edge: edge["value"])
    values = [edge["value"] for edge in edges]
    # A few leaves that end in a collision would leave one colour to all others.
    low = statistics.quantiles(values, n=20)[1] if len(values) > 20 else min(values)
    colours = plt.get_cmap("viridis")
    scale = matplotlib.colors.Normalize(low, max(values) if max(values) > low else low + 1.0)
    lines = LineCollection([(edge["from"], edge["to"]) for edge in edges], zorder=3,
                           linewidths=[0.5 + 1.3 * edge["weight"] for edge in edges])
    lines.set_color([colours(scale(edge["value"])) for edge in edges])
    axes.add_collection(lines)
    axes.scatter(*zip(*(edge["to"] for edge in edges)), s=3, zorder=3.5, linewidths=0,
                 c=values, cmap=colours, norm=scale)
    return matplotlib.cm.ScalarMappable(scale, colours)


def draw_decision(figure, axes, decision):
    world = decision["world"]
    draw_world(axes, world)
    for path in decision["rollouts"]:
        axes.plot(*zip(*path), color="#777777", linewidth=0.8, linestyle=(0, (4, 3)), zorder=2.5)
    mappable = draw_tree(axes, decision)
    axes.plot(*zip(*decision["plan"]), color=COLOURS[5], linewidth=2.2, zorder=4.5)
    for person in decision["people"]:
        draw_person(axes, person, world["destinations"])
    axes.add_patch(plt.Circle(decision["robot"]["position"], decision["robot"]["radius"],
                              fill=False, edgecolor=INK, linewidth=1.4, zorder=5))
    axes.plot(*decision["robot"]["position"], "o", color=INK, markersize=3, zorder=5)
    axes.plot(*world["goal"], "*", color=COLOURS[1], markeredgecolor=INK, markersize=12, zorder=6)
    left, right, bottom, top = extent_of(decision, 2.0)
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    figure.colorbar(mappable, ax=axes, shrink=0.8, label="value of the belief")


def plot_decision(options):
    decision = read_json(options.file)
    for key in ("world", "robot", "tree", "rollouts", "people", "plan"):
        if not isinstance(decision, dict) or key not in decision:
            raise Refusal(f"{options.file}: expected a decision of export_decision, "
                          f"'{key}' is missing")
    if not decision["tree"]:
        raise Refusal(f"{options.file}: this decision has no search tree")
    figure, axes = plt.subplots(figsize=(5.4, 4.6), constrained_layout=True)
    with expecting("a decision of export_decision", options.file):
        draw_decision(figure, axes, decision)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(matplotlib.ticker.MaxNLocator(nbins=6, integer=True))
    circle = {"linestyle": "none", "marker": "o", "markersize": 6}
    figure.legend(ncol=3, **BELOW, handles=[
        Line2D([], [], **{**circle, "markersize": 9}, color="white", markeredgecolor=INK,
               label="robot"),
        Line2D([], [], color=COLOURS[5], linewidth=2.2, label="planned steps"),
        Line2D([], [], color="#777777", linewidth=0.8, linestyle=(0, (4, 3)), label="roll-outs"),
        Line2D([], [], **circle, color=COLOURS[0], markeredgecolor=INK, label="person, lines: belief"),
        Line2D([], [], **circle, color="white", markeredgecolor=COLOURS[0],
               label="the same, 1 to 5 steps on"),
        Line2D([], [], **circle, color="#8c8c8c", markeredgecolor=INK, label="person, not searched")])
    save(figure, options.output)


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
        axes.errorbar(search, travel, yerr=errors, color=COLOURS[k % len(COLOURS)],
                      marker=MARKERS[k % len(MARKERS)], markersize=5, markeredgecolor=INK,
                      markeredgewidth=0.5, linewidth=1.2, capsize=2.5,
                      label=f"{name_of(planner)}, {world_name(world)}, {people} people")
        if k == 0:  # what limits the search
            for x, _, _, label in points:
                axes.annotate(label, (x, 0.02), xytext=(-2, 0), textcoords="offset points",
                              xycoords=axes.get_xaxis_transform(), rotation=90, fontsize=7,
                              ha="right", va="bottom", color=INK)
    axes.set_xscale("log")
    axes.margins(x=0.1, y=0.12)
    ticks = matplotlib.ticker.LogLocator(subs=(1.0, 2.0, 5.0))
    axes.xaxis.set_major_locator(ticks)
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    axes.set_xlabel("search for a decision, mean [ms]")
    axes.set_ylabel("travel time [s]\n(mean ± standard error)")
    axes.grid(True, color="#dddddd", linewidth=0.6)
    figure.legend(ncol=1 if len(series) < 3 else 2, **ABOVE)
    save(figure, options.output)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refusal(message)


def parse(arguments):
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True, metavar="FIGURE",
                                     parser_class=Parser)

    def add(name, plot, help_text, files, files_help):
        command = commands.add_parser(name, help=help_text, description=help_text)
        command.set_defaults(plot=plot)
        if files == "file":
            command.add_argument("file", help=files_help)
        else:
            command.add_argument("files", nargs="+", help=files_help)
        command.add_argument("--output", nargs="+", required=True, metavar="FILE",
                             help="figure to write, .png, .pdf or .svg; several if wanted")
        return command

    trails = add("trails", plot_trails, "where the robot drove in all runs", "files",
                 "CSV that run_experiments wrote with --trails")
    trails.add_argument("--pedestrians", type=int,
                        help="size of the crowd to show; without it the largest there is")
    trails.add_argument("--config", type=pathlib.Path, default=config_folder(),
                        help="folder of worlds (%(default)s)")
    reduction = add("reduction", plot_reduction, "by how much trips are shorter than a baseline's",
                    "files", "CSV of results; pairs are within a file")
    reduction.add_argument("--baseline", default="1d_astar", help="planner (%(default)s)")
    add("decision", plot_decision, "the search tree of one decision", "file",
        "JSON that export_decision wrote")
    add("search-time", plot_search_time, "travel time against search time", "files",
        "CSV of results, one for each limit of the search (--max-trials or --search-time)")
    options = parser.parse_args(arguments)
    for output in options.output:
        if pathlib.Path(output).suffix[1:] not in FORMATS:
            raise Refusal(f"--output: '{output}' must end with one of: " + ", ".join(FORMATS))
    return options


def main():
    try:
        options = parse(sys.argv[1:])
        with plt.rc_context(STYLE):
            options.plot(options)
    except Refusal as refusal:
        print(f"plot_experiments.py: {refusal}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
