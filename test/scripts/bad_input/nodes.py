# SPDX-License-Identifier: BSD-3-Clause
"""Nodes, which read the parameter server."""
import os
import subprocess

from bad_input.refusal import PACKAGE, SHARE, TRACKS_HEADER, WORLD, BadInputTest


class NodesTest(BadInputTest):
    def test_arguments_that_are_no_parameters(self):
        for node in ("sim_node", "planner_node", "velocity_guard", "tractor_mode"):
            self.expect_refusal(node, ["world_file"], "world_file", "_NAME:=VALUE")
            for option in ("--help", "-h"):
                result = self.run_program(node, option, ROS_MASTER_URI="http://127.0.0.1:1")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(f"usage: rosrun {PACKAGE} {node}", result.stdout)

    def test_sim_node_without_a_world_of_that_name(self):
        self.expect_node_refusal("sim_node", {"world_file": "atlantis.yaml"}, "atlantis.yaml")

    def test_sim_node_with_a_field_too_large_to_draw(self):
        path = self.write("large.yaml", "bounds: {min: [0, 0], max: [1e5, 1e5]}\n"
                          "start: [1, 1, 0]\ngoal: [9, 9]\ndestinations: [[0, 0]]\n")
        self.expect_node_refusal("sim_node", {"world_file": path}, "resolution", "cells")

    def test_sim_node_with_negative_pedestrians(self):
        self.expect_node_refusal("sim_node", {"world_file": WORLD, "pedestrians": -3},
                                 "pedestrians", "-3")

    def test_nodes_with_a_negative_seed(self):
        self.expect_node_refusal("sim_node", {"world_file": WORLD, "seed": -1}, "seed", "-1")
        self.expect_node_refusal("planner_node", {"world_file": WORLD, "seed": -1}, "seed", "-1")

    def test_sim_node_with_a_text_for_a_number(self):
        self.expect_node_refusal("sim_node", {"world_file": WORLD, "pedestrians": "many"},
                                 "pedestrians")

    def test_sim_node_with_a_text_in_a_number_column(self):
        path = self.write("tracks.csv", TRACKS_HEADER + "0.0,1,2.0,north\n")
        self.expect_node_refusal(
            "sim_node",
            {"world_file": f"{SHARE}/config/worlds/ucy_zara01.yaml", "tracks_file": path},
            "tracks.csv:2", "y_m", "north")

    def test_sim_node_with_a_misspelt_key(self):
        self.expect_node_refusal("sim_node", {"world_file": WORLD, "pedestrain": 3}, "pedestrain")

    def test_planner_node_with_a_misspelt_key(self):
        self.expect_node_refusal("planner_node", {"world_file": WORLD, "saerch_time": 1.0},
                                 "saerch_time")

    def test_velocity_guard_with_a_misspelt_key(self):
        self.expect_node_refusal("velocity_guard", {"guard": {"margn": 0.3}}, "guard/margn")

    def test_velocity_guard_with_a_value_out_of_range(self):
        self.expect_node_refusal("velocity_guard", {"guard": {"frequency": 5.0}},
                                 "guard/frequency", "20", "5")

    def test_planner_node_with_an_unknown_planner(self):
        self.expect_node_refusal("planner_node", {"world_file": WORLD, "planner": "3d_magic"},
                                 "3d_magic", "2d_fmm")
        self.expect_node_refusal("planner_node", {"world_file": WORLD, "planner": "2d_fnm"},
                                 "did you mean '2d_fmm'?")

    def test_planner_node_without_a_world_of_that_name(self):
        self.expect_node_refusal("planner_node", {"world_file": "atlantis.yaml"}, "atlantis.yaml")

    def test_roslaunch_shows_the_reason_and_ends(self):
        result = subprocess.run(
            ["roslaunch", PACKAGE, "simulation.launch", "world:=atlantis", "rviz:=false"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            timeout=60, check=False, env={**os.environ, "PATH": "/usr/bin:" + os.environ["PATH"]})
        # What the launcher itself prints may stand in front of it in the line.
        self.assertRegex(result.stdout, r"sim_node: .*atlantis")
        self.assertIn("exit code 2", result.stdout)
