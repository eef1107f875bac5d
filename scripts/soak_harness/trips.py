# SPDX-License-Identifier: BSD-3-Clause
"""A new random goal on arrival, and wherever a goal got lost."""
import math
import random
import time

import rospy
import yaml
from actionlib_msgs.msg import GoalID
from geometry_msgs.msg import PoseStamped

MARGIN = 5.0      # [m] of goals from border and obstacles
CLOSEST = 20.0    # [m] of a goal from the robot
SETTLING = 2.0    # [s] in which a goal that was sent may not show in the planner's state yet


class World:
    """Places of a world file; of a field whose obstacles are circles and polygons."""

    def __init__(self, path, seed):
        with open(path, encoding="utf-8") as file:
            world = yaml.safe_load(file)
        self.start = tuple(world["start"])
        self.low, self.high = world["bounds"]["min"], world["bounds"]["max"]
        self.circles = world.get("circles", [])
        self.walls = [vertex for polygon in world.get("polygons", [])
                      for vertex in polygon["vertices"]]
        self.random = random.Random(seed)

    def is_free(self, x, y):
        return (all(math.hypot(x - cx, y - cy) > radius + MARGIN for cx, cy, radius in self.circles)
                and all(math.hypot(x - vx, y - vy) > 2.0 * MARGIN for vx, vy in self.walls))

    def place(self, away_from=None):
        margin = [min(MARGIN, 0.2 * (high - low)) for low, high in zip(self.low, self.high)]
        while True:
            x, y = (self.random.uniform(low + m, high - m)
                    for low, high, m in zip(self.low, self.high, margin))
            far = 0.25 * (self.high[0] - self.low[0]) if away_from else 0.0
            if self.is_free(x, y) and (not away_from or math.hypot(
                    x - away_from[0], y - away_from[1]) > min(far, CLOSEST)):
                return x, y


class Trips:
    def __init__(self, world, truth, status):
        self.world, self.truth, self.status = world, truth, status
        self.goals = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=60)
        self.cancels = rospy.Publisher("move_base/cancel", GoalID, queue_size=1)
        self.goal = None
        self.sent = self.last_arrival = time.monotonic()
        self.sent_count = self.reached = 0
        self.has_left = False  # the planner has been seen busy with the goal

    def send(self, goal=None):
        self.goal = goal or self.world.place(self.truth.position)
        message = PoseStamped()
        message.header.frame_id = "map"
        message.pose.position.x, message.pose.position.y = self.goal
        message.pose.orientation.w = 1.0
        self.goals.publish(message)
        self.sent = time.monotonic()
        self.sent_count += 1
        self.has_left = False

    def cancel(self):
        self.cancels.publish(GoalID())

    def is_at_goal(self):
        x, y = self.truth.position
        return self.goal and math.hypot(x - self.goal[0], y - self.goal[1]) < 2.0

    def look(self):
        """Sends the next goal when the planner has none."""
        state = self.status.state()
        if state not in ("IDLE", "SILENT"):
            self.has_left = True
        if state != "IDLE" or time.monotonic() - self.sent < SETTLING:
            return
        if self.has_left and self.is_at_goal() and self.truth.has_reached_goal():
            self.reached += 1
            self.last_arrival = time.monotonic()
            self.goal = None
        self.send(self.goal)  # one that got lost is sent again
