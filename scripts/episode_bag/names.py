# SPDX-License-Identifier: BSD-3-Clause
"""Which topics an episode is recorded from, and where they are in a bag."""
import re

from command_line.refusal import Refusal

NODES = ("planner_node", "sim_node", "velocity_guard")
SHARED = ("odom", "tracked_persons", "people", "map", "cmd_vel", "cmd_vel_raw")
GLOBAL = ("/tf", "/tf_static", "/diagnostics")

# Markers are worked out only while somebody listens. Those of the world are sent once.
COSTLY = r".*/(?!world_markers$)\w*markers|.*/(search_tree|arrival_time|roadmap|navigation)"


def is_of_a_node(topic):
    """Whether one of our nodes has published it under its own name."""
    return any(f"/{node}/" in topic for node in NODES)


def namespaces(topics):
    """Those in which there is a node of an episode, '' for none."""
    pattern = re.compile(rf"(.*)/(?:{'|'.join(NODES)})/\w+$")
    return sorted({match[1] for match in map(pattern.match, topics) if match})


def namespace_of(topics, wanted, path):
    """The namespace to show: the wanted one, else the only one there is."""
    found = namespaces(topics)
    if not found:
        raise Refusal(f"{path}: no topic of planner_node or sim_node in it, not an episode: "
                      "record one with record:=true")
    names = ", ".join(name or "/" for name in found)
    if wanted == "only":
        if len(found) > 1:
            raise Refusal(f"{path}: there are several robots in it, name one's namespace: {names}")
        return found[0]
    name = wanted.rstrip("/")
    name = name if not name or name.startswith("/") else "/" + name
    if name not in found:
        raise Refusal(f"{path}: nothing in the namespace '{wanted}', there is: {names}")
    return name
