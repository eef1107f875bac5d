# SPDX-License-Identifier: BSD-3-Clause
"""simulation.launch, started from here, with all but the simulator behind a relay."""
import os
import pathlib
import re
import signal
import sys
import time
import urllib.parse

import roslaunch
import roslaunch.parent
import roslaunch.rlutil

PACKAGE = "pomdp_crowd_nav"
SIMULATOR, PLANNER = "sim_node", "planner_node"
RELAYED = ("odom", "tracked_persons", "map", "/tf", "/clock")
SANITIZER = re.compile(r"ERROR: \w+Sanitizer|WARNING: ThreadSanitizer|runtime error:")


def relayed(topic):
    """Where the relay publishes what the simulator publishes on `topic`."""
    return "/relayed/" + topic.lstrip("/")


def deaths(expected, running, killed):
    """Names in `expected` whose process is neither in `running` nor was killed; brings `expected` up
    to date. All are process ids, by name but for the set `killed`."""
    gone = [name for name, pid in expected.items() if running.get(name) != pid]
    dead = [name for name in gone if expected[name] not in killed]
    for name in gone:
        del expected[name]
    for name, pid in running.items():
        expected.setdefault(name, pid)
    return dead


class Stack:
    """The nodes of a launch file and what becomes of their processes."""

    def __init__(self, folder, arguments, with_relay=True):
        self.folder = pathlib.Path(folder)
        # What roslaunch says about each process is for a file.
        sys.stdout = open(self.folder / "log/roslaunch.txt", "w", encoding="utf-8", buffering=1)
        files = roslaunch.rlutil.resolve_launch_arguments([PACKAGE, "simulation.launch"])
        port = urllib.parse.urlparse(os.environ["ROS_MASTER_URI"]).port
        self.parent = roslaunch.parent.ROSLaunchParent(
            roslaunch.rlutil.get_or_generate_uuid(None, False),
            [(files[0], [f"{name}:={value}" for name, value in arguments.items()])],
            port=port, show_summary=False, sigint_timeout=5.0)
        self.parent._load_config()  # pylint: disable=protected-access
        self.names = [node.name for node in self.parent.config.nodes]
        for node in self.parent.config.nodes:
            self._amend(node, with_relay)
        self.expected_pids = {}
        self.killed_pids = set()

    def _amend(self, node, with_relay):
        log = self.folder / "log" / f"{node.name}.log"
        node.launch_prefix = f"""sh -c 'exec "$0" "$@" >>"{log}" 2>&1' {node.launch_prefix or ''}"""
        if node.package != PACKAGE or node.name == SIMULATOR:
            return
        node.required, node.respawn, node.respawn_delay = False, True, 1.0
        if with_relay:
            taken = [source for source, _ in node.remap_args]
            node.remap_args = node.remap_args + [
                (topic, relayed(topic)) for topic in RELAYED if topic not in taken]

    def start(self):
        """Returns once the nodes are started; they may not have advertised anything yet."""
        self.parent.start(auto_terminate=False)
        time.sleep(1.0)
        self.expected_pids = self.pids()

    def pids(self):
        """Process id of each node that runs."""
        with self.parent.pm.plock:
            processes = list(self.parent.pm.procs)
        return {re.sub(r"-\d+$", "", process.name): process.pid for process in processes
                if process.is_alive() and process.pid > 0}

    def guards(self):
        return [name for name in self.names if "guard" in name]

    def signal(self, name, number):
        pid = self.pids().get(name)
        if pid:
            if number == signal.SIGKILL:  # noted first, as others look for deaths meanwhile
                self.killed_pids.add(pid)
            os.kill(pid, number)
        return pid is not None

    def unexpected_deaths(self):
        """Nodes that are gone or started again though nobody has killed them; each is told once."""
        return deaths(self.expected_pids, self.pids(), self.killed_pids)

    def is_running(self):
        return SIMULATOR in self.pids()

    def sanitizer_reports(self):
        """Lines of the nodes' logs with which a sanitizer begins a report."""
        found = []
        for path in sorted((self.folder / "log").glob("*.log")):
            with open(path, encoding="utf-8", errors="replace") as file:
                found += [f"{path.name}:{number}: {line.strip()}"
                          for number, line in enumerate(file, 1) if SANITIZER.search(line)]
        return found

    def stop(self):
        for pid in self.pids().values():
            os.kill(pid, signal.SIGCONT)  # a stopped process would not end
        self.parent.shutdown()
