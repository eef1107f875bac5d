# SPDX-License-Identifier: BSD-3-Clause
"""Reads what run_experiments and export_decision have written."""
import csv
import json
import math
import pathlib
import statistics

from command_line.refusal import Refusal, expecting, read_text

RESULTS = ("reached", "travel_time_s", "unsafe_ticks_0_5m", "mean_search_time_s")


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


def mean_and_error(values):
    """Mean and standard error, which a single value does not tell: then it is no number."""
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.mean(values), error
