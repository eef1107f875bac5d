#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""demo.sh says why a trip ends with status 1, and its long steps show at once that they go on.

Nothing is installed, built or started: stubs stand for all of that.
"""
import os
import pathlib
import pty
import shutil
import subprocess
import unittest

from surroundings import SOURCE, FolderTest

INSTALL = SOURCE / "scripts/install_dependencies.sh"
STUBS = f"""
. '{INSTALL}'
install_missing() {{ :; }}
build() {{ :; }}
"""
SUMMARY = ("goal_reached={} travel_time_s=61.5 min_moving_distance_m={} unsafe_steps={} "
           "sudden_brakes=2 decisions=124 deadline_misses=0")


class TripTest(FolderTest):
    """With what the trip prints in the place of roslaunch."""

    def setUp(self):
        super().setUp()
        (self.folder / "scripts").mkdir()
        (self.folder / "build/devel").mkdir(parents=True)
        shutil.copy(SOURCE / "scripts/demo.sh", self.folder / "scripts")
        self.write("scripts/install_dependencies.sh", STUBS)

    def drive(self, *lines):
        text = "\n".join(lines)
        self.write("build/devel/setup.bash", f"roslaunch() {{ printf '%s\\n' '{text}'; }}")
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("DISPLAY", "PCN_BUILD_DIR")}
        return subprocess.run(["bash", self.folder / "scripts/demo.sh"], env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=60, check=False)

    def expect_reason(self, summary, *words, without=()):
        result = self.drive("send_goal: SUCCEEDED, goal reached", summary, "roslaunch: done")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(result.stdout, summary + "\n")
        reason = result.stderr.splitlines()[-1]
        self.assertTrue(reason.startswith("demo.sh: exit status 1: "), reason)
        for word in words:
            self.assertIn(word, reason)
        for word in without:
            self.assertNotIn(word, reason)

    def test_a_good_trip_needs_no_reason(self):
        result = self.drive(SUMMARY.format("true", "1.02", 0))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, SUMMARY.format("true", "1.02", 0) + "\n")
        self.assertNotIn("exit status", result.stderr)

    def test_somebody_came_too_close(self):
        self.expect_reason(SUMMARY.format("true", "0.83", 12), "within 1 m", "0.83 m", "12",
                           without=["goal"])

    def test_the_goal_was_not_reached(self):
        self.expect_reason(SUMMARY.format("false", "1.50", 0), "the goal was not reached",
                           without=["within 1 m"])
        self.expect_reason(SUMMARY.format("false", "0.50", 1), "the goal was not reached",
                           "within 1 m")

    def test_nothing_is_known_of_people(self):
        self.expect_reason(SUMMARY.format("true", "nan", "nan"), "how near people came",
                           without=["within 1 m"])

    def test_a_trip_without_an_end(self):
        result = self.drive("roslaunch: something broke")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.splitlines()[-1],
                         "demo.sh: the trip did not come to its end")


class ProgressTest(FolderTest):
    def step(self, seconds, stderr):
        log = self.folder / "log"
        script = (f". '{INSTALL}'; trap stop_heartbeat EXIT; "
                  f"run_step '[1/1] working' '{log}' sh -c 'echo half way; sleep {seconds}'; "
                  "say finished")
        return subprocess.Popen(["bash", "-c", script], stdin=subprocess.DEVNULL, stderr=stderr)

    def test_a_line_after_a_few_seconds(self):
        with self.step(8, subprocess.PIPE) as process:
            lines = process.stderr.read().decode().splitlines()
        self.assertEqual(process.returncode, 0)
        self.assertEqual((lines[0], lines[-1]), ("[1/1] working", "finished"))
        self.assertEqual(len(lines), 3, lines)
        self.assertRegex(lines[1], r"^      [3-8] s: half way$")

    def test_one_line_of_a_terminal(self):
        terminal, end = pty.openpty()
        with self.step(6, end) as process:
            os.close(end)
            shown = self.read_all(terminal)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(shown, r"\r\x1b\[K      [1-6] s: half way")
        self.assertEqual(shown.count("\n"), 2, shown)
        self.assertTrue(shown.endswith("\r\x1b[Kfinished\r\n"), shown)

    @staticmethod
    def read_all(terminal):
        found = b""
        try:
            while piece := os.read(terminal, 4096):
                found += piece
        except OSError:  # nobody holds its other end any more
            pass
        os.close(terminal)
        return found.decode()


if __name__ == "__main__":
    unittest.main()
