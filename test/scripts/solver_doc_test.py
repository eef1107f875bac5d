#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The example in doc/solver.md is the one that is compiled and tested, to the letter."""

import pathlib
import sys


def between(text, begin, end):
    return text.split(begin, 1)[1].split(end, 1)[0]


def main(source_dir):
    model = (source_dir / "test/despot/models/crossing.h").read_text()
    page = (source_dir / "doc/solver.md").read_text()
    compiled = between(model, "// [begin of the example]\n", "// [end of the example]")
    shown = between(page, "```cpp\n", "```")
    if shown == compiled:
        return 0
    print("doc/solver.md: the example differs from test/despot/models/crossing.h")
    return 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
