# SPDX-License-Identifier: BSD-3-Clause
"""simulation.launch without faults, driven from goal to goal: what measurements are taken of."""
import time

import rospkg
import rospy

from command_line.progress import Progress

from .outputs import StatusWatch
from .stack import PACKAGE, Stack
from .trips import Trips, World
from .truth import Truth

START_TIMEOUT = 120.0  # [s]


class UndisturbedDrive:
    def __init__(self, options, folder, planned):
        """`planned`: [s] that will be spent in all."""
        self.options, self.folder = options, folder
        self.planned, self.spent = planned, 0.0
        self.stack = Stack(folder, {
            "world": options.world, "pedestrians": options.people, "profile": options.profile,
            "seed": options.seed, "rviz": "false", "send_goal": "false"}, with_relay=False)

    def start(self, name):
        """As the ROS node `name`; raises RuntimeError where the nodes do not answer."""
        self.stack.start()
        rospy.init_node(name, disable_signals=True)
        share = rospkg.RosPack().get_path(PACKAGE)
        world = World(f"{share}/config/worlds/{self.options.world}.yaml", self.options.seed)
        self.status, truth = StatusWatch(), Truth(world.start)
        self.trips = Trips(world, truth, self.status)
        end = time.monotonic() + START_TIMEOUT
        while not (self.status.is_alive() and truth.metrics):
            if time.monotonic() > end or not self.stack.is_running():
                raise RuntimeError(f"the nodes do not answer; their logs are in {self.folder}/log")
            time.sleep(0.2)
        self.progress = Progress(f"{name}.py", pause=15.0)

    def spend(self, seconds, is_driving=True):
        """Drives on, or waits, and says how long all that is planned still takes."""
        begin, end = time.monotonic(), time.monotonic() + seconds
        while time.monotonic() < end and self.stack.is_running():
            if is_driving:
                self.trips.look()
            time.sleep(0.1)
            self.progress.show(self.spent + time.monotonic() - begin, self.planned, " s")
        self.spent += seconds
        if self.spent >= self.planned:
            self.progress.end()

    def stop(self):
        self.stack.stop()
