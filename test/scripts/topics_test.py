#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the nodes' topics, services and actions with README.md and rviz/

  topics_test.py SOURCE_FOLDER

A node is what its program under src/nodes includes of ros/. Each row of the README's tables of
nodes must be in the code, and the other way about, with its type; topics and namespaces of markers
in rviz/*.rviz must be of a node. A line for each difference; exit status 1 when there is any.
"""
import pathlib
import re
import sys

import yaml

PACKAGE = "pomdp_crowd_nav"
NODES = ("planner_node", "velocity_guard", "tractor_mode", "sim_node")
# What libraries bring with them, by what the code has of them.
OF_LIBRARIES = {
    "diagnostic_updater::Updater": ("publishes", "/diagnostics", "diagnostic_msgs/DiagnosticArray"),
    "tf2_ros::TransformBroadcaster": ("publishes", "/tf", "tf2_msgs/TFMessage"),
    "dynamic_reconfigure::Server<": ("service", "~set_parameters",
                                     "dynamic_reconfigure/Reconfigure"),
}
# Every node of roscpp hears it where /use_sim_time is set; the tables need not say so.
OF_EVERY_NODE = ("subscribes", "/clock", "rosgraph_msgs/Clock")
# How a goal from RViz is handed to the node's own action, which has a row.
OF_THE_ACTION = ("publishes", "move_base/goal", "move_base_msgs/MoveBaseActionGoal")
ALIASES = {"CrowdBeliefMessage": "CrowdBelief", "EpisodeMetricsMessage": "EpisodeMetrics",
           "MarkerArray": "visualization_msgs/MarkerArray", "PauseService": "SetBool"}
CALL = re.compile(r"(\w+)\.(advertiseService|advertise|subscribe)(?:<([\w:]+)[^>(]*>)?"
                  r"\(\s*\"([^\"]+)\"(?:,\s*\w+,\s*&(\w+::\w+)|,\s*&(\w+::\w+))?")
problems = []


def type_of(name):
    """As ROS writes it: nav_msgs::Odometry is nav_msgs/Odometry."""
    name = re.sub(r"(::Request|ConstPtr|::ConstPtr)$", "", name).replace("::", "/")
    name = ALIASES.get(name, name)
    return name if "/" in name else f"{PACKAGE}/{name}"


def sources_of(root, program):
    """The texts that a program is made of, as far as they are in ros/."""
    texts, todo = {}, [root / "src/nodes" / f"{program}.cpp"]
    while todo:
        path = todo.pop()
        if path in texts or not path.is_file():
            continue
        texts[path] = path.read_text()
        for name in re.findall(rf'#include "{PACKAGE}/ros/(\w+)\.h"', texts[path]):
            todo += [root / f"include/{PACKAGE}/ros/{name}.h", root / f"src/ros/{name}.cpp"]
    return texts


def callback_type(text, method):
    for name in (method, method.split("::")[-1]):  # the latter where its header has its body
        found = re.search(rf"\b{name}\(\s*(?:const )?([\w:]+)&", text)
        if found:
            return found[1]
    return f"(the type that {method} takes)"


def calls_in(path, text, everything):
    """(direction, name, type) of each call that advertises or subscribes."""
    is_private = "ros::NodeHandle node(private_node)" in text
    found = list(CALL.finditer(text))
    number = len(re.findall(r'\.(?:advertise|subscribe)\w*(?:<[^;]*?>)?\(\s*"', text))
    if len(found) != number:
        problems.append(f"{path.name}: {number} calls, of which {len(found)} are understood")
    for handle, call, kind, name, by_method, by_service in (match.groups() for match in found):
        direction = {"advertise": "publishes", "subscribe": "subscribes"}.get(call, "service")
        kind = kind or callback_type(everything, by_method or by_service)
        private = is_private or handle == "private_node"
        yield direction, ("~" if private else "") + name, type_of(kind)


def layers_in(header, text):
    """Those of members LatchedLayer<Type>."""
    for kind, member in re.findall(r"LatchedLayer<([\w:]+)> (\w+);", header):
        name = re.search(rf"{member}\(private_node, \"(\w+)\"", text)
        yield "publishes", "~" + (name[1] if name else member), type_of(kind)


def of_code(root, program):
    texts = sources_of(root, program)
    actions = {path: text for path, text in texts.items() if path.stem == "move_base_server"}
    texts = {path: text for path, text in texts.items() if path not in actions}
    everything = "\n".join(texts.values())
    found = {row for mark, row in OF_LIBRARIES.items() if mark in everything}
    for path, text in texts.items():
        found.update(calls_in(path, text, everything))
    found.update(layers_in(everything, everything))
    for kind in re.findall(r"actionlib::ActionServerBase<([\w:]+)>", "\n".join(actions.values())):
        name = re.search(r"server_\(\s*ros::NodeHandle\(node, \"(\w+)\"", everything)
        found.add(("action", name[1], type_of(kind)))
    for name in re.findall(r'= subscribe\("(/\w+)"', everything):  # TransformFeed
        found.add(("subscribes", name, "tf2_msgs/TFMessage"))
    return found - {OF_THE_ACTION}


def of_readme(text, program):
    section = re.search(rf"^### {program}$(.*?)^#", text, re.M | re.S)
    if not section:
        problems.append(f"README.md: there is no section {program}")
        return set()
    rows = set()
    row = re.compile(r"^\| (action|subscribes|publishes|service) \| (.*?) \| (.*?) \|", re.M)
    for direction, names, kinds in row.findall(section[1]):
        names, kinds = re.findall(r"`([^`]+)`", names), kinds.split(", ")
        kinds = kinds * len(names) if len(kinds) == 1 else kinds
        rows.update((direction, name, kind) for name, kind in zip(names, kinds))
    return rows


def compare(program, in_readme, in_code):
    missing = in_code - in_readme - {OF_EVERY_NODE}
    surplus = in_readme - in_code - {OF_EVERY_NODE}
    problems.extend(f"{program}: '{' '.join(row)}' is not in the README" for row in sorted(missing))
    problems.extend(f"{program}: '{' '.join(row)}' is in the README only"
                    for row in sorted(surplus))


def displays_of(node):
    """Those that show a topic, groups of displays included."""
    for display in node.get("Displays", []):
        yield from displays_of(display)
        topic = display.get("Topic") or display.get("Marker Topic")
        if topic:
            yield display["Name"], topic, display.get("Namespaces") or {}


def namespaces_in(root):
    text = "\n".join(path.read_text() for path in sorted((root / "src/ros").glob("*.cpp")))
    return set(re.findall(r'\.(?:beginList|addText)\("(\w+)"', text))


def check_views(root, rows):
    topics = {"/" + name.replace("~", f"{program}/") for program, _, name, _ in rows}
    known = namespaces_in(root)
    for path in sorted((root / "rviz").glob("*.rviz")):
        manager = yaml.safe_load(path.read_text())["Visualization Manager"]
        for name, topic, namespaces in displays_of(manager):
            if topic not in topics:
                problems.append(f"{path.name}: nobody publishes {topic} of '{name}'")
            problems.extend(f"{path.name}: nobody draws '{each}' of '{name}'"
                            for each in sorted(set(namespaces) - known))
        tools = [tool["Topic"] for tool in manager["Tools"] if "Topic" in tool]
        heard = {"/" + name for _, direction, name, _ in rows if direction == "subscribes"}
        problems.extend(f"{path.name}: nobody hears {topic}"
                        for topic in tools if topic not in heard)


def main():
    root = pathlib.Path(sys.argv[1])
    readme = (root / "README.md").read_text()
    rows = set()
    for program in NODES:
        in_code = of_code(root, program)
        if not in_code:
            problems.append(f"{program}: nothing found in its sources")
        compare(program, of_readme(readme, program), in_code)
        rows.update((program, *row) for row in in_code)
    check_views(root, rows)
    print("\n".join(problems)
          or f"README.md, rviz/ and the code agree on {len(rows)} topics and services")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
