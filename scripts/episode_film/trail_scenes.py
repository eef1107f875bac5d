# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the trails that run_experiments has written: the robot alone, in one run or in many."""
import numpy

from command_line.refusal import Refusal
from experiment_figures.tables import read_rows
from experiment_figures.world import world_file

from .scene import Place, Scene


def only(rows, key, wanted, path):
    """The rows of one world, planner or crowd: the wanted one, else the only one."""
    found = sorted({row[key] for row in rows})
    names = ", ".join(f"{value:g}" if isinstance(value, float) else value for value in found)
    if wanted is None:
        if len(found) > 1:
            raise Refusal(f"{path}: choose one of several with --{key}: {names}")
        return rows
    kept = [row for row in rows if row[key] == wanted]
    if not kept:
        raise Refusal(f"{path}: --{key}: there is no '{wanted}', there is: {names}")
    return kept


class TrailScenes:
    ZOOM = 0.0  # [m], there is nothing about the robots

    def __init__(self, path, options, config):
        rows = read_rows(path, ("time_s", "x_m", "y_m"))
        rows = only(rows, "world", options.world, path)
        rows = only(rows, "planner", options.planner, path)
        rows = only(rows, "pedestrians", options.pedestrians, path)
        if options.seed is not None:
            rows = only(rows, "seed", options.seed, path)
        self.world = world_file(rows[0]["world"], config)
        runs = {}
        for row in rows:
            runs.setdefault(row["seed"], []).append((row["time_s"], row["x_m"], row["y_m"]))
        self.runs = [numpy.array(sorted(run)) for run in runs.values()]
        self.label = f"{rows[0]['planner']}, {rows[0]['pedestrians']:.0f} people"
        self.begin, self.end = 0.0, max(float(run[-1, 0]) for run in self.runs)

    def place(self):
        (left, bottom), (right, top) = self.world["bounds"]
        return Place((left, bottom, right, top), world=self.world,
                     marks=(self.world["start"], self.world["goal"]))

    def scenes(self, start, end, step):
        for k in range(int((min(end, self.end) - start) / step + 1e-9) + 1):
            time = start + k * step
            robots = [(float(numpy.interp(time, run[:, 0], run[:, 1])),
                       float(numpy.interp(time, run[:, 0], run[:, 2])), None) for run in self.runs]
            driving = sum(time < run[-1, 0] for run in self.runs)
            yield Scene(time=time, robots=robots, goal=tuple(self.world["goal"]),
                        state=f"{driving} of {len(self.runs)} under way", detail=self.label)
