#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Films of small bags and trails show something, and bad input ends with one line and status 2.

Run in the environment of the devel space, which has the messages that the bags are made of.
"""
import contextlib
import importlib.util
import io
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

import cv2
import numpy
import rosbag
from PIL import Image

from episode_bag_writer import EpisodeBag
from std_msgs.msg import String

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/render_episode.py"
sys.path.insert(0, str(SCRIPT.parent))
SPEC = importlib.util.spec_from_file_location("render_episode", SCRIPT)
RENDER = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(RENDER)
TRAILS = "world,pedestrians,planner,seed,time_s,x_m,y_m\n"


def gif_pictures(path):
    with Image.open(path) as image:
        for k in range(image.n_frames):
            image.seek(k)
            yield numpy.asarray(image.convert("RGB"))


def mp4_pictures(path):
    film = cv2.VideoCapture(str(path))
    while True:
        is_there, picture = film.read()
        if not is_there:
            return
        yield picture[:, :, ::-1]


class RenderTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.TemporaryDirectory()
        cls.bag = pathlib.Path(cls.shared.name) / "episode.bag"
        EpisodeBag(cls.bag, seconds=2.0)

    @classmethod
    def tearDownClass(cls):
        cls.shared.cleanup()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    @staticmethod
    def run_script(*arguments):
        """Status and what is said; in this process, as starting one takes longer than a film."""
        with contextlib.redirect_stderr(io.StringIO()) as said, \
                unittest.mock.patch.object(sys, "argv", ["render_episode.py", *map(str, arguments)]):
            return RENDER.status_of(RENDER.PROGRAM, RENDER.main), said.getvalue()

    def expect_film(self, source, name, *options):
        path = self.folder / name
        status, said = self.run_script(source, "--output", path, "--width", 400, *options)
        self.assertEqual(status, 0, said)
        pictures = list((gif_pictures if name.lower().endswith("gif") else mp4_pictures)(path))
        self.assertEqual([item.name for item in self.folder.iterdir() if item.name[0] == "."], [])
        return pictures

    def expect_refusal(self, arguments, *words):
        status, said = self.run_script(*arguments)
        self.assertEqual(status, 2, said)
        self.assertEqual(len(said.splitlines()), 1, said)
        for word in ("render_episode.py: ", *words):
            self.assertIn(word, said)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def assert_alive(self, pictures, count):
        """Not blank, of the wanted size, and something moves."""
        self.assertAlmostEqual(len(pictures), count, delta=1)
        for picture in pictures:
            self.assertEqual(picture.shape[1], 400)
            self.assertGreater(numpy.ptp(picture.astype(int)), 150)
        differences = (pictures[0].astype(int) - pictures[-1]) ** 2
        self.assertGreater(numpy.count_nonzero(differences.sum(axis=2) > 3000), 50)

    @staticmethod
    def count_like(picture, colour):
        """Pixels of about that colour."""
        return int((numpy.abs(picture.astype(int) - colour).max(axis=2) < 40).sum())

    def test_gif_of_a_bag(self):
        pictures = self.expect_film(self.bag, "film.GIF", "--speed", 1, "--fps", 5, "--zoom", 8)
        self.assert_alive(pictures, 10)
        for colour in ((230, 0, 0), (219, 31, 120), (236, 180, 70)):  # tree, plan, person
            self.assertGreater(self.count_like(pictures[5], colour), 3, colour)

    def test_mp4_of_a_bag(self):
        self.assert_alive(self.expect_film(self.bag, "film.mp4", "--speed", 1, "--fps", 5), 10)

    def test_bag_of_a_robot_in_a_namespace_with_people_msgs(self):
        bag = self.folder / "two.bag"
        EpisodeBag(bag, seconds=1.0, namespace="/robot_1", people_msgs=True)
        pictures = self.expect_film(bag, "film.gif", "--speed", 1, "--fps", 5, "--zoom", 0)
        self.assert_alive(pictures, 5)
        self.assertGreater(self.count_like(pictures[3], (236, 180, 70)), 3)

    def test_part_of_an_episode(self):
        pictures = self.expect_film(self.bag, "film.gif", "--speed", 1, "--fps", 5, "--start", 1,
                                    "--end", 1.5)
        self.assertAlmostEqual(len(pictures), 3, delta=1)

    def test_few_colours(self):
        pictures = self.expect_film(self.bag, "film.gif", "--speed", 1, "--max-colors", 8)
        colours = {tuple(colour) for picture in pictures for colour in picture.reshape(-1, 3)}
        self.assertLessEqual(len(colours), 8)

    def test_trails(self):
        rows = [f"scenario_1,100,2d_fmm,{seed},{t},{1 + 5 * t},{25 + t + 9 * seed}\n"
                for seed in (1, 2) for t in range(9)]
        trails = self.write("trails.csv", TRAILS + "".join(rows))
        self.assert_alive(self.expect_film(trails, "film.gif", "--speed", 5, "--fps", 5), 9)
        self.assert_alive(self.expect_film(trails, "one.mp4", "--speed", 5, "--fps", 5, "--seed", 2), 9)

    def test_trails_of_several_planners(self):
        rows = [f"scenario_1,100,{planner},1,{t},{t},{t}\n" for planner in ("2d_fmm", "1d_astar")
                for t in range(3)]
        trails = self.write("trails.csv", TRAILS + "".join(rows))
        output = ["--output", self.folder / "film.gif"]
        self.expect_refusal([trails, *output], "--planner", "1d_astar, 2d_fmm")
        self.expect_refusal([trails, *output, "--planner", "magic"], "magic", "1d_astar, 2d_fmm")

    def test_bad_files(self):
        output = ["--output", self.folder / "film.gif"]
        whole = self.bag.read_bytes()
        self.write("cut.bag.active", b"")
        for name, content, words in (
                ("empty.bag", b"", ["empty"]), ("text.bag", b"no bag at all\n", ["rosbag record"]),
                ("short.bag", whole[:len(whole) // 2], ["rosbag"]), ("film.txt", b"", [".bag"]),
                ("header.csv", "a,b\n1,2\n", ["there is no column 'world'"]),
                ("cells.csv", TRAILS + "scenario_1,1,2d_fmm,1,x,0,0\n", ["time_s", "'x'"])):
            with self.subTest(name):
                self.expect_refusal([self.write(name, content), *output], name, *words)
        self.expect_refusal([self.folder / "none.bag", *output], "there is no such file")
        self.expect_refusal([self.folder / "cut.bag", *output], "rosbag reindex")
        self.assertFalse((self.folder / "film.gif").exists())

    def test_foreign_and_silent_bags(self):
        foreign, silent = self.folder / "foreign.bag", self.folder / "silent.bag"
        with rosbag.Bag(str(foreign), "w") as bag:
            bag.write("/chatter", String("hello"))
        with rosbag.Bag(str(silent), "w"):
            pass
        self.expect_refusal([foreign, "--output", self.folder / "f.gif"], "not an episode")
        self.expect_refusal([silent, "--output", self.folder / "f.gif"], "no message")

    def test_bad_options(self):
        good = ["--output", self.folder / "film.gif"]
        for options, word in (([], "--output"), (["--output", "film.avi"], ".gif, .mp4"),
                              (["--output", self.folder / "no/film.gif"], "no folder"),
                              ([*good, "--speed", "0"], "--speed"), ([*good, "--fps", "x"], "--fps"),
                              ([*good, "--width", "9"], "--width"), ([*good, "--start", "5"], "2.0 s"),
                              ([*good, "--start", "1", "--end", "1"], "--end"),
                              ([*good, "--max-colors", "1"], "--max-colors"),
                              ([*good, "--namespace", "robot_7"], "robot_7")):
            with self.subTest(options):
                self.expect_refusal([self.bag, *options], word)

    def test_as_a_program(self):
        result = subprocess.run([sys.executable, SCRIPT, self.bag, "--output", "film.avi"], text=True,
                                check=False, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual(result.returncode, 2, result.stderr)

    def test_interrupted(self):
        process = subprocess.Popen([sys.executable, SCRIPT, self.bag, "--output",
                                    self.folder / "film.mp4", "--speed", "0.01"],
                                   stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60.0
        while not list(self.folder.iterdir()) and time.monotonic() < end:
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(30), 130)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_film_that_fails_leaves_the_old_one(self):
        film = self.write("film.gif", "the old one")
        self.expect_refusal([self.bag, "--output", film, "--start", "9"], "--start")
        self.assertEqual(film.read_text(), "the old one")


if __name__ == "__main__":
    unittest.main()
