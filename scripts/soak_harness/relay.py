# SPDX-License-Identifier: BSD-3-Clause
"""Stands between the simulator and all who listen to it; faults change what it passes on.

A process has one subscription of a topic: who wants to know what comes in asks the channel.
"""
import io
import struct

import rospy
from nav_msgs.msg import OccupancyGrid, Odometry
from pomdp_crowd_nav.msg import TrackedPersons
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from .stack import relayed


def raw(message_class):
    """Messages of a type as bytes, passed on without being read."""
    class Raw(message_class):
        _has_header = False
        __slots__ = ["bytes"]
        _slot_types = ["string"]

        def __init__(self, data=b""):  # pylint: disable=super-init-not-called
            self.bytes = data

        def deserialize(self, data):
            self.bytes = bytes(data)
            return self

        def serialize(self, buffer):
            buffer.write(self.bytes)

        def parsed(self):
            return message_class().deserialize(self.bytes)
    return Raw


def with_stamp_moved(data, seconds):
    """A message that begins with a header, `seconds` older or younger."""
    secs, nsecs = struct.unpack_from("<II", data, 4)
    total = max(0, secs * 10 ** 9 + nsecs + int(seconds * 1e9))
    return data[:4] + struct.pack("<II", total // 10 ** 9, total % 10 ** 9) + data[12:]


def serialized(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


class Channel:
    """One topic. `change` takes the bytes of a message and returns those to pass on, or None."""

    def __init__(self, topic, message_class, latch=False):
        self.change = None
        self.last = None      # the newest message as it came in
        self.listener = None  # is shown each as it came in
        self.type = raw(message_class)
        self.publisher = rospy.Publisher(relayed(topic), self.type, queue_size=10, latch=latch,
                                         tcp_nodelay=True)
        self.subscriber = rospy.Subscriber(topic, self.type, self._on_message, queue_size=10,
                                           buff_size=2 ** 24, tcp_nodelay=True)

    def _on_message(self, message):
        is_raw = isinstance(message, self.type)  # rospy itself has read the clock already
        self.last = message.bytes if is_raw else serialized(message)
        change = self.change
        data = change(self.last) if change else self.last
        if data is not None:
            self.send(data)
        if self.listener:
            self.listener(message.parsed())

    def send(self, data):
        self.publisher.publish(self.type(data))


class Relay:
    def __init__(self, use_sim_time):
        self.odom = Channel("odom", Odometry)
        self.people = Channel("tracked_persons", TrackedPersons)
        self.map = Channel("map", OccupancyGrid, latch=True)
        self.transforms = Channel("/tf", TFMessage)
        self.clock = Channel("/clock", Clock) if use_sim_time else None

    def channels(self):
        channels = [self.odom, self.people, self.map, self.transforms, self.clock]
        return [channel for channel in channels if channel]

    def repair(self):
        for channel in self.channels():
            channel.change = None

    def move_time(self, seconds):
        """From now on everything comes as from another time, until it is repaired."""
        def moved_transforms(data):
            message = TFMessage().deserialize(data)
            for transform in message.transforms:
                transform.header.stamp = max(
                    rospy.Time(0), transform.header.stamp + rospy.Duration(seconds))
            return serialized(message)

        def moved_clock(data):
            secs, nsecs = struct.unpack("<II", data)
            return struct.pack("<II", max(0, secs + int(seconds)), nsecs)

        for channel in (self.odom, self.people):
            channel.change = lambda data: with_stamp_moved(data, seconds)
        self.transforms.change = moved_transforms
        if self.clock:
            self.clock.change = moved_clock
