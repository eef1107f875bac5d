#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records an episode with rosbag record; started by the launch files where record:=true.

  record_episode.py --bag episode       writes episode_DATE.bag
  record_episode.py --bag episode.bag   writes that file, which must not exist yet

Recorded are the topics of planner_node, sim_node and velocity_guard in this namespace, odom,
tracked_persons, people, map, cmd_vel and cmd_vel_raw, each as it is remapped here, and /tf,
/tf_static and /diagnostics. Exit status 2 and one line for a bad argument.
"""
import argparse
import os
import re
import sys

import rosgraph.names
import roslib.packages

from command_line.options import Parser, choice
from command_line.refusal import Refusal, say, status_of
from command_line.share import path_of
from episode_bag import names

PROGRAM = "record_episode.py"


def topics_to_record(node, mappings):
    """Regular expressions, each of which matches whole names."""
    def resolve(name, remapped=None):
        return rosgraph.names.resolve_name(name, node, remapped)
    remapped = {resolve(key): resolve(value) for key, value in mappings.items()}
    topics = [resolve(name, remapped) for name in (*names.SHARED, *names.GLOBAL)]
    own = re.escape(rosgraph.names.namespace(node)) + f"({'|'.join(names.NODES)})/.*"
    return [*map(re.escape, topics), own]


def output_of(bag):
    """Options of rosbag record."""
    path = path_of(bag)
    folder = path.parent
    if bag.endswith("/") or not path.name:
        raise Refusal(f"--bag: expected the beginning of a file's name, got the folder '{bag}'")
    if not folder.is_dir():
        raise Refusal(f"--bag: there is no folder '{folder}'")
    if not os.access(folder, os.W_OK):
        raise Refusal(f"--bag: the folder '{folder}' cannot be written")
    if path.suffix.lower() != ".bag":
        return ["-o", str(path)]
    if path.exists() or path.with_name(path.name + ".active").exists():
        raise Refusal(f"--bag: '{path}' exists and is not overwritten")
    return ["-O", str(path)]


def parse(arguments):
    parser = Parser(prog=PROGRAM, description=__doc__,
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bag", default="episode", help="beginning of the file's name (episode)")
    parser.add_argument("--markers", type=choice, default=True,
                        help="whether to record the markers, which the nodes then have to work out")
    return parser.parse_args(arguments)


def main():
    arguments = [word for word in sys.argv[1:] if ":=" not in word]
    internal = [word for word in sys.argv[1:] if word.startswith("__")]
    options = parse(arguments)
    recorder = roslib.packages.find_node("rosbag", "record")
    if not recorder:
        raise Refusal("rosbag record was not found: install python3-rosbag (Noetic: "
                      "ros-noetic-rosbag)")
    output = output_of(options.bag)
    mappings = {key: value for key, value in rosgraph.names.load_mappings(sys.argv).items()
                if not key.startswith("_")}
    topics = topics_to_record(rosgraph.names.make_caller_id("recorder"), mappings)
    exclusion = [] if options.markers else ["-x", names.COSTLY]
    say(PROGRAM, "recording to " + output[1] + ("" if output[0] == "-O" else "_DATE.bag"))
    os.execv(recorder[0], [recorder[0], "--lz4", "--quiet", *output, *exclusion, "-e", *topics,
                           *internal])


if __name__ == "__main__":
    sys.exit(status_of(PROGRAM, main))
