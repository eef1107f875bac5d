#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what the tests have measured into the tables of doc/safety.md.

usage: fault_matrix.py RESULTS_FOLDER [DOCUMENT]

  scripts/fault_matrix.py build/test_results

RESULTS_FOLDER is test_results of a build folder in which the tests have run; in it every test of a
fault has left the properties fault, bound_s and rest_s (or period_s, where nothing stops). DOCUMENT
is doc/safety.md beside this script's folder unless it is given. Rows whose test has not run stay as
they are and are named on standard error. Exit status 0; 1 when a result has no row, or another bound
than its row; 2 and one line for a bad argument or file.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

BOUND, MEASURED = "bound [s]", "measured [s]"


def cells_of(line):
    """Cells of a row of a Markdown table; none for any other line."""
    line = line.strip()
    if len(line) < 2 or line[0] != "|" or line[-1] != "|":
        return None
    return [cell.strip() for cell in line[1:-1].split("|")]


def rows_of(text):
    """(number of the line, {column: cell}) of every row below a head with a bound and a measure."""
    head = None
    for number, line in enumerate(text.splitlines()):
        cells = cells_of(line)
        if cells is None:
            head = None
        elif head is None:
            head = cells
        elif BOUND in head and MEASURED in head and not re.fullmatch(r"[-: ]*", "".join(cells)):
            if len(cells) != len(head):
                raise ValueError(f"line {number + 1}: {len(cells)} cells below {len(head)} heads")
            yield number, dict(zip(head, cells))


def properties_of(case):
    """What RecordProperty has left: elements in newer versions of GoogleTest, else attributes."""
    found = dict(case.attrib)
    found.update((p.get("name"), p.get("value")) for p in case.iter("property"))
    return found


def results_in(folder):
    """{fault: (bound, measured)} as texts, of all files of results below the folder."""
    results = {}
    for path in sorted(folder.rglob("*.xml")):
        try:
            cases = ElementTree.parse(path).iter("testcase")
        except ElementTree.ParseError:
            continue  # the program died while it wrote
        for case in cases:
            found = properties_of(case)
            measured = found.get("rest_s") or found.get("period_s")
            if "fault" in found and measured:
                results[found["fault"]] = (found["bound_s"], measured)
    return results


def with_measures(text, results):
    """The text with the measured cells rewritten, and a list of problems."""
    lines, problems, seen = text.splitlines(), [], set()
    for number, row in rows_of(text):
        fault = next(iter(row.values()))
        if fault not in results:
            print(f"not measured: {fault}", file=sys.stderr)
            continue
        bound, measured = results[fault]
        seen.add(fault)
        if float(bound) != float(row[BOUND]):
            problems.append(f"{fault}: its row says {row[BOUND]} s, its test {bound} s")
        row[MEASURED] = measured
        lines[number] = "| " + " | ".join(row.values()) + " |"
    problems += [f"{fault}: measured, but without a row" for fault in results if fault not in seen]
    return "\n".join(lines) + "\n", problems


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[0] in ("-h", "--help"):
        print(__doc__.strip(), file=sys.stdout if "-h" in arguments or "--help" in arguments
              else sys.stderr)
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    folder = pathlib.Path(arguments[0])
    document = pathlib.Path(arguments[1]) if len(arguments) == 2 else \
        pathlib.Path(__file__).resolve().parents[1] / "doc/safety.md"
    if not folder.is_dir():
        print(f"fault_matrix.py: {folder} is no folder", file=sys.stderr)
        return 2
    results = results_in(folder)
    if not results:
        print(f"fault_matrix.py: no test of a fault has left results in {folder}", file=sys.stderr)
        return 2
    try:
        text, problems = with_measures(document.read_text(), results)
        document.write_text(text)
    except (OSError, ValueError) as error:
        print(f"fault_matrix.py: {document}: {error}", file=sys.stderr)
        return 2
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
