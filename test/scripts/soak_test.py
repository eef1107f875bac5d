#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad options of the scripts that break, sanitize, fuzz and time the nodes, and their arithmetic."""
import math
import os
import pathlib
import subprocess
import sys
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True
# pylint: disable-next=wrong-import-position
from soak_harness import blame, figures, memory, stack  # noqa: E402


class RefusalTest(unittest.TestCase):
    def expect(self, script, args, *words, **variables):
        environment = {key: value for key, value in os.environ.items() if key != "PCN_BUILD_DIR"}
        environment.update(variables)
        command = [str(SCRIPTS / script), *args]
        if script.endswith(".py"):
            command.insert(0, sys.executable)
        result = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, timeout=60, check=False,
                                env=environment)
        self.assertEqual(result.returncode, 2, result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        for word in (script + ": ", *words):
            self.assertIn(word, lines[0])

    def test_options_of_both(self):
        for script in ("soak.py", "measure_jitter.py"):
            self.expect(script, ["--people", "many"], "--people", "whole number", "'many'")
            self.expect(script, ["--people", "-1"], "--people", "0 to 10000", "'-1'")
            self.expect(script, ["--seed", "1.5"], "--seed", "'1.5'")
            self.expect(script, ["--world", "atlantis"], "--world", "atlantis", "scenario_1")
            self.expect(script, ["--profile", "atlantis"], "--profile", "atlantis", "tuned")
            self.expect(script, ["--build-dir", "/nowhere"], "--build-dir", "/nowhere")
            self.expect(script, ["--minuets", "3"], "--minuets")

    def test_options_of_one(self):
        for option, value in (("--duration", "nan"), ("--fault-period", "0"), ("--slack", "-1"),
                              ("--goal-timeout", "soon"), ("--max-growth", "inf")):
            self.expect("soak.py", [option, value], option, f"'{value}'")
        self.expect("soak.py", ["--use-sim-time", "maybe"], "--use-sim-time", "maybe")
        self.expect("measure_jitter.py", ["--minutes", "0"], "--minutes", "'0'")
        self.expect("measure_jitter.py", ["--load", "0"], "--load", "'0'")

    def test_screenshots(self):
        self.expect("screenshots.py", ["--at", "0"], "--at", "'0'")
        self.expect("screenshots.py", ["--people", "none"], "--people", "'none'")
        self.expect("screenshots.py", [], "not installed: imagemagick, rviz, xvfb",
                    PATH="/nowhere")

    def test_shell_scripts(self):
        self.expect("sanitize.sh", [], "address or thread")
        self.expect("sanitize.sh", ["memory"], "'memory'", "address or thread")
        self.expect("sanitize.sh", ["thread", "--cores"], "--cores")
        self.expect("sanitize.sh", ["thread", "--core", "true"], "--core", "'true'")
        self.expect("sanitize.sh", ["thread", "--rostests", "true"], "--rostests", "'true'")
        self.expect("fuzz.sh", ["worlds"], "'worlds'", "world_file", "tracks_csv", "conversions")
        self.expect("fuzz.sh", ["--seconds", "0"], "--seconds", "'0'")
        self.expect("fuzz.sh", ["--second", "1"], "--second")


class FiguresTest(unittest.TestCase):
    def test_percentiles(self):
        values = list(range(100, 0, -1))
        self.assertEqual(figures.percentile(values, 0.5), 50)
        self.assertEqual(figures.percentile(values, 0.99), 99)
        self.assertEqual(figures.percentile([7.0], 0.99), 7.0)
        self.assertTrue(math.isnan(figures.percentile([], 0.5)))

    def test_series_share_a_slope_and_not_their_height(self):
        series = [[(t, 2.0 * t + 5.0) for t in range(10)], [(t, 2.0 * t - 90.0) for t in range(20, 25)]]
        slope, error = figures.common_slope(series)
        self.assertAlmostEqual(slope, 2.0)
        self.assertAlmostEqual(error, 0.0)
        self.assertTrue(math.isnan(figures.common_slope([[(0.0, 1.0)]])[0]))

    def test_error_of_a_slope(self):
        slope, error = figures.common_slope([[(0, 0.0), (1, 1.0), (2, 0.0), (3, 1.0)]])
        self.assertAlmostEqual(slope, 0.2)
        self.assertAlmostEqual(error, math.sqrt(0.8 / 2 / 5))


class BlameTest(unittest.TestCase):
    AHEAD, ASIDE = (1.0, 0.0, 0.0, 0.0), (0.0, 0.9, 0.0, -1.0)

    def cause(self, people, speed=1.0, since_put=math.inf):
        return blame.blame((0.0, 0.0), (speed, 0.0), people, since_put)["cause"]

    def test_who_drives_at_somebody_has_caused_it(self):
        self.assertEqual(self.cause([self.AHEAD]), "robot")
        self.assertTrue(blame.is_violation("robot"))

    def test_who_walks_up_to_the_robot_has_caused_it(self):
        self.assertEqual(self.cause([self.AHEAD, self.ASIDE]), "person")
        self.assertEqual(self.cause([self.AHEAD], speed=-0.5), "person")
        self.assertFalse(blame.is_violation("person"))

    def test_nobody_has_where_the_robot_has_just_been_put(self):
        self.assertEqual(self.cause([self.AHEAD], since_put=1.0), "put there")
        self.assertEqual(self.cause([self.AHEAD], since_put=2.0), "robot")
        self.assertFalse(blame.is_violation("put there"))

    def test_what_cannot_be_known_counts(self):
        self.assertTrue(blame.is_violation(self.cause([])))


class MemoryTest(unittest.TestCase):
    def grown(self, mb_per_hour):
        watched = memory.Memory(warm_up=100.0)
        watched.series[("node", 1)] = [
            (10.0 * i, 50.0 + (500.0 if i < 10 else 0.0) + mb_per_hour * i / 360.0)
            for i in range(200)]
        return watched.growth()["node"]

    def test_a_leak_is_found_and_the_warm_up_is_not_one(self):
        leak = self.grown(30.0)
        self.assertAlmostEqual(leak["slope_mb_per_h"], 30.0, places=6)
        self.assertEqual(memory.Memory.verdict(leak, 10.0), "grows")
        self.assertEqual(memory.Memory.verdict(self.grown(0.0), 10.0), "flat")

    def test_what_the_error_or_a_short_time_leaves_open_is_undecided(self):
        figures_of = {"slope_mb_per_h": 9.0, "error_mb_per_h": 1.0, "span_s": 3000.0}
        self.assertEqual(memory.Memory.verdict(figures_of, 10.0), "undecided")
        self.assertEqual(memory.Memory.verdict({**figures_of, "slope_mb_per_h": 12.5}, 10.0), "grows")
        self.assertEqual(memory.Memory.verdict({**figures_of, "slope_mb_per_h": 11.5}, 10.0),
                         "undecided")
        self.assertEqual(memory.Memory.verdict({**figures_of, "slope_mb_per_h": 7.5}, 10.0), "flat")
        short = {"slope_mb_per_h": 900.0, "error_mb_per_h": 0.0, "span_s": 500.0}
        self.assertEqual(memory.Memory.verdict(short, 10.0), "undecided")

    def test_of_a_process_that_lives(self):
        self.assertGreater(memory.resident(os.getpid()), 1.0)
        self.assertTrue(math.isnan(memory.resident(2 ** 30)))


class DeathsTest(unittest.TestCase):
    def test_who_was_killed_has_not_died(self):
        expected = {"planner": 1, "guard": 2}
        self.assertEqual(stack.deaths(expected, {"guard": 2}, {1}), [])
        self.assertEqual(stack.deaths(expected, {"planner": 3, "guard": 2}, {1}), [])
        self.assertEqual(expected, {"planner": 3, "guard": 2})

    def test_a_kill_that_is_not_seen_at_once_is_no_death_later(self):
        expected = {}
        self.assertEqual(stack.deaths(expected, {"planner": 1}, {1}), [])  # still in the list
        self.assertEqual(stack.deaths(expected, {}, {1}), [])

    def test_a_death_is_told_once(self):
        expected = {"planner": 1}
        self.assertEqual(stack.deaths(expected, {"planner": 2}, set()), ["planner"])
        self.assertEqual(stack.deaths(expected, {"planner": 2}, set()), [])
        self.assertEqual(stack.deaths(expected, {}, set()), ["planner"])
        self.assertEqual(stack.deaths(expected, {}, set()), [])


if __name__ == "__main__":
    unittest.main()
