#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lists all parameters from config/parameters.yaml.

list_parameters.py --profile          a profile in which every key has its default, on stdout
list_parameters.py --readme README.md writes the tables of parameters into that file
list_parameters.py --check README.md  exit status 1 unless they are there as they should be
"""
import argparse
import pathlib
import re
import sys
import textwrap

import yaml

HEADINGS = {"profile": "### Of a profile", "simulator": "### Of a profile, for the simulator",
            "nodes": "### Of the nodes"}
COLUMNS = {"profile": ("parameter", "unit", "default", "range", "change", "meaning"),
           "simulator": ("parameter", "unit", "default", "range", "meaning"),
           "nodes": ("parameter", "node", "unit", "default", "range", "meaning")}
NUMBERS = {"pi": "3.141592653589793", "pi / 4": "0.7853981633974483"}


def find_table():
    """In the source tree or, installed, in the package's share folder."""
    here = pathlib.Path(__file__).resolve().parent
    for folder in (here.parent, here.parents[1] / "share" / "pomdp_crowd_nav"):
        if (folder / "config/parameters.yaml").exists():
            return folder / "config/parameters.yaml"
    sys.exit("list_parameters.py: config/parameters.yaml is nowhere near this script")


def text_of(value):
    if isinstance(value, bool):
        return str(value).lower()
    return "" if value is None else str(value)


def range_of(entry):
    limits = entry.get("range", "")
    if isinstance(limits, list):
        if all(isinstance(limit, str) for limit in limits):
            limits = ", ".join(f"`{word}`" for word in limits)
        else:
            limits = " to ".join(f"{limit:g}" for limit in limits)
    return "; ".join(filter(None, (limits, entry.get("also"))))


def row_of(key, entry, columns):
    cells = {name: text_of(entry.get(name)) for name in columns}
    cells.update(parameter=f"`{key}`", range=range_of(entry))
    return re.sub(r"\|  (?=\|)", "| ", "| " + " | ".join(cells[name] for name in columns) + " |")


def table_of(section, entries):
    columns = COLUMNS[section]
    rows = [row_of(key, entry, columns) for key, entry in entries.items()]
    return "\n".join(["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns), *rows])


def with_tables(readme, parameters):
    for section, heading in HEADINGS.items():
        table = table_of(section, parameters[section])
        readme, count = re.subn(rf"(?m)^({heading}\n\n(?:[^|#\n].*\n+)*)(?:\|.*\n)+",
                                lambda match: match[1] + table + "\n", readme)
        if count != 1:
            sys.exit(f"list_parameters.py: '{heading}' is there {count} times")
    return readme


def comment_of(entry):
    words = [entry.get("unit", ""), range_of(entry), entry.get("meaning", "")]
    return textwrap.fill("; ".join(filter(None, words)).replace("`", ""), 98,
                         initial_indent="# ", subsequent_indent="# ")


def profile_of(parameters):
    lines = []
    group = None
    for key, entry in {**parameters["profile"], **parameters["simulator"]}.items():
        *head, name = key.split("/")
        if head and head[0] != group:
            lines.append(f"{head[0]}:")
        group = head[0] if head else None
        indent = "  " if head else ""
        default = text_of(entry["default"])
        lines += textwrap.indent(comment_of(entry), indent).splitlines()
        lines.append(f"{indent}{name}: {NUMBERS.get(default, default)}")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--profile", action="store_true",
                      help="print a profile with every default: the start of one of your own")
    what.add_argument("--readme", metavar="FILE", type=pathlib.Path,
                      help="write the tables into this file")
    what.add_argument("--check", metavar="FILE", type=pathlib.Path,
                      help="compare them with this file")
    options = parser.parse_args()
    parameters = yaml.safe_load(find_table().read_text())
    if options.profile:
        sys.stdout.write(profile_of(parameters))
        return 0
    path = options.readme or options.check
    old = path.read_text()
    new = with_tables(old, parameters)
    if options.readme:
        path.write_text(new)
        return 0
    for said, meant in zip(old.splitlines(), new.splitlines()):
        if said != meant:
            print(f"{path.name} says: {said}\nthe table: {meant}")
            break
    return 0 if old == new else 1


if __name__ == "__main__":
    sys.exit(main())
