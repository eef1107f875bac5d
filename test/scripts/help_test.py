#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""--help of every tool and script teaches: help_test.py SOURCE_DIR FOLDER_OF_PROGRAMS

It says what the program is for, its options with their defaults, an example, and the exit status.
"""
import pathlib
import re
import subprocess
import sys


def help_of(command):
    result = subprocess.run([*command, "--help"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, timeout=60, check=False)
    return result.stdout if result.returncode == 0 else f"(status {result.returncode})"


def problems_of(name, text, is_tool, options):
    missing = [what for what, pattern in (
        ("its exit status", r"[Ee]xit status|Exits with"),
        ("an example", rf"Example|^\s+(scripts/)?{re.escape(name)} |usage: scripts/{name}"))
               if not re.search(pattern, text, re.M)]
    missing += [option for option in options if option not in text]
    if is_tool and max(len(line) for line in text.splitlines()) > 160:
        missing.append("shorter lines")
    return [f"{name} --help lacks {what}" for what in missing]


def main(source, programs):
    problems, count = [], 0
    for path in sorted((source / "src/tools").glob("*.cpp")):
        if not (programs / path.stem).exists():
            continue  # without CLI11
        options = re.findall(r'add_(?:option|flag)\(\s*"(--[\w-]+)"', path.read_text())
        problems += problems_of(path.stem, help_of([programs / path.stem]), True, options)
        count += 1
    for path in sorted((source / "scripts").glob("*")):
        if path.suffix not in (".py", ".sh"):
            continue
        program = [sys.executable] if path.suffix == ".py" else ["bash"]
        text = path.read_text()
        options = [] if "add_subparsers" in text else \
            re.findall(r'add_argument\("(--[\w-]+)"', text)
        problems += problems_of(path.name, help_of([*program, path]), False, options)
        count += 1
    print("\n".join(problems) or f"{count} programs explain themselves")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:3])))
