#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What doc/recipes.md says, works: its files compile, its commands run.

recipes_test.py SOURCE_DIR BUILD_DIR DEVEL_DIR

A copy of the sources is changed as the page says. What has changed is compiled with the flags of the
build, into a library that stands in for those parts of the package's own in the programs of the
build; these are then run as the page says.
"""
import concurrent.futures
import json
import pathlib
import re
import shlex
import shutil
import sys
import tempfile
import unittest

import surroundings

PAGE = "doc/recipes.md"
LIBRARY = "librecipes.so"
INPUTS = {}  # from the command line


class Page:
    """The steps of the page: files to write, changes of files, commands."""

    def __init__(self, text):
        self.files, self.changes, self.commands = {}, [], []
        pieces = re.split(r"^```(\w*)\n", text, flags=re.M)  # text, kind, block, "", text, ...
        for before, kind, block in zip(pieces[::4], pieces[1::4], pieces[2::4]):
            self.add(" ".join(before.strip().rsplit("\n\n", 1)[-1].split()), kind, block)

    def add(self, before, kind, block):
        new = re.search(r"(?:^|\s)`([\w./]+)`:$", before)
        change = re.search(r"(?:^|\s)In `([\w./]+)`, (.*):$", before)
        if kind == "sh":
            lines = block.replace("\\\n", " ").splitlines()
            self.commands += [line.split(" #")[0].strip() for line in lines if line.strip()]
        elif change:
            self.changes.append((change[1], change[2], block))
        elif new:
            self.files[new[1]] = block
        else:
            raise AssertionError(f"{PAGE}: what is to be done with the block after '{before}'?")


def changed(text, how, block):
    """The text of a file after a change that the page describes in words."""
    if how == "with the other includes":
        *_, last = re.finditer(r'^#include "pomdp_crowd_nav/.*\n', text, re.M)
        return text[:last.end()] + block + text[last.end():]
    line = re.match(r"a line of `(\w+)`, before `(.*)`$", how)
    if line:
        begin = text.index(f"{line[1]}[] = {{")
        at = text.rindex("\n", 0, text.index("\n" + (" " * 4 if line[2] != "};" else "") + line[2],
                                             begin) + 1) + 1
        return text[:at] + block + text[at:]
    old = re.match(r".*instead of `(.*)`$", how)[1]
    assert text.count(old) == 1, f"'{old}' is there {text.count(old)} times"
    return text.replace(old, block.strip())


class Overlay:
    """A copy of the sources, changed as the page says."""

    def __init__(self, folder, page):
        self.folder = folder
        for name in ("config", "include", "launch", "rviz", "scripts", "src"):
            shutil.copytree(INPUTS["source"] / name, folder / name)
        for name in ("README.md", "package.xml"):
            shutil.copy(INPUTS["source"] / name, folder)
        for name, text in page.files.items():
            (folder / name).write_text(text)
        for name, how, block in page.changes:
            path = folder / name
            path.write_text(changed(path.read_text(), how, block))
        self.changed = sorted({*page.files, *(name for name, _, _ in page.changes)})

    def sources(self):
        """What has changed, and what includes a header that has changed. Nodes do not."""
        headers = [name.split("include/")[1] for name in self.changed if name.endswith(".h")]
        found = {name for name in self.changed if name.endswith(".cpp")}
        for path in (self.folder / "src").rglob("*.cpp"):
            if any(f'"{header}"' in path.read_text() for header in headers):
                found.add(str(path.relative_to(self.folder)))
        return sorted(found)

    def compile(self, name, flags):
        target = str(self.folder / name).replace("/", "_") + ".o"
        # In the search itself an unoptimised part would take the time of the whole test.
        how = ["-fsyntax-only"] if name.endswith("extended_space_planner.cpp") else \
            ["-c", "-o", str(self.folder / target.strip("_"))]
        result = surroundings.run([*flags, *how, str(self.folder / name)], timeout=280.0)
        assert result.returncode == 0, f"{name}: {result.stderr}"
        return None if how[0] == "-fsyntax-only" else how[-1]

    def build(self):
        flags = self.flags()
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            objects = filter(None, pool.map(lambda name: self.compile(name, flags),
                                            self.sources()))
            library = self.folder / LIBRARY
            result = surroundings.run([flags[0], "-shared", "-o", str(library), *objects])
        assert result.returncode == 0, result.stderr
        return library

    def flags(self):
        """Of the build's own planner_factory.cpp, but for the time that optimising takes."""
        database = json.loads((INPUTS["build"] / "compile_commands.json").read_text())
        own = str(INPUTS["source"] / "src/planner/planner_factory.cpp")
        words = shlex.split(next(e["command"] for e in database if e["file"] == own))
        while "ccache" in pathlib.Path(words[0]).name:
            words.pop(0)
        include = f"-I{INPUTS['source']}/include"
        assert include in words, words
        words = words[:words.index("-o")]
        words = [f"-I{self.folder}/include" if word == include else word for word in words]
        return [word for word in words if not re.match(r"-O\d|-Werror|-flto", word)] + ["-O0"]


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        package = pathlib.Path(folder.name) / "package"
        package.mkdir()
        cls.page = Page((INPUTS["source"] / PAGE).read_text())
        cls.overlay = Overlay(package, cls.page)
        cls.environment = surroundings.environment_of(INPUTS["devel"],
                                                      pathlib.Path(folder.name) / "log")
        cls.preloaded = None

    def run_there(self, command, timeout=200.0, preload=True):
        environment = dict(self.environment)
        if preload:
            environment["LD_PRELOAD"] = str(self.preloaded)
        result = surroundings.run(command, timeout, cwd=self.overlay.folder, env=environment)
        self.assertEqual(result.returncode, 0, f"{command}: {result.stdout}{result.stderr}")
        return result.stdout

    def there(self, words):
        return [word.replace("$PWD", str(self.overlay.folder)) for word in words]

    def commands(self, *names):
        """The words of the commands of the page that begin with one of these."""
        found = [self.there(shlex.split(line)) for line in self.page.commands]
        found = [words for words in found if words[0].endswith(names)]
        self.assertTrue(found, names)
        return found


