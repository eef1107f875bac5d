# SPDX-License-Identifier: BSD-3-Clause
"""What tests of programs need around them: a folder, a free port, an environment, an ending."""
import contextlib
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class FolderTest(unittest.TestCase):
    """With a folder of its own for each test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)


def environment_of(devel, folder):
    """That of a build, with a master of its own (not started) and logs in `folder`."""
    text = subprocess.run(["bash", "-c", '. "$0" >&2 && env -0', f"{devel}/setup.bash"],
                          check=True, stdout=subprocess.PIPE, text=True).stdout
    environment = dict(entry.split("=", 1) for entry in text.split("\0") if "=" in entry)
    for name in ("ROS_HOSTNAME", "ROS_NAMESPACE", "ROSCONSOLE_FORMAT", "ROSCONSOLE_CONFIG_FILE"):
        environment.pop(name, None)
    environment.update(
        ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}", ROS_IP="127.0.0.1",
        ROS_HOME=str(folder), ROS_LOG_DIR=str(folder), ROSCONSOLE_STDOUT_LINE_BUFFERED="1",
        PATH=f"{devel}/lib/pomdp_crowd_nav:/usr/bin:{environment['PATH']}")
    return environment


def run(command, timeout=60.0, **how):
    """A program to its end; a group of its own, so that nothing of it outlives the test."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, start_new_session=True, **how)
    try:
        out, err = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.communicate(timeout=15.0)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        return subprocess.CompletedProcess(command, -1, out, err)
    return subprocess.CompletedProcess(command, process.returncode, out, err)
