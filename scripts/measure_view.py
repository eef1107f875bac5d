#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the view costs: processor time of planner_node and of its display thread, by who looks.

  measure_view.py --seconds 30 --build-dir build

Starts simulation.launch on a master of its own and prints a Markdown table: idle and driving, without
a subscriber to any picture, and with one to each. In per cent of a processor. The subscriber is a
process of its own that only counts; RViz's own time is not in the figures. Exit status 0, or 2 for a
bad option or nodes that do not start.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
# pylint: disable=wrong-import-position,import-outside-toplevel
from soak_harness import environment  # noqa: E402

SETTLE = 4.0           # [s], until a change shows
PICTURES = ("belief_markers", "robot_markers", "search_tree", "arrival_time", "roadmap")
LISTENER = """
import rospy, sys
rospy.init_node("view_listener", disable_signals=False)
for topic in sys.argv[1:]:
    rospy.Subscriber(topic, rospy.AnyMsg, lambda message: None)
rospy.spin()
"""


def say(text):
    print(f"measure_view.py: {text}", file=sys.stderr)


def parse():
    parser = environment.Parser(prog="measure_view.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    environment.add_common_options(parser)
    parser.add_argument("--seconds", type=environment.number(1, 3600), default=30.0,
                        help="of each of the four measurements")
    options = parser.parse_args()
    if not options.output:
        options.output = time.strftime("view_%Y%m%d_%H%M%S")
        sys.argv += ["--output", options.output]
    return parser, options


def seconds_of(pid):
    """Processor time [s] of a process: of all its threads, and of the one called display."""
    total = display = 0.0
    for thread in pathlib.Path(f"/proc/{pid}/task").iterdir():
        name, fields = (thread / "stat").read_text().split("(", 1)[1].rsplit(")", 1)
        fields = fields.split()
        used = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
        total += used
        display += used if name == "display" else 0.0
    return total, display


class Measurement:
    def __init__(self, options, folder):
        from soak_harness.undisturbed import UndisturbedDrive
        self.options, self.folder = options, folder
        self.drive = UndisturbedDrive(options, folder, 4 * (SETTLE + options.seconds))

    def measure(self, name, is_driving):
        """A row of the table."""
        from soak_harness.stack import PLANNER
        say(f"{name}, {self.options.seconds:g} s…")
        self.drive.spend(SETTLE, is_driving)
        pid = self.drive.stack.pids().get(PLANNER)
        if not pid:
            raise RuntimeError(f"planner_node has ended; the logs are in {self.folder}/log")
        before, begin = seconds_of(pid), time.monotonic()
        self.drive.spend(self.options.seconds, is_driving)
        duration = time.monotonic() - begin
        shares = [100.0 * (b - a) / duration for a, b in zip(before, seconds_of(pid))]
        return f"| {name} | {shares[0]:.1f} | {shares[1]:.1f} |"

    def measure_seen(self, name, is_driving):
        """The same while somebody looks at every picture."""
        from soak_harness.stack import PLANNER
        listener = subprocess.Popen([sys.executable, "-c", LISTENER]
                                    + [f"/{PLANNER}/{topic}" for topic in PICTURES])
        try:
            return self.measure(name, is_driving)
        finally:
            listener.terminate()
            listener.wait()


def run(measurement):
    rows = [measurement.measure("idle, nobody looks", False),
            measurement.measure_seen("idle, all layers", False)]
    measurement.drive.trips.send()
    rows += [measurement.measure("driving, nobody looks", True),
             measurement.measure_seen("driving, all layers", True)]
    options, output = measurement.options, sys.__stdout__
    print(f"{options.world}, {options.people} people, profile {options.profile}, "
          f"{options.seconds:g} s each:\n", file=output)
    print("| | planner_node [% of a processor] | of that the display thread |", file=output)
    print("|---|---|---|", file=output)
    print("\n".join(rows), file=output)


def work(options, folder):
    measurement = Measurement(options, folder)
    try:
        measurement.drive.start("measure_view")
        run(measurement)
    finally:
        measurement.drive.stop()


if __name__ == "__main__":
    sys.exit(environment.run(parse, work, say))
