#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Figures are made in each format, and bad input ends with one line and status 2."""
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/plot_experiments.py"
SPEC = importlib.util.spec_from_file_location("plot_experiments", SCRIPT)
PLOT = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(PLOT)
RESULTS = ("world,pedestrians,planner,seed,reached,travel_time_s,unsafe_ticks_0_5m,"
           "mean_search_time_s,stale_paths\n")
TRAILS = "world,pedestrians,planner,seed,time_s,x_m,y_m\n"
MAGIC = {".png": b"\x89PNG", ".pdf": b"%PDF", ".svg": b"<?xml"}


def results(search=0.02, seeds=(1, 2, 3)):
    rows = [f"{world},{people},{planner},{seed},1,{time + seed},0,{search},0\n"
            for world in ("scenario_1", "scenario_2") for people in (100, 400)
            for planner, time in (("1d_astar", 80), ("2d_fmm", 64), ("mine", 66))
            for seed in seeds]
    return RESULTS + "".join(rows)


def trails():
    rows = [f"{world},{people},2d_fmm,{seed},{t},{1 + 2 * t},{25 + t + seed}\n"
            for world in ("scenario_1", "scenario_3") for people in (100, 400)
            for seed in (1, 2) for t in range(5)]
    return TRAILS + "".join(rows)


def decision():
    return {"world": {"bounds": [[0, 0], [100, 100]], "goal": [100, 75], "circles": [[9, 9, 2]],
                      "polygons": [{"closed": False, "vertices": [[1, 1], [2, 2]]}],
                      "destinations": [[0, 0], [100, 100]]},
            "robot": {"position": [5, 5], "radius": 1.0}, "plan": [[5, 5], [6, 5]],
            "tree": [{"from": [5, 5], "to": [6, y], "value": 10.0 * y, "weight": 1.0, "depth": 1}
                     for y in (4, 5, 6)],
            "rollouts": [[[6, 5], [20, 10], [100, 75]]],
            "people": [{"position": [8, 5], "belief": [0.3, 0.7], "attended": True,
                        "predicted": [[8.7, 5.7], [9.4, 6.4]]},
                       {"position": [20, 5], "belief": [0.5, 0.5], "attended": False,
                        "predicted": []}]}


def error_bars_of(svg):
    """How many are drawn; those in a legend are not clipped."""
    groups = re.findall(r'<g id="LineCollection_\d+">(.*?)</g>', svg, re.S)
    return sum(len(re.findall(r'<path d="M[^"]+" clip-path', group)) for group in groups)


@contextlib.contextmanager
def in_folder(folder):
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


class PlotTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def run_script(self, *args):
        return subprocess.run([sys.executable, SCRIPT, *args], cwd=self.folder,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=120, check=False)

    def expect_figures(self, *args, formats=(".png",)):
        outputs = [f"figure{ending}" for ending in formats]
        result = self.run_script(*args, "--output", *outputs)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        for output in outputs:
            content = (self.folder / output).read_bytes()
            self.assertGreater(len(content), 2000)
            self.assertTrue(content.startswith(MAGIC[pathlib.Path(output).suffix]))

    # Without a program of its own, for it would take most of its time to begin.
    def expect_status(self, status, args):
        shown = io.StringIO()
        with contextlib.redirect_stderr(shown), in_folder(self.folder), \
                unittest.mock.patch.object(sys, "argv", [str(SCRIPT), *args]):
            self.assertEqual(PLOT.main(), status, shown.getvalue())
        PLOT.plt.close("all")
        return shown

    def expect_refusal(self, args, *words):
        shown = self.expect_status(2, args)
        lines = shown.getvalue().splitlines()
        self.assertEqual(len(lines), 1, shown.getvalue())
        self.assertTrue(lines[0].startswith("plot_experiments.py: "), lines[0])
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual([path.name for path in self.folder.glob("figure*")], [])

    def test_trails_of_worlds_with_and_without_obstacles(self):
        self.expect_figures("trails", self.write("t.csv", trails()), "--pedestrians", "100",
                            formats=(".png", ".pdf", ".svg"))

    def test_reduction(self):
        self.expect_figures("reduction", self.write("r.csv", results()), formats=(".png", ".svg"))
        text = (self.folder / "figure.svg").read_text()
        for word in ("2D-FMM", "mine", "Scenario 2", "1D-A*", "400"):
            self.assertIn(word, text)

    def test_of_a_single_run_no_standard_error_is_known(self):
        rows = results(seeds=(1, 2)).splitlines(keepends=True)
        mixed = "".join(row for row in rows if not row.startswith("scenario_2,400,mine,2"))
        for figure, single, bars in (("reduction", "one pair", 8), ("search-time", "one run", 12)):
            for text, label, drawn in (
                    (results(seeds=(1,)), f"({single} each, no standard error)", 0),
                    (mixed, f"none for {single})", bars - 1),
                    (results(), "(mean ± standard error)", bars)):
                with self.subTest(figure=figure, label=label):
                    file = self.write("r.csv", text)
                    self.expect_status(0, [figure, file, "--output", "figure.svg"])
                    svg = (self.folder / "figure.svg").read_text()
                    self.assertIn(label, svg)
                    self.assertEqual(error_bars_of(svg), drawn)

    def test_decision(self):
        self.expect_figures("decision", self.write("d.json", json.dumps(decision())))

    def test_search_time_is_labelled_from_the_settings(self):
        for name, settings, search in (("a.csv", {"max_trials": 50, "search_time": 0}, 0.004),
                                       ("b.csv", {"max_trials": 0, "search_time": 0.5}, 0.5),
                                       ("c.csv", None, 0.02)):
            self.write(name, results(search))
            if settings:
                self.write(f"{name}.settings.json", json.dumps(settings))
        self.expect_figures("search-time", "a.csv", "b.csv", "c.csv", formats=(".svg",))
        text = (self.folder / "figure.svg").read_text()
        for label in ("50 trials", "500 ms", ">c<"):
            self.assertIn(label, text)

    def test_files_that_are_none(self):
        out = ("--output", "figure.png")
        self.expect_refusal(["reduction", "none.csv", *out], "none.csv", "cannot be read")
        self.expect_refusal(["reduction", self.write("empty.csv", ""), *out], "empty.csv:1")
        self.expect_refusal(["reduction", self.write("head.csv", RESULTS), *out], "head.csv:2")
        self.expect_refusal(["trails", self.write("r.csv", results()), *out], "r.csv:1", "'time_s'")
        ragged = results() + "scenario_1,100\n"
        self.expect_refusal(["reduction", self.write("ragged.csv", ragged), *out],
                            "ragged.csv:38", "9 cells", "got 2")
        words = results().replace("81,", "soon,", 1)
        self.expect_refusal(["reduction", self.write("w.csv", words), *out], "w.csv:2",
                            "travel_time_s", "'soon'")
        self.expect_refusal(["decision", self.write("d.json", "{"), *out], "d.json:1")
        self.expect_refusal(["decision", self.write("d.json", "{}"), *out], "d.json", "'world'")

    def test_files_that_lack_something(self):
        out = ("--output", "figure.png")
        world = (ROOT / "config/worlds/scenario_1.yaml").read_text()
        for key in ("goal", "start", "bounds"):
            text = re.sub(rf"^{key}:", "more:", world, flags=re.MULTILINE)
            path = self.write("w.yaml", text)
            one = trails().replace("scenario_1", f"./{path}").replace("scenario_3", f"./{path}")
            self.expect_refusal(["trails", self.write("t.csv", one), *out], "w.yaml", f"'{key}'")
        for line in ("circles: [[1, 2]]", "circles: 3", "polygons: [{closed: true}]",
                     "polygons: [[1, 2]]"):
            self.write("w.yaml", f"{world}\n{line}\n")
            self.expect_refusal(["trails", "t.csv", *out], "w.yaml", "a world")
        for part, key in (("robot", "position"), ("robot", "radius"), ("world", "goal"),
                          ("world", "destinations"), ("world", "bounds")):
            broken = decision()
            del broken[part][key]
            self.expect_refusal(["decision", self.write("d.json", json.dumps(broken)), *out],
                                "d.json", f"'{key}'")
        for part, value in (("tree", [{"from": [1, 2]}]), ("tree", [7]), ("people", [[1, 2]]),
                            ("rollouts", [3]), ("plan", [1]), ("robot", []), ("world", "here")):
            broken = {**decision(), part: value}
            self.expect_refusal(["decision", self.write("d.json", json.dumps(broken)), *out],
                                "d.json", "a decision of export_decision")
        self.write("r.csv", results())
        for settings in ([1, 2], {"max_trials": "many"}, {"max_trials": [1]}, "x"):
            self.write("r.csv.settings.json", json.dumps(settings))
            self.expect_refusal(["search-time", "r.csv", *out], "r.csv.settings.json", "settings")

    def test_what_is_not_in_the_files(self):
        out = ("--output", "figure.png")
        self.write("r.csv", results())
        self.expect_refusal(["reduction", "r.csv", "--baseline", "3d", *out], "'3d'")
        self.write("t.csv", trails())
        self.expect_refusal(["trails", "t.csv", "--pedestrians", "7", *out], "7 people", "100, 400")
        self.expect_refusal(["trails", "t.csv", "--config", "nowhere", *out], "scenario_1.yaml")

    def test_options(self):
        self.write("r.csv", results())
        self.expect_refusal([], "FIGURE")
        self.expect_refusal(["reduction", "r.csv"], "--output")
        self.expect_refusal(["reduction", "r.csv", "--output", "figure.bmp"], "figure.bmp", "png")
        self.expect_refusal(["reduction", "r.csv", "--output", "nowhere/figure.png"],
                            "nowhere/figure.png")
        result = self.run_script("--help")
        self.assertEqual(result.returncode, 0)
        for figure in ("trails", "reduction", "decision", "search-time"):
            self.assertIn(figure, result.stdout)


if __name__ == "__main__":
    unittest.main()
