# SPDX-License-Identifier: BSD-3-Clause
"""Writes small bags of episodes as record:=true would, for the tests of replay and film."""
import math

import rosbag
import rospy
from geometry_msgs.msg import Point, PoseStamped, TransformStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from std_msgs.msg import ColorRGBA, Header
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from pomdp_crowd_nav.msg import (CrowdBelief, People, Person, PersonBelief, PlannerStatus,
                                 TrackedPerson, TrackedPersons)

BEGIN = 1000.0  # [s]
RED = ColorRGBA(0.9, 0.0, 0.0, 1.0)
FIELD = 40.0    # [m]


class EpisodeBag:
    """A robot that drives to the right along y = 20 m, among three people, for a few seconds."""

    def __init__(self, path, seconds=3.0, namespace="", people_msgs=False, planner=True):
        self.namespace, self.people_msgs = namespace, people_msgs
        self.frame_prefix = namespace.strip("/") + "/" if namespace else ""
        with rosbag.Bag(str(path), "w") as bag:
            self.bag = bag
            self._write_once()
            for k in range(int(10 * seconds) + 1):
                self._write_tick(0.1 * k, planner)

    def _header(self, time, frame="map"):
        return Header(stamp=rospy.Time.from_sec(BEGIN + time), frame_id=self.frame_prefix + frame)

    def _write(self, topic, message, time, latched=False):
        name = topic if topic.startswith("/") else f"{self.namespace}/{topic}"
        # pylint: disable=protected-access
        header = {"topic": name, "type": message._type, "md5sum": message._md5sum,
                  "message_definition": message._full_text, "latching": "1" if latched else "0",
                  "callerid": "/writer"}
        self.bag.write(name, message, rospy.Time.from_sec(BEGIN + time), connection_header=header)

    def _write_once(self):
        grid = OccupancyGrid(header=self._header(0.0))
        grid.info.resolution, grid.info.width, grid.info.height = 1.0, int(FIELD), int(FIELD)
        grid.info.origin.orientation.w = 1.0
        grid.data = [100 if i % 40 == 30 else 0 for i in range(1600)]
        self._write("map", grid, 0.0, latched=True)
        goal = PoseStamped(header=self._header(0.0))
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = 38.0, 20.0, 1.0
        self._write("planner_node/current_goal", goal, 0.0, latched=True)

    def _write_tick(self, time, planner):
        for parent, child, x in (("map", "odom", 2.0), ("odom", "base_link", 2.0 * time)):
            transform = TransformStamped(header=self._header(time, parent),
                                         child_frame_id=self.frame_prefix + child)
            transform.transform.translation.x = x
            transform.transform.translation.y = 20.0 if parent == "map" else 0.0
            transform.transform.rotation.w = 1.0
            self._write("/tf", TFMessage([transform]), time)
        odom = Odometry(header=self._header(time, "odom"),
                        child_frame_id=self.frame_prefix + "base_link")
        odom.pose.pose.position.x, odom.pose.pose.orientation.w = 2.0 * time, 1.0
        odom.twist.twist.linear.x = 2.0
        self._write("odom", odom, time)
        self._write_people(time)
        for topic in ("cmd_vel", "cmd_vel_raw"):
            command = Twist()
            command.linear.x = 2.0
            self._write(topic, command, time)
        goal = PoseStamped(header=self._header(time))
        goal.pose.orientation.w = 1.0
        self._write("move_base_simple/goal", goal, time)
        if planner:
            self._write_decision(time)

    @staticmethod
    def places(time):
        return [(10.0 + k * 8.0, 14.0 + 4.0 * k + time) for k in range(3)]

    def belief_id(self, k):
        """What idOfName (conversions.cpp) makes of visitor_0, visitor_1, visitor_2."""
        names = (4657958269991066366, 4657959369502694577, 4657956070967809944)
        return names[k] if self.people_msgs else k

    def _write_people(self, time):
        if self.people_msgs:
            people = People(header=self._header(time))
            people.people = [Person(name=f"visitor_{k}", position=Point(x, y, 0.0))
                             for k, (x, y) in enumerate(self.places(time))]
            self._write("people", people, time)
            return
        tracks = TrackedPersons(header=self._header(time))
        for k, (x, y) in enumerate(self.places(time)):
            track = TrackedPerson(track_id=k)
            track.pose.pose.position.x, track.pose.pose.position.y = x, y
            tracks.tracks.append(track)
        self._write("tracked_persons", tracks, time)

    def _write_decision(self, time):
        belief = CrowdBelief(header=self._header(time), destinations=[Point(0, 0, 0), Point(0, 40, 0)])
        belief.people = [PersonBelief(id=self.belief_id(k), position=Point(x, y, 0.0),
                                      probabilities=[0.1, 0.9])
                         for k, (x, y) in enumerate(self.places(time))]
        self._write("planner_node/beliefs", belief, time)
        status = PlannerStatus(header=self._header(time), state_name="DRIVING", decisions=3,
                               trials=200, cycle_time=0.35)
        self._write("planner_node/status", status, time)
        robot = (2.0 + 2.0 * time, 20.0)
        tree = Marker(header=self._header(time), ns="tree", type=Marker.LINE_LIST, color=RED)
        tree.scale.x, tree.pose.orientation.w = 0.1, 1.0
        for k in range(-3, 4):
            end = (robot[0] + 4.0 * math.cos(0.3 * k), robot[1] + 4.0 * math.sin(0.3 * k))
            tree.points += [Point(*robot, 0.0), Point(*end, 0.0)]
        self._write("planner_node/search_tree", MarkerArray([tree]), time)
        plan = Path(header=self._header(time))
        for k in range(3):
            pose = PoseStamped(header=plan.header)
            pose.pose.position.x, pose.pose.position.y = robot[0] + k, 20.0
            plan.poses.append(pose)
        self._write("planner_node/local_plan", plan, time)
