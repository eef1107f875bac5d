# SPDX-License-Identifier: BSD-3-Clause
"""Where the robot drove in all runs."""
from matplotlib.collections import LineCollection

from command_line.refusal import Refusal

from . import style
from .style import name_of, plt, save, world_name
from .tables import in_order, read_all
from .world import draw_world, mark_ends, world_file


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
            axes.add_collection(LineCollection(paths, colors=style.COLOURS[0], linewidths=0.7,
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
