#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A replay shows an episode, moves nothing, and leaves the master as it was.

Run in the environment of the devel space; starts a master of its own.
"""
import contextlib
import importlib.util
import io
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

import rosbag
import rosgraph
import rospy
import yaml
from geometry_msgs.msg import Twist
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from episode_bag_writer import EpisodeBag
from surroundings import free_port

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/replay_episode.py"
sys.path.insert(0, str(SCRIPT.parent))
SPEC = importlib.util.spec_from_file_location("replay_episode", SCRIPT)
REPLAY = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(REPLAY)
# pylint: disable=wrong-import-position
from episode_replay.live import Master  # noqa: E402
from episode_replay.view import replay_view  # noqa: E402

SECONDS = 2.0
COMMANDS = ("/cmd_vel", "/cmd_vel_raw", "/move_base_simple/goal")
SHOWN = ("/odom", "/tf", "/map", "/tracked_persons", "/planner_node/beliefs", "/planner_node/status",
         "/planner_node/search_tree", "/planner_node/local_plan", "/planner_node/current_goal")
SIM_TIME = "/use_sim_time"


def wait_until(is_true, seconds=20.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if is_true():
            return True
        time.sleep(0.05)
    return False


class ReplayTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.shared.name)
        port = free_port()
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                          ROS_HOME=str(folder), ROS_LOG_DIR=str(folder / "log"))
        for name in ("ROS_HOSTNAME", "ROS_NAMESPACE", "DISPLAY"):
            os.environ.pop(name, None)
        cls.core = subprocess.Popen(["rosmaster", "--core", "-p", str(port)],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.master = rosgraph.Master("/replay_test")
        assert wait_until(rosgraph.is_master_online), "no master"
        rospy.init_node("replay_test", disable_signals=True)
        cls.bag = folder / "episode.bag"
        EpisodeBag(cls.bag, seconds=SECONDS)

    @classmethod
    def tearDownClass(cls):
        rospy.signal_shutdown("the end")
        cls.core.terminate()
        cls.core.wait(10)
        cls.shared.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.heard = {}
        if self.master.hasParam(SIM_TIME):
            self.master.deleteParam(SIM_TIME)

    def listen(self, *topics):
        for topic in topics:
            self.heard[topic] = 0
            subscriber = rospy.Subscriber(topic, rospy.AnyMsg, self.count, topic)
            self.addCleanup(subscriber.unregister)

    def count(self, _, topic):
        self.heard[topic] += 1

    def start(self, *arguments, command=(sys.executable, SCRIPT)):
        process = subprocess.Popen([*map(str, command), *map(str, arguments)], text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.terminate()
            process.wait(30)
        process.stderr.close()

    def start_replay(self, bag, *options):
        return self.start(bag, "--rviz", "false", *options)

    def finish(self, process, status):
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, status, said)
        return said

    def expect_refusal(self, arguments, *words):
        """In this process, which takes less time than starting one."""
        with contextlib.redirect_stderr(io.StringIO()) as heard, \
                unittest.mock.patch.object(sys, "argv", ["replay_episode.py", *map(str, arguments)]):
            status = REPLAY.status_of(REPLAY.PROGRAM, REPLAY.main)
        said = heard.getvalue()
        self.assertEqual(status, 2, said)
        self.assertEqual(len(said.splitlines()), 1, said)
        for word in ("replay_episode.py: ", *words):
            self.assertIn(word, said)

    def publisher(self, topic, kind):
        publisher = rospy.Publisher(topic, kind, queue_size=1)
        self.addCleanup(publisher.unregister)

    def published(self):
        return {topic: nodes for topic, nodes in self.master.getSystemState()[0]}

    def test_shows_all_and_commands_nothing(self):
        self.listen(*COMMANDS, *SHOWN)
        process = self.start_replay(self.bag)
        self.assertTrue(wait_until(lambda: "/odom" in self.published()))
        self.assertTrue(self.master.getParam(SIM_TIME))
        self.assertFalse(set(COMMANDS) & self.published().keys())
        said = self.finish(process, 0)
        self.assertIn("/cmd_vel", said)  # what is not played
        self.assertEqual({topic: self.heard[topic] for topic in COMMANDS}, dict.fromkeys(COMMANDS, 0))
        for topic in SHOWN:
            self.assertGreater(self.heard[topic], 0, topic)
        self.assertGreater(self.heard["/odom"], 10)
        self.assertFalse(self.master.hasParam(SIM_TIME))

    def test_launch_file(self):
        self.listen("/planner_node/beliefs", "/cmd_vel")
        process = self.start(ROOT / "launch/replay.launch", f"bag:={self.bag}",
                             "rviz:=false", "rate:=2.0", command=["roslaunch"])
        self.finish(process, 0)
        self.assertGreater(self.heard["/planner_node/beliefs"], 0)
        self.assertEqual(self.heard["/cmd_vel"], 0)
        self.assertFalse(self.master.hasParam(SIM_TIME))

    def test_robot_in_a_namespace_is_shown_without_it(self):
        bag = self.folder / "two.bag"
        EpisodeBag(bag, namespace="/robot_1", seconds=SECONDS)
        self.listen(*COMMANDS, *SHOWN)
        self.finish(self.start_replay(bag), 0)
        for topic in SHOWN:
            self.assertGreater(self.heard[topic], 0, topic)
        self.assertEqual(sum(self.heard[topic] for topic in COMMANDS), 0)
        self.expect_refusal([bag, "--namespace", "/robot_2"], "/robot_2", "/robot_1")

    def test_later_start_has_what_was_said_once(self):
        self.listen("/map", "/planner_node/current_goal")
        self.finish(self.start_replay(self.bag, "--start", 1.0), 0)
        self.assertEqual(self.heard, {"/map": 1, "/planner_node/current_goal": 1})

    def test_time_is_restored_after_an_interrupt(self):
        self.master.setParam(SIM_TIME, False)
        for number, wait in ((signal.SIGINT, 0.3), (signal.SIGINT, 0.5), (signal.SIGTERM, 0.4)):
            process = self.start_replay(self.bag, "--rate", 0.2)
            self.assertTrue(wait_until(lambda: "/odom" in self.published()))
            time.sleep(wait)  # it asks the master every half second, which must not matter
            self.assertIs(self.master.getParam(SIM_TIME), True)
            process.send_signal(number)
            self.finish(process, 130)
            self.assertIs(self.master.getParam(SIM_TIME), False)
            self.assertTrue(wait_until(lambda: "/odom" not in self.published()))

    def test_asks_again_after_an_interrupted_question(self):
        master = Master()
        with unittest.mock.patch("http.client.HTTPConnection.getresponse",
                                 side_effect=KeyboardInterrupt):
            self.assertRaises(KeyboardInterrupt, master.get, SIM_TIME)
        self.assertIsNone(master.get(SIM_TIME))

    def test_refuses_a_live_system(self):
        for topic, kind in (("/tf", TFMessage), ("/base/cmd_vel", Twist), ("/clock", String)):
            with self.subTest(topic):
                publisher = rospy.Publisher(topic, kind, queue_size=1)
                self.assertTrue(wait_until(lambda: topic in self.published()))
                self.expect_refusal([self.bag], topic, "/replay_test", "live system", "-p 11399")
                publisher.unregister()
                self.assertFalse(self.master.hasParam(SIM_TIME))

    def test_stops_when_a_system_comes_alive(self):
        process = self.start_replay(self.bag, "--rate", 0.1)
        self.assertTrue(wait_until(lambda: "/odom" in self.published()))
        self.publisher("/base/cmd_vel", Twist)
        self.assertIn("stopped: /replay_test", self.finish(process, 2))
        self.assertFalse(self.master.hasParam(SIM_TIME))

    def test_bad_bags(self):
        whole = self.bag.read_bytes()
        for name, content, word in (("none.bag", None, "there is no such file"), ("e.bag", b"", "empty"),
                                    ("text.bag", b"nothing\n", "rosbag record"),
                                    ("cut.bag", whole[:len(whole) // 2], "rosbag")):
            with self.subTest(name):
                if content is not None:
                    (self.folder / name).write_bytes(content)
                self.expect_refusal([self.folder / name], name, word)
        (self.folder / "live.bag.active").write_bytes(whole[:5000])
        self.expect_refusal([self.folder / "live.bag"], "not finished", "rosbag reindex")
        with rosbag.Bag(str(self.folder / "foreign.bag"), "w") as bag:
            bag.write("/chatter", String("hello"))
        self.expect_refusal([self.folder / "foreign.bag"], "not an episode", "record:=true")
        self.expect_refusal(["none"], "bag:=")

    def test_bad_options(self):
        for options in (["--rate", "0"], ["--start", "x"], ["--start", "99"], ["--rviz", "maybe"],
                        ["--view", "atlantis"]):
            with self.subTest(options):
                self.expect_refusal([self.bag, *options], options[0])

    def test_without_a_master(self):
        with unittest.mock.patch.dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}"):
            self.expect_refusal([self.bag], "no answer from a master", "replay.launch")

    def test_view_only_shows(self):
        for name in ("navigation", "street"):
            view = yaml.safe_load(replay_view(ROOT / f"rviz/{name}.rviz", "robot_1/map"))
            manager = view["Visualization Manager"]
            self.assertEqual(manager["Global Options"]["Fixed Frame"], "robot_1/map")
            tools = [tool["Class"] for tool in manager["Tools"]]
            self.assertIn("rviz/MoveCamera", tools)
            self.assertFalse({"rviz/SetGoal", "rviz/SetInitialPose"} & set(tools))
            models = [display for display in manager["Displays"]
                      if display["Class"] == "rviz/RobotModel"]
            self.assertEqual([model["TF Prefix"] for model in models], ["robot_1"] * len(models))


if __name__ == "__main__":
    unittest.main(warnings="ignore")  # of rospy
