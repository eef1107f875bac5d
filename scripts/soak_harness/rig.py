# SPDX-License-Identifier: BSD-3-Clause
"""The whole set-up of a soak, and what each fault has led to."""
import csv
import random
import threading
import time

import rospkg
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped

from .blame import is_violation
from .faults import Limits, endless, faults
from .memory import Memory
from .outputs import CommandWatch, StatusWatch
from .relay import Relay
from .stack import PACKAGE, PLANNER, SIMULATOR, Stack
from .trips import Trips, World
from .truth import Truth

START_TIMEOUT = 120.0  # [s] until the nodes answer
SAMPLE_PERIOD = 10.0   # [s]
FAST = 0.5             # of the greatest speed; a fault that asks for rest waits until the base has it
PATIENCE = 8.0         # [s] of that wait


def arguments_of(options):
    return {"world": options.world, "pedestrians": options.people, "profile": options.profile,
            "seed": options.seed, "rviz": "false", "send_goal": "false",
            "use_sim_time": "true" if options.use_sim_time else "false"}


def braking_time(name="/" + PLANNER):
    """[s] from the greatest speed to rest."""
    if rospy.get_param(name + "/instant_velocity", False):
        return 0.0
    return (rospy.get_param(name + "/max_vel_trans", 1.0) /
            rospy.get_param(name + "/brake_deceleration", 1.0))


def limits_of(slack, name="/" + PLANNER):
    return Limits(odometry=rospy.get_param(name + "/odom_timeout", 0.5),
                  people=rospy.get_param(name + "/people_timeout", 1.0),
                  transform=rospy.get_param(name + "/transform_tolerance", 0.3),
                  command=rospy.get_param(f"/{SIMULATOR}/command_timeout", 0.5),
                  braking=braking_time(name), slack=slack)


