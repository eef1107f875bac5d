# SPDX-License-Identifier: BSD-3-Clause
"""What is seen at one moment, wherever it comes from. Metres and radians in the global frame."""
import dataclasses

import numpy

NOWHERE = numpy.zeros((0, 2))


@dataclasses.dataclass
class Lines:
    """Line segments, each with a colour, of one width [m]; `is_filled`: triangles instead."""
    shapes: numpy.ndarray   # n x 2 (or 3) x 2
    colours: numpy.ndarray  # n x 4
    width: float = 0.0
    is_filled: bool = False


@dataclasses.dataclass
class Person:
    position: tuple
    destination: int = None  # the most likely one, STANDING or ELSEWHERE; None: not known
    certainty: float = 1.0   # 0: all are as likely
    fan: tuple = ()          # (direction to a destination, its probability, its index)


STANDING, ELSEWHERE = -1, -2


@dataclasses.dataclass
class Scene:
    time: float                       # [s] since the beginning
    robots: list                      # (x, y, heading or None)
    people: dict = dataclasses.field(default_factory=dict)   # id: Person
    others: numpy.ndarray = ()   # people where they really are
    tree: list = dataclasses.field(default_factory=list)     # Lines
    rings: list = dataclasses.field(default_factory=list)    # Lines
    plan: numpy.ndarray = ()
    way: numpy.ndarray = ()      # the way without people
    goal: tuple = None
    state: str = ""
    detail: str = ""


@dataclasses.dataclass
class Place:
    """What does not change."""
    bounds: tuple                     # left, bottom, right, top
    robot_radius: float = 0.5
    outlines: list = dataclasses.field(default_factory=list)  # Lines
    grid: tuple = None                # picture, extent
    world: dict = None                # of a world file
    marks: tuple = None               # start and goal, of a world file
