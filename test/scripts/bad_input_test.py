#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input ends a program at once: one line on standard error, exit status 2.

Run by rostest, which starts the master that the nodes need.
"""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import roslib.packages
import rosunit
import yaml

PACKAGE = "pomdp_crowd_nav"
SHARE = pathlib.Path(__file__).resolve().parents[2]
WORLD = f"{SHARE}/config/worlds/scenario_1.yaml"
TRACKS_HEADER = "time_s,ped_id,x_m,y_m\n"


class BadInputTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def run_program(self, name, *args, **environment):
        program = roslib.packages.find_node(PACKAGE, name)[0]
        return subprocess.run([program, *args], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=60, check=False, env={**os.environ, **environment})

    def expect_refusal(self, name, args, *words):
        result = self.run_program(name, *args)
        self.assertEqual(result.returncode, 2, result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith(name + ": "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])

    # A node reads the parameters of its own name.
    def expect_node_refusal(self, node, params, *words):
        master = rosgraph.Master(self.id())
        name = f"/{node}_{self._testMethodName}"
        for key, value in params.items():
            master.setParam(f"{name}/{key}", value)
        self.addCleanup(master.deleteParam, name)
        self.expect_refusal(node, [f"__name:={name[1:]}"], *words)


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
        self.expect(["--profile", "atlantis"], "atlantis", "movo, paper, paper_car, street, tuned")

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

    def test_files_that_cannot_be_resumed(self):
        self.expect(["--resume"], "--output")
        self.expect(["--trails", "t.csv"], "--output")
        path = self.write("old.csv", "world,seed\nscenario_1,1\n")
        self.expect(["--output", path], "old.csv", "--resume")
        self.expect(["--output", path, "--resume"], "old.csv.settings.json")

    def options(self, output, *more):
        return ["--config", f"{SHARE}/config", "--pedestrians", "20", "--runs", "6",
                "--max-trials", "3", "--output", output, *more]

    @staticmethod
    def timeless(text):
        """Rows without the times that the search took."""
        return [row.split(",")[:11] + row.split(",")[13:] for row in text.splitlines()]

    def begin(self, options, **how):
        """The program under way, once it has written a row."""
        program = roslib.packages.find_node(PACKAGE, "run_experiments")[0]
        path = self.folder / options[options.index("--output") + 1]

        def count():
            files = [path, path.with_name(path.name + ".ahead")]
            return sum(max(0, file.read_text().count("\n") - 1) for file in files if file.exists())
        before = count()
        run = subprocess.Popen([program, *options], cwd=self.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **how)
        give_up = time.monotonic() + 60.0
        while count() <= before and time.monotonic() < give_up and run.poll() is None:
            time.sleep(0.005)
        return run

    def test_killed_and_resumed_it_writes_the_same(self):
        whole_options = self.options("whole.csv", "--trails", "whole_t.csv")
        options = self.options("killed.csv", "--trails", "killed_t.csv", "--resume")
        for some in (whole_options, options):
            some[some.index("6")] = "16"
        self.run_program("run_experiments", *whole_options)
        whole = (self.folder / "whole.csv").read_text()
        for _ in range(3):
            run = self.begin(options)
            run.kill()
            run.communicate()
            self.assertEqual(run.returncode, -signal.SIGKILL, "it was under way")
            self.assertLess((self.folder / "killed.csv").read_text().count("\n"), 17, "and not done")
        result = self.run_program("run_experiments", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.timeless((self.folder / "killed.csv").read_text()),
                         self.timeless(whole))
        self.assertEqual((self.folder / "killed_t.csv").read_text(),
                         (self.folder / "whole_t.csv").read_text())
        self.assertEqual(sorted(path.name for path in self.folder.glob("*.ahead")), [])
        self.expect([*options[2:], "--set", "search/scenarios=50"], "search/scenarios",
                    '"100"', '"50"')

    def test_interrupted_it_says_how_to_go_on(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            options = self.options(f"{status}.csv")
            options[options.index("6")] = "500"
            run = self.begin(options)
            run.send_signal(number)
            shown = run.communicate(timeout=30)[1]
            self.assertEqual(run.returncode, status, shown)
            self.assertRegex(shown, r"interrupted after \d+ of 500 episodes; .*--resume")

    def test_signals_that_are_ignored_stay_ignored(self):
        run = self.begin(self.options("results.csv"), preexec_fn=lambda: [
            signal.signal(number, signal.SIG_IGN) for number in (signal.SIGHUP, signal.SIGINT)])
        run.send_signal(signal.SIGHUP)
        run.send_signal(signal.SIGINT)
        shown = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 0, shown)
        self.assertEqual((self.folder / "results.csv").read_text().count("\n"), 7)

    def test_jobs_change_nothing(self):
        files = []
        for jobs in ("1", "4"):
            options = self.options(f"{jobs}.csv", "--trails", f"{jobs}_t.csv", "--jobs", jobs,
                                   "--planners", "1d_astar", "2d_prm", "2d_fmm")
            options[options.index("6")] = "2"
            result = self.run_program("run_experiments", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            files.append((self.timeless((self.folder / f"{jobs}.csv").read_text()),
                          (self.folder / f"{jobs}_t.csv").read_text()))
        self.assertEqual(files[0], files[1])
        self.assertEqual(len(files[0][0]), 7)

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


class OmniscientBoundTest(BadInputTest):
    def expect(self, args, *words):
        self.expect_refusal("omniscient_bound", ["--config", f"{SHARE}/config", *args], *words)

    def test_names_and_numbers(self):
        self.expect(["--worlds", "atlantis"], "atlantis", "scenario_1")
        self.expect(["--profile", "atlantis"], "atlantis")
        self.expect(["--pedestrians", "-3"], "--pedestrians", "-3")
        self.expect(["--runs", "0"], "--runs", "'0'")

    def test_output_that_is_there(self):
        self.expect(["--output", self.write("bounds.csv", "")], "bounds.csv", "it exists")

    def test_combinations_that_are_named_twice(self):
        self.expect(["--pedestrians", "100", "100"], "--pedestrians: 100 is named twice")
        self.expect(["--worlds", "scenario_1", "scenario_1"], "--worlds", "twice")

    def test_jobs_change_nothing(self):
        rows = [self.run_program("omniscient_bound", "--config", f"{SHARE}/config", "--pedestrians",
                                 "20", "50", "--runs", "3", "--jobs", jobs).stdout.splitlines()
                for jobs in ("1", "4")]
        self.assertEqual(rows[0], rows[1])
        self.assertEqual([row.split(",")[1:3] for row in rows[0][1:]],
                         [[people, seed] for people in ("20", "50") for seed in "123"])

    def test_world_without_a_way(self):
        text = pathlib.Path(WORLD).read_text() + """
