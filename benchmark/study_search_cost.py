#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the search scales: runs benchmark_search for many settings and prints tables of medians.

Nothing else should run on the machine meanwhile; takes about ten minutes.
"""

import argparse
import subprocess
import sys

# Heading, and the options of each row.
STUDIES = [
    ("bound", [["--upper-bound", "paper"], ["--upper-bound", "tight"],
               ["--upper-bound", "paper", "--bold-rollouts", "false"]]),
    ("time", [["--time", t] for t in ("0.005", "0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1")]),
    ("scenarios K", [["--scenarios", k] for k in ("25", "50", "100", "200", "300", "500")]),
    ("people n_ped", [["--pedestrians", n] for n in ("0", "3", "6", "10", "16", "32")]),
    ("depth D", [["--depth", d] for d in ("50", "70", "100", "150")]),
    ("threads", [["--threads", n] for n in ("1", "2")]),
]
COLUMNS = [
    ("M steps/s", lambda f: f"{float(f['model_steps_per_s']) * 1e-6:.0f}"),
    ("trials", lambda f: f["trials"]),
    ("expansions", lambda f: f["expansions"]),
    ("beliefs", lambda f: f["belief_nodes"]),
    ("L", lambda f: f["lower_bound"]),
    ("U", lambda f: f["upper_bound"]),
    ("gap", lambda f: f["gap"]),
    ("L = 125.7 after [ms]", lambda f: milliseconds(f["time_to_lower_bound_125_7_s"])),
    ("L = 148 after [ms]", lambda f: milliseconds(f["time_to_lower_bound_148_s"])),
    ("longest decision [s]", lambda f: f["decision_wall_max_s"]),
    ("memory [MB]", lambda f: f["peak_rss_mb"]),
]


def milliseconds(text):
    return "never" if text == "inf" else f"{1e3 * float(text):.1f}"


def figures(tool, options):
    print(" ".join(options), file=sys.stderr)
    output = subprocess.run([tool, *options], check=True, capture_output=True, text=True).stdout
    return dict(item.split("=") for item in output.splitlines()[-1].split())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool", help="path of benchmark_search")
    parser.add_argument("--crowds", default="20")
    parser.add_argument("--only", help="one of the studies, by the beginning of its name")
    options = parser.parse_args()
    for heading, rows in STUDIES:
        if options.only and not heading.startswith(options.only):
            continue
        # The paper's bound keeps a search busy for all of its time.
        keep_busy = [] if heading in ("bound", "time") else ["--upper-bound", "paper"]
        print(f"| {heading} | " + " | ".join(name for name, _ in COLUMNS) + " |")
        print("|" + "---|" * (len(COLUMNS) + 1))
        for row in rows:
            found = figures(options.tool, [*row, *keep_busy, "--crowds", options.crowds])
            label = " ".join(word for word in row if not word.startswith("--"))
            print(f"| {label} | " + " | ".join(of(found) for _, of in COLUMNS) + " |", flush=True)
        print()


if __name__ == "__main__":
    main()
