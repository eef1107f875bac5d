# SPDX-License-Identifier: BSD-3-Clause
"""Faults to inject: how each begins and ends, and by when the base must be at rest."""
import dataclasses
import random
from typing import Callable, Optional

from . import message_faults, process_faults, use_faults


@dataclasses.dataclass
class Fault:
    name: str
    begin: Callable  # of the rig
    end: Callable = lambda rig: None
    duration: float = 3.0           # [s] from begin to end
    bound: Optional[float] = None   # [s] from begin to rest; None where it need not rest
    holds: bool = True              # once at rest, it stays so until the end
    every: int = 1                  # in which rounds of the list it comes: each, every third...


@dataclasses.dataclass
class Limits:
    """Ages and braking as the nodes have them, [s]."""
    odometry: float
    people: float
    transform: float
    command: float  # of the base's watchdog
    braking: float  # from the greatest speed to rest
    slack: float    # cycles, transport and a busy machine


def repaired(rig):
    rig.relay.repair()


def faults(limits, guards, use_sim_time):
    """All that apply to the nodes that run."""
    rest = limits.braking + limits.slack
    silent_odometry, silent_people = limits.odometry + rest, limits.people + rest
    silent_transform = max(limits.odometry, limits.people) + limits.transform + rest
    stale = max(limits.odometry, limits.people) + 1.5
    messages, use = message_faults, use_faults
    everything = [
        Fault("odometry silent", messages.silence("odom"), repaired, 3.0, silent_odometry),
        Fault("odometry NaN", messages.odometry_not_finite, repaired, 3.0, silent_odometry),
        Fault("odometry garbage", messages.odometry_garbage, repaired, 2.0, silent_odometry),
        Fault("odometry old", messages.age("odom", -stale), repaired, 3.0, silent_odometry),
        Fault("odometry jumps", messages.odometry_jump, repaired, 0.3, rest + 0.3, holds=False),
        Fault("people silent", messages.silence("people"), repaired, 4.0, silent_people),
        Fault("people old", messages.age("people", -stale), repaired, 4.0, silent_people),
        Fault("people from the future", messages.age("people", 5.0), repaired),
        Fault("transforms silent", messages.silence("transforms"), repaired, 4.0,
              silent_transform),
        Fault("10000 tracks", messages.flood_of_tracks, repaired),
        Fault("ids switch", messages.id_switches, repaired),
        Fault("ids twice", messages.same_ids, repaired, 1.0),
        Fault("velocities of people NaN", messages.velocities_not_finite, repaired, 2.0),
        Fault("map again and again", messages.map_again, messages.map_as_it_was, 2.0),
        Fault("goal preempted 50 times", use.preempt, duration=6.0),
        Fault("goal cancelled", use.cancel, use.new_goal, 2.0, rest),
        Fault("planner paused", use.pause_planner, use.resume_planner, 3.0, rest),
        Fault("simulator paused", use.pause_simulator, use.resume_simulator, 2.0),
        Fault("simulator reset", use.reset_simulator, use.new_goal, 1.0),
        Fault("robot put elsewhere", use.put_elsewhere, duration=1.0),
        Fault("planner stopped", process_faults.stop("planner_node"),
              process_faults.go_on("planner_node"), 2.0, limits.command + rest),
        Fault("planner killed", process_faults.kill("planner_node"), duration=0.9,
              bound=limits.command + rest, holds=False, every=4),
        Fault("processors busy", process_faults.occupy, process_faults.release, 5.0),
    ]
    if use_sim_time:
        everything.append(Fault("clock 10 s back", messages.clock_back, repaired, 3.0,
                                silent_odometry, holds=False))
    for guard in guards:
        everything += [
            Fault(f"{guard} stopped", process_faults.stop(guard), process_faults.go_on(guard), 2.0,
                  limits.command + rest),
            Fault(f"{guard} killed", process_faults.kill(guard), duration=0.9,
                  bound=limits.command + rest, holds=False, every=4)]
    return everything


def endless(all_faults, seed):
    """Round after round all faults in random order; the rare ones not in every round."""
    dice = random.Random(seed)
    turn = 0
    while True:
        turn += 1
        deck = [fault for fault in all_faults if turn % fault.every == 0]
        dice.shuffle(deck)
        yield from deck
