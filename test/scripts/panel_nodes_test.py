#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The panel with real nodes, which die, and whose master dies: panel_nodes_test.py FOLDER_OF_NODES

Reads what panel_probe, the panel without its widgets, shows. Exit status 1 when it does not see what
happens, or waits for somebody.
"""
import os
import pathlib
import queue
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

import rosgraph
import yaml

SHARE = pathlib.Path(__file__).resolve().parents[2]
PROFILE = yaml.safe_load((SHARE / "config/profiles/movo.yaml").read_text())
WORLD = str(SHARE / "config/worlds/scenario_1.yaml")
PATIENCE = 60.0  # [s]
processes = []


def start(*command, **options):
    processes.append(subprocess.Popen(command, stdin=subprocess.PIPE, **options))
    return processes[-1]


def end(process, how=signal.SIGKILL):
    process.send_signal(how)
    process.wait()


class Stage:
    """A master, a planner and a simulator."""

    def __init__(self, folder):
        self.folder = folder
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            self.port = s.getsockname()[1]
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{self.port}", ROS_IP="127.0.0.1")
        os.environ.pop("ROS_HOSTNAME", None)

    def start_master(self):
        program = shutil.which("rosmaster") or sys.exit("panel_nodes_test.py: no rosmaster")
        self.master = start(program, "--core", "-p", str(self.port), stdout=subprocess.DEVNULL)
        handle = rosgraph.Master("/panel_nodes_test")
        give_up = time.monotonic() + PATIENCE
        while not handle.is_online():
            if time.monotonic() > give_up:
                sys.exit("panel_nodes_test.py: the master did not come")
            time.sleep(0.1)
        handle.setParam("/planner_node", {**PROFILE, "world_file": WORLD})
        handle.setParam("/sim_node", {**PROFILE, "world_file": WORLD, "pedestrians": 5})

    def start_planner(self):
        self.planner = start(str(self.folder / "planner_node"))

    def start_simulator(self):
        start(str(self.folder / "sim_node"), "current_goal:=planner_node/current_goal")


class Panel:
    """What panel_probe prints."""

    def __init__(self, folder):
        self.process = start(str(folder / "panel_probe"), stdout=subprocess.PIPE, text=True)
        self.lines = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            print(f"{time.monotonic():.1f} {line}", end="", flush=True)
            self.lines.put(line)

    def press(self, word):
        self.process.stdin.write(word + "\n")
        self.process.stdin.flush()

    def expect(self, *alternatives):
        give_up = time.monotonic() + PATIENCE
        while time.monotonic() < give_up:
            try:
                line = self.lines.get(timeout=0.2)
            except queue.Empty:
                continue
            if "was made to wait" in line:
                sys.exit("panel_nodes_test.py: the panel was made to wait")
            if any(what in line for what in alternatives):
                return
        sys.exit(f"panel_nodes_test.py: the panel did not show {' or '.join(alternatives)}")


def drive(stage, panel):
    stage.start_simulator()
    panel.expect("reset is possible")
    panel.press("start")
    panel.expect("goal (100.0, 75.0) sent")
    panel.expect("DRIVING")
    panel.press("pause")
    panel.expect("PAUSED | 2d_fmm | paused")
    panel.press("start")
    panel.expect("DRIVING | 2d_fmm | resumed")
    panel.press("reset")
    panel.expect("reset: simulating scenario_1")
    panel.press("stop")
    panel.expect("IDLE")


def main():
    folder = pathlib.Path(sys.argv[1])
    stage = Stage(folder)
    stage.start_master()
    panel = Panel(folder)
    panel.expect("no planner_node")
    stage.start_planner()
    panel.expect("IDLE | 2d_fmm")

    panel.press("2d_prm")
    panel.expect("IDLE | 2d_prm | planner 2d_prm")
    panel.press("2d_nhv")
    panel.expect("keeps the planner 2d_prm")  # it is a car's
    panel.press("2d_fmm")
    panel.expect("IDLE | 2d_fmm | planner 2d_fmm")

    drive(stage, panel)

    stage.planner.send_signal(signal.SIGSTOP)
    panel.expect("silent")
    stage.planner.send_signal(signal.SIGCONT)
    panel.expect("IDLE | 2d_fmm")

    end(stage.planner)
    panel.expect("silent", "no planner_node")  # the master still lists it
    stage.start_planner()
    panel.expect("IDLE | 2d_fmm")

    print("the master dies")
    end(stage.master)
    panel.press("2d_prm")
    panel.expect("set_parameters does not answer")  # no master, no service
    end(stage.planner)
    panel.expect("no ROS master")
    stage.start_master()
    stage.start_planner()
    panel.expect("IDLE | 2d_fmm")


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
