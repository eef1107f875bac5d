# SPDX-License-Identifier: BSD-3-Clause
"""What run_experiments refuses, and what it takes."""
import os
import pathlib
import shutil
import subprocess

import roslib.packages

from bad_input.refusal import PACKAGE, SHARE, TRACKS_HEADER, WORLD, BadInputTest


class RunExperimentsTest(BadInputTest):
    def expect(self, args, *words):
        self.expect_refusal("run_experiments", ["--config", f"{SHARE}/config", *args], *words)

    def test_unknown_world(self):
        self.expect(["--worlds", "atlantis"], "atlantis")

    def test_unknown_profile(self):
        self.expect(["--profile", "atlantis"], "atlantis")

    def test_unknown_planner(self):
        self.expect(["--planners", "3d_magic"], "3d_magic", "2d_fmm")

    def test_negative_pedestrians(self):
        self.expect(["--pedestrians", "-3"], "pedestrians", "-3")

    def test_number_that_is_none(self):
        self.expect(["--seed", "many"], "--seed", "many")

    def test_runs_out_of_range(self):
        self.expect(["--runs", "0"], "--runs", "0")

    def test_unknown_option(self):
        self.expect(["--pedestrian", "3"], "--pedestrian")

    def test_misspelt_key_of_a_profile(self):
        text = (SHARE / "config/profiles/paper.yaml").read_text()
        path = self.write("misspelt.yaml", text + "\nsaerch_time: 1.0\n")
        self.expect(["--profile", path], "saerch_time")

    def test_misspelt_key_of_a_world(self):
        text = pathlib.Path(WORLD).read_text()
        path = self.write("misspelt.yaml", text + "\ngaol: [1.0, 2.0]\n")
        self.expect(["--worlds", path], "gaol")

    def test_world_that_is_no_yaml(self):
        path = self.write("broken.yaml", "bounds: {min: [0.0\n")
        self.expect(["--worlds", path], "broken.yaml")

    def test_missing_tracks_file(self):
        self.expect(["--worlds", "ucy_zara01", "--tracks", "nowhere.csv"], "nowhere.csv")

    def test_missing_tracks_file_leaves_no_output(self):
        path = self.folder / "results.csv"
        self.expect(["--worlds", "ucy_zara01", "--tracks", "nowhere.csv", "--output", str(path)],
                    "nowhere.csv", str(self.folder))
        self.assertFalse(path.exists())

    def test_tracks_without_their_world(self):
        self.expect(["--tracks", self.write("tracks.csv", TRACKS_HEADER + "0.0,1,2.0,3.0\n")],
                    "--tracks", "--worlds")

    def test_world_without_a_way(self):
        text = pathlib.Path(WORLD).read_text() + """
polygons:
  - {closed: false, vertices: [[30.0, 0.0], [30.0, 100.0]]}
"""
        self.expect(["--worlds", self.write("wall.yaml", text)], "wall", "no way to the goal")

    def test_unknown_names_come_with_the_choice(self):
        self.expect(["--worlds", "atlantis"], "atlantis", "scenario_1, scenario_2")
        self.expect(["--profile", "atlantis"], "atlantis", "movo, movo_stock, paper, paper_car, street, tuned")

    def test_names_that_may_have_been_meant(self):
        for args, meant in ((["--worlds", "scenario1"], "'scenario_1'"),
                            (["--profile", "street2"], "'street'"),
                            (["--planners", "2d_fnm"], "'2d_fmm'"),
                            (["--planners", "astar"], "'1d_astar'"),
                            (["--pedestrian", "3"], "'--pedestrians'"),
                            (["--set", "crowd=corner"], "'corners'"),
                            (["--set", "vehicle=cra"], "'car'"),
                            (["--worlds", f"{SHARE}/config/worlds/scenario1.yaml"],
                             "'scenario_1.yaml'")):
            self.expect(args, f"did you mean {meant}?")

    def test_missing_file_with_the_short_ending(self):
        self.expect(["--worlds", "w/mine.yml"], "w/mine.yml: ", str(self.folder))

    def test_config_that_is_no_folder(self):
        self.expect_refusal("run_experiments", ["--config", "nowhere"], "--config", "nowhere")

    def test_numbers_out_of_range(self):
        self.expect(["--seed", "-1"], "--seed", "'-1'")
        self.expect(["--pedestrians", "1e3"], "whole number from 0 to 10000", "'1e3'")
        self.expect(["--max-trials", "0"], "whole number from 1 to 1000000000", "'0'")
        for value in ("0", "-1", "nan", "inf"):
            self.expect(["--search-time", value], "above 0", f"'{value}'")

    def test_profile_that_no_node_would_take(self):
        text = (SHARE / "config/profiles/paper.yaml").read_text()
        fast = text.replace("planner_frequency: 1.0", "planner_frequency: 6.0")
        self.expect(["--profile", self.write("fast.yaml", fast)], "planner_frequency", "6")
        other = text.replace("planner: 2d_fmm", "planner: fmm")
        self.expect(["--profile", self.write("fmm.yaml", other)], "planner", "fmm", "2d_fmm")

    def test_text_in_a_number_column(self):
        path = self.write("tracks.csv", TRACKS_HEADER + "0.0,1,2.0,3.0\n0.4,1,left,3.0\n")
        self.expect(["--worlds", "ucy_zara01", "--tracks", path], "tracks.csv:3", "x_m", "left")

    def test_output_that_cannot_be_written(self):
        self.expect(["--output", "nowhere/results.csv"], "nowhere/results.csv")

    def test_progress_does_not_stick_to_rows_on_a_terminal(self):
        program = roslib.packages.find_node(PACKAGE, "run_experiments")[0]
        args = [program, "--config", f"{SHARE}/config", "--pedestrians", "0", "--max-trials", "1"]
        ours, theirs = os.openpty()
        with os.fdopen(ours), os.fdopen(theirs, "w") as terminal:
            shown = subprocess.run(args, stdin=subprocess.DEVNULL, stdout=terminal,
                                   stderr=subprocess.PIPE, text=True, timeout=30, check=True)
        self.assertNotIn("episodes", shown.stderr)
        piped = self.run_program("run_experiments", *args[1:])
        self.assertIn("1/1 episodes", piped.stderr)

    def test_world_decides_on_the_profile(self):
        result = self.run_program("run_experiments", "--worlds", "ucy_zara01", "scenario_1",
                                  "--pedestrians", "0", "--max-trials", "1")
        self.assertIn("ucy_zara01: with the profile street", result.stderr)
        self.assertNotIn("scenario_1: with", result.stderr)
        street, paper = (row.split(",") for row in result.stdout.splitlines()[1:])
        self.assertLess(float(street[5]), 12.0)
        self.assertGreater(float(paper[5]), 50.0)

    def test_help_is_no_error(self):
        self.assertEqual(self.run_program("run_experiments", "--help").returncode, 0)

    def test_keys_that_are_set(self):
        self.expect(["--set", "saerch/scenarios=5"], "saerch/scenarios", "search/scenarios")
        self.expect(["--set", "search/scenarios=many"], "search/scenarios", "'many'")
        self.expect(["--set", "search/scenarios=0"], "scenarios", "0")
        self.expect(["--set", "search/scenarios"], "KEY=VALUE")
        self.expect(["--set", "planner=2d_fmm"], "--set", "planner=2d_fmm")

    def test_combinations_that_are_named_twice(self):
        self.expect(["--pedestrians", "5", "5"], "--pedestrians: 5 is named twice")
        self.expect(["--worlds", "scenario_1", "scenario_1"], "--worlds", "twice")

    def test_the_profile_has_a_planner(self):
        for profile, planner in (("paper_car", "2d_nhv"), ("paper", "2d_fmm")):
            result = self.run_program("run_experiments", "--config", f"{SHARE}/config", "--profile",
                                      profile, "--pedestrians", "0", "--max-trials", "1")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stdout.splitlines()[1].split(",")[2:5], [planner, "1", "1"])
        self.expect(["--profile", "paper_car", "--planners", "2d_fmm"], "2d_fmm", "2d_nhv")

    def test_worlds_whose_profiles_have_other_planners(self):
        config = self.folder / "config"
        shutil.copytree(f"{SHARE}/config", config)
        street = config / "profiles/street.yaml"
        street.write_text(street.read_text().replace("planner: 2d_fmm", "planner: 2d_prm"))
        self.expect_refusal("run_experiments", ["--config", str(config), "--worlds", "scenario_1",
                                                "ucy_zara01"], "--planners", "2d_fmm", "2d_prm")

    def test_a_blind_planner_may_drive_among_obstacles(self):
        for world in ("scenario_2", "scenario_3"):
            result = self.run_program("run_experiments", "--config", f"{SHARE}/config", "--worlds",
                                      world, "--profile", "paper_car", "--pedestrians", "0",
                                      "--max-trials", "1")
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_other_recorded_people_are_other_settings(self):
        rows = "0.0,1,2.0,3.0\n0.0,10,5.0,5.0\n0.4,1,2.4,3.0\n0.4,10,5.4,5.0\n"
        path = self.write("tracks.csv", TRACKS_HEADER + rows)
        options = ["--worlds", "ucy_zara01", "--tracks", path, "--max-trials", "1", "--output",
                   "r.csv"]
        result = self.run_program("run_experiments", "--config", f"{SHARE}/config", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.write("tracks.csv", TRACKS_HEADER + rows.replace("2.4,3.0", "2.4,3.1"))
        self.expect([*options, "--resume"], "worlds/ucy_zara01/recording")
