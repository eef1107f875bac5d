# SPDX-License-Identifier: BSD-3-Clause
"""RViz for a replay: the package's own view, without what could send anything."""
import pathlib

import yaml

from command_line.refusal import Refusal, expecting, read_text
from command_line.share import share_folder

FRAMES = ("Fixed Frame", "Reference Frame", "Target Frame")
SENDING_TOOLS = ("rviz/SetGoal", "rviz/SetInitialPose", "rviz/PublishPoint")


def view_file(name, is_street):
    """A file of the folder rviz without its ending, or a path; by default what suits the place."""
    if name == "auto":
        name = "street" if is_street else "navigation"
    path = pathlib.Path(name) if "/" in name else share_folder() / f"rviz/{name}.rviz"
    if not path.is_file():
        known = ", ".join(sorted(file.stem for file in (share_folder() / "rviz").glob("*.rviz")))
        raise Refusal(f"--view: there is no '{name}'; choose one of: {known}")
    return path


def prefix_of(frame):
    """That of all frames where the global one is PREFIX/map."""
    return frame[:-len("map")] if frame.endswith("/map") else ""


def rename_frames(node, frame):
    prefix = prefix_of(frame)
    if isinstance(node, list):
        for item in node:
            rename_frames(item, frame)
    if not isinstance(node, dict):
        return
    for key, value in node.items():
        if key in FRAMES and value == "map":
            node[key] = frame
        elif key in FRAMES and isinstance(value, str) and value and value[0] != "<":
            node[key] = prefix + value
        elif key == "TF Prefix" and prefix:
            node[key] = prefix.rstrip("/")
        else:
            rename_frames(value, frame)


def replay_view(path, frame):
    """The text of a view whose global frame is `frame` and which only shows."""
    try:
        view = yaml.safe_load(read_text(path))
    except yaml.YAMLError:
        raise Refusal(f"{path}: expected a view of RViz in yaml") from None
    with expecting("a view of RViz", path):
        manager = view["Visualization Manager"]
        manager["Tools"] = [tool for tool in manager.get("Tools", [])
                            if tool["Class"] not in SENDING_TOOLS]
        view["Panels"] = [panel for panel in view.get("Panels", [])
                          if panel["Class"].startswith("rviz/")]
        rename_frames(manager, frame)
    return yaml.safe_dump(view, sort_keys=False)
