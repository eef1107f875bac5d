# SPDX-License-Identifier: BSD-3-Clause
"""The programs that a replay runs, and its course."""
import ctypes
import os
import signal
import subprocess
import sys
import time

import roslib.packages

from command_line.progress import Progress
from command_line.refusal import Refusal

WAIT_FOR_RVIZ = 30.0  # [s]
PATIENCE = 5.0        # [s] for a program to end by itself


def program(package, name, hint):
    found = roslib.packages.find_node(package, name)
    if not found:
        raise Refusal(f"{package} {name} was not found: {hint}")
    return found[0]


LIBC = ctypes.CDLL(None)
PR_SET_PDEATHSIG = 1  # see prctl(2)


def end_with_parent():
    """The calling process gets SIGINT when its parent is gone, however that ended."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGINT)


class Child:
    """A program of its own process group: Ctrl-C reaches this script alone, which ends it."""

    def __init__(self, arguments, **options):
        self.process = subprocess.Popen(arguments, start_new_session=True,
                                        preexec_fn=end_with_parent, **options)

    def has_ended(self):
        return self.process.poll() is not None

    def end(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            if self.has_ended():
                return
            try:
                os.killpg(self.process.pid, number)
                self.process.wait(PATIENCE)
            except (ProcessLookupError, subprocess.TimeoutExpired):
                pass


class Replay:
    """RViz first, then the bag, watched for others who publish the same."""

    def __init__(self, program_name, master, episode, rate):
        self.program_name, self.master, self.episode, self.rate = program_name, master, episode, rate
        self.rviz = self.bag = None

    def start_rviz(self, view):
        path = program("rviz", "rviz", "install rviz, or replay with rviz:=false")
        self.rviz = Child([path, "-d", str(view), "__name:=replay_rviz",
                           "robot_description:=/replay_episode/robot_description"])
        begin = time.monotonic()
        wanted = set(self.episode.selection.played.values())
        while not wanted & self.master.subscribers("/replay_rviz"):
            if self.rviz.has_ended():
                raise Refusal("RViz did not start; without a display replay with rviz:=false")
            if time.monotonic() - begin > WAIT_FOR_RVIZ:
                raise Refusal(f"RViz shows nothing of the bag after {WAIT_FOR_RVIZ:.0f} s")
            time.sleep(0.2)
        time.sleep(1.0)  # the other displays

    def start_bag(self):
        """A later start has what latched topics had said before: rosbag play sees to it."""
        path = program("rosbag", "play", "install python3-rosbag (Noetic: ros-noetic-rosbag)")
        episode = self.episode
        self.bag = Child([path, "--clock", "--quiet", "--delay", "0.02", "--rate", f"{self.rate:g}",
                          "--start", f"{episode.start:.6f}", *episode.selection.arguments(),
                          "--bags", str(episode.path), "__name:=replay_player"],
                         stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)

    def watch(self):
        """Until the bag is over; RViz stays open after that until somebody closes it."""
        progress, begin = Progress(self.program_name), time.monotonic()
        length = self.episode.duration - self.episode.start
        topics = set(self.episode.selection.played.values())
        while not self.bag.has_ended():
            time.sleep(0.5)
            progress.show(min(length, (time.monotonic() - begin) * self.rate), length, " s")
            if self.rviz and self.rviz.has_ended():
                return "RViz was closed"
            conflict = self.master.conflict(topics)
            if conflict:
                raise Refusal(f"stopped: {conflict}")
        progress.end()
        if self.bag.process.returncode:
            raise Refusal(f"rosbag play ended with status {self.bag.process.returncode}")
        return "the end of the bag"

    def wait_for_rviz(self):
        while self.rviz and not self.rviz.has_ended():
            time.sleep(0.2)

    def end(self):
        for child in (self.bag, self.rviz):
            if child:
                child.end()
        sys.stderr.flush()
