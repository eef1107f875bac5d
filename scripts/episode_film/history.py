# SPDX-License-Identifier: BSD-3-Clause
"""Where everybody has been until now."""
import collections

import numpy

from .palette import person_colour

TAIL = 3.0   # [s] of a person's way that is still seen
JUMP = 3.0   # [m] between two pictures: somebody else has got that id, the robot was put there


class History:
    def __init__(self):
        self.trails = []
        self.walks = {}  # id: deque of (time, position)

    def add(self, scene):
        for k, robot in enumerate(scene.robots):
            if k == len(self.trails):
                self.trails.append([])
            self.trails[k].append(robot[:2])
        for name, person in scene.people.items():
            walk = self.walks.setdefault(name, collections.deque())
            walk.append((scene.time, person.position))
        for name, walk in list(self.walks.items()):
            while walk and walk[0][0] < scene.time - TAIL:
                walk.popleft()
            if not walk:
                del self.walks[name]

    def tails(self, scene):
        """Segments and their colours, fading with age."""
        shapes, colours = [], []
        for name, person in scene.people.items():
            walk = list(self.walks.get(name, ()))
            red, green, blue, alpha = person_colour(person)
            for (time, start), (_, end) in zip(walk, walk[1:]):
                if max(abs(start[0] - end[0]), abs(start[1] - end[1])) > JUMP:
                    continue
                fade = 1.0 - (scene.time - time) / TAIL
                shapes.append((start, end))
                colours.append((red, green, blue, 0.6 * alpha * max(0.0, fade)))
        return numpy.array(shapes).reshape(-1, 2, 2), numpy.array(colours).reshape(-1, 4)
