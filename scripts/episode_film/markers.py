# SPDX-License-Identifier: BSD-3-Clause
"""Markers of RViz as lines in the plane."""
import numpy

from .frames import moved, yaw_of
from .scene import Lines

ADD, LINE_STRIP, LINE_LIST, SPHERE_LIST, POINTS, TRIANGLE_LIST = 0, 4, 5, 7, 8, 11
CLOSED = 24  # segments of a circle


def points_of(marker):
    """n x 2, in the frame of the marker's header."""
    points = numpy.array([(point.x, point.y) for point in marker.points]).reshape(-1, 2)
    pose = (marker.pose.position.x, marker.pose.position.y, yaw_of(marker.pose.orientation))
    if pose == (0.0, 0.0, 0.0):
        return points
    return numpy.array([moved(pose, (x, y, 0.0))[:2] for x, y in points]).reshape(-1, 2)


def colours_of(marker, count):
    colours = marker.colors if len(marker.colors) == count else [marker.color] * count
    return numpy.array([(c.r, c.g, c.b, c.a) for c in colours]).reshape(-1, 4)


def lists_of(message, *spaces):
    """The markers that are shown, of the given namespaces where any is given."""
    return [marker for marker in message.markers
            if marker.action == ADD and (not spaces or marker.ns in spaces)]


def lines_of(message, *spaces):
    """All that is made of lines or triangles."""
    found = []
    for marker in lists_of(message, *spaces):
        points = points_of(marker)
        colours = colours_of(marker, len(points))
        if marker.type == LINE_STRIP and len(points) > 1:
            shapes, colours = numpy.stack([points[:-1], points[1:]], axis=1), colours[1:]
        elif marker.type == LINE_LIST and len(points) > 1:
            even = len(points) // 2 * 2
            shapes, colours = points[:even].reshape(-1, 2, 2), colours[:even:2]
        elif marker.type == TRIANGLE_LIST and len(points) > 2:
            whole = len(points) // 3 * 3
            shapes, colours = points[:whole].reshape(-1, 3, 2), colours[:whole:3]
        else:
            continue
        found.append(Lines(shapes, numpy.clip(colours, 0.0, 1.0), marker.scale.x,
                           marker.type == TRIANGLE_LIST))
    return found


def spots_of(message, *spaces):
    """Places of a list of spheres or points."""
    for marker in lists_of(message, *spaces):
        if marker.type in (SPHERE_LIST, POINTS):
            return points_of(marker)
    return numpy.zeros((0, 2))


def radius_of(message, *spaces):
    """Half the width of what is drawn there, 0 where nothing is."""
    for marker in lists_of(message, *spaces):
        points = points_of(marker)
        if len(points):
            return 0.5 * float(numpy.ptp(points[:, 0]))
    return 0.0
