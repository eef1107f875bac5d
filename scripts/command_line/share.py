# SPDX-License-Identifier: BSD-3-Clause
"""Where the package's files are."""
import pathlib


def share_folder():
    """That of the sources or of the installation that this script lies in."""
    scripts = pathlib.Path(__file__).resolve().parents[1]
    installed = scripts.parents[1] / "share/pomdp_crowd_nav"
    return installed if (installed / "config").is_dir() else scripts.parent
