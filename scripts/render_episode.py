#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a film of an episode, .gif or .mp4.

  render_episode.py episode.bag --output episode.mp4
      what record:=true has written: people in the colour of their most likely destination, those
      whose futures are searched ringed, search tree, planned steps, robot, its trail, goal, status
  render_episode.py trails.csv --output trails.gif --pedestrians 400 --planner 2d_fmm
      trails that run_experiments has written: the robots of all runs at once, or of one (--seed)

Exit status 0; 2 and one line for a bad argument or file, 130 after Ctrl-C. The film appears under its
name when it is whole.
"""
import argparse
import os
import pathlib
import sys

os.environ.setdefault("OPENCV_LOG_LEVEL", "OFF")
os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")  # of codecs that are tried and not there

from command_line.options import Parser, number  # noqa: E402
from command_line.progress import Progress  # noqa: E402
from command_line.refusal import Refusal, say, status_of  # noqa: E402
from command_line.share import share_folder  # noqa: E402
from episode_film.output import film_file, require_output  # noqa: E402

PROGRAM = "render_episode.py"


def parse(arguments):
    parser = Parser(prog=PROGRAM, description=__doc__,
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("episode", help="bag of record:=true, or CSV of run_experiments --trails")
    parser.add_argument("--output", required=True, metavar="FILE", help="film to write, .gif or .mp4")
    parser.add_argument("--speed", type=number(0.01, 1000.0), default=4.0,
                        help="times real time (4)")
    parser.add_argument("--fps", type=number(1.0, 60.0), default=10.0, help="pictures a second (10)")
    parser.add_argument("--width", type=number(160, 3840, int), default=800, help="[pixels] (800)")
    parser.add_argument("--start", type=number(0.0, 1e9), default=0.0,
                        help="[s] of the episode from its beginning (0)")
    parser.add_argument("--end", type=number(0.0, 1e9), default=1e9,
                        help="[s] of the episode from its beginning (its end)")
    parser.add_argument("--zoom", type=number(0.0, 1000.0), default=None,
                        help="[m] shown about the robot beside the field; 0: the field alone (24 of a "
                             "bag, 0 of trails)")
    parser.add_argument("--max-colors", type=number(2, 255, int), default=64,
                        help="of a .gif; fewer make it smaller (64)")
    parser.add_argument("--namespace", default="only",
                        help="of the robot to show, where the bag has several")
    parser.add_argument("--world", default=None, help="of the trails to show")
    parser.add_argument("--planner", default=None, help="of the trails to show")
    parser.add_argument("--pedestrians", type=number(0, 1000000, int), default=None,
                        help="of the trails to show")
    parser.add_argument("--seed", type=number(0, 1e18, int), default=None,
                        help="of the trails to show; all without it")
    parser.add_argument("--config", type=pathlib.Path, default=share_folder() / "config",
                        help="folder of the worlds of trails (%(default)s)")
    return parser.parse_args(arguments)


def shown_span(options, source):
    """The seconds to show."""
    length = source.end - source.begin
    end = min(options.end, length)
    if options.start >= length:
        raise Refusal(f"--start: the episode is {length:.1f} s long, got {options.start:g}")
    if end <= options.start:
        raise Refusal(f"--end: expected more than --start, {options.start:g}, got {options.end:g}")
    return options.start, end


def render(options, source, path):
    from episode_film.drawing import Film
    from episode_film.history import History
    start, end = shown_span(options, source)
    step = options.speed / options.fps
    film = Film(source.place(), options.width, source.ZOOM if options.zoom is None else options.zoom)
    history, progress = History(), Progress(PROGRAM)
    count = 0
    with film_file(path, options.fps, options.max_colors) as file:
        for scene in source.scenes(start, end, step):
            history.add(scene)
            file.add(film.draw(scene, history, options.speed))
            count += 1
            progress.show(scene.time - start, end - start, " s")
        if count == 0:
            raise Refusal(f"{options.episode}: no odometry from {start:g} to {end:g} s")
    progress.end()
    film.close_figure()
    say(PROGRAM, f"{path}: {count} pictures, {count / options.fps:.1f} s, "
        f"{path.stat().st_size / 1e6:.1f} MB")


def render_bag(options, path):
    from episode_bag import names, opening
    from episode_film.bag_scenes import BagScenes
    with opening.open_bag(options.episode) as bag:
        namespace = names.namespace_of(opening.types_of(bag), options.namespace, options.episode)
        render(options, BagScenes(bag, options.episode, namespace), path)


def main():
    options = parse(sys.argv[1:])
    path = require_output(options.output)
    kind = pathlib.Path(options.episode).suffix.lower()
    if kind == ".csv":
        from episode_film.trail_scenes import TrailScenes
        render(options, TrailScenes(options.episode, options, options.config), path)
    elif kind in (".bag", ".active"):
        render_bag(options, path)
    else:
        raise Refusal(f"{options.episode}: expected a .bag of record:=true or a .csv of "
                      "run_experiments --trails")


if __name__ == "__main__":
    sys.exit(status_of(PROGRAM, main))
