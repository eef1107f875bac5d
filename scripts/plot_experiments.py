#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws figures of experiments.

  plot_experiments.py trails trails.csv --pedestrians 400 --output trails.png trails.pdf
      where the robot drove in all runs: a row for each world, a column for each planner
  plot_experiments.py reduction results.csv --output reduction.png
      by how much each planner's trips are shorter than 1d_astar's among the same people
  plot_experiments.py decision decision.json --output decision.png
      the search tree of one decision
  plot_experiments.py search-time t20.csv t50.csv t200.csv --output search_time.png
      travel time against search time, a point for each results file

Results and trails come from run_experiments, decisions from export_decision. Each figure goes to the
files after --output, in the format of their ending: png, pdf or svg. Exit status 2 and one line for
a file that is none of these.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
# pylint: disable=wrong-import-position
from command_line.options import Parser  # noqa: E402
from command_line.refusal import Refusal, status_of  # noqa: E402
from command_line.share import share_folder  # noqa: E402
from experiment_figures import decision, reduction, search_time, style, trails  # noqa: E402
from experiment_figures.style import plt  # noqa: E402


def parse(arguments):
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True, metavar="FIGURE",
                                     parser_class=Parser)

    def add(name, plot, help_text, files, files_help):
        command = commands.add_parser(name, help=help_text, description=help_text)
        command.set_defaults(plot=plot)
        if files == "file":
            command.add_argument("file", help=files_help)
        else:
            command.add_argument("files", nargs="+", help=files_help)
        command.add_argument("--output", nargs="+", required=True, metavar="FILE",
                             help="figure to write, .png, .pdf or .svg; several if wanted")
        return command

    command = add("trails", trails.plot_trails, "where the robot drove in all runs", "files",
                  "CSV that run_experiments wrote with --trails")
    command.add_argument("--pedestrians", type=int,
                        help="size of the crowd to show; without it the largest there is")
    command.add_argument("--config", type=pathlib.Path, default=share_folder() / "config",
                        help="folder of worlds (%(default)s)")
    command = add("reduction", reduction.plot_reduction,
                  "by how much trips are shorter than a baseline's", "files",
                  "CSV of results; pairs are within a file")
    command.add_argument("--baseline", default="1d_astar", help="planner (%(default)s)")
    add("decision", decision.plot_decision, "the search tree of one decision", "file",
        "JSON that export_decision wrote")
    add("search-time", search_time.plot_search_time, "travel time against search time", "files",
        "CSV of results, one for each limit of the search (--max-trials or --search-time)")
    options = parser.parse_args(arguments)
    for output in options.output:
        if pathlib.Path(output).suffix[1:] not in style.FORMATS:
            raise Refusal(f"--output: '{output}' must end with one of: " + ", ".join(style.FORMATS))
    return options


def draw():
    options = parse(sys.argv[1:])
    with plt.rc_context(style.STYLE):
        options.plot(options)


def main():
    return status_of("plot_experiments.py", draw)


if __name__ == "__main__":
    sys.exit(main())
