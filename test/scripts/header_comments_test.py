#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every class and struct of the headers that is not inside another has a comment: above it, or, of
a struct of fields alone, at one of these."""
import pathlib
import re
import sys

TYPE = re.compile(r"^(?:class|struct) (\w+)(?!\w|<)[^;<]*\{", re.M)  # no specialisation


def explains_its_fields(text, begin):
    body = text[begin:text.index("\n};", begin)]
    return body.startswith("struct") and "//" in body


def lacking(path):
    text = path.read_text()
    for match in TYPE.finditer(text):
        before = text[:match.start()].splitlines()
        while before and before[-1].startswith("template"):
            before.pop()
        is_explained = before and before[-1].startswith("//")
        if not is_explained and not explains_its_fields(text, match.start()):
            yield f"{path}:{len(before) + 1}: {match[1]} has no comment"


def main(root):
    headers = sorted((root / "include").rglob("*.h"))
    problems = [problem for path in headers for problem in lacking(path)]
    print("\n".join(problems) or f"{len(headers)} headers say what their types are for")
    return 1 if problems or not headers else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
