# SPDX-License-Identifier: BSD-3-Clause
"""Keeps a replay away from a system that is alive."""
import http.client
import os

import rosgraph

from command_line.refusal import Refusal

from .topics import is_command

OWN = ("/replay_player", "/replay_rviz")
ELSEWHERE = ("replay on a master of its own: ROS_MASTER_URI=http://localhost:11399 roslaunch "
             "-p 11399 pomdp_crowd_nav replay.launch bag:=...")


class Master:
    """What is asked of the master and told to it."""

    @staticmethod
    def _ask(question, *arguments):
        """On a connection of its own: Ctrl-C may have cut the last one short."""
        try:
            return getattr(rosgraph.Master("/replay_episode"), question)(*arguments)
        except (OSError, http.client.HTTPException, rosgraph.MasterException) as error:
            uri = os.environ.get("ROS_MASTER_URI", "nowhere, ROS_MASTER_URI is not set")
            raise Refusal(f"no answer from a master at '{uri}' ({error}); roslaunch pomdp_crowd_nav "
                          "replay.launch bag:=... starts one") from None

    def publishers(self):
        """{topic: nodes}, those of this replay excepted"""
        topics = {topic: [node for node in nodes if node not in OWN]
                  for topic, nodes in self._ask("getSystemState")[0]}
        return {topic: nodes for topic, nodes in topics.items() if nodes}

    def subscribers(self, node):
        return {topic for topic, nodes in self._ask("getSystemState")[1] if node in nodes}

    def commanded(self):
        """Topics by which somebody may command a base."""
        return {topic for topic, kind in self._ask("getTopicTypes") if is_command(kind)}

    def conflict(self, topics):
        """Why playing these topics would get in the way, None when it would not."""
        publishers = self.publishers()
        for topic in sorted({*topics, "/clock"} & publishers.keys()):
            return f"{publishers[topic][0]} publishes {topic} here, a live system: {ELSEWHERE}"
        for topic in sorted(self.commanded() & publishers.keys()):
            return (f"{publishers[topic][0]} may send commands on {topic} here, a live system: "
                    f"{ELSEWHERE}")
        return None

    def get(self, name):
        """A parameter, None where it is not set."""
        return self._ask("getParam", name) if self._ask("hasParam", name) else None

    def set(self, name, value):
        self._ask("setParam", name, value)

    def restore(self, name, value):
        """None: it was not set."""
        if value is not None:
            self.set(name, value)
        elif self._ask("hasParam", name):
            self._ask("deleteParam", name)
