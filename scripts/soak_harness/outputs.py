# SPDX-License-Identifier: BSD-3-Clause
"""What the nodes put out: commands within their limits and in time, decisions and their time."""
import collections
import math
import threading
import time

import rosgraph
import rospy
from geometry_msgs.msg import Twist
from pomdp_crowd_nav.msg import PlannerStatus

from .stack import PLANNER, SIMULATOR

SLACK = 1.0e-3      # of a limit, for rounding
LONGEST_GAP = 1.0   # [s] a longer one is the pause between two trips


def command_topic():
    """The topic from which the simulator takes its commands, whoever publishes there."""
    master = rosgraph.Master(rospy.get_name())
    types = dict(master.getTopicTypes())
    for topic, nodes in master.getSystemState()[1]:
        if "/" + SIMULATOR in nodes and types.get(topic, "geometry_msgs/Twist") == Twist._type:
            return topic
    return "/cmd_vel"


class CommandWatch:
    """Every command that reaches the base."""

    def __init__(self, max_speed, max_yaw_rate):
        self.max_speed, self.max_yaw_rate = max_speed, max_yaw_rate
        self.last = -math.inf
        self.periods = []
        self.count = 0
        self.violations = collections.Counter()
        self.worst = {"speed": 0.0, "yaw_rate": 0.0}
        self.on_violation = None
        self.topic = command_topic()
        self.subscriber = rospy.Subscriber(self.topic, Twist, self._on_command, queue_size=100,
                                           tcp_nodelay=True)

    def interrupt(self):
        """What comes next is no continuation: the planner had nothing to do."""
        self.last = -math.inf

    def _on_command(self, twist):
        now = time.monotonic()
        gap, self.last = now - self.last, now
        self.count += 1
        if gap < LONGEST_GAP:
            self.periods.append(gap)
        speed, yaw_rate = math.hypot(twist.linear.x, twist.linear.y), abs(twist.angular.z)
        if not (math.isfinite(speed) and math.isfinite(yaw_rate)):
            return self._violate("not finite", twist)
        self.worst["speed"] = max(self.worst["speed"], speed)
        self.worst["yaw_rate"] = max(self.worst["yaw_rate"], yaw_rate)
        if speed > self.max_speed * (1.0 + SLACK):
            self._violate("too fast", twist)
        if yaw_rate > self.max_yaw_rate * (1.0 + SLACK):
            self._violate("turns too fast", twist)
        return None

    def _violate(self, kind, twist):
        self.violations[kind] += 1
        if self.on_violation:
            self.on_violation(f"command {kind}: {twist.linear.x} {twist.linear.y} "
                              f"{twist.angular.z}")


class StatusWatch:
    """The planner's own account: its state, and the time of every decision."""

    def __init__(self):
        self.lock = threading.Lock()
        self.newest = None
        self.heard = -math.inf
        self.on_idle = None
        self.cycle_times = []
        self.decisions = self.deadline_misses = self.bound_violations = 0
        self.subscriber = rospy.Subscriber(PLANNER + "/status", PlannerStatus, self._on_status,
                                           queue_size=100)

    @staticmethod
    def _growth(now, before):
        return now - before if now >= before else now

    def _on_status(self, status):
        with self.lock:
            last, self.newest = self.newest or PlannerStatus(), status
            self.heard = time.monotonic()
            decisions = self._growth(status.decisions, last.decisions)
            if decisions:
                self.cycle_times.append(status.cycle_time)
            self.decisions += decisions
            self.deadline_misses += self._growth(status.deadline_misses, last.deadline_misses)
            self.bound_violations += self._growth(status.bound_violations, last.bound_violations)
        if status.state == PlannerStatus.IDLE and self.on_idle:
            self.on_idle()

    def is_alive(self):
        return time.monotonic() - self.heard < 2.0

    def state(self):
        return self.newest.state_name if self.newest and self.is_alive() else "SILENT"

    def is_ready(self):
        """Drives, or would if people let it."""
        return self.state() in ("DRIVING", "WAITING_FOR_PEOPLE", "BLOCKED", "PREPARING", "IDLE")
