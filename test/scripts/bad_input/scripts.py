# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of the source tree, and launch files."""
import re
import subprocess
import unittest

from bad_input.refusal import PACKAGE, SHARE, TRACKS_HEADER, BadInputTest


class DemoTest(BadInputTest):
    def expect(self, args, *words):
        result = subprocess.run([f"{SHARE}/scripts/demo.sh", *args], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, timeout=30, check=False)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_tracks_without_their_world(self):
        self.expect(["--tracks", self.write("t.csv", TRACKS_HEADER)], "--tracks needs --world")

    def test_unknown_world(self):
        self.expect(["--world", "atlantis"], "atlantis", "scenario_1 scenario_2")
        self.expect(["--world", "scenario1"], "did you mean 'scenario_1'?")
        self.expect(["--world", "./atlantis.yaml"], "./atlantis.yaml", "cannot be read")


    def test_unknown_planner_and_option(self):
        self.expect(["--planner", "2d_fnm"], "'2d_fnm'", "1d_astar", "did you mean '2d_fmm'?")
        self.expect(["--pedestrian", "3"], "did you mean '--pedestrians'?")


class TestScriptTest(unittest.TestCase):
    def test_help_counts_nothing(self):
        result = subprocess.run([f"{SHARE}/scripts/test.sh", "--help"], stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                timeout=30, check=True)
        self.assertIn("UCY_DATA_DIR", result.stdout)
        self.assertNotIn("1 failed", result.stdout)


class LaunchTest(unittest.TestCase):
    """What simulation.launch makes of its arguments; needs no master."""

    def roslaunch(self, *args):
        result = subprocess.run(["roslaunch", *args], stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                timeout=60, check=True)
        return result.stdout

    def params(self, *args):
        return self.roslaunch("--dump-params", PACKAGE, "simulation.launch", *args)

    def test_world_of_ones_own(self):
        params = self.params("world_file:=/home/robot/my worlds/yard.yaml")
        for node in ("sim_node", "planner_node"):
            self.assertIn(f"/{node}/world_file: /home/robot/my worlds/yard.yaml", params)
        self.assertIn("/sim_node/robot_radius: 0.3", params, "the profile street")

    def test_defaults(self):
        params = self.params()
        self.assertRegex(params, r"/sim_node/world_file: \S+/config/worlds/scenario_1.yaml")
        self.assertIn("/sim_node/robot_radius: 1.0", params, "the profile paper")
        self.assertIn("/sim_node/tracks_file: ''", params)
        self.assertIn("/sim_node/tracks_file: /x.csv", self.params("tracks:=/x.csv"))

    def test_planner(self):
        def planner(*args):
            found = re.search(r"^/planner_node/planner: (\w+)$", self.params(*args), re.MULTILINE)
            return found.group(1)
        self.assertEqual(planner(), "2d_fmm")
        self.assertEqual(planner("world:=ucy_zara01"), "2d_fmm")
        self.assertEqual(planner("planner:=2d_prm"), "2d_prm")
        self.assertEqual(planner("profile:=paper_car"), "2d_nhv")
        self.assertEqual(planner("profile:=paper_car", "world:=scenario_2"), "2d_nhv_fm2")
        self.assertEqual(planner("profile:=paper_car", "world:=scenario_2", "planner:=1d_astar"),
                         "1d_astar")

    def test_goal(self):
        def command(*args):
            return self.roslaunch("--args", "send_goal", PACKAGE, "simulation.launch", *args)
        self.assertIn("--x=world --y=world", command())
        self.assertIn("--x=-3 --y=7.5", command("goal_x:=-3", "goal_y:=7.5"))

    def test_every_argument_is_optional_and_explained(self):
        for launch in ("simulation.launch", "movo.launch"):
            text = self.roslaunch("--ros-args", PACKAGE, launch)
            self.assertNotIn("Required", text)
            self.assertNotIn("undocumented", text)
