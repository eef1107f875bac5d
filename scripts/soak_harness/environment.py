# SPDX-License-Identifier: BSD-3-Clause
"""A ROS environment of one's own: the build folder's, with a master on a free port."""
import argparse
import difflib
import importlib.util
import os
import pathlib
import signal
import socket
import subprocess
import sys

from command_line.options import number

MARK = "PCN_SOAK_ENVIRONMENT"  # set in the environment that has been prepared
SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Parser(argparse.ArgumentParser):
    """One line for a bad option."""

    def error(self, message):
        print(f"{self.prog}: {message}", file=sys.stderr)
        sys.exit(2)


def named_in(folder):
    """A type for options: a yaml file of a folder of config/, without its ending."""
    def parse(text):
        names = sorted(path.stem for path in (SOURCE / "config" / folder).glob("*.yaml"))
        if names and text not in names:
            meant = difflib.get_close_matches(text, names, 1)
            hint = f", did you mean '{meant[0]}'?" if meant else ""
            raise argparse.ArgumentTypeError(
                f"there is no '{text}'; choose one of: {', '.join(names)}{hint}")
        return text
    return parse


def add_common_options(parser):
    parser.add_argument("--build-dir", default=os.environ.get("PCN_BUILD_DIR", ""),
                        help="folder of the build to run, by default $PCN_BUILD_DIR, else what the "
                             "environment or build/ has")
    parser.add_argument("--output", default="",
                        help="folder for what is written, made if it is missing; by default one "
                             "named after the time in the present folder")
    parser.add_argument("--world", type=named_in("worlds"), default="scenario_2",
                        help="a file of config/worlds without its ending (%(default)s)")
    parser.add_argument("--profile", type=named_in("profiles"), default="tuned",
                        help="a file of config/profiles without its ending (%(default)s)")
    parser.add_argument("--people", type=number(0, 10000, int), default=400,
                        help="size of the crowd (%(default)s)")
    parser.add_argument("--seed", type=number(0, 999999999, int), default=1,
                        help="of the crowd, the goals and the faults (%(default)s)")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def setup_file(parser, build_dir):
    """The setup.bash to source; None where the environment knows the package already."""
    if build_dir:
        path = pathlib.Path(build_dir).resolve() / "devel/setup.bash"
        if not path.is_file():
            parser.error(f"--build-dir: there is no '{path}'")
        return path
    paths = os.environ.get("ROS_PACKAGE_PATH", "").split(":")
    if any(pathlib.Path(path, "pomdp_crowd_nav/package.xml").is_file()
           or pathlib.Path(path).resolve() == SOURCE for path in paths if path):
        return None
    path = SOURCE / "build/devel/setup.bash"
    if path.is_file():
        return path
    return parser.error("--build-dir: nothing has been built in build/ and no environment is set up")


def sourced(path):
    """The environment after sourcing a file."""
    text = subprocess.run(["bash", "-c", '. "$0" >&2 && env -0', str(path)], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    return dict(entry.split("=", 1) for entry in text.split("\0") if "=" in entry)


def enter(parser, options):
    """Starts this program afresh in an environment of its own, unless it is in there."""
    if os.environ.get(MARK) == str(os.getpid()):
        return pathlib.Path(options.output)
    setup = setup_file(parser, options.build_dir)
    folder = pathlib.Path(options.output).resolve()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "log").mkdir(exist_ok=True)
    except OSError as error:
        parser.error(f"--output: {error}")
    environment = sourced(setup) if setup else dict(os.environ)
    for name in ("ROS_HOSTNAME", "ROS_NAMESPACE", "ROSCONSOLE_FORMAT", "ROSCONSOLE_CONFIG_FILE"):
        environment.pop(name, None)
    environment.update(
        ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}", ROS_IP="127.0.0.1",
        ROS_HOME=str(folder / "log"), ROS_LOG_DIR=str(folder / "log"),
        ROSCONSOLE_STDOUT_LINE_BUFFERED="1", PYTHONUNBUFFERED="1")
    environment[MARK] = str(os.getpid())  # exec keeps the process
    # A python of pyenv or conda in front of the system's lacks the ROS modules.
    python = sys.executable if importlib.util.find_spec("rospkg") else "/usr/bin/python3"
    arguments = [python, *sys.argv]
    os.execvpe(arguments[0], arguments, environment)


def _interrupt(*_):
    raise KeyboardInterrupt


def run(parse, work, say):
    """`work(options, folder)` in an environment of its own, with its exit status: 2 when the nodes do not
    start or it is interrupted. `parse` returns the parser and the options."""
    parser, options = parse()
    folder = enter(parser, options).resolve()
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        work(options, folder)
        return 0
    except (RuntimeError, KeyboardInterrupt) as error:
        say(str(error) or "interrupted")
        return 2
