# SPDX-License-Identifier: BSD-3-Clause
"""RViz on a screen of its own: one view of a project's configuration as a picture."""
import concurrent.futures
import copy
import os
import queue
import subprocess
import time

import yaml
from PIL import Image

SHARPNESS = 2    # drawn so many times larger, then reduced: RViz draws edges without shades
TIMEOUT = 300.0  # [s]
BACKGROUND = (250, 250, 248)  # of rviz/*.rviz
LEAST_TIME = 3.0  # [s] from the first grid to what comes over topics


class View:
    """From above. `frame`: what x and y are relative to, the picture's middle; `width` in m."""

    def __init__(self, width, x=0.0, y=0.0, frame="map"):
        self.width, self.x, self.y, self.frame = width, x, y, frame


def configured(text, view, size, shown=None):
    """The configuration with that view; `shown` {display: namespaces or None for all}: no more."""
    config = yaml.safe_load(text)
    manager = config["Visualization Manager"]
    config["Panels"] = [panel for panel in config["Panels"] if panel["Class"] == "rviz/Displays"]
    for display in manager["Displays"]:
        name = display["Name"]
        if shown is not None and not name.startswith("Grid"):
            display["Enabled"] = display["Value"] = name in shown
            for namespace in display.get("Namespaces") or {}:
                wanted = shown.get(name)
                display["Namespaces"][namespace] = wanted is None or namespace in wanted
    manager["Views"]["Current"].update({
        "Target Frame": "<Fixed Frame>" if view.frame == "map" else view.frame,
        "X": view.x, "Y": view.y, "Scale": size[0] / view.width, "Angle": 0})
    manager["Global Options"]["Frame Rate"] = 2  # nothing moves, and no graphics card draws
    config["Window Geometry"].update({
        "Width": size[0], "Height": size[1], "X": 0, "Y": 0, "Hide Left Dock": True,
        "Hide Right Dock": True})
    return yaml.safe_dump(config)


class Screens:
    """Several, for pictures at the same time."""

    def __init__(self, folder, count, width, height):
        self.all = [Screen(folder / f"screen_{i}", width, height) for i in range(count)]
        self.free = queue.Queue()
        for screen in self.all:
            self.free.put(screen)

    def pictures(self, wanted):
        """Of each of `wanted`, which are arguments of Screen.picture."""
        def take(arguments):
            screen = self.free.get()
            try:
                return screen.picture(*arguments)
            finally:
                self.free.put(screen)

        with concurrent.futures.ThreadPoolExecutor(len(self.all)) as pool:
            return list(pool.map(take, wanted))

    def stop(self):
        for screen in self.all:
            screen.stop()


class Screen:
    """Xvfb, whose number it finds itself."""

    def __init__(self, folder, width, height):
        self.folder = folder
        folder.mkdir(exist_ok=True)
        reading, writing = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0",
             f"{SHARPNESS * width}x{SHARPNESS * height}x24", "-nolisten", "tcp"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb does not start")
        self.name = f":{number}"

    def grab(self, size):
        path = self.folder / "screen.png"
        subprocess.run(["import", "-window", "root", "-crop", f"{size[0]}x{size[1]}+0+0", "+repage",
                        str(path)], env=dict(os.environ, DISPLAY=self.name), check=True,
                       stderr=subprocess.DEVNULL)
        with Image.open(path) as image:
            return image.convert("RGB")

    def picture(self, text, view, size, shown=None):
        """What RViz shows once nothing changes any more."""
        large = tuple(SHARPNESS * side for side in size)
        path = self.folder / "view.rviz"
        path.write_text(configured(text, view, large, copy.deepcopy(shown)))
        with open(self.folder / "rviz.log", "w", encoding="utf-8") as log:
            rviz = subprocess.Popen(
                ["rviz", "--fullscreen", "-d", str(path)], stdout=log, stderr=subprocess.STDOUT,
                env=dict(os.environ, DISPLAY=self.name, LIBGL_ALWAYS_SOFTWARE="1"))
            try:
                return self._settled(rviz, large).resize(size, Image.LANCZOS)
            finally:
                rviz.kill()
                rviz.wait()

    def _settled(self, rviz, size):
        end, drawn_at, last = time.monotonic() + TIMEOUT, None, None
        while time.monotonic() < end and rviz.poll() is None:
            time.sleep(0.7)
            now = self.grab(size)
            colors = {color for _, color in now.getcolors(maxcolors=size[0] * size[1])}
            if drawn_at is None and BACKGROUND in colors and len(colors) > 1:
                drawn_at = time.monotonic()
            is_ripe = drawn_at and time.monotonic() - drawn_at > LEAST_TIME
            if is_ripe and last and now.tobytes() == last.tobytes():
                return now
            last = now
        raise RuntimeError(f"RViz shows nothing; its log is {self.folder}/rviz.log")

    def stop(self):
        self.process.terminate()
        self.process.wait()
