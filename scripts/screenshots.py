#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the pictures of RViz that doc/ shows: the whole field, close to the robot, each layer alone.

  screenshots.py --build-dir build --output doc/images

Drives in simulation.launch on a master of its own, keeps all that is drawn at a moment, ends the
simulation, and shows that moment to RViz on a screen of its own (Xvfb). It writes

  rviz_scenario_1.png  the view "Whole field" of rviz/navigation.rviz, --at seconds into the trip
  rviz_close.png       the same moment in its view "Close to the robot"
  rviz_layers.png      each layer alone; who is in the way, arrival times and roadmap of other moments

and takes some minutes. Needs RViz and the packages xvfb and imagemagick. Exit status 0, or 2 for a
bad option, a missing program, or a moment that does not come.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
# pylint: disable=wrong-import-position,import-outside-toplevel
from command_line.share import share_folder  # noqa: E402
from soak_harness import environment  # noqa: E402

PROGRAMS = {"Xvfb": "xvfb", "import": "imagemagick", "rviz": "rviz"}
FIELD, CLOSE, TILE = (830, 850), (830, 580), (405, 270)  # [px]
PEOPLE, TREE, ROBOT = "People as believed", "Search tree", "Robot and status"
WORLD, TRUTH, ROADMAP = "World (simulator)", "People as they are (simulator)", "Roadmap (2d_prm)"
LARGE_TREE = 30000  # beliefs
# Layer, the moment, its display, its namespace, width of the view [m] (None: the field), about what.
LAYERS = (
    ("areas", "obstacles", WORLD, "areas", None, "field"),
    ("outlines", "obstacles", WORLD, "outlines", None, "field"),
    ("really_there", "drive", TRUTH, "really_there", 60, "robot"),
    ("people", "drive", PEOPLE, "people", 30, "robot"),
    ("belief", "drive", PEOPLE, "belief", 30, "robot"),
    ("tracks", "drive", PEOPLE, "tracks", 30, "robot"),
    ("attended", "drive", PEOPLE, "attended", 30, "robot"),
    ("ways", "drive", PEOPLE, "ways", 30, "robot"),
    ("blocking", "blocked", PEOPLE, "blocking", 15, "robot"),
    ("tree", "drive", TREE, "tree", 20, "robot"),
    ("rollouts", "drive", TREE, "rollouts", 30, "robot"),
    ("chosen", "drive", TREE, "chosen", 20, "robot"),
    ("disc", "drive", ROBOT, "disc", 8, "robot"),
    ("emergency_distance", "drive", ROBOT, "emergency_distance", 8, "robot"),
    ("driven", "drive", ROBOT, "driven", 60, "robot"),
    ("status", "drive", ROBOT, "status", 80, "headline"),
    ("cause", "blocked", ROBOT, "cause", 30, "robot"),
    ("Way without people", "drive", "Way without people", None, 30, "robot"),
    ("Planned path", "drive", "Planned path", None, 20, "robot"),
    ("Goal", "drive", "Goal", None, 15, "goal"),
    ("MOVO", "drive", "MOVO", None, 3, "robot"),
    ("Arrival time", "obstacles", "Arrival time (prior)", None, None, "field"),
    ("edges", "roadmap", ROADMAP, "edges", 30, "middle"),
    ("milestones", "roadmap", ROADMAP, "milestones", 30, "middle"),
    ("shortest_ways", "roadmap", ROADMAP, "shortest_ways", 30, "middle"),
)


def say(text):
    print(f"screenshots.py: {text}", file=sys.stderr, flush=True)


def parse():
    number = environment.number
    parser = environment.Parser(prog="screenshots.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build-dir", default=os.environ.get("PCN_BUILD_DIR", ""),
                        help="folder of the build to run, by default $PCN_BUILD_DIR, else what the "
                             "environment or build/ has")
    parser.add_argument("--output", default="screenshots",
                        help="folder of the pictures, made if it is missing (%(default)s)")
    parser.add_argument("--people", type=number(1, 10000, int), default=400,
                        help="size of the crowd (%(default)s)")
    parser.add_argument("--seed", type=number(0, 999999999, int), default=1,
                        help="of the crowd (%(default)s)")
    parser.add_argument("--at", type=number(1, 1000), default=20.0,
                        help="the moment: the first larger decision after so many seconds of the "
                             "trip (%(default)s)")
    parser.add_argument("--jobs", type=number(1, 64, int), default=os.cpu_count(),
                        help="pictures at the same time (%(default)s)")
    options = parser.parse_args()
    options.images, options.work = options.output, f"{options.output}/screenshots_work"
    options.output = options.work  # of logs, for the environment
    missing = sorted(package for program, package in PROGRAMS.items() if not shutil.which(program))
    if missing:
        parser.error(f"not installed: {', '.join(missing)}; apt-get install {' '.join(missing)}")
    return parser, options


