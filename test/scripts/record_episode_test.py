#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""record:=true records every topic of the contract, also in a namespace and under other names.

Run in the environment of the devel space; each launch has a master of its own.
"""
import importlib.util
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import rosbag
from surroundings import free_port

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/record_episode.py"
sys.path.insert(0, str(SCRIPT.parent))
SPEC = importlib.util.spec_from_file_location("record_episode", SCRIPT)
RECORD = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(RECORD)

OWN = {"odom", "tracked_persons", "map", "cmd_vel", "cmd_vel_raw",
       "planner_node/status", "planner_node/beliefs", "planner_node/belief_markers",
       "planner_node/search_tree", "planner_node/global_plan", "planner_node/local_plan",
       "planner_node/current_goal", "sim_node/crowd_markers", "sim_node/world_markers",
       "sim_node/metrics", "velocity_guard/status"}
SHARED = {"/tf", "/tf_static", "/diagnostics"}
MARKERS = {"planner_node/belief_markers", "planner_node/search_tree", "sim_node/crowd_markers"}
NAMESPACED = """<launch><group ns="robot_1">
  <include file="$(find pomdp_crowd_nav)/launch/simulation.launch" pass_all_args="true"/>
</group></launch>"""


class RecordTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.environment = {**os.environ, "ROS_IP": "127.0.0.1", "ROS_HOME": folder.name,
                            "PWD": folder.name}
        for name in ("ROS_HOSTNAME", "ROS_NAMESPACE", "ROS_MASTER_URI"):
            self.environment.pop(name, None)

    def launch(self, *arguments):
        port = free_port()
        self.environment["ROS_MASTER_URI"] = f"http://127.0.0.1:{port}"
        log = open(self.folder / "roslaunch.log", "wb")
        self.addCleanup(log.close)
        process = subprocess.Popen(["roslaunch", "-p", str(port), *map(str, arguments)],
                                   cwd=self.folder, env=self.environment, stdout=log, stderr=log)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)  # it ends its nodes
            process.wait(30)

    def bags(self, ending):
        return list(self.folder.glob("*.bag" + ending))

    def said(self):
        return (self.folder / "roslaunch.log").read_text()

    def record(self, seconds, *arguments):
        """{topic: number of messages} of the bag, `seconds` after recorder and trip have begun."""
        process = self.launch(*arguments)
        end = time.monotonic() + 90.0
        while not (self.bags(".active") and "new goal" in self.said()):
            self.assertIsNone(process.poll(), self.said())
            self.assertLess(time.monotonic(), end, self.said())
            time.sleep(0.1)
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
        process.wait(60)
        self.assertEqual(len(self.bags("")), 1, self.said())
        with rosbag.Bag(str(self.bags("")[0])) as bag:
            topics = bag.get_type_and_topic_info().topics
        return {topic: info.message_count for topic, info in topics.items()}

    SIMULATION = ("rviz:=false", "pedestrians:=20", "record:=true")

    def test_a_trip(self):
        topics = self.record(8.0, ROOT / "launch/simulation.launch",
                             *self.SIMULATION)
        self.assertEqual(({"/" + name for name in OWN} | SHARED) - topics.keys(), set(), self.said())
        self.assertGreater(topics["/odom"], 100)
        self.assertFalse({"/move_base/goal", "/move_base_simple/goal", "/initialpose", "/rosout"}
                         & topics.keys())
        self.assertRegex(self.bags("")[0].name, r"^episode_[0-9-]+\.bag$")

    def test_in_a_namespace_without_markers(self):
        launch = self.folder / "two.launch"
        launch.write_text(NAMESPACED)
        topics = self.record(8.0, launch, *self.SIMULATION, "tf_prefix:=robot_1", "bag:=one.bag",
                             "record_markers:=false")
        missing = ({"/robot_1/" + name for name in OWN - MARKERS} | SHARED) - topics.keys()
        self.assertEqual(missing, set(), self.said())
        self.assertFalse({"/robot_1/" + name for name in MARKERS} & topics.keys())
        self.assertEqual(self.bags("")[0].name, "one.bag")

    def test_topics_of_a_robot(self):
        """Those that movo.launch remaps, whose publishers are the robot's."""
        command = subprocess.run(
            ["roslaunch", "--args", "recorder", ROOT / "launch/movo.launch", "record:=true",
             "people_topic:=/spencer/persons", "cmd_vel_topic:=/base/cmd",
             "people_msgs_topic:=/base/people"], check=True, text=True,
            stdout=subprocess.PIPE, env=self.environment).stdout.split()
        mappings = dict(word.split(":=") for word in command
                        if ":=" in word and not word.startswith("__"))
        topics = RECORD.topics_to_record("/recorder", mappings)
        for topic in ("/base/cmd", "/cmd_vel_raw", "/spencer/persons", "/map",
                      "/movo/odometry/local_filtered", "/base/people"):
            self.assertIn(topic, topics)
        self.assertFalse({"/odom", "/cmd_vel", "/tracked_persons", "/people"} & set(topics))

    def test_bad_names(self):
        (self.folder / "old.bag").write_text("old")
        for name, words in (("no_such_folder/episode", ["no folder"]), ("old.bag", ["not overwritten"]),
                            ("old.bag/", ["folder"])):
            with self.subTest(name):
                result = subprocess.run([sys.executable, SCRIPT, "--bag", name], cwd=self.folder,
                                        text=True, stderr=subprocess.PIPE, check=False,
                                        env=self.environment, timeout=60)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                for word in ("record_episode.py: --bag: ", *words):
                    self.assertIn(word, result.stderr)
        self.assertEqual((self.folder / "old.bag").read_text(), "old")


if __name__ == "__main__":
    unittest.main()
