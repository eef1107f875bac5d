#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot under way reaches its goal though the master dies: master_death_test.py FOLDER_OF_NODES

Nodes are connected to each other, not through the master, so what drives goes on. What is started
later finds nobody. Exit status 1 when the trip fails.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import rosgraph
import yaml

from surroundings import free_port

SHARE = pathlib.Path(__file__).resolve().parents[2]
PROFILE = yaml.safe_load((SHARE / "config/profiles/movo.yaml").read_text())
WORLD = str(SHARE / "config/worlds/scenario_1.yaml")
PATIENCE = 60.0  # [s]
processes = []


def start(*command, **options):
    processes.append(subprocess.Popen(command, stdin=subprocess.DEVNULL, **options))
    return processes[-1]


def wait_for(what, condition):
    give_up = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > give_up:
            sys.exit(f"master_death_test.py: {what} did not come")
        time.sleep(0.1)


def main():
    folder = pathlib.Path(sys.argv[1])
    port = free_port()
    os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1")
    os.environ.pop("ROS_HOSTNAME", None)
    program = shutil.which("rosmaster") or sys.exit("master_death_test.py: there is no rosmaster")
    roscore = start(program, "--core", "-p", str(port), stdout=subprocess.DEVNULL)
    master = rosgraph.Master("/master_death_test")
    wait_for("the master", master.is_online)

    nodes = {"sim_node": {"world_file": WORLD, "pedestrians": 5}, "velocity_guard": {},
             "planner_node": {"world_file": WORLD}}
    for name, params in nodes.items():
        master.setParam(f"/{name}", {**PROFILE, **params})
        remaps = ["cmd_vel:=cmd_vel_raw"] if name == "planner_node" else []
        start(str(folder / name), *remaps)
    trip = start(str(folder / "send_goal"), "--x", "16", "--y", "27", "--timeout", "90",
                 "sim_metrics:=sim_node/metrics", "planner_status:=planner_node/status",
                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for line in trip.stderr:
        print(line, end="")
        if line.strip().endswith("to the goal"):
            break  # it is under way
    roscore.send_signal(signal.SIGKILL)
    roscore.wait()
    print("the master is dead")
    output, errors = trip.communicate(timeout=PATIENCE + 60.0)
    print(errors, output, sep="")
    if trip.returncode != 0 or "goal_reached=true" not in output:
        sys.exit("master_death_test.py: the trip did not come to its goal")
    dead = [p.args[0] for p in processes[1:-1] if p.poll() is not None]
    if dead:
        sys.exit(f"master_death_test.py: ended without the master: {dead}")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as home:
        os.environ["ROS_HOME"] = home
        try:
            main()
        finally:
            for process in processes:
                if process.poll() is None:
                    process.kill()
                process.wait()
