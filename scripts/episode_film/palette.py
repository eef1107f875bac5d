# SPDX-License-Identifier: BSD-3-Clause
"""Colours as in RViz (src/ros/markers.cpp)."""
from .scene import ELSEWHERE, STANDING

DESTINATIONS = ((0.00, 0.45, 0.70), (0.90, 0.60, 0.00), (0.55, 0.25, 0.60), (0.20, 0.70, 0.85),
                (0.80, 0.35, 0.55), (0.45, 0.35, 0.15), (0.35, 0.40, 0.45), (0.10, 0.20, 0.50))
GREY = (0.78, 0.79, 0.81)
UNKNOWN = (0.35, 0.37, 0.40)
ROBOT = (0.10, 0.20, 0.80)
ROBOT_FILL = (0.75, 0.83, 1.0)
PLAN = (0.86, 0.12, 0.47)
RING = (0.85, 0.10, 0.10, 1.0)
WAY = (0.80, 0.74, 0.90)
# What must not be mistaken for each other, in a film of few colours either.
MEANINGFUL = (PLAN, RING[:3], ROBOT, WAY, *DESTINATIONS)


def person_colour(person, index=None):
    """That of the most likely destination, or of the given one; the paler, the less sure."""
    if index is not None:
        return (*DESTINATIONS[index % len(DESTINATIONS)], 0.9)
    alpha = 0.3 + 0.7 * person.certainty
    if person.destination is None:
        return (*UNKNOWN, 0.9)
    if person.destination == STANDING:
        return (0.0, 0.0, 0.0, alpha)
    if person.destination == ELSEWHERE:
        return (0.45, 0.45, 0.45, alpha)
    return (*DESTINATIONS[person.destination % len(DESTINATIONS)], alpha)
