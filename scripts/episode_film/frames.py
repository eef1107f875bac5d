# SPDX-License-Identifier: BSD-3-Clause
"""Where frames are in the plane, as tf has said last."""
import math


def yaw_of(rotation):
    return math.atan2(2.0 * (rotation.w * rotation.z + rotation.x * rotation.y),
                      1.0 - 2.0 * (rotation.y ** 2 + rotation.z ** 2))


def moved(pose, offset):
    """`offset`, given in the frame that is at `pose`, in that frame's parent."""
    x, y, yaw = pose
    cos, sin = math.cos(yaw), math.sin(yaw)
    return (x + cos * offset[0] - sin * offset[1], y + sin * offset[0] + cos * offset[1],
            math.remainder(yaw + offset[2], 2.0 * math.pi))


class Frames:
    MOST_PARENTS = 50

    def __init__(self, root):
        self.root = root
        self.parents = {}  # child: (parent, pose in it)

    def hear(self, message):
        for transform in message.transforms:
            moving = transform.transform
            self.parents[transform.child_frame_id.lstrip("/")] = (
                transform.header.frame_id.lstrip("/"),
                (moving.translation.x, moving.translation.y, yaw_of(moving.rotation)))

    def pose(self, frame, offset=(0.0, 0.0, 0.0)):
        """A pose given in `frame`, in the global frame; None where no transform leads there."""
        frame = frame.lstrip("/")
        for _ in range(self.MOST_PARENTS):
            if frame == self.root:
                return offset
            if frame not in self.parents:
                return None
            frame, own = self.parents[frame]
            offset = moved(own, offset)
        return None
