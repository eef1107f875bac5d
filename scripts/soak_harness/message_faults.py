# SPDX-License-Identifier: BSD-3-Clause
"""Faults of what the nodes receive; each is a function of the rig."""
import math
import random
import struct
import threading

from geometry_msgs.msg import Vector3
from nav_msgs.msg import OccupancyGrid, Odometry
from pomdp_crowd_nav.msg import TrackedPerson, TrackedPersons

from .relay import serialized, with_stamp_moved

FLOOD = 10000            # tracks
JUMP = 5.0               # [m]
MAPS, MAP_PERIOD = 20, 0.1  # [s]
CLOCK_JUMP = -10.0       # [s]


def silence(channel):
    def begin(rig):
        getattr(rig.relay, channel).change = lambda data: None
    return begin


def age(channel, seconds):
    def begin(rig):
        getattr(rig.relay, channel).change = lambda data: with_stamp_moved(data, seconds)
    return begin


def edited(message_class, edit):
    """A change of the bytes of a message that `edit` makes in the message."""
    def change(data):
        message = message_class().deserialize(data)
        edit(message)
        return serialized(message)
    return change


def odometry_not_finite(rig):
    values = [math.nan, math.inf, -math.inf]

    def edit(odometry):
        odometry.pose.pose.position.x = rig.random.choice(values)
    rig.relay.odom.change = edited(Odometry, edit)


def odometry_garbage(rig):
    rig.relay.odom.change = lambda data: data[:rig.random.randrange(len(data))]


def odometry_jump(rig):
    def edit(odometry):
        odometry.pose.pose.position.x += JUMP
    rig.relay.odom.change = edited(Odometry, edit)


def header_length(data):
    return 16 + struct.unpack_from("<I", data, 12)[0]


def flood_of_tracks(rig):
    dice = random.Random(rig.random.random())
    tracks = []
    for number in range(FLOOD):
        person = TrackedPerson(track_id=10 ** 6 + number, is_matched=True)
        person.pose.pose.position.x = dice.uniform(0.0, 100.0)
        person.pose.pose.position.y = dice.uniform(0.0, 100.0)
        person.pose.pose.orientation.w = 1.0
        tracks.append(serialized(person))
    flood = b"".join(tracks)

    def change(data):
        begin = header_length(data)
        count = struct.unpack_from("<I", data, begin)[0]
        return data[:begin] + struct.pack("<I", count + FLOOD) + data[begin + 4:] + flood
    rig.relay.people.change = change


def id_switches(rig):
    def edit(persons):
        ids = [person.track_id for person in persons.tracks]
        rig.random.shuffle(ids)
        for person, number in zip(persons.tracks, ids):
            person.track_id = number
    rig.relay.people.change = edited(TrackedPersons, edit)


def same_ids(rig):
    def edit(persons):
        for person in persons.tracks:
            person.track_id = 1
    rig.relay.people.change = edited(TrackedPersons, edit)


def velocities_not_finite(rig):
    def edit(persons):
        for person in persons.tracks:
            person.twist.twist.linear = Vector3(math.nan, math.inf, 0.0)
    rig.relay.people.change = edited(TrackedPersons, edit)


def with_one_more_obstacle(data):
    """The map with another cell in a corner, so that it cannot pass for the same."""
    grid = OccupancyGrid().deserialize(data)
    cells = bytearray((cell + 256) % 256 for cell in grid.data)
    cells[-1] = 100 if cells[-1] == 0 else 0
    grid.data = [cell if cell < 128 else cell - 256 for cell in cells]
    return serialized(grid)


def map_again(rig):
    original = rig.relay.map.last
    if original is None:
        return
    maps = [with_one_more_obstacle(original), original]

    def send():
        for number in range(MAPS):
            rig.relay.map.send(maps[number % 2])
            if rig.is_over.wait(MAP_PERIOD):
                return
    threading.Thread(target=send, daemon=True).start()


def map_as_it_was(rig):
    if rig.relay.map.last is not None:
        rig.relay.map.send(rig.relay.map.last)


def clock_back(rig):
    rig.relay.move_time(CLOCK_JUMP)
