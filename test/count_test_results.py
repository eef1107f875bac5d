#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts test cases: count_test_results.py RESULTS_FOLDER

The folder holds ctest.xml (ctest --output-junit) and, below it, what gtest and rostest wrote. A
program of ctest counts as its own cases where it wrote any and as one case where it did not. It
counts as one failure more when it failed though all of its cases passed: a crash, a time-out, a
node that died. What failed or was skipped goes to standard error with the reason, "N passed, N
failed" to standard output; the exit status is 1 when something failed or nothing ran.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree


def outcome_of(case):
    """Outcome of a <testcase> and the reason when it failed."""
    for tag in ("failure", "error"):
        problem = case.find(tag)
        if problem is not None:
            return "failed", (problem.get("message") or problem.text or "").strip()
    if case.get("status") == "fail":
        return "failed", "the program failed"
    skipped = case.find("skipped")
    if skipped is not None:
        said = (skipped.get("message") or skipped.text or "").strip().splitlines()
        return "skipped", said[-1] if said else ""
    if case.get("status") in ("notrun", "disabled"):
        return "skipped", ""
    return "passed", ""


def result_files_of(test, folder):
    """What the program of that name in ctest has written.

    The cases of a rostest are in rosunit-NAME.xml; rostest-test_NAME.xml only repeats their sum.
    """
    match = re.match(r"_ctest_(.+?)_(gtest|rostest|roslaunch-check)_(.+)$", test)
    if not match:
        return []
    package, kind, name = match.groups()
    if kind != "rostest":
        return list((folder / package).glob(f"{kind}-{name}.xml")) or \
            list((folder / package).glob(f"{kind}_{name}.xml"))
    name = re.sub(r"\.(test|launch)$", "", name)
    return [path for path in (folder / package).glob("rosunit-*.xml")
            if ("_" + name).endswith("_" + path.stem[len("rosunit-"):])]


def cases_of(test, folder):
    for path in result_files_of(test, folder):
        try:
            cases = ElementTree.parse(path).iter("testcase")
        except ElementTree.ParseError:
            continue  # the program died while it wrote; ctest knows that it failed
        for case in cases:
            yield f"{case.get('classname')}.{case.get('name')}", *outcome_of(case)


def count(folder):
    totals = {"passed": 0, "failed": 0, "skipped": 0}

    def add(name, outcome, reason):
        totals[outcome] += 1
        if outcome != "passed":
            print(f"{outcome.upper()} {name}: " + "\n  ".join(reason.splitlines()[:6]),
                  file=sys.stderr)

    try:
        programs = list(ElementTree.parse(folder / "ctest.xml").iter("testcase"))
    except (OSError, ElementTree.ParseError) as error:
        add("ctest", "failed", f"no results: {error}")
        return totals
    for program in programs:
        outcome, reason = outcome_of(program)
        cases = list(cases_of(program.get("name"), folder))
        for case in cases:
            add(*case)
        is_explained = any(case[1] == "failed" for case in cases)
        if not cases or (outcome == "failed" and not is_explained):
            add(program.get("name"), outcome, reason or "see the log")
    return totals


def main():
    totals = count(pathlib.Path(sys.argv[1]))
    skipped = f", {totals['skipped']} skipped" if totals["skipped"] else ""
    print(f"{totals['passed']} passed, {totals['failed']} failed{skipped}")
    return 1 if totals["failed"] or not totals["passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
