# SPDX-License-Identifier: BSD-3-Clause
"""Draws scenes in one view with matplotlib."""
import numpy
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection

from experiment_figures import style
from experiment_figures.world import draw_world, mark_ends

from .palette import GREY, PLAN, RING, ROBOT, ROBOT_FILL, WAY, person_colour
from .scene import Lines

PERSON = 0.3        # [m], radius of a symbol that is large enough
LEAST_PIXELS = 2.2  # radius of a symbol
# Before matplotlib 3.5 the argument had another name.
OFFSETS = "offset_transform" if hasattr(EllipseCollection, "set_offset_transform") else "transOffset"


class Panel:
    """One view of the scene: all of the field, or the surroundings of the robot."""

    def __init__(self, axes, place, pixels_per_metre, is_close):
        self.axes, self.place, self.scale, self.is_close = axes, place, pixels_per_metre, is_close
        self.moving = []
        axes.set_aspect("equal")
        axes.set_xticks([])
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_visible(True)
            spine.set_color("#9a9a9a")
        self._draw_place()

    def _draw_place(self):
        for lines in self.place.outlines:
            self._lines(lines, 1.0, keep=True)
        if self.place.grid:
            picture, extent = self.place.grid
            self.axes.imshow(picture, cmap="gray", vmin=0, vmax=255, origin="lower", extent=extent,
                             zorder=0.5, interpolation="nearest")
        if self.place.world:
            draw_world(self.axes, self.place.world)
            mark_ends(self.axes, *self.place.marks)

    def points(self, metres, least=0.6):
        """A width in points."""
        return max(least, metres * self.scale * 72.0 / self.axes.figure.dpi)

    def radius(self, metres):
        return max(metres, LEAST_PIXELS / self.scale)

    def _keep(self, artist):
        self.moving.append(artist)
        return artist

    def _lines(self, lines, order, keep=False, factor=1.0):
        if lines.is_filled:
            made = PolyCollection(lines.shapes, facecolors=lines.colours, linewidths=0,
                                  zorder=order)
        else:
            made = LineCollection(lines.shapes, colors=lines.colours, zorder=order + 0.1,
                                  linewidths=self.points(lines.width * factor, 0.5))
        self.axes.add_collection(made)
        if not keep:
            self._keep(made)

    def _discs(self, places, metres, order, **look):
        if not len(places):
            return
        size = 2.0 * self.radius(metres)
        self._keep(self.axes.add_collection(EllipseCollection(
            size, size, 0.0, units="xy", offsets=numpy.asarray(places), zorder=order,
            **{OFFSETS: self.axes.transData}, **look)))

    def _path(self, places, metres, order, **look):
        if len(places) > 1:
            self._keep(self.axes.plot(*numpy.transpose(places), linewidth=self.points(metres, 1.0),
                                      zorder=order, solid_capstyle="round", **look)[0])

    def draw(self, scene, history):
        for artist in self.moving:
            artist.remove()
        self.moving = []
        self._path(scene.way, 0.2, 2.0, color=WAY)
        self._discs(scene.others, PERSON, 2.1, facecolors=GREY, linewidths=0)
        for trail in history.trails:
            alpha = 0.75 if len(history.trails) == 1 else 0.4
            self._path(trail, 0.35, 2.3, color=ROBOT, alpha=alpha)
        for lines in scene.tree if self.is_close else []:
            self._lines(lines, 2.5, factor=0.8)
        self._people(scene, history)
        for lines in scene.rings:
            colours = numpy.tile(RING, (len(lines.shapes), 1))
            self._lines(Lines(lines.shapes, colours, lines.width), 4.0)
        self._path(scene.plan, 0.3, 4.2, color=PLAN)
        self._robots(scene)
        if scene.goal and not self.place.marks:
            self._keep(self.axes.plot(*scene.goal, "*", color=style.COLOURS[1], zorder=6,
                                      markeredgecolor=style.INK, markersize=11)[0])

    def _people(self, scene, history):
        shapes, colours = history.tails(scene)
        if len(shapes):
            self._lines(Lines(shapes, colours, 0.35 if self.is_close else 0.5), 3.0)
        people = list(scene.people.values())
        self._discs([person.position for person in people], PERSON, 3.5,
                    facecolors=[person_colour(person) for person in people],
                    edgecolors="white" if self.is_close else "none", linewidths=0.5)
        if self.is_close:
            self._fans(people)

    def _fans(self, people):
        """From each person toward each destination, as long as that is likely."""
        shapes, colours = [], []
        for person in people:
            for direction, probability, index in person.fan:
                way = numpy.array([numpy.cos(direction), numpy.sin(direction)])
                start = numpy.array(person.position)
                shapes.append((start, start + (PERSON + 2.0 * probability) * way))
                colours.append(person_colour(person, index))
        if shapes:
            self._lines(Lines(numpy.array(shapes), numpy.array(colours), 0.12), 3.3)

    def _robots(self, scene):
        size = self.radius(self.place.robot_radius)
        places = [robot[:2] for robot in scene.robots]
        self._discs(places, self.place.robot_radius, 5.0, facecolors=[(*ROBOT_FILL, 0.9)],
                    edgecolors=[ROBOT], linewidths=1.2)
        for x, y, heading in scene.robots:
            if heading is not None:
                nose = (x + size * numpy.cos(heading), y + size * numpy.sin(heading))
                self._path([(x, y), nose], 0.15, 5.1, color=ROBOT)