class RecipesTest(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.preloaded = cls.overlay.build()

    def test_every_command_is_looked_at(self):
        known = ("run_experiments", "demo.sh", "roslaunch", "cmake", "list_parameters.py", "export",
                 "check_inputs", "send_goal", "test_planner", "test_prior", "test_sim", ".")
        for line in self.page.commands:
            self.assertTrue(line.split()[0].endswith(known), line)

    def test_the_table_of_parameters_takes_the_new_names(self):
        for words in self.commands("list_parameters.py"):
            self.run_there([sys.executable, *words], preload=False)
        text = (self.overlay.folder / "README.md").read_text()
        for name in ("`careful`", "`2d_wide`", "`two_way`"):
            self.assertIn(name, text)

    def test_experiments(self):
        for words in self.commands("run_experiments"):
            with self.subTest(words=words):
                options = words[1:] + ["--max-trials", "3"]
                header, *rows = self.run_there(["run_experiments", *options]).splitlines()
                self.assertTrue(header.startswith("world,"))
                planners = words[words.index("--planners") + 1:] if "--planners" in words else [""]
                planners = [name for name in planners if not name.isdigit() and name[0:2] != "--"]
                self.assertEqual(len(rows), len(planners), rows)
                for row in rows:
                    self.assertEqual(row.split(",")[4], "1", f"did not arrive: {row}")

    def test_contracts(self):
        for words in self.commands("test_planner", "test_prior", "test_sim"):
            with self.subTest(words=words):
                program = INPUTS["devel"] / "lib/pomdp_crowd_nav" / pathlib.Path(words[0]).name
                out = self.run_there([str(program), *words[1:]])
                self.assertRegex(out, r"\[  PASSED  \] [1-9]")

    def test_arguments_of_other_commands(self):
        launch = (INPUTS["source"] / "launch/simulation.launch").read_text()
        usage = self.run_there(["bash", "scripts/demo.sh", "--help"], preload=False)
        for words in self.commands("demo.sh", "roslaunch", "check_inputs", "send_goal"):
            if words[0] in ("check_inputs", "send_goal"):
                usage_of_tool = self.run_there([words[0], "--help"], preload=False)
                for option in filter(lambda word: word.startswith("--"), words):
                    self.assertIn(option, usage_of_tool)
            elif words[0] == "roslaunch" and "simulation.launch" in words:
                for name in (word.split(":=")[0] for word in words[3:]):
                    self.assertIn(f'<arg name="{name}"', launch, words)
            elif words[0] != "roslaunch":
                for option in filter(lambda word: word.startswith("--"), words):
                    self.assertIn(option, usage)

    def test_launch_files_start_what_they_say(self):
        nodes = self.run_there(["roslaunch", "--nodes", "my_robot.launch"], preload=False)
        self.assertEqual(nodes.split(), ["/planner_node", "/velocity_guard"])
        self.assertNotIn("undocumented", self.run_there(
            ["roslaunch", "--ros-args", "my_robot.launch"], preload=False))


class RobotTest(PageTest):
    def test_robot_drives_in_the_simulator(self):
        port = self.environment["ROS_MASTER_URI"].rsplit(":", 1)[1]
        near = self.overlay.folder / "near.yaml"  # the yard, for a shorter trip
        near.write_text(self.page.files["yard.yaml"].replace("goal: [28.0, ", "goal: [8.0, "))
        self.assertIn("goal: [8.0, ", near.read_text())
        out = self.run_there(["roslaunch", "-p", port, "my_robot_simulated.launch",
                              f"world_file:={near}"], timeout=150.0, preload=False)
        self.assertIn("goal_reached=true", out)


if __name__ == "__main__":
    INPUTS.update(zip(("source", "build", "devel"), map(pathlib.Path, sys.argv[1:4])))
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