polygons:
  - {closed: false, vertices: [[30.0, 0.0], [30.0, 100.0]]}
"""
        self.expect(["--worlds", self.write("wall.yaml", text)], "wall", "no way to the goal")


class ExportDecisionTest(BadInputTest):
    def expect(self, args, *words):
        self.expect_refusal("export_decision", ["--config", f"{SHARE}/config", *args], *words)

    def test_names_and_numbers(self):
        self.expect(["--world", "atlantis"], "atlantis", "scenario_1")
        self.expect(["--planner", "3d_magic"], "3d_magic")
        self.expect(["--step", "0"], "--step", "'0'")
        self.expect(["--set", "saerch/scenarios=5"], "saerch/scenarios")

    def test_decision_after_the_end(self):
        self.expect(["--pedestrians", "0", "--max-trials", "1", "--step", "500"], "--step", "500")

    def test_what_is_written(self):
        result = self.run_program("export_decision", "--config", f"{SHARE}/config", "--step", "2",
                                  "--max-trials", "20")
        self.assertEqual(result.returncode, 0, result.stderr)
        decision = json.loads(result.stdout)
        self.assertGreater(len(decision["tree"]), 5)
        self.assertEqual(sum(person["attended"] for person in decision["people"]), 6)
        self.assertEqual(decision["tree"][0]["from"], decision["robot"]["position"])
        self.assertTrue(decision["rollouts"])


class ReportExperimentsTest(BadInputTest):
    def expect(self, args, *words):
        self.expect_refusal("report_experiments",
                            ["--paper", f"{SHARE}/config/paper_results.yaml", *args], *words)

    def test_nothing_to_report(self):
        self.expect([], "results")
        self.expect(["nowhere.csv"], "nowhere.csv")

    def test_file_of_something_else(self):
        self.expect([self.write("tracks.csv", TRACKS_HEADER)], "tracks.csv:2", "row")
        self.expect([self.write("tracks.csv", TRACKS_HEADER + "0,1,2,3\n")], "tracks.csv:1",
                    "'world'")

    def test_bounds_that_are_none(self):
        self.run_program("run_experiments", "--config", f"{SHARE}/config", "--pedestrians", "0",
                         "--max-trials", "1", "--output", "results.csv")
        header = "world,pedestrians,seed,max_speed_mps,bound_s,free_drive_s\n"
        for text, *words in (("", "b.csv:1"), (header, "b.csv:2", "row"),
                             (header + "w,1,1,2,soon,9\n", "b.csv:2", "bound_s", "'soon'"),
                             (header + "w,1,1,2,9,-1\n", "b.csv:2", "free_drive_s"),
                             ("world,seed\nw,1\n", "b.csv:1", "'pedestrians'")):
            self.expect(["results.csv", "--bound", self.write("b.csv", text)], *words)
        self.expect(["results.csv", "--bound", "nowhere.csv"], "nowhere.csv")

    def test_paper_that_is_none(self):
        self.run_program("run_experiments", "--config", f"{SHARE}/config", "--pedestrians", "0",
                         "--max-trials", "1", "--output", "results.csv")
        result = self.run_program("report_experiments", "results.csv")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("1 of 1 episodes arrived", result.stdout)
        self.expect_refusal("report_experiments",
                            ["results.csv", "--paper", self.write("p.yaml", "a: {b: [[1, 2]]}\n")],
                            "p.yaml", "a/b")


class RunReplayTasksTest(BadInputTest):
    TASK = ('{{"ped_id": {}, "t_start_s": 0, "start": [1, 5], "goal": {}, "human_time_s": 9,'
            ' "human_min_distance_m": 1}}')

    def expect(self, tasks, *words):
        tracks = self.write("tracks.csv", TRACKS_HEADER + "0.0,7,2.0,3.0\n0.4,7,2.4,3.0\n")
        path = self.write("tasks.json", '{"replace_person_tasks": {"items": [' + tasks + "]}}")
        self.expect_refusal("run_replay_tasks", ["--tracks", tracks, "--tasks", path],
                            "tasks.json", *words)

    def test_person_who_is_not_there_is_found_before_the_first_trip(self):
        good = self.TASK.format(7, "[12, 5]")
        self.expect(good + "," + self.TASK.format(999, "[12, 5]"), "person 999")

    def test_goal_that_is_no_place(self):
        self.expect(self.TASK.format(7, "[12, 105]"), "person 7", "off the map")

    def test_words_of_the_json_library_are_not_shown(self):
        self.expect('{"ped_id": 7}', "task 1: 't_start_s' is missing")
        self.expect("{", "parse error")
        result = self.run_program("run_replay_tasks", "--tracks", "none.csv", "--tasks",
                                  str(self.folder / "tasks.json"))
        self.assertNotIn("json.exception", result.stderr)


class LearnDestinationsTest(BadInputTest):
    NAME = "learn_destinations"

    # Six people from one door to another, and one who is there all the time.
    def tracks(self):
        rows = [(0, 99, 5, 5), (60, 99, 5, 5)]
        for i in range(6):
            rows += [(5 + i, i, 0, 0.1 * i), (15 + i, i, 10, 0.1 * i)]
        return self.write("people.csv", TRACKS_HEADER + "".join(
            f"{t},{person},{x},{y}\n" for t, person, x, y in sorted(rows)))

    def expect(self, args, *words):
        self.expect_refusal(self.NAME, args, *words)

    def test_finds_the_doors(self):
        result = self.run_program(self.NAME, "--tracks", self.tracks(), "--output", "places.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("[10.00, 0.25]: 6 people", result.stdout)
        self.assertIn("2 destinations from 6 walks", result.stderr)
        places = yaml.safe_load((self.folder / "places.yaml").read_text())
        self.assertEqual(sorted(places["destinations"]), [[0.0, 0.25], [10.0, 0.25]])
        self.expect(["--tracks", self.tracks(), "--output", "places.yaml"], "--output", "exists")

    def test_missing_file(self):
        self.expect(["--tracks", "nowhere.csv"], "nowhere.csv")
        self.expect(["--tracks", "nowhere.bag"], "nowhere.bag")
        self.expect([], "--tracks")

    def test_file_that_is_no_recording(self):
        self.expect(["--tracks", self.write("t.csv", "time,x\n")], "t.csv:1", TRACKS_HEADER[:-1])
        self.expect(["--tracks", self.write("t.bag", "no bag at all\n")], "t.bag: ")

    def test_recording_in_which_nothing_is_found(self):
        self.expect(["--tracks", self.tracks(), "--min-people", "7"], "people.csv", "7 people")

    def test_numbers_out_of_range(self):
        for option, value in (("--min-people", "0"), ("--merge-distance", "nan"),
                              ("--min-walk", "-1")):
            self.expect(["--tracks", self.tracks(), option, value], option, f"'{value}'")


class RosrunTest(unittest.TestCase):
    def test_rosrun_finds_the_tool_and_passes_its_status_on(self):
        program = pathlib.Path(roslib.packages.find_node(PACKAGE, "run_experiments")[0])
        if SHARE / "build" in program.parents:
            self.skipTest("rosrun passes over a folder 'build' inside a package")
        result = subprocess.run(["rosrun", PACKAGE, "run_experiments", "--runs", "0"],
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("run_experiments: --runs", result.stdout)


class SendGoalTest(BadInputTest):
    def test_no_goal(self):
        self.expect_refusal("send_goal", [], "--x")

    def test_coordinate_that_is_none(self):
        self.expect_refusal("send_goal", ["--x", "east", "--y", "1"], "--x", "east")

    def test_unknown_option(self):
        self.expect_refusal("send_goal", ["--z", "1"], "--z")

    def test_one_coordinate(self):
        self.expect_refusal("send_goal", ["--x", "1", "--y", "world"], "give both --x and --y")

    def test_timeout_out_of_range(self):
        self.expect_refusal("send_goal", ["--x", "1", "--y", "1", "--timeout", "0"],
                            "--timeout", "above 0", "'0'")

    def expect_no_trip(self, reason, **environment):
        result = self.run_program("send_goal", "--x", "1", "--y", "1", "--timeout", "1",
                                  **environment)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(reason, result.stderr)
        self.assertIn("goal_reached=false travel_time_s=nan min_moving_distance_m=nan",
                      result.stdout)

    def test_without_a_planner(self):
        self.expect_no_trip("no planner answers")

    def test_without_a_master(self):
        self.expect_no_trip("no ROS master", ROS_MASTER_URI="http://127.0.0.1:1")


class CheckInputsTest(BadInputTest):
    def test_duration_that_is_none(self):
        for value in ("0", "never"):
            self.expect_refusal("check_inputs", ["--duration", value], "--duration", f"'{value}'")

    def test_unknown_option(self):
        self.expect_refusal("check_inputs", ["--durations", "1"], "--durations")

    def test_no_master(self):
        result = self.run_program("check_inputs", ROS_MASTER_URI="http://127.0.0.1:1")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no ROS master answers", result.stderr)


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
        self.expect(["--world", "./atlantis.yaml"], "./atlantis.yaml", "cannot be read")


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


if __name__ == "__main__":
    rosunit.unitrun(PACKAGE, "bad_input", "__main__")
