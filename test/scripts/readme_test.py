#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares what README.md says with the code: readme_test.py SOURCE_FOLDER

Parameters with their nodes, defaults and ranges in flight, keys of worlds and profiles, options and columns of the
tools, arguments of the launch file, build folders, commands, relative links. Prints a line for each difference; exit status
1 when there is any.
"""
import pathlib
import re
import runpy
import subprocess
import sys
import types

import yaml

KEY = re.compile(r'(?:reader_?\.read\(|readChoice\(reader, |(?:numbers|point)\()"([^"]+)"'
                 r'(?:, ([\w.>-]+))?')
# Debian's packages of the programs that the documents call. rosdep is for other systems.
PACKAGES = {"catkin_make": "catkin", "cmake": "cmake", "rosparam": "python3-rosparam",
            "roslaunch": "python3-roslaunch", "rospack": "rospack-tools", "rosrun": "rosbash",
            "rosservice": "python3-rosservice", "rostopic": "python3-rostopic"}
problems = []


def compare(what, in_readme, in_code):
    problems.extend(f"{what}: '{x}' is not in the README" for x in sorted(in_code - in_readme))
    problems.extend(f"{what}: '{x}' is in the README only" for x in sorted(in_readme - in_code))


def require(what, words, text):
    problems.extend(f"{what}: `{word}` is not in the README" for word in words
                    if f"`{word}`" not in text)


def tables_of(text):
    """Rows of the tables of each section, as {heading: {key: [other cells]}}."""
    tables, heading = {}, None
    for line in text.splitlines():
        if line.startswith("#"):
            heading = line.lstrip("# ")
        match = re.match(r"\| `([^`]+)` \|(.*)\|$", line)
        if match:
            cells = [cell.strip() for cell in match[2].split("|")]
            tables.setdefault(heading, {})[match[1]] = cells
    return tables


def keys_of(source):
    """{key: name of the field that it is read into}"""
    return {key: re.split(r"\.|->", field)[-1] for key, field in KEY.findall(source)}


def leaves_of(node, prefix=""):
    for key, value in node.items():
        if isinstance(value, dict):
            yield from leaves_of(value, f"{prefix}{key}/")
        else:
            yield prefix + key


def normal(value):
    """A default as the README writes it."""
    value = value.strip().strip('"').replace("'", "").replace("M_PI", "pi")
    if "::k" in value:  # an enumerator: kFreeDrive is free_drive
        value = re.sub(r"(?<!^)(?=[A-Z])", "_", value.split("::k")[-1]).lower()
    try:
        return float(value)
    except ValueError:
        return value


def check_defaults(rows, keys, default_cell, headers):
    for key, field in keys.items():
        if key not in rows or field == "frequency":  # the inverse of the step
            continue
        declared = re.findall(rf"\b{field} = ([^;,]+);", headers)
        said = normal(rows[key][default_cell])
        if declared and said not in map(normal, declared):
            problems.append(f"default of {key}: {said} in the README, {declared} in the headers")


def check_parameters(root, tables):
    headers = "\n".join(path.read_text() for path in (root / "include").rglob("*.h"))
    load = (root / "src/params/load_params.cpp").read_text()
    navigation, simulator = load.split("Simulator::Params loadSimulatorParams")
    profile = tables.get("Of a profile", {})
    profile_sim = tables.get("Of a profile, for the simulator", {})
    compare("parameter of a profile", set(profile), set(keys_of(navigation)))
    compare("parameter of the simulator", set(profile_sim), set(keys_of(simulator)))
    check_defaults(profile, keys_of(navigation), 1, headers)
    check_defaults(profile_sim, keys_of(simulator), 1, headers)

    nodes = (root / "src/ros/node_params.cpp").read_text()
    frames, rest = nodes.split("std::uint64_t readSeed")
    seed, rest = rest.split("// Keys of the libraries")
    library, rest = rest.split("PlannerNodeParams loadPlannerNodeParams")
    planner, sim = rest.split("SimNodeParams loadSimNodeParams")
    expected = {key: "both" for key in keys_of(frames)}
    for name, source in (("planner_node", seed + library + planner), ("sim_node", seed + sim)):
        for key in keys_of(source):
            expected[key] = name if key not in expected else "both"
    rows = tables.get("Of the nodes", {})
    compare("parameter of a node", {(k, cells[0]) for k, cells in rows.items()},
            set(expected.items()))
    check_defaults(rows, {k: f for k, f in keys_of(nodes).items() if k != "destinations"}, 2,
                   headers)

    for path in sorted((root / "config/profiles").glob("*.yaml")):
        unknown = set(leaves_of(yaml.safe_load(path.read_text()))) - set(profile) - set(profile_sim)
        problems.extend(f"{path.name}: '{key}' is not in the README" for key in sorted(unknown))
    world = keys_of((root / "src/sim/world_file.cpp").read_text())
    compare("key of a world", set(tables.get("World file", {})), set(world) | {"polygons"})


def cfg_of(root):
    """What cfg/Planner.cfg declares: {name: (default, lowest, highest, choices)}"""
    declared = {}

    class Generator:
        def const(self, name, kind, value, about):
            return value

        def enum(self, constants, about):
            return constants

        def add(self, name, kind, level, about, default, lowest=None, highest=None,
                edit_method=None):
            declared[name] = (default, lowest, highest, edit_method)

        def generate(self, *names):
            return 0

    module = types.ModuleType("parameter_generator_catkin")
    module.ParameterGenerator = Generator
    module.bool_t, module.int_t, module.double_t, module.str_t = "bool", "int", "double", "str"
    sys.modules["dynamic_reconfigure"] = types.ModuleType("dynamic_reconfigure")
    sys.modules["dynamic_reconfigure.parameter_generator_catkin"] = module
    try:
        runpy.run_path(str(root / "cfg/Planner.cfg"))
    except SystemExit:
        pass
    return declared


def check_reconfigurable(root, tables):
    """Table, README and cfg say the same; the C++ tests compare the table with the code."""
    tool = root / "scripts/list_parameters.py"
    check = subprocess.run([sys.executable, tool, "--check", root / "README.md"], text=True,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if check.returncode != 0:
        problems.append(f"run scripts/list_parameters.py --readme README.md: {check.stdout}")
    profile = yaml.safe_load(subprocess.run([sys.executable, tool, "--profile"], text=True,
                                            stdout=subprocess.PIPE, check=True).stdout)
    rows = tables.get("Of a profile", {})
    compare("key of the profile of defaults", set(rows) | set(
        tables.get("Of a profile, for the simulator", {})), set(leaves_of(profile)))

    declared = cfg_of(root)
    changing = {key: cells for key, cells in rows.items() if cells[3]}
    compare("parameter of Planner.cfg", {key.replace("/", "_") for key in changing}, set(declared))
    for key, (_, default, limits, change, *_) in changing.items():
        preset, lowest, highest, choices = declared.get(key.replace("/", "_"), (None,) * 4)
        if normal(default) != normal(str(preset).lower()):
            problems.append(f"default of {key}: {default} in the README, {preset} in Planner.cfg")
        said = limits.split("; ")[0]
        meant = (", ".join(f"`{word}`" for word in choices) if choices else
                 "" if lowest is None else f"{lowest:g} to {highest:g}")
        if said != meant:
            problems.append(f"range of {key}: {said} in the README, {meant} in Planner.cfg")
        if change not in ("in flight", "when idle"):
            problems.append(f"change of {key}: '{change}'")


def check_tools(root, text):
    for path in sorted((root / "src/tools").glob("*.cpp")):
        source = path.read_text()
        require(path.name, re.findall(r'add_option\(\s*"(--[\w-]+)"', source), text)
    columns = re.search(r"csvHeader\(\) \{(.*?)\}",
                        (root / "src/evaluation/experiment.cpp").read_text(), re.S)[1]
    require("results.csv", "".join(re.findall(r'"([^"]*)"', columns)).split(","), text)
    for name in ("simulation.launch", "movo.launch"):
        launch = (root / "launch" / name).read_text()
        require(name, re.findall(r'<arg name="(\w+)"\s+default=', launch), text)
    demo = (root / "scripts/demo.sh").read_text()
    options = re.search(r"<<'END'\n(.*?)\nEND", demo, re.S)[1]
    require("demo.sh", set(re.findall(r"(--[a-z-]+)", options)) - {"--help"}, text)


def check_lists(root, text):
    """The README lists every page and every program that a user may start."""
    pages = {f"doc/{path.name}" for path in (root / "doc").glob("*.md")}
    problems.extend(f"README.md: {page} is in no list" for page in sorted(pages)
                    if f"[{page}]({page})" not in text)
    programs = {path.stem for path in (root / "src/tools").glob("*.cpp")} | \
        {path.name for path in (root / "scripts").glob("*.py")}
    require("list of tools", sorted(programs), text)


def check_build_folders(text):
    """rosrun passes over a folder `build` inside a package."""
    for folder in re.findall(r"cmake -S \. -B (\S+)", text):
        if not folder.startswith("../"):
            problems.append(f"README.md: rosrun does not find what is built in {folder}")


def check_commands(root):
    """A bare Debian has what the documents call once install_dependencies.sh has run."""
    script = (root / "scripts/install_dependencies.sh").read_text()
    installed = set(re.search(r"BUILD_PACKAGES=(.*?)\nRVIZ", script, re.S)[1]
                    .replace("(", " ").replace(")", " ").split())
    documents = [*root.glob("*.md"), *(root / "doc").glob("*.md")]
    text = "\n".join(path.read_text() for path in documents)
    called = set(re.findall(r"\b(?:ros(?!dep\b)\w+|catkin_make|cmake)(?= [\w-])",
                            "\n".join(re.findall(r"```sh\n(.*?)```", text, re.S))))
    needed = {PACKAGES.get(command, f"the package of {command}") for command in called}
    if called & {"catkin_make", "cmake"}:
        needed.add("make")  # what both build with where nothing else is said
    problems.extend(f"install_dependencies.sh: {package} is missing"
                    for package in sorted(needed - installed))


def prose_of(path):
    return re.sub(r"```.*?```", "", path.read_text(), flags=re.DOTALL)


def anchors_of(path):
    """The ends of links that GitHub makes of headings."""
    headings = re.findall(r"^#+ (.*)$", prose_of(path), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links(root):
    for path in [*root.glob("*.md"), *(root / "doc").glob("*.md")]:
        for link, anchor in re.findall(r"\]\(([^)#]*)#?([^)]*)\)", prose_of(path)):
            target = path.parent / link if link else path
            if "://" in link:
                continue
            if not target.exists():
                problems.append(f"{path.name}: the link {link} leads nowhere")
            elif anchor and anchor not in anchors_of(target):
                problems.append(f"{path.name}: {target.name} has no heading {anchor}")


def main():
    root = pathlib.Path(sys.argv[1])
    text = (root / "README.md").read_text()
    check_parameters(root, tables_of(text))
    check_reconfigurable(root, tables_of(text))
    check_tools(root, text + "".join((root / "doc" / name).read_text()
                                     for name in ("tools.md", "movo.md")))
    check_lists(root, text)
    check_build_folders(text)
    check_commands(root)
    check_links(root)
    print("\n".join(problems) or "README.md and the code agree")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
