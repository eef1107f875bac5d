# SPDX-License-Identifier: BSD-3-Clause
"""Which topics of a bag are played, and under which names.

A list of what may be played, not of what may not: whatever is not known to be only looked at stays
in the bag. No command, goal, cancellation or pose to drive from is among it.
"""
from command_line.refusal import Refusal
from episode_bag import names

TYPES = {
    "diagnostic_msgs/DiagnosticArray", "geometry_msgs/PolygonStamped", "geometry_msgs/PoseArray",
    "nav_msgs/GridCells", "nav_msgs/OccupancyGrid", "nav_msgs/Odometry", "nav_msgs/Path",
    "people_msgs/People", "pomdp_crowd_nav/CrowdBelief", "pomdp_crowd_nav/EpisodeMetrics",
    "pomdp_crowd_nav/GuardStatus", "pomdp_crowd_nav/People", "pomdp_crowd_nav/PlannerStatus",
    "pomdp_crowd_nav/TrackedPersons", "sensor_msgs/LaserScan", "sensor_msgs/PointCloud2",
    "spencer_tracking_msgs/TrackedPersons", "tf/tfMessage", "tf2_msgs/TFMessage",
    "visualization_msgs/Marker", "visualization_msgs/MarkerArray"}
POSE = "geometry_msgs/PoseStamped"  # a goal to show or a goal to drive to: the name decides
COMMANDS = ("Twist", "TwistStamped", "AckermannDrive", "AckermannDriveStamped")
SHOWN_POSE = "/planner_node/current_goal"


def may_be_played(topic, kind):
    if kind == POSE:
        return topic.endswith(SHOWN_POSE)
    return kind in TYPES


def is_command(kind):
    """Whether publishers of this type say that something can be driven here."""
    return kind.split("/")[-1] in COMMANDS


class Selection:
    """What is played of one robot's topics. {topic in the bag: topic to play it as}"""

    def __init__(self, types, wanted_namespace, path):
        self.namespace = names.namespace_of(types, wanted_namespace, path)
        others = [name for name in names.namespaces(types) if name != self.namespace]
        self.played, self.left_out = {}, []
        for topic, kind in sorted(types.items()):
            if any(topic.startswith(other + "/") for other in others if other):
                continue  # of another robot
            if may_be_played(topic, kind):
                self.played[topic] = self.shown_as(topic)
            else:
                self.left_out.append(topic)
        if not self.played:
            raise Refusal(f"{path}: there is nothing to show in it")
        self.name_map(types)

    def shown_as(self, topic):
        """Without the robot's namespace, so that RViz's configuration fits."""
        inside = self.namespace and topic.startswith(self.namespace + "/")
        return topic[len(self.namespace):] if inside else topic

    def name_map(self, types):
        """RViz looks for the map at /map, whatever the robot called it."""
        maps = [topic for topic in self.played if types[topic] == "nav_msgs/OccupancyGrid"
                and not names.is_of_a_node(topic)]
        if len(maps) == 1:
            self.played[maps[0]] = "/map"

    def arguments(self):
        """Of rosbag play."""
        renamed = [f"{topic}:={name}" for topic, name in self.played.items() if topic != name]
        return ["--topics", *self.played, *renamed]
