# SPDX-License-Identifier: BSD-3-Clause
"""Tools that talk to ROS."""
import pathlib
import subprocess
import sys
import time
import unittest

import rosbag
import roslib.packages
import rospy
import yaml
from geometry_msgs.msg import Point, TransformStamped
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

from bad_input.refusal import PACKAGE, SHARE, TRACKS_HEADER, BadInputTest


def own_messages():
    """Those of the build whose programs are tested; rostest need not have its environment."""
    program = pathlib.Path(roslib.packages.find_node(PACKAGE, "learn_destinations")[0])
    sys.path.insert(0, str(program.parents[1] / "python3/dist-packages"))
    from pomdp_crowd_nav import msg  # pylint: disable=import-outside-toplevel
    return msg


class LearnDestinationsTest(BadInputTest):
    NAME = "learn_destinations"

    # Six people from one door to another, and one who is there all the time.
    @staticmethod
    def rows():
        rows = [(0, 99, 5, 5), (60, 99, 5, 5)]
        for i in range(6):
            rows += [(5 + i, i, 0, 0.1 * i), (15 + i, i, 10, 0.1 * i)]
        return sorted(rows)

    def tracks(self):
        return self.write("people.csv", TRACKS_HEADER + "".join(
            f"{t},{person},{x},{y}\n" for t, person, x, y in self.rows()))

    # The same as People in odom, which lies 100 m before the map.
    def bag(self):
        odom = TransformStamped(header=Header(frame_id="map"), child_frame_id="odom")
        odom.transform.translation.x, odom.transform.rotation.w = 100.0, 1.0
        path = str(self.folder / "people.bag")
        msg = own_messages()
        with rosbag.Bag(path, "w") as bag:
            bag.write("/tf_static", TFMessage([odom]), rospy.Time(1000))
            for t, person, x, y in self.rows():
                stamp = rospy.Time(1000 + t)
                bag.write("/people", msg.People(
                    header=Header(stamp=stamp, frame_id="odom"),
                    people=[msg.Person(name=str(person), position=Point(x, y, 0.0))]), stamp)
        return path

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

    def test_finds_the_doors_of_a_bag_in_another_frame(self):
        result = self.run_program(self.NAME, "--tracks", self.bag(), "--topic", "people",
                                  "--output", "places.yaml")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("[110.00, 0.25]: 6 people", result.stdout)
        self.assertNotIn("left out", result.stderr)
        self.expect(["--tracks", self.bag(), "--topic", "people", "--frame", "hall"],
                    "people.bag", "no transform", "'odom'", "'hall'")
        self.expect(["--tracks", self.bag()], "people.bag", "no topic 'tracked_persons'")

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
