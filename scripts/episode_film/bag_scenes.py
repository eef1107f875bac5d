# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of a recorded episode."""
import math

import numpy

from command_line.refusal import Refusal
from episode_bag import names, opening

from . import markers
from .frames import Frames, yaw_of
from .people import People
from .scene import NOWHERE, Place, Scene

TF = ("/tf", "/tf_static")
FRAME_SOURCES = ("nav_msgs/OccupancyGrid", "pomdp_crowd_nav/CrowdBelief", "nav_msgs/Path")
MARGIN = 10.0  # [m], where there is no map


class BagScenes:
    """Reads a bag once, from front to back; of each topic only what is shown is taken apart."""

    ZOOM = 24.0  # [m]

    def __init__(self, bag, path, namespace):
        self.bag, self.path = bag, path
        self.types = opening.types_of(bag)
        self.namespace = namespace
        self.begin, self.end = bag.get_start_time(), bag.get_end_time()
        self.topics = self._find_topics()
        self.frames = Frames(self._global_frame())
        self.raw, self.decoded = {}, {}
        self.people = People(self.frames)

    def _of_type(self, *kinds):
        """A topic of that type in the robot's namespace, else anywhere but with other robots."""
        others = [name + "/" for name in names.namespaces(self.types)
                  if name and name != self.namespace]
        found = [topic for topic, kind in self.types.items()
                 if kind in kinds and not topic.startswith(tuple(others))]
        found.sort(key=lambda topic: (names.is_of_a_node(topic),
                                      not topic.startswith(self.namespace + "/"), topic))
        return found[0] if found else None

    def _find_topics(self):
        own = self.namespace
        topics = {
            "odom": self._of_type("nav_msgs/Odometry"),
            "map": self._of_type("nav_msgs/OccupancyGrid"),
            "tracks": self._of_type("pomdp_crowd_nav/TrackedPersons",
                                    "spencer_tracking_msgs/TrackedPersons"),
            "people": self._of_type("pomdp_crowd_nav/People", "people_msgs/People"),
            "metrics": own + "/sim_node/metrics",
            "crowd": own + "/sim_node/crowd_markers", "world": own + "/sim_node/world_markers"}
        for name, topic in (("beliefs", "beliefs"), ("rings", "belief_markers"), ("robot", "robot_markers"),
                            ("tree", "search_tree"), ("plan", "local_plan"),
                            ("way", "global_plan"), ("goal", "current_goal"),
                            ("status", "status")):
            topics[name] = f"{own}/planner_node/{topic}"
        topics = {name: topic for name, topic in topics.items() if topic in self.types}
        if "odom" not in topics:
            raise Refusal(f"{self.path}: no odometry in it, so nobody knows where the robot was")
        return topics

    def _global_frame(self):
        wanted = [topic for kind in FRAME_SOURCES for topic in self.topics.values()
                  if self.types[topic] == kind]
        for topic in wanted:
            for _, message, _ in self.bag.read_messages([topic]):
                if message.header.frame_id:
                    return message.header.frame_id.lstrip("/")
        return "map"

    def first(self, name):
        if name not in self.topics:
            return None
        messages = self.bag.read_messages([self.topics[name]])
        return next((message for _, message, _ in messages), None)

    def place(self):
        """The field, from the simulator's picture of the world, the map, or where the robot was."""
        world, grid = self.first("world"), self.first("map")
        outlines = markers.lines_of(world) if world else []
        robot = self.first("robot")
        radius = markers.radius_of(robot, "disc") if robot else 0.0
        picture = grid_of(grid) if grid else None
        if outlines:
            corners = numpy.concatenate([lines.shapes.reshape(-1, 2) for lines in outlines])
            lows, highs = corners.min(axis=0), corners.max(axis=0)
            bounds = (*lows, *highs)
        elif picture:
            left, right, bottom, top = picture[1]
            bounds = (left, bottom, right, top)
        else:
            bounds = self._bounds_of_drive()
        return Place(bounds, radius or 0.5, outlines, None if outlines else picture)

    def _bounds_of_drive(self):
        frames, places = Frames(self.frames.root), []
        for topic, message, _ in self.bag.read_messages([*TF, self.topics["odom"]]):
            if topic in TF:
                frames.hear(message)
            else:
                places.append(robot_pose(message, frames)[:2])
        lows, highs = numpy.min(places, axis=0) - MARGIN, numpy.max(places, axis=0) + MARGIN
        return (*lows, *highs)

    def scenes(self, start, end, step):
        """A scene every `step` seconds of the bag."""
        by_topic = {topic: name for name, topic in self.topics.items()}
        due = self.begin + start
        for topic, raw, stamp in self.bag.read_messages([*by_topic, *TF], raw=True):
            while stamp.to_sec() > due and due <= self.begin + end:
                scene = self._scene(due - self.begin)
                if scene:
                    yield scene
                due += step
            if due > self.begin + end:
                return
            if topic in TF:
                self.frames.hear(decode(raw))
            else:
                self.raw[by_topic[topic]] = raw
                self.decoded.pop(by_topic[topic], None)
        scene = self._scene(due - self.begin)
        if scene:
            yield scene

    def newest(self, name):
        if name in self.raw and name not in self.decoded:
            self.decoded[name] = decode(self.raw[name])
        return self.decoded.get(name)

    def _scene(self, time):
        odom = self.newest("odom")
        if odom is None:
            return None
        status, goal, tree = self.newest("status"), self.newest("goal"), self.newest("tree")
        rings, crowd = self.newest("rings"), self.newest("crowd")
        people = self.people.seen(self.newest("tracks"), self.newest("people"),
                                  self.newest("beliefs"))
        return Scene(
            time=time, robots=[robot_pose(odom, self.frames)], people=people,
            others=markers.spots_of(crowd, "really_there") if crowd else NOWHERE,
            tree=markers.lines_of(tree) if tree else [],
            rings=markers.lines_of(rings, "attended") if rings else [],
            plan=path_of(self.newest("plan")), way=path_of(self.newest("way")),
            goal=(goal.pose.position.x, goal.pose.position.y) if goal else None,
            state=status.state_name if status else "",
            detail=detail_of(status, odom, people))


def decode(raw):
    _, data, _, _, kind = raw
    message = kind()
    message.deserialize(data)
    return message


def robot_pose(odom, frames):
    pose = odom.pose.pose
    own = (pose.position.x, pose.position.y, yaw_of(pose.orientation))
    return frames.pose(odom.header.frame_id, own) or own


def path_of(message):
    if message is None:
        return NOWHERE
    return numpy.array([(pose.pose.position.x, pose.pose.position.y)
                        for pose in message.poses]).reshape(-1, 2)


def grid_of(message):
    """A picture of an occupancy grid whose axes are those of the map, and where it is."""
    info = message.info
    if not info.width or not info.height or abs(yaw_of(info.origin.orientation)) > 1e-6:
        return None
    cells = numpy.array(message.data, dtype=numpy.int16).reshape(info.height, info.width)
    picture = numpy.where(cells < 0, 225, 255 - cells * 110 // 100).astype(numpy.uint8)
    x, y = info.origin.position.x, info.origin.position.y
    return picture, (x, x + info.width * info.resolution, y, y + info.height * info.resolution)


def detail_of(status, odom, people):
    twist = odom.twist.twist.linear
    parts = [f"{math.hypot(twist.x, twist.y):.1f} m/s", f"{len(people)} people seen"]
    if status and status.trials:
        parts.append(f"{status.trials} trials in {status.cycle_time:.2f} s")
    if status and status.stop_cause:
        parts.append(status.stop_cause)
    return ", ".join(parts)
