# SPDX-License-Identifier: BSD-3-Clause
"""The search tree of one decision."""
import math
import statistics

import matplotlib
import matplotlib.ticker
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from command_line.refusal import Refusal, expecting

from . import style
from .style import plt, save
from .tables import read_json
from .world import draw_world


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
    colour = style.COLOURS[0] if person["attended"] else "#8c8c8c"
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
    axes.add_patch(plt.Circle((x, y), 0.3, facecolor=colour, edgecolor=style.INK, linewidth=0.6,
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
    axes.plot(*zip(*decision["plan"]), color=style.COLOURS[5], linewidth=2.2, zorder=4.5)
    for person in decision["people"]:
        draw_person(axes, person, world["destinations"])
    axes.add_patch(plt.Circle(decision["robot"]["position"], decision["robot"]["radius"],
                              fill=False, edgecolor=style.INK, linewidth=1.4, zorder=5))
    axes.plot(*decision["robot"]["position"], "o", color=style.INK, markersize=3, zorder=5)
    axes.plot(*world["goal"], "*", color=style.COLOURS[1], markeredgecolor=style.INK,
              markersize=12, zorder=6)
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
    figure.legend(ncol=3, **style.BELOW, handles=[
        Line2D([], [], **{**circle, "markersize": 9}, color="white", markeredgecolor=style.INK,
               label="robot"),
        Line2D([], [], color=style.COLOURS[5], linewidth=2.2, label="planned steps"),
        Line2D([], [], color="#777777", linewidth=0.8, linestyle=(0, (4, 3)), label="roll-outs"),
        Line2D([], [], **circle, color=style.COLOURS[0], markeredgecolor=style.INK,
               label="person, lines: belief"),
        Line2D([], [], **circle, color="white", markeredgecolor=style.COLOURS[0],
               label="the same, 1 to 5 steps on"),
        Line2D([], [], **circle, color="#8c8c8c", markeredgecolor=style.INK,
               label="person, not searched")])
    save(figure, options.output)
