#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests scripts/fault_matrix.py, and that doc/safety.md has a row for every fault that is tested.

A test injects a fault through expectRest or expectDriveOn of test/system/fault_probe.h, with the
row's name and bound as literals.
"""
import importlib.util
import pathlib
import re
import unittest

from surroundings import FolderTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CALL = re.compile(r"\bexpect(?:Rest|DriveOn)\(\s*(?:Fault)?\{(.*?)\}", re.S)
LITERALS = re.compile(r'((?:"[^"]*"\s*)+),\s*([0-9.]+)\s*', re.S)


def load_script():
    spec = importlib.util.spec_from_file_location("fault_matrix",
                                                  ROOT / "scripts/fault_matrix.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


fault_matrix = load_script()

DOCUMENT = """# Safety

| layer | where |
|---|---|
| planner | here |

| fault | injected how | reaction | bound [s] | measured [s] |
|---|---|---|---|---|
| odometry silent | not published | brakes | 1.8 | |
| people silent | not published | brakes | 2.3 | 2.00 |

text
"""

RESULTS = """<?xml version="1.0"?>
<testsuites><testsuite name="InputsTest">
  <testcase name="A" {attributes}>{element}</testcase>
  <testcase name="B"/>
</testsuite></testsuites>
"""
AS_ELEMENT = ('<properties><property name="fault" value="odometry silent"/>'
              '<property name="bound_s" value="1.80"/>'
              '<property name="rest_s" value="1.23"/></properties>')
AS_ATTRIBUTES = 'fault="odometry silent" bound_s="1.80" rest_s="1.23"'


class FaultMatrixTest(FolderTest):
    def setUp(self):
        super().setUp()
        self.results = self.folder / "results/package"
        self.results.mkdir(parents=True)
        self.document = self.folder / "safety.md"
        self.document.write_text(DOCUMENT)

    def run_script(self, attributes="", element=""):
        (self.results / "rosunit-inputs.xml").write_text(
            RESULTS.format(attributes=attributes, element=element))
        return fault_matrix.main([str(self.folder / "results"), str(self.document)])

    def test_writes_the_measured_cell_and_nothing_else(self):
        for kinds in ({"element": AS_ELEMENT}, {"attributes": AS_ATTRIBUTES}):
            self.document.write_text(DOCUMENT)
            self.assertEqual(self.run_script(**kinds), 0)
            self.assertEqual(self.document.read_text(),
                             DOCUMENT.replace("| 1.8 | |", "| 1.8 | 1.23 |"))

    def test_another_bound_is_a_problem(self):
        self.assertEqual(self.run_script(element=AS_ELEMENT.replace("1.80", "9.00")), 1)

    def test_a_result_without_a_row_is_a_problem(self):
        self.assertEqual(self.run_script(element=AS_ELEMENT.replace("silent", "loud")), 1)

    def test_nothing_measured_is_a_bad_argument(self):
        self.assertEqual(self.run_script(), 2)
        self.assertEqual(fault_matrix.main([str(self.folder / "nowhere")]), 2)
        self.assertEqual(fault_matrix.main([]), 2)
        self.assertEqual(self.document.read_text(), DOCUMENT)

    def test_a_row_with_a_cell_too_many_is_a_bad_file(self):
        self.document.write_text(DOCUMENT.replace("| 2.00 |", "| 2.00 | 3 |"))
        self.assertEqual(self.run_script(element=AS_ELEMENT), 2)


def tested_faults():
    """[(name, bound)] of all calls in the sources of the tests, bound as text."""
    for path in sorted((ROOT / "test").rglob("*.cpp")):
        for arguments in CALL.findall(path.read_text()):
            literals = LITERALS.fullmatch(arguments.strip())
            if not literals:
                raise AssertionError(f"{path.name}: name and bound must be literals: {arguments}")
            yield "".join(re.findall(r'"([^"]*)"', literals[1])), float(literals[2])


class SafetyDocumentTest(unittest.TestCase):
    def test_rows_and_tests_are_the_same(self):
        text = (ROOT / "doc/safety.md").read_text()
        rows = [(row["fault"], float(row["bound [s]"])) for _, row in fault_matrix.rows_of(text)]
        self.assertEqual(len(rows), len({name for name, _ in rows}), "a row is there twice")
        self.assertEqual(sorted(rows), sorted(tested_faults()))

    def test_tests_that_rows_name_are_there(self):
        named = re.findall(r"`(\w+)\.(test_\w+)`", (ROOT / "doc/safety.md").read_text())
        self.assertGreaterEqual(len(named), 4)
        sources = "\n".join(path.read_text() for path in (ROOT / "test/scripts").rglob("*.py"))
        for case, name in named:
            self.assertRegex(sources, rf"class {case}\(")
            self.assertIn(f"def {name}(self)", sources)

    def test_no_row_was_measured_over_its_bound(self):
        for _, row in fault_matrix.rows_of((ROOT / "doc/safety.md").read_text()):
            if row["measured [s]"]:
                self.assertLessEqual(float(row["measured [s]"]), float(row["bound [s]"]),
                                     row["fault"])


if __name__ == "__main__":
    unittest.main()
