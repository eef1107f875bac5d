#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The messages that doc/troubleshooting.md quotes are those of the programs.

A message is what stands between backticks in the first column of a table under `message`, and what of
the text has a "…" in backticks. "…" there, and placeholders in the sources, stand for anything.
"""
import pathlib
import re
import sys

ANY = "\0"
C_STRINGS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
PLACEHOLDERS = re.compile(r"\{[^{}]*\}|%[-.\d]*l?[a-z]|\$\{[^}]*\}|\$\w+|\$[*@?]|…")
ROS = "## What ROS prints"  # messages of others


def normal(text):
    text = PLACEHOLDERS.sub(ANY, text.replace('\\"', '"'))
    return re.sub(f"{ANY}+", ANY, " ".join(text.split())).strip(ANY + " ")


def literals_of(path):
    text = path.read_text()
    if path.suffix in (".cpp", ".h"):
        for match in C_STRINGS.finditer(text):
            yield "".join(piece[1:-1] for piece in re.findall(r'"(?:[^"\\\n]|\\.)*"', match[0]))
    else:
        yield from re.findall(r'"((?:[^"\\]|\\.)*)"', text)


def quoted(page):
    """(message, number of its line)"""
    in_messages = False
    for number, line in enumerate(page.splitlines(), 1):
        if line == ROS:
            in_messages = False
        if line.startswith("| message"):
            in_messages = True
        elif not line.startswith("|"):
            in_messages = False
            yield from ((text, number) for text in re.findall(r"`([^`]*…[^`]*)`", line)
                        if " " in text)
        elif in_messages and line.startswith("| `"):
            yield re.match(r"\| `([^`]+)`", line)[1], number


def main(root):
    sources = [path for folder in ("src", "include", "scripts")
               for path in sorted((root / folder).rglob("*"))
               if path.suffix in (".cpp", ".h", ".sh", ".py")] + [root / "CMakeLists.txt"]
    known = {normal(literal) for path in sources for literal in literals_of(path)}
    page = (root / "doc/troubleshooting.md").read_text()
    messages = list(quoted(page))
    problems = [f"doc/troubleshooting.md:{number}: no program prints '{message}'"
                for message, number in messages
                if not any(normal(message) in literal for literal in known)]
    print("\n".join(problems) or f"all {len(messages)} messages are there")
    return 1 if problems or len(messages) < 60 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
