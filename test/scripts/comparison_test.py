#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What doc/comparison.md says of this package can be looked up: names of topics and parameters are
those of the README, rates those of the profiles, and the text ends up in no table of figures."""
import pathlib
import re
import sys

import yaml

OF_OTHERS = {"move_base"}  # names that the page has from elsewhere, and that are ours as well


def main(root):
    page = (root / "doc/comparison.md").read_text()
    readme = (root / "README.md").read_text()
    problems = [f"`{name}` is not in the README" for name in sorted(set(re.findall(r"`([^`]+)`", page)))
                if f"`{name}`" not in readme and name not in OF_OTHERS | {"tf"}]
    rates = [yaml.safe_load(path.read_text()).get("planner_frequency", 2.0)
             for path in (root / "config/profiles").glob("*.yaml")]
    said = re.search(r"\| ([\d.]+) to ([\d.]+) a second by profile", page)
    if [float(said[1]), float(said[2])] != [min(rates), max(rates)]:
        problems.append(f"decisions a second are {min(rates)} to {max(rates)}")
    rows = [line for line in page.splitlines() if line.startswith("|")]
    columns = {row.count("|") for row in rows}
    if len(columns) != 1:
        problems.append(f"rows of {sorted(columns)} columns")
    if "https://" not in rows[-1] or rows[-1].count("https://") < 5:
        problems.append("the last row names a source for each of the others")
    if "In the model" in readme and "do not react to the robot" not in readme:
        problems.append("whether people react to the robot is another matter now")
    print("\n".join(f"doc/comparison.md: {problem}" for problem in problems) or "it agrees")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
