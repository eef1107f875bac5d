# SPDX-License-Identifier: BSD-3-Clause
"""Who has caused it that somebody came too near to the moving robot."""
import math

MOVING = 0.05  # [m/s] as the simulator counts it
ARRIVAL = 1.5  # [s] in which a robot that was put beside somebody cannot help it


def blame(position, velocity, people, since_put):
    """A dict with the `cause` and what it follows from; people are (x, y, vx, vy).

    The robot has caused it when it drove towards the nearest person at more than `MOVING`; where
    the robot only failed to get out of the way, that "person" has. Nobody has when the robot was
    "put there" less than `ARRIVAL` ago: positions may then still be those of two places.
    """
    if since_put < ARRIVAL:
        return {"cause": "put there"}
    if not people:
        return {"cause": "unknown"}
    x, y = position
    person = min(people, key=lambda p: math.hypot(p[0] - x, p[1] - y))
    distance = math.hypot(person[0] - x, person[1] - y)
    towards = ((person[0] - x) / max(distance, 1e-9), (person[1] - y) / max(distance, 1e-9))
    ours = velocity[0] * towards[0] + velocity[1] * towards[1]
    theirs = -(person[2] * towards[0] + person[3] * towards[1])
    return {"cause": "robot" if ours > MOVING else "person", "distance": round(distance, 3),
            "robot_towards": round(ours, 3), "person_towards": round(theirs, 3)}


def is_violation(cause):
    return cause not in ("person", "put there")
