# SPDX-License-Identifier: BSD-3-Clause
"""What really happens, taken from the simulator itself and never from behind the relay."""
import math
import threading
import time

import rospy
from nav_msgs.msg import Odometry
from pomdp_crowd_nav.msg import EpisodeMetrics, TrackedPersons

from .blame import MOVING, blame, is_violation

COUNTS = ("unsafe_steps", "unsafe_ticks", "contact_ticks")


def rotated(quaternion, vector):
    yaw = 2.0 * math.atan2(quaternion.z, quaternion.w)
    cosine, sine = math.cos(yaw), math.sin(yaw)
    return cosine * vector.x - sine * vector.y, sine * vector.x + cosine * vector.y


class Truth:
    """Speed of the base, and each increase of the simulator's counts with who has caused it."""

    def __init__(self, start, relay=None):
        self.lock = threading.Lock()
        self.speed = math.nan
        self.velocity = (0.0, 0.0)
        self.turning = 0.0
        self.position = start[:2]
        self.start = start  # x, y, heading of the odometry's frame
        self.put_at = -math.inf
        self.people = []
        self.metrics = None
        self.events = []  # of the counts that have grown
        self.on_event = None
        self.totals = dict.fromkeys(COUNTS, 0)
        self.caused_by_robot = dict.fromkeys(COUNTS, 0)
        self.smallest_distance = math.inf
        if relay:
            relay.odom.listener, relay.people.listener = self._on_odometry, self._on_people
        else:
            rospy.Subscriber("odom", Odometry, self._on_odometry, queue_size=1, tcp_nodelay=True)
            rospy.Subscriber("tracked_persons", TrackedPersons, self._on_people, queue_size=1,
                             buff_size=2 ** 22)
        rospy.Subscriber("sim_node/metrics", EpisodeMetrics, self._on_metrics, queue_size=10)

    def _on_odometry(self, odometry):
        twist = odometry.twist.twist
        place = odometry.pose.pose.position
        heading = self.start[2]
        cosine, sine = math.cos(heading), math.sin(heading)
        velocity = rotated(odometry.pose.pose.orientation, twist.linear)
        with self.lock:
            self.position = (self.start[0] + cosine * place.x - sine * place.y,
                             self.start[1] + sine * place.x + cosine * place.y)
            self.velocity = (cosine * velocity[0] - sine * velocity[1],
                             sine * velocity[0] + cosine * velocity[1])
            self.speed = math.hypot(twist.linear.x, twist.linear.y)
            self.turning = abs(twist.angular.z)

    def _on_people(self, persons):
        people = [(track.pose.pose.position.x, track.pose.pose.position.y,
                   track.twist.twist.linear.x, track.twist.twist.linear.y)
                  for track in persons.tracks]
        with self.lock:
            self.people = people

    def _on_metrics(self, metrics):
        event = None
        with self.lock:
            last, self.metrics = self.metrics, metrics
            grown = {}
            for name in COUNTS:
                now, before = getattr(metrics, name), getattr(last, name) if last else 0
                grown[name] = now - before if now >= before else now  # another trip begins with 0
            self.smallest_distance = min(self.smallest_distance, metrics.min_moving_distance)
            if any(grown.values()):
                event = self._judge(grown)
        if event and self.on_event:
            self.on_event(event)

    def _judge(self, grown):
        now = time.monotonic()
        event = {"time": now, **grown,
                 **blame(self.position, self.velocity, self.people, now - self.put_at)}
        for name in COUNTS:
            self.totals[name] += grown[name]
            if is_violation(event["cause"]):
                self.caused_by_robot[name] += grown[name]
        self.events.append(event)
        return event

    def move_start(self, start):
        """The robot was put elsewhere; its odometry begins afresh there."""
        with self.lock:
            self.start = start
            self.put_at = time.monotonic()

    def is_at_rest(self):
        return self.speed < MOVING and self.turning < 0.05

    def has_reached_goal(self):
        with self.lock:
            return bool(self.metrics and self.metrics.goal_reached)
