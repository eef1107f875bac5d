#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Period of the commands and time of the decisions while other work takes every processor.

  measure_jitter.py --minutes 10 --load 2 --build-dir build

Starts simulation.launch on a master of its own, drives from goal to goal without faults, and prints
two rows of a Markdown table: without other work, and with --load busy processes of the nodes' own
priority; --minutes each. The periods are those at which commands arrive here, so that delays of this
listener count too; as root it runs at a higher priority than the rest. Exit status 0, or 2 for a bad
option or nodes that do not start.
"""
import argparse
import os
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
# pylint: disable=wrong-import-position,import-outside-toplevel
from soak_harness import environment  # noqa: E402

PRIORITY = -10        # niceness of this listener, where it may have it
WARM_UP = 10.0        # [s]


def say(text):
    print(f"measure_jitter.py: {text}", file=sys.stderr)


def parse():
    number = environment.number
    parser = environment.Parser(prog="measure_jitter.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    environment.add_common_options(parser)
    parser.add_argument("--minutes", type=number(0.1, 1e4), default=10.0,
                        help="of each of the two measurements (%(default)s)")
    parser.add_argument("--load", type=number(1, 1000, int), default=os.cpu_count(),
                        help="busy processes, by default one for each processor")
    options = parser.parse_args()
    if not options.output:
        options.output = time.strftime("jitter_%Y%m%d_%H%M%S")
        sys.argv += ["--output", options.output]
    return parser, options


def hurry():
    """The higher priority for each thread of this process; whether it was granted."""
    try:
        for thread in os.listdir("/proc/self/task"):
            os.setpriority(os.PRIO_PROCESS, int(thread), PRIORITY)
        return True
    except (PermissionError, ProcessLookupError):
        return False


class Measurement:
    def __init__(self, options, folder):
        from soak_harness.undisturbed import UndisturbedDrive
        self.options, self.folder = options, folder
        self.drive = UndisturbedDrive(options, folder, WARM_UP + 2 * 60.0 * options.minutes)

    def start(self):
        import rospy
        from soak_harness.outputs import CommandWatch
        from soak_harness.stack import PLANNER
        self.drive.start("measure_jitter")
        self.status = self.drive.status
        self.commands = CommandWatch(rospy.get_param(f"/{PLANNER}/max_vel_trans", 1.0),
                                     rospy.get_param(f"/{PLANNER}/max_vel_theta", 1.0))
        self.status.on_idle = self.commands.interrupt
        self.drive.trips.send()
        self.drive.spend(WARM_UP)

    def measure(self, name):
        """A row of the table."""
        from soak_harness.figures import summary
        begin = (len(self.commands.periods), len(self.status.cycle_times),
                 self.status.deadline_misses)
        say(f"{name}, {self.options.minutes:g} min…")
        self.drive.spend(60.0 * self.options.minutes)
        if not self.drive.stack.is_running():
            raise RuntimeError(f"sim_node has ended; the logs are in {self.folder}/log")
        period = summary(self.commands.periods[begin[0]:])
        times = summary(self.status.cycle_times[begin[1]:])
        cells = [f"{1000.0 * figures[key]:.1f}" for figures in (period, times)
                 for key in ("p50", "p99", "max")]
        return "| " + " | ".join([name, str(period["count"]), *cells[:3], str(times["count"]),
                                  *cells[3:], str(self.status.deadline_misses - begin[2])]) + " |"


def run(measurement, has_priority):
    from soak_harness.process_faults import busy_processes
    options = measurement.options
    rows = [measurement.measure("none")]
    busy = busy_processes(options.load, 0)
    try:
        rows.append(measurement.measure(f"{options.load} busy processes"))
    finally:
        for process in busy:
            process.kill()
    output = sys.__stdout__
    print(f"{options.world}, {options.people} people, profile {options.profile}, "
          f"{os.cpu_count()} processors, {options.minutes:g} min each, the listener at "
          f"{'higher' if has_priority else 'the same'} priority:\n", file=output)
    print("| other work | commands | period p50 [ms] | p99 | max | decisions | time p50 [ms] | p99 "
          "| max | too late |", file=output)
    print("|---|---|---|---|---|---|---|---|---|---|", file=output)
    print("\n".join(rows), file=output)


def work(options, folder):
    measurement = Measurement(options, folder)
    try:
        measurement.start()
        run(measurement, hurry())
    finally:
        measurement.drive.stop()


if __name__ == "__main__":
    sys.exit(environment.run(parse, work, say))
