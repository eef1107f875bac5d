# SPDX-License-Identifier: BSD-3-Clause
"""A moment of a simulated drive, kept and published again for as long as pictures are taken."""
import copy
import signal
import subprocess
import time

import nav_msgs.msg as nav
import rospy
from geometry_msgs.msg import PoseStamped
from pomdp_crowd_nav.msg import EpisodeMetrics, PlannerStatus
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

TREE, BELIEFS, ROBOT = (f"/planner_node/{name}"
                        for name in ("search_tree", "belief_markers", "robot_markers"))
TOPICS = {
    "/sim_node/crowd_markers": MarkerArray, "/sim_node/world_markers": MarkerArray,
    TREE: MarkerArray, BELIEFS: MarkerArray, ROBOT: MarkerArray,
    "/planner_node/roadmap": MarkerArray, "/planner_node/arrival_time": nav.OccupancyGrid,
    "/planner_node/global_plan": nav.Path, "/planner_node/local_plan": nav.Path,
    "/planner_node/current_goal": PoseStamped,
}
START_TIMEOUT = 120.0  # [s]


class Drive:
    """simulation.launch on the master that is there, with a listener to all pictures."""

    def __init__(self, arguments, log):
        self.latest, self.arrived, self.frames = {}, {}, {}
        self.metrics, self.status = None, None
        self.log = open(log, "w", encoding="utf-8")
        self.process = subprocess.Popen(
            ["roslaunch", "pomdp_crowd_nav", "simulation.launch", "rviz:=false",
             *(f"{name}:={value}" for name, value in arguments.items())],
            stdout=self.log, stderr=subprocess.STDOUT)
        self.listeners = [rospy.Subscriber(topic, kind, self._keep, topic)
                          for topic, kind in TOPICS.items()]
        self.listeners += [rospy.Subscriber(topic, TFMessage, self._keep_frames)
                           for topic in ("/tf", "/tf_static")]
        self.listeners += [
            rospy.Subscriber("/sim_node/metrics", EpisodeMetrics, self._set("metrics")),
            rospy.Subscriber("/planner_node/status", PlannerStatus, self._set("status"))]

    def _set(self, name):
        return lambda message: setattr(self, name, message)

    def _keep(self, message, topic):
        self.latest[topic], self.arrived[topic] = message, time.monotonic()

    def _keep_frames(self, message):
        for transform in message.transforms:
            self.frames[transform.child_frame_id] = transform

    def until(self, condition, what, timeout):
        end = time.monotonic() + timeout
        while not condition():
            if time.monotonic() > end or self.process.poll() is not None:
                raise RuntimeError(f"{what} did not come about; the log is {self.log.name}")
            time.sleep(0.02)

    def moment(self, condition, what, timeout):
        """The first decision after which the condition holds, people and robot as drawn then."""
        self.until(lambda: self.metrics and self.status, "the start", START_TIMEOUT)
        end = time.monotonic() + timeout
        while True:
            begin = time.monotonic()
            self.until(lambda: self.arrived.get(TREE, 0.0) > begin, what, end - begin)
            decided = self.arrived[TREE]
            self.until(lambda: min(self.arrived.get(BELIEFS, 0.0), self.arrived.get(ROBOT, 0.0))
                       > decided, "a picture", 30.0)
            if condition():
                return Moment(dict(self.latest), list(self.frames.values()))

    def stop(self):
        for listener in self.listeners:
            listener.unregister()
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(30.0)
        except subprocess.TimeoutExpired:
            self.process.kill()
        self.log.close()


class Moment:
    def __init__(self, messages, frames):
        self.messages, self.frames = copy.deepcopy(messages), copy.deepcopy(frames)
        self.publishers = []

    def publish(self):
        """Each message latched, valid for ever."""
        for topic, message in self.messages.items():
            for marker in getattr(message, "markers", []):
                marker.lifetime, marker.header.stamp = rospy.Duration(0), rospy.Time(0)
            self._latch(topic, message)
        self._latch("/tf_static", TFMessage(transforms=self.frames))

    def _latch(self, topic, message):
        publisher = rospy.Publisher(topic, type(message), latch=True, queue_size=1)
        publisher.publish(message)
        self.publishers.append(publisher)

    def withdraw(self):
        for publisher in self.publishers:
            publisher.unregister()
        self.publishers = []
