# SPDX-License-Identifier: BSD-3-Clause
"""A world file, read and drawn."""
import pathlib

import yaml

from command_line.refusal import Refusal, expecting, read_text

from . import style
from .style import plt


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
                                 edgecolor=style.INK, linewidth=0.8, zorder=3))
    for x, y, radius in world["circles"]:
        axes.add_patch(plt.Circle((x, y), radius, zorder=2, **style.OBSTACLE))
    for polygon in world["polygons"]:
        if polygon.get("closed", True):
            axes.add_patch(plt.Polygon(polygon["vertices"], zorder=2, **style.OBSTACLE))
        else:
            axes.plot(*zip(*polygon["vertices"]), color=style.INK, linewidth=1.5, zorder=2)
    axes.set_aspect("equal")


def mark_ends(axes, start, goal):
    axes.plot(*start[:2], "o", color="white", markeredgecolor=style.INK, markersize=6, zorder=6,
              clip_on=False)
    axes.plot(*goal[:2], "*", color=style.COLOURS[1], markeredgecolor=style.INK, markersize=11,
              zorder=6, clip_on=False)
