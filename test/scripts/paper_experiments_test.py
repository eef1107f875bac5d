#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""paper_experiments.sh refuses bad arguments, and goes on where it ended; with stubs as its tools."""
import pathlib
import subprocess
import unittest

from surroundings import FolderTest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/paper_experiments.sh"
TOOLS = ("run_experiments", "omniscient_bound", "report_experiments", "export_decision")
# Notes its arguments, fills the file after --output, and fails where a file says so.
STUB = """#!/bin/sh
name=$(basename "$0")
echo "$name $*" >>"$(dirname "$0")/calls"
[ "$(cat "$(dirname "$0")/fails" 2>/dev/null)" != "$name" ] || exit 3
while [ $# -gt 0 ]; do [ "$1" != --output ] || echo x >"$2"; shift; done
"""


class PaperExperimentsTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        for name in TOOLS:
            (self.tools / name).write_text(STUB)
            (self.tools / name).chmod(0o755)

    def run_script(self, *args):
        return subprocess.run(["bash", str(SCRIPT), *args], cwd=self.folder, check=False,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=60)

    def calls(self):
        path = self.tools / "calls"
        lines = path.read_text().splitlines() if path.exists() else []
        path.unlink(missing_ok=True)
        return lines

    def expect_refusal(self, args, *words):
        result = self.run_script(*args)
        self.assertEqual(result.returncode, 2, result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("paper_experiments.sh: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(self.calls(), [])

    def test_arguments(self):
        tools = ("--tools", str(self.tools))
        self.expect_refusal([], "OUTPUT_DIR")
        self.expect_refusal(["out", "more", *tools], "'more'")
        self.expect_refusal(["out", "--runs"], "--runs needs a value")
        for option in ("--runs", "--max-trials", "--jobs"):
            for value in ("0", "-1", "many", "1.5"):
                self.expect_refusal(["out", option, value, *tools], option, f"'{value}'")
        self.expect_refusal(["out", "--trial", "3"], "'--trial'")
        self.expect_refusal(["out", "--tools", "nowhere"], "nowhere/run_experiments")
        (self.tools / "export_decision").unlink()
        self.expect_refusal(["out", *tools], "export_decision")
        self.assertFalse((self.folder / "out").exists())
        self.assertIn("usage:", self.run_script("--help").stdout)

    def test_what_it_runs_and_how_it_goes_on(self):
        args = ("out", "--tools", str(self.tools), "--runs", "2", "--jobs", "1")
        fails = self.tools / "fails"
        fails.write_text("omniscient_bound")
        self.assertEqual(self.run_script(*args).returncode, 3)
        first = self.calls()
        self.assertEqual([call.split()[0] for call in first],
                         ["run_experiments"] * 7 + ["omniscient_bound"])
        for call in first[:7]:
            for words in ("--runs 2", "--jobs 1", "--resume"):
                self.assertIn(words, call)
        fails.write_text("report_experiments")
        self.assertEqual(self.run_script(*args).returncode, 3)
        second = self.calls()
        self.assertEqual(second[:7], first[:7], "the tool itself leaves out what is there")
        self.assertEqual([call.split()[0] for call in second[7:]],
                         ["omniscient_bound"] * 2 + ["report_experiments"])
        self.assertFalse((self.folder / "out/report.md").exists(), "no half report")
        self.assertEqual(self.run_script(*args).returncode, 3)
        self.assertEqual([call.split()[0] for call in self.calls()[7:]], ["report_experiments"],
                         "bounds that are there are kept")


if __name__ == "__main__":
    unittest.main()
