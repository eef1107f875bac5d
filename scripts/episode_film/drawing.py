# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of a film."""
import numpy
from matplotlib.patches import Rectangle

from experiment_figures import style
from experiment_figures.style import plt

from .panel import Panel

ZOOM_FROM = 1.6     # a close-up shows less than the field by this factor, or there is none


class Film:
    """The picture of one scene after the other, as arrays of RGB."""

    DPI = 100
    HEAD = 46    # [pixels]
    GAP = 8

    def __init__(self, place, width, zoom):
        self.place, self.zoom = place, zoom
        left, bottom, right, top = place.bounds
        span = (right - left, top - bottom)
        self.has_close_up = zoom > 0.0 and max(span) > ZOOM_FROM * zoom
        field_width = (width - 3 * self.GAP) // 2 if self.has_close_up else width - 2 * self.GAP
        height = max(1, round(field_width * min(2.0, span[1] / span[0])))
        # Encoders want even numbers.
        self.size = (width // 2 * 2, (height + self.HEAD + self.GAP) // 2 * 2)
        self.figure = plt.figure(figsize=(self.size[0] / self.DPI, self.size[1] / self.DPI),
                                 dpi=self.DPI, facecolor="white")
        self.field = self._panel(self.GAP, field_width, height, False)
        self._show(self.field, place.bounds, field_width / height)
        self.close = self.frame = None
        if self.has_close_up:
            self.close = self._panel(2 * self.GAP + field_width, field_width, height, True)
            self.frame = self.field.axes.add_patch(
                Rectangle((0, 0), 1, 1, fill=False, edgecolor=style.INK, linewidth=0.8, zorder=7))
        else:
            self.field.is_close = True
        self.head = self.figure.text(self.GAP / self.size[0], 1.0 - 4 / self.size[1], "", va="top",
                                     fontsize=11, fontweight="bold", color=style.INK)
        self.detail = self.figure.text(self.GAP / self.size[0], 1.0 - 25 / self.size[1], "",
                                       va="top", fontsize=9, color=style.INK)

    def _panel(self, x, width, height, is_close):
        left, bottom, right, top = self.place.bounds
        axes = self.figure.add_axes((x / self.size[0], self.GAP / 2 / self.size[1],
                                     width / self.size[0], height / self.size[1]))
        shown = self.zoom if is_close else max(right - left, (top - bottom) * width / height)
        return Panel(axes, self.place, width / shown, is_close)

    @staticmethod
    def _show(panel, bounds, aspect):
        """The bounds in the middle of the panel, with a little margin."""
        left, bottom, right, top = bounds
        width = max(right - left, (top - bottom) * aspect) * 1.02
        x, y = 0.5 * (left + right), 0.5 * (bottom + top)
        panel.axes.set_xlim(x - 0.5 * width, x + 0.5 * width)
        panel.axes.set_ylim(y - 0.5 * width / aspect, y + 0.5 * width / aspect)

    def _follow(self, robot):
        """The close-up keeps the robot in its middle."""
        box = self.close.axes.get_position()
        aspect = box.width * self.size[0] / (box.height * self.size[1])
        half = 0.5 * self.zoom
        tall = half / aspect
        self.close.axes.set_xlim(robot[0] - half, robot[0] + half)
        self.close.axes.set_ylim(robot[1] - tall, robot[1] + tall)
        self.frame.set_bounds(robot[0] - half, robot[1] - tall, 2 * half, 2 * tall)

    def draw(self, scene, history, speed):
        if self.close:
            self._follow(scene.robots[0])
            self.close.draw(scene, history)
        self.field.draw(scene, history)
        self.head.set_text(f"{scene.time:5.1f} s   {scene.state}")
        self.detail.set_text(f"{speed:g} times real time, {scene.detail}"[:110])
        self.figure.canvas.draw()
        return numpy.asarray(self.figure.canvas.buffer_rgba())[:, :, :3].copy()

    def close_figure(self):
        plt.close(self.figure)