class Rig:
    def __init__(self, options, folder, say):
        self.options, self.folder, self.say = options, folder, say
        self.random = random.Random(options.seed)
        self.is_over = threading.Event()
        self.violations = []
        self.outcomes = []
        self.busy = []
        self.begin = time.monotonic()
        self.world = World(self._world_file(), options.seed)
        self.stack = Stack(folder, arguments_of(options))
        self.memory = Memory(options.duration / 6.0)

    def _world_file(self):
        share = rospkg.RosPack().get_path(PACKAGE)
        return f"{share}/config/worlds/{self.options.world}.yaml"

    def start(self):
        """Raises RuntimeError where the nodes do not answer."""
        self.stack.start()
        rospy.init_node("soak", disable_signals=True)
        self.relay = Relay(self.options.use_sim_time)
        self.truth, self.status = Truth(self.world.start, self.relay), StatusWatch()
        self.trips = Trips(self.world, self.truth, self.status)
        self.places = rospy.Publisher("initialpose", PoseWithCovarianceStamped, queue_size=1)
        end = time.monotonic() + START_TIMEOUT
        while not (self.status.is_alive() and self.truth.metrics):
            if time.monotonic() > end or not self.stack.is_running():
                raise RuntimeError(f"the nodes do not answer; their logs are in {self.folder}/log")
            time.sleep(0.2)
        self.commands = CommandWatch(rospy.get_param(f"/{PLANNER}/max_vel_trans", 1.0),
                                     rospy.get_param(f"/{PLANNER}/max_vel_theta", 1.0))
        self.commands.on_violation = self.violate
        self.status.on_idle = self.commands.interrupt
        self.truth.on_event = self._on_unsafe
        self.schedule = endless(
            faults(limits_of(self.options.slack), self.stack.guards(), self.options.use_sim_time),
            self.options.seed)
        self.begin = time.monotonic()
        self.trips.last_arrival = self.begin
        self.trips.send()

    def now(self):
        return time.monotonic() - self.begin

    def violate(self, text):
        self.violations.append({"time_s": round(self.now(), 2), "what": text})
        if len(self.violations) <= 20:
            self.say(f"{self.now():.1f} s: {text}")

    def _on_unsafe(self, event):
        event["time"] = round(event["time"] - self.begin, 2)
        event["fault"] = self.outcomes[-1]["fault"] if self.outcomes else ""
        if is_violation(event["cause"]):
            self.violate(f"unsafe: {event}")

    def look(self):
        """What is watched all the time."""
        self.trips.look()
        for name in self.stack.unexpected_deaths():
            self.violate(f"{name} died")
        if time.monotonic() - self.trips.last_arrival > self.options.goal_timeout:
            self.violate(f"no goal reached for {self.options.goal_timeout:g} s; "
                         f"the planner says {self.status.state()}")
            self.trips.last_arrival = time.monotonic()

    def inject(self, fault):
        """Injects a fault and watches until it is over."""
        if fault.bound is not None:
            self._await_speed()
        outcome = {"time_s": round(self.now(), 2), "fault": fault.name, "bound_s": fault.bound,
                   "speed_mps": round(self.truth.speed, 2), "rest_s": None, "moved_again": False,
                   "ready_s": None}
        self.outcomes.append(outcome)
        fault.begin(self)
        begin = time.monotonic()
        while time.monotonic() - begin < fault.duration or self._is_awaited(fault, begin, outcome):
            self._watch_rest(fault, begin, outcome)
            if self.is_over.wait(0.01):
                break
        fault.end(self)
        if fault.bound is not None and not self.is_over.is_set():
            self._judge_rest(fault, outcome)

    def _await_speed(self):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and self.truth.speed < FAST * self.commands.max_speed:
            if self.is_over.wait(0.01):
                return

    @staticmethod
    def _is_awaited(fault, begin, outcome):
        return (fault.bound is not None and outcome["rest_s"] is None and
                time.monotonic() - begin < fault.bound)

    def _watch_rest(self, fault, begin, outcome):
        took = time.monotonic() - begin
        if outcome["rest_s"] is None and self.truth.is_at_rest():
            outcome["rest_s"] = round(took, 3)
        elif fault.holds and outcome["rest_s"] is not None and fault.bound is not None and \
                took > fault.bound and took < fault.duration and not self.truth.is_at_rest():
            outcome["moved_again"] = True

    def _judge_rest(self, fault, outcome):
        if outcome["rest_s"] is None or outcome["rest_s"] > fault.bound:
            self.violate(f"{fault.name}: not at rest within {fault.bound:.2f} s")
        if outcome["moved_again"]:
            self.violate(f"{fault.name}: moved while the fault lasted")

    def recover(self, until):
        """Waits for the next fault; by then the planner has to be ready again."""
        begin, outcome = time.monotonic(), self.outcomes[-1] if self.outcomes else {}
        while time.monotonic() < until and not self.is_over.is_set():
            if outcome.get("ready_s") is None and time.monotonic() - begin > 0.5 \
                    and self.status.is_ready():
                outcome["ready_s"] = round(time.monotonic() - begin, 2)
            self.is_over.wait(0.05)
        if self.outcomes and outcome["ready_s"] is None and not self.is_over.is_set():
            self.violate(f"{outcome['fault']}: not ready again, {self.status.state()} "
                         f"{self.status.newest.stop_cause if self.status.newest else ''}")

    def stop(self):
        self.is_over.set()
        for process in self.busy:
            process.kill()
        self.stack.stop()


class SampleFile:
    """A row every 10 s."""

    FIELDS = ["time_s", "node", "resident_mb", "goals_reached", "decisions", "deadline_misses",
              "commands", "unsafe_steps", "faults", "state"]

    def __init__(self, path):
        self.file = open(path, "w", newline="", encoding="utf-8")
        self.rows = csv.writer(self.file)
        self.rows.writerow(self.FIELDS)

    def sample(self, rig):
        now = rig.now()
        for node, size in rig.memory.sample(now, rig.stack.pids()).items():
            self.rows.writerow([f"{now:.1f}", node, f"{size:.2f}", rig.trips.reached,
                                rig.status.decisions, rig.status.deadline_misses,
                                rig.commands.count, rig.truth.totals["unsafe_steps"],
                                len(rig.outcomes), rig.status.state()])
        self.file.flush()

    def close(self):
        self.file.close()
