# SPDX-License-Identifier: BSD-3-Clause
"""Faults of processes; each is a function of the rig."""
import multiprocessing
import os
import signal


def kill(node):
    return lambda rig: rig.stack.signal(node, signal.SIGKILL)


def stop(node):
    return lambda rig: rig.stack.signal(node, signal.SIGSTOP)


def go_on(node):
    return lambda rig: rig.stack.signal(node, signal.SIGCONT)


def _spin(niceness):
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # their parent ends them
    if niceness is not None:
        try:
            os.setpriority(os.PRIO_PROCESS, 0, niceness)
        except PermissionError:
            pass
    while True:
        pass


def busy_processes(count, niceness=None):
    """Processes that do nothing but take time of the processors."""
    context = multiprocessing.get_context("spawn")  # a fork would inherit ROS's threads' locks
    processes = [context.Process(target=_spin, args=(niceness,), daemon=True) for _ in range(count)]
    for process in processes:
        process.start()
    return processes


def occupy(rig):
    rig.busy = busy_processes(multiprocessing.cpu_count())


def release(rig):
    for process in rig.busy:
        process.kill()
        process.join()
    rig.busy = []
