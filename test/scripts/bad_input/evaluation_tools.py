# SPDX-License-Identifier: BSD-3-Clause
"""The other tools without ROS."""
import json
import pathlib

from bad_input.refusal import SHARE, TRACKS_HEADER, WORLD, BadInputTest


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
