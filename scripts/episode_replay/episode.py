# SPDX-License-Identifier: BSD-3-Clause
"""What a replay needs to know of a bag."""
from command_line.refusal import Refusal
from episode_bag import names, opening

from .topics import Selection

LARGE_FIELD = 30.0  # [m], a larger map is looked at from further away


class Episode:
    def __init__(self, path, namespace, start):
        self.path, self.start = path, start
        with opening.open_bag(path) as bag:
            self.types = opening.types_of(bag)
            self.selection = Selection(self.types, namespace, path)
            self.begin, self.end = bag.get_start_time(), bag.get_end_time()
            if start >= self.duration:
                raise Refusal(f"--start: the bag is {self.duration:.1f} s long, got {start:g}")
            self.frame, self.is_street = "map", False
            self._look(bag)

    @property
    def duration(self):
        return self.end - self.begin

    def _first(self, bag, kinds):
        topics = [topic for topic in self.selection.played if self.types[topic] in kinds]
        topics.sort(key=names.is_of_a_node)  # there are other grids than the map
        if not topics:
            return None
        return next((message for _, message, _ in bag.read_messages(topics)), None)

    def _look(self, bag):
        """The global frame and the size of the place."""
        grid = self._first(bag, {"nav_msgs/OccupancyGrid"})
        message = grid or self._first(bag, {"pomdp_crowd_nav/CrowdBelief", "nav_msgs/Path"})
        if message is not None and message.header.frame_id:
            self.frame = message.header.frame_id
        if grid is not None:
            longest = max(grid.info.width, grid.info.height) * grid.info.resolution
            self.is_street = longest < LARGE_FIELD
