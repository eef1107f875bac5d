#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Drives in the simulator for hours, breaks something every few seconds, and checks all the time.

  soak.py --duration 3600 --seed 1 --people 400 --fault-period 20 --build-dir build

Starts simulation.launch by itself, on a master of its own. Everything that the planner and the guard
hear of the simulator comes through a relay that can lose, change and flood it; what really happens is
measured at the simulator. Checked are: no process dies by itself; no command over the limits or not
finite; no unsafe moving step that the robot has caused; at rest in time after each fault, ready again
before the next one; goals are reached; memory is flat; nothing in the logs from a sanitizer.

Writes samples.csv, soak.json and the nodes' logs. Exit status 0 when all held, 1 when not, 2 for a
bad option or nodes that do not start.
"""
import argparse
import pathlib
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
# pylint: disable=wrong-import-position,import-outside-toplevel
from soak_harness import environment  # noqa: E402


def say(text):
    print(f"soak.py: {text}", file=sys.stderr)


def parse():
    number = environment.number
    parser = environment.Parser(prog="soak.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    environment.add_common_options(parser)
    parser.add_argument("--duration", type=number(10.0, 1e6), default=3600.0,
                        help="[s] to drive (%(default)s)")
    parser.add_argument("--fault-period", type=number(8.0, 1e6), default=20.0,
                        help="[s] from one fault to the next (%(default)s)")
    parser.add_argument("--goal-timeout", type=number(1.0, 1e6), default=600.0,
                        help="[s] in which a goal must be reached (%(default)s)")
    parser.add_argument("--slack", type=number(0.0, 60.0), default=0.5,
                        help="[s] on top of each bound, for cycles and a busy machine "
                             "(%(default)s)")
    parser.add_argument("--max-growth", type=number(0.0, 1e6), default=10.0,
                        help="[MB/h] of a node's memory (%(default)s)")
    parser.add_argument("--use-sim-time", choices=["true", "false"], default="true",
                        help="whether the simulator is the clock, which then jumps too "
                             "(%(default)s)")
    options = parser.parse_args()
    options.use_sim_time = options.use_sim_time == "true"
    if not options.output:
        options.output = time.strftime("soak_%Y%m%d_%H%M%S")
        sys.argv += ["--output", options.output]
    return parser, options


def progress(rig):
    left = max(0.0, rig.options.duration - rig.now())
    say(f"{left:5.0f} s left, {len(rig.outcomes)} faults, {rig.trips.reached} goals, "
        f"{len(rig.violations)} violations, {rig.status.state()}")


def run(rig, samples):
    from soak_harness.rig import SAMPLE_PERIOD
    import threading

    def watch():
        count = 0
        while not rig.is_over.wait(0.2):
            rig.look()
            if rig.now() >= count * SAMPLE_PERIOD:
                samples.sample(rig)
                if count % 3 == 0:
                    progress(rig)
                count += 1
    watcher = threading.Thread(target=watch)
    watcher.start()
    try:
        period, next_fault = rig.options.fault_period, rig.options.fault_period
        rig.recover(rig.begin + next_fault)
        while rig.now() < rig.options.duration - period and rig.stack.is_running():
            rig.inject(next(rig.schedule))
            next_fault += period
            rig.recover(rig.begin + max(next_fault, rig.now() + 4.0))
        if not rig.stack.is_running():
            rig.violate("sim_node has ended, and the soak with it")
    finally:
        rig.is_over.set()
        watcher.join()


def finish(rig, folder):
    from soak_harness import report
    duration = rig.now()
    rig.stop()
    for line in rig.stack.sanitizer_reports():
        rig.violate(f"sanitizer: {line}")
    figures = report.results(rig, duration)
    for node, growth in figures["memory"].items():
        if growth["verdict"] == "grows":
            rig.violate(f"memory of {node} grows by {growth['slope_mb_per_h']:.1f} MB/h")
    if rig.trips.reached == 0 and duration > rig.options.goal_timeout:
        rig.violate("no goal was reached")
    figures["violations"] = rig.violations
    report.write(folder / "soak.json", figures)
    print("\n".join(report.screen(figures)), file=sys.__stdout__)
    say(f"{folder}/soak.json")
    return 1 if rig.violations else 0


def interrupt(*_):
    raise KeyboardInterrupt


def main():
    parser, options = parse()
    folder = environment.enter(parser, options).resolve()
    from soak_harness.rig import Rig, SampleFile
    signal.signal(signal.SIGTERM, interrupt)
    rig = Rig(options, folder, say)
    samples = SampleFile(folder / "samples.csv")
    try:
        rig.start()
    except (RuntimeError, KeyboardInterrupt) as error:
        rig.stop()
        say(str(error) or "interrupted")
        return 2
    try:
        run(rig, samples)
    except KeyboardInterrupt:
        say("interrupted: what follows is about the time until now")
    samples.close()
    return finish(rig, folder)


if __name__ == "__main__":
    sys.exit(main())
