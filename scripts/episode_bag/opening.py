# SPDX-License-Identifier: BSD-3-Clause
"""Opens a bag, or says in one line what to do with it."""
import contextlib
import pathlib
import struct

import rosbag

from command_line.refusal import Refusal


def require_file(path):
    if not path.exists():
        active = path.with_name(path.name + ".active")
        if active.exists():
            raise Refusal(f"{path}: its recording is not finished: end it, or, if it was cut off, "
                          f"rosbag reindex '{active}' and use that")
        raise Refusal(f"{path}: there is no such file")
    if not path.is_file():
        raise Refusal(f"{path}: expected a bag, it is a folder or a device")
    if path.stat().st_size == 0:
        raise Refusal(f"{path}: the file is empty: record the episode anew")


@contextlib.contextmanager
def open_bag(name):
    """A bag with messages and an index, for reading."""
    path = pathlib.Path(name)
    require_file(path)
    try:
        bag = rosbag.Bag(str(path))
    except rosbag.ROSBagUnindexedException:
        raise Refusal(f"{path}: the bag has no index, its recording was cut off or still runs: "
                      f"rosbag reindex '{path}'") from None
    except (rosbag.ROSBagException, struct.error, ValueError, KeyError, EOFError) as error:
        raise Refusal(f"{path}: expected a bag of rosbag record: {error}") from None
    except OSError as error:
        raise Refusal(f"{path}: the file cannot be read: {error.strerror}") from None
    with bag:
        if bag.get_message_count() == 0:
            raise Refusal(f"{path}: there is no message in the bag: record the episode anew")
        yield bag


def types_of(bag):
    """{topic: type}"""
    return {topic: info.msg_type for topic, info in
            bag.get_type_and_topic_info().topics.items()}
