#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What search buys: travel time and sudden brakes for several budgets, K and n_ped.

Runs run_experiments in lockstep with the wall clock as the limit, one variation of the profile at a
time, and prints a table. Nothing else should run on the machine meanwhile.
"""

import argparse
import csv
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

# Search time [s], K, n_ped. The first one is what the others are compared with.
VARIATIONS = [
    (0.1, 100, 6),
    (0.005, 100, 6),
    (0.02, 100, 6),
    (0.5, 100, 6),
    (0.1, 50, 6),
    (0.1, 300, 6),
    (0.1, 100, 10),
    (0.1, 100, 16),
]


def profile_text(base, scenarios, pedestrians):
    """The profile with two of its lines replaced."""
    lines = []
    for line in base.splitlines():
        if line.startswith("attended_pedestrians:"):
            line = f"attended_pedestrians: {pedestrians}"
        elif line.strip().startswith("scenarios:"):
            line = f"  scenarios: {scenarios}"
        lines.append(line)
    text = "\n".join(lines) + "\n"
    assert f"attended_pedestrians: {pedestrians}\n" in text
    assert f"  scenarios: {scenarios}\n" in text
    return text


def run(tool, config, folder, variation, options):
    time, scenarios, pedestrians = variation
    profile = folder / f"k{scenarios}_n{pedestrians}.yaml"
    base = (config / "profiles/paper.yaml").read_text()
    profile.write_text(profile_text(base, scenarios, pedestrians))
    output = folder / f"t{time}_k{scenarios}_n{pedestrians}.csv"
    if not output.exists():
        part = output.with_suffix(".part")
        part.unlink(missing_ok=True)
        subprocess.run(
            [tool, "--config", config, "--profile", profile, "--worlds", options.world,
             "--pedestrians", str(options.pedestrians), "--runs", str(options.runs), "--seed", "1",
             "--jobs", str(options.jobs), "--search-time", str(time), "--output", part],
            check=True)
        part.rename(output)
    with output.open() as file:
        return {row["seed"]: row for row in csv.DictReader(file)}


def mean_and_error(values):
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.mean(values), error


def table_row(variation, rows, base):
    time, scenarios, pedestrians = variation
    travel = [float(row["travel_time_s"]) for row in rows.values()]
    difference = [float(rows[s]["travel_time_s"]) - float(base[s]["travel_time_s"]) for s in rows]
    brakes = [float(row["sudden_brakes"]) for row in rows.values()]
    unsafe = sum(int(row["unsafe_steps_1m"]) for row in rows.values())
    reached = sum(int(row["reached"]) for row in rows.values())
    trials = statistics.mean(float(row["mean_trials"]) for row in rows.values())
    searched = 1e3 * statistics.mean(float(row["mean_search_time_s"]) for row in rows.values())
    return (f"| {1e3 * time:.0f} | {scenarios} | {pedestrians} | {reached} of {len(rows)} "
            f"| {{:.2f}} ± {{:.2f}} | {{:+.2f}} ± {{:.2f}} | {{:.2f}} ± {{:.2f}} "
            f"| {unsafe} | {trials:.0f} | {searched:.0f} |").format(
                *mean_and_error(travel), *mean_and_error(difference), *mean_and_error(brakes))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool", help="path of run_experiments")
    parser.add_argument("--config", type=pathlib.Path, default=pathlib.Path("config"))
    parser.add_argument("--world", default="scenario_1")
    parser.add_argument("--pedestrians", type=int, default=400)
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=1, help="at most one for each core")
    parser.add_argument("--folder", type=pathlib.Path, help="keeps the CSVs, and goes on from them")
    options = parser.parse_args()
    folder = options.folder or pathlib.Path(tempfile.mkdtemp(prefix="travel_time_"))
    folder.mkdir(parents=True, exist_ok=True)
    results = []
    for i, variation in enumerate(VARIATIONS):
        print(f"{i + 1}/{len(VARIATIONS)}: {1e3 * variation[0]:.0f} ms, K = {variation[1]}, "
              f"n_ped = {variation[2]}", file=sys.stderr)
        results.append(run(options.tool, options.config, folder, variation, options))
    print("| search [ms] | K | n_ped | arrived | travel time [s] | difference [s] | SB | unsafe "
          "| trials | searched [ms] |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for variation, rows in sorted(zip(VARIATIONS, results), key=lambda pair: pair[0]):
        print(table_row(variation, rows, results[0]))


if __name__ == "__main__":
    main()
