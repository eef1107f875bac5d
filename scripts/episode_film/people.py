# SPDX-License-Identifier: BSD-3-Clause
"""People as the robot sees them, with what it believes of them."""
import math

from .scene import ELSEWHERE, STANDING, Person

ID_MASK = 2 ** 63 - 1


def id_of_name(name):
    """The id that the planner gives to a person of people_msgs (idOfName in conversions.cpp)."""
    if name.isascii() and name.isdigit():
        return int(name)
    number = 0xcbf29ce484222325
    for byte in name.encode():
        number = (number ^ byte) * 0x100000001b3 % 2 ** 64
    return number & ID_MASK | 2 ** 62


class Belief:
    """What is believed of one person."""

    def __init__(self, person, destinations):
        self.position = (person.position.x, person.position.y)
        odds = list(person.probabilities)
        choices = [*enumerate(odds), (STANDING, person.probability_standing),
                   (ELSEWHERE, person.probability_elsewhere)]
        self.destination, best = max(choices, key=lambda choice: choice[1], default=(None, 0.0))
        count = max(2, len(odds))
        self.certainty = min(1.0, max(0.0, (best - 1.0 / count) / (1.0 - 1.0 / count)))
        self.fan = [(place, probability, index)
                    for index, (place, probability) in enumerate(zip(destinations, odds))
                    if probability > 0.05]

    def person_at(self, place):
        fan = tuple((math.atan2(y - place[1], x - place[0]), probability, index)
                    for (x, y), probability, index in self.fan)
        return Person(place, self.destination, self.certainty, fan)


class People:
    def __init__(self, frames):
        self.frames = frames
        self.beliefs, self.heard = {}, None

    def _hear(self, message):
        if message is self.heard:
            return
        self.heard = message
        destinations = [(place.x, place.y) for place in message.destinations]
        self.beliefs = {person.id: Belief(person, destinations) for person in message.people}

    def _places(self, tracks, people):
        """{id: position} of the newest message, in the global frame where tf leads there."""
        if tracks is not None:
            header = tracks.header
            found = {track.track_id: track.pose.pose.position for track in tracks.tracks}
        elif people is not None:
            header = people.header
            found = {id_of_name(person.name): person.position for person in people.people}
        else:
            return {name: belief.position for name, belief in self.beliefs.items()}
        if header.frame_id.lstrip("/") == self.frames.root:
            return {name: (place.x, place.y) for name, place in found.items()}
        moved = {name: self.frames.pose(header.frame_id, (place.x, place.y, 0.0))
                 for name, place in found.items()}
        return {name: place[:2] for name, place in moved.items() if place}

    def seen(self, tracks, people, beliefs):
        """{id: Person}"""
        if beliefs is not None:
            self._hear(beliefs)
        persons = {}
        for name, place in self._places(tracks, people).items():
            belief = self.beliefs.get(name)
            persons[name] = belief.person_at(place) if belief else Person(place)
        return persons
