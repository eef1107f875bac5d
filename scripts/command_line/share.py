# SPDX-License-Identifier: BSD-3-Clause
"""Where files are: the package's and the caller's."""
import os
import pathlib


def share_folder():
    """That of the sources or of the installation that this script lies in."""
    scripts = pathlib.Path(__file__).resolve().parents[1]
    installed = scripts.parents[1] / "share/pomdp_crowd_nav"
    return installed if (installed / "config").is_dir() else scripts.parent


def path_of(name):
    """A path that is not absolute begins where roslaunch was called, not where nodes run."""
    return pathlib.Path(os.environ.get("PWD", "."), pathlib.Path(name).expanduser())
