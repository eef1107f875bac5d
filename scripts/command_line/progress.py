# SPDX-License-Identifier: BSD-3-Clause
"""How far a long work is and how long it will take."""
import sys
import time


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


class Progress:
    """A bar on a terminal; elsewhere a line every `pause` seconds. Silent for short works."""

    WIDTH = 30

    def __init__(self, program, stream=None, pause=5.0):
        self.program = program
        self.stream = stream or sys.stderr
        self.pause = 0.2 if self.stream.isatty() else pause
        self.begin = time.monotonic()
        self.shown = self.begin
        self.is_shown = False

    def show(self, done, total, unit=""):
        """`done` of `total`; the rest is taken to go on as what has been done."""
        now = time.monotonic()
        if now - self.shown < self.pause or done <= 0 or total <= 0:
            return
        self.shown = now
        self.is_shown = True
        left = (now - self.begin) * max(0.0, total - done) / done
        text = f"{done:.0f} of {total:.0f}{unit}, {clock(left)} left"
        if not self.stream.isatty():
            print(f"{self.program}: {text}", file=self.stream, flush=True)
            return
        filled = int(self.WIDTH * min(1.0, done / total))
        print(f"\r[{'#' * filled}{'.' * (self.WIDTH - filled)}] {text}   ", end="",
              file=self.stream, flush=True)

    def end(self):
        if self.is_shown and self.stream.isatty():
            print(file=self.stream, flush=True)