def drives(options, folder):
    """The moments, by name."""
    from rviz_pictures.moment import Drive
    found = {}

    def drive(name, arguments, moments):
        simulation = Drive(dict(arguments, seed=options.seed), folder / f"log/{name}.log")
        try:
            for moment, condition, what, timeout in moments(simulation):
                say(f"waiting for {what}…")
                found[moment] = simulation.moment(condition, what, timeout)
        finally:
            simulation.stop()

    def in_the_crowd(simulation):
        def is_blocked():
            return simulation.status.state == simulation.status.WAITING_FOR_PEOPLE
        def is_time():  # and the decision was not a simple one
            return simulation.metrics.travel_time >= options.at and \
                simulation.status.tree_size >= LARGE_TREE
        yield "drive", is_time, f"a decision after {options.at:g} s of the trip", options.at + 60.0
        yield "blocked", is_blocked, "somebody in the way", 180.0

    def at_the_start(name, topic):
        return lambda simulation: [(name, lambda: topic in simulation.latest, name, 60.0)]

    drive("drive", {"world": "scenario_1", "pedestrians": options.people}, in_the_crowd)
    for name, planner, topic in (("obstacles", "2d_fmm", "/planner_node/arrival_time"),
                                 ("roadmap", "2d_prm", "/planner_node/roadmap")):
        drive(name, {"world": "scenario_2", "pedestrians": 20, "planner": planner},
              at_the_start(name, topic))
    return found


def view_of(moment, width, about, size):
    from rviz_pictures.window import View
    if width is None:  # the field of 100 m in the picture's height
        return View(108.0 * size[0] / size[1], 50.0, 50.0)
    places = {"field": (50.0, 50.0), "middle": (50.0, 50.0), "headline": (50.0, 104.0)}
    if about == "robot":
        return View(width, 0.0, 0.0, "base_link")
    if about == "goal":
        goal = moment.messages["/planner_node/current_goal"].pose.position
        return View(width, goal.x, goal.y)
    return View(width, *places[about])


def layers(screens, text, moments):
    """Each layer alone, a tile each, sorted by the moment so that it is shown once."""
    from rviz_pictures.sheet import sheet
    tiles = {}
    for name, moment in moments.items():
        chosen = [layer for layer in LAYERS if layer[1] == name]
        say(f"{len(chosen)} layers, {len(LAYERS) - len(tiles)} to go…")
        moment.publish()
        pictures = screens.pictures(
            (text, view_of(moment, width, about, TILE), TILE, {display: namespace and [namespace]})
            for _, _, display, namespace, width, about in chosen)
        moment.withdraw()
        tiles.update({layer[0]: picture for layer, picture in zip(chosen, pictures)})
    return sheet([(f"{layer[0]}, {layer[4]} m" if layer[4] else layer[0], tiles[layer[0]])
                  for layer in LAYERS], 3)


def take(screens, moments, images):
    from rviz_pictures.sheet import save
    from rviz_pictures.window import View
    text = (share_folder() / "rviz/navigation.rviz").read_text()
    say("the whole field and close to the robot…")
    moments["drive"].publish()
    # The views Whole field and Close to the robot.
    whole, close = screens.pictures([(text, View(FIELD[0] / 7.6, 50.0, 54.0), FIELD),
                                     (text, View(CLOSE[0] / 28.0, frame="base_link"), CLOSE)])
    moments["drive"].withdraw()
    save(whole, images / "rviz_scenario_1.png")
    save(close, images / "rviz_close.png")
    save(layers(screens, text, moments), images / "rviz_layers.png")


def work(options, folder):
    import rospy
    from rviz_pictures.window import Screens
    port = urllib.parse.urlparse(os.environ["ROS_MASTER_URI"]).port
    with open(folder / "log/roscore.log", "w", encoding="utf-8") as log:
        master = subprocess.Popen(["roscore", "-p", str(port)], stdout=log, stderr=log)
    screens = None
    begin = time.monotonic()
    try:
        rospy.init_node("screenshots", disable_signals=True)
        moments = drives(options, folder)
        screens = Screens(folder, options.jobs, *map(max, zip(FIELD, CLOSE, TILE)))
        take(screens, moments, folder.parent)
        say(f"written to {folder.parent} in {time.monotonic() - begin:.0f} s")
    finally:
        if screens:
            screens.stop()
        master.terminate()
        master.wait()
    shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(environment.run(parse, work, say))
