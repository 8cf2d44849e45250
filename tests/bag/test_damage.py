"""Damaged bags: whatever is wrong with a file, it is read as far as it goes or refused in one sentence."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
import rosbag2_py
from std_msgs.msg import String

from rclpy.serialization import serialize_message

STORAGES = {"mcap": "bag_0.mcap", "sqlite3": "bag_0.db3"}


def whole(folder: Path, storage: str) -> bytes:
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder / "bag"), storage_id=storage))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/chatter", "std_msgs/msg/String", "cdr", [rosbag2_py.QoS(10)]))
    for number in range(60):
        writer.write("/chatter", serialize_message(String(data=f"hi {number}")), 1_000_000 + number)
        if number % 20 == 0:
            writer.flush()
    writer.close()
    return (folder / "bag" / STORAGES[storage]).read_bytes()


def read(path: Path) -> int:
    """How many messages come out; a refusal counts as none, any other exception fails the test."""
    reader = rosbag2_py.SequentialReader()
    count = 0
    try:
        reader.open_uri(str(path))
        reader.get_all_message_definitions()
        while reader.has_next():
            reader.read_next()
            count += 1
    except RuntimeError as error:
        assert str(error)
    finally:
        reader.close()
    return count


@pytest.mark.parametrize("storage", STORAGES)
def test_a_file_that_ends_anywhere(tmp_path, storage):
    data = whole(tmp_path, storage)
    path = tmp_path / STORAGES[storage]
    counts = []
    for end in range(0, len(data), max(1, len(data) // 150)):
        path.write_bytes(data[:end])
        counts.append(read(path))
    if storage == "mcap":
        assert counts == sorted(counts) and counts[-1] == 60


@pytest.mark.long
@pytest.mark.parametrize("storage", STORAGES)
def test_bytes_that_are_wrong_anywhere(tmp_path, storage):
    data = whole(tmp_path, storage)
    path = tmp_path / STORAGES[storage]
    dice = random.Random(7)
    for _ in range(200):
        broken = bytearray(data)
        for _ in range(dice.randint(1, 4)):
            broken[dice.randrange(len(broken))] = dice.randrange(256)
        path.write_bytes(broken)
        assert read(path) <= 200
