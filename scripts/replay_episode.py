#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shows a recorded episode again in RViz; started by replay.launch.

  roslaunch pomdp_crowd_nav replay.launch bag:=episode.bag
  replay_episode.py episode.bag --rate 2     where a master is running

A replay moves nothing: only topics that are looked at are played, never commands, goals or poses.
It refuses to begin, and stops, where somebody publishes such a topic already or may send commands on
this master. /use_sim_time is set while it lasts and then as it was before. Exit status 0 at the end
of the bag or when RViz is closed, 2 and one line for a bad argument, a bag that cannot be played, a
live system, 130 after Ctrl-C.
"""
import argparse
import contextlib
import pathlib
import signal
import sys
import tempfile

from command_line.options import Parser, choice, number
from command_line.refusal import Refusal, say, status_of
from command_line.share import path_of, share_folder
from episode_replay.episode import Episode
from episode_replay.live import Master
from episode_replay.player import Replay
from episode_replay.view import replay_view, view_file

PROGRAM = "replay_episode.py"
DESCRIPTION = "/replay_episode/robot_description"


def parse(arguments):
    parser = Parser(prog=PROGRAM, description=__doc__,
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag", help="what record:=true has written")
    parser.add_argument("--rate", type=number(0.01, 100.0), default=1.0, help="times real time (1)")
    parser.add_argument("--start", type=number(0.0, 1e9), default=0.0,
                        help="[s] from the beginning of the bag (0)")
    parser.add_argument("--rviz", type=choice, default=True, help="whether to open RViz (true)")
    parser.add_argument("--view", default="auto",
                        help="how RViz shows it, a file of the folder rviz without its ending or a "
                             "path (by the size of the map)")
    parser.add_argument("--namespace", default="only",
                        help="of the robot to show, where the bag has several")
    options = parser.parse_args([word for word in arguments if ":=" not in word])
    if options.bag == "none":
        raise Refusal("name the bag: roslaunch pomdp_crowd_nav replay.launch bag:=episode.bag")
    return options


def restore(master, name, value):
    with contextlib.suppress(Refusal):  # a master that is gone has no parameters either
        master.restore(name, value)


@contextlib.contextmanager
def replay_time(master):
    """Nodes that start now take the bag's time."""
    before = master.get("/use_sim_time")
    master.set("/use_sim_time", True)
    try:
        yield
    finally:
        restore(master, "/use_sim_time", before)


def play(options, episode, master, folder):
    replay = Replay(PROGRAM, master, episode, options.rate)
    try:
        if options.rviz:
            view = folder / "replay.rviz"
            view.write_text(replay_view(view_file(options.view, episode.is_street), episode.frame))
            master.set(DESCRIPTION, (share_folder() / "urdf/movo.urdf").read_text())
            replay.start_rviz(view)
        replay.start_bag()
        end = replay.watch()
        if options.rviz and end != "RViz was closed":
            say(PROGRAM, f"{end}: close RViz or press Ctrl-C")
            replay.wait_for_rviz()
    finally:
        for interrupt in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(interrupt, signal.SIG_IGN)  # from here on all is put back
        replay.end()
        restore(master, DESCRIPTION, None)


def main():
    options = parse(sys.argv[1:])
    episode = Episode(path_of(options.bag), options.namespace, options.start)
    if options.rviz:
        view_file(options.view, episode.is_street)  # refuses before anything has begun
    master = Master()
    conflict = master.conflict(episode.selection.played.values())
    if conflict:
        raise Refusal(conflict)
    left_out = episode.selection.left_out
    say(PROGRAM, f"{episode.duration - episode.start:.1f} s at {options.rate:g} times real time"
        + (f"; not played: {', '.join(left_out)}" if left_out else ""))
    with tempfile.TemporaryDirectory() as folder, replay_time(master):
        play(options, episode, master, pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(status_of(PROGRAM, main))
