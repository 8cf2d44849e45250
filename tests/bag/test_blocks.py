"""The index by blocks: it counts and finds every message that the reader of whole bags finds, whatever the storage."""

from __future__ import annotations

import random
from collections import Counter
from pathlib import Path

import pytest
import rosbag2_py
from rosbag2_py._blocks import open_blocks
from rosbag2_py._mcap_blocks import McapBlocks
from rosbag2_py._mcap_file import McapFile
from std_msgs.msg import String

from rclpy.serialization import serialize_message

STORAGES = {"mcap": "bag_0.mcap", "sqlite3": "bag_0.db3"}
KINDS = (("mcap", ""), ("mcap", "zstd_fast"), ("mcap", "zstd_small"), ("sqlite3", ""))


def write(folder: Path, storage: str, preset: str = "", count: int = 3000) -> Path:
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder / "bag"), storage_id=storage, storage_preset_profile=preset))
    for name in ("/chatter", "/rare", "/silent"):
        writer.create_topic(rosbag2_py.TopicMetadata(0, name, "std_msgs/msg/String", "cdr", [rosbag2_py.QoS(10)]))
    random.seed(3)
    for number in range(count):
        topic = "/rare" if number % 700 == 5 else "/chatter"
        # Some are older than the one before them.
        time_ns = 1_000_000 + number * 1000 - (5_500 if number % 90 == 0 else 0)
        writer.write(topic, serialize_message(String(data=f"hi {number}")), time_ns, time_ns - 7)
        if number % 500 == 499:
            writer.flush()
    writer.close()
    return folder / "bag" / STORAGES[storage]


def everything(path: Path) -> tuple[Counter[str], list[tuple[int, str, bytes]]]:
    """The counts of the blocks, and all messages by way of them."""
    file = open_blocks(path)
    counts: Counter[str] = Counter()
    found = []
    try:
        for block in file.blocks():
            counts.update(block.counts)
            entries = file.entries(block)
            assert {topic: len(each.times) for topic, each in entries.items()} == block.counts
            for topic, (times, keys) in entries.items():
                assert list(times) == sorted(times) and block.start_ns <= times[0] and times[-1] <= block.end_ns
                for time_ns, key in zip(times, keys, strict=True):
                    message = file.message(block, topic, key)
                    assert message.received_ns == time_ns
                    found.append((time_ns, topic, message.data))
    finally:
        file.close()
    return counts, sorted(found)


def by_reader(path: Path) -> list[tuple[int, str, bytes]]:
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(path))
    found = []
    while reader.has_next():
        topic, data, time_ns = reader.read_next()
        found.append((time_ns, topic, data))
    reader.close()
    return sorted(found)


@pytest.mark.parametrize(("storage", "preset"), KINDS)
def test_the_blocks_hold_every_message_once(tmp_path, storage, preset):
    path = write(tmp_path, storage, preset)
    counts, found = everything(path)
    assert found == by_reader(path) and len(found) == 3000
    assert counts == {"/chatter": 2995, "/rare": 5}
    file = open_blocks(path)
    assert [topic.name for topic in file.topics()] == ["/chatter", "/rare", "/silent"]
    assert {definition.topic_type for definition in file.definitions()} == {"std_msgs/msg/String"}
    file.close()


@pytest.mark.parametrize("preset", ["", "zstd_fast"])
def test_an_mcap_file_that_was_cut_off_is_indexed_as_far_as_it_goes(tmp_path, preset):
    path = write(tmp_path, "mcap", preset)
    data = path.read_bytes()
    for part in (0.3, 0.6, 0.97):
        path.write_bytes(data[: int(len(data) * part)])
        _, found = everything(path)
        assert found == by_reader(path) and len(found) % 500 == 0
        file = McapBlocks(path)
        list(file.blocks())
        assert not file.is_complete and next(topic.name for topic in file.topics()) == "/chatter"
        file.close()


@pytest.mark.parametrize("preset", ["", "zstd_fast"])
def test_of_a_file_that_was_cut_off_only_the_first_and_the_last_chunk_are_unpacked(tmp_path, preset, monkeypatch):
    path = write(tmp_path, "mcap", preset)
    data = path.read_bytes()
    path.write_bytes(data[: int(len(data) * 0.8)])
    unpacked = []
    unpack = McapFile.unpack

    def noted(self, offset, **words):
        unpacked.append(offset)
        return unpack(self, offset, **words)

    monkeypatch.setattr(McapFile, "unpack", noted)
    file = McapBlocks(path)
    blocks = list(file.blocks())
    assert len(blocks) >= 4 and len(unpacked) <= 2 and file.passed == 1.0
    assert sum(sum(block.counts.values()) for block in blocks) % 500 == 0
    file.close()


def test_a_channel_that_is_first_named_in_a_later_chunk_is_found_in_a_file_that_was_cut_off(tmp_path):
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "bag"), storage_id="mcap"))
    for number in range(40):
        name = f"/topic{number // 10}"
        writer.create_topic(rosbag2_py.TopicMetadata(0, name, "std_msgs/msg/String", "cdr", [rosbag2_py.QoS(10)]))
        writer.write(name, serialize_message(String(data=f"hi {number}")), number + 1)
        writer.flush()
    writer.close()
    path = tmp_path / "bag" / "bag_0.mcap"
    path.write_bytes(path.read_bytes()[:-200])
    counts, found = everything(path)
    assert counts == {f"/topic{number}": 10 for number in range(4)} and found == by_reader(path)


def test_an_mcap_file_without_chunks_is_gone_through(tmp_path):
    from mcap.writer import Writer

    path = tmp_path / "loose.mcap"
    with path.open("wb") as stream:
        writer = Writer(stream, use_chunking=False)
        writer.start("ros2", "test")
        schema = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        channel = writer.register_channel("/chatter", "cdr", schema)
        for number in range(2500):
            writer.add_message(channel, number + 1, serialize_message(String(data=f"{number}")), number)
        writer.finish()
    counts, found = everything(path)
    assert counts == {"/chatter": 2500} and found == by_reader(path)
    assert len(list(McapBlocks(path).blocks())) == 3
    path.write_bytes(path.read_bytes()[:60_000])
    assert everything(path)[1] == by_reader(path)


@pytest.mark.parametrize("compression", ["NONE", "LZ4", "ZSTD"])
@pytest.mark.parametrize("index", ["ALL", "CHUNK", "NONE"])
def test_files_of_another_writer_with_and_without_indexes(tmp_path, compression, index):
    from mcap.writer import CompressionType, IndexType, Writer

    path = tmp_path / "other.mcap"
    with path.open("wb") as stream:
        types = IndexType[index]
        writer = Writer(stream, chunk_size=2000, compression=CompressionType[compression], index_types=types)
        writer.start("ros2", "test")
        schema = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        channels = [writer.register_channel(topic, "cdr", schema) for topic in ("/a", "/b", "/a")]
        for number in range(500):
            time_ns = 1000 + number - 3 * (number % 7 == 0)
            writer.add_message(channels[number % 3], time_ns, serialize_message(String(data=f"{number}")), time_ns)
        writer.finish()
    counts, found = everything(path)
    assert counts == {"/a": 333, "/b": 167} and found == by_reader(path)


def test_a_long_file_has_no_more_blocks_than_a_timeline_can_use(tmp_path, monkeypatch):
    from rosbag2_py import _sqlite_blocks

    path = write(tmp_path, "sqlite3")
    monkeypatch.setattr(_sqlite_blocks, "LEAST_ROWS", 10)
    monkeypatch.setattr(_sqlite_blocks, "MOST_BLOCKS", 20)
    file = open_blocks(path)
    blocks = list(file.blocks())
    assert 18 <= len(blocks) <= 21 and sum(sum(block.counts.values()) for block in blocks) == 3000
    file.close()


@pytest.mark.long
@pytest.mark.parametrize("storage", STORAGES)
def test_bytes_that_are_wrong_anywhere_are_told_as_a_damaged_bag(tmp_path, storage):
    path = write(tmp_path, storage, count=400)
    data = path.read_bytes()
    random.seed(8)
    refused = 0
    for _ in range(150):
        broken = bytearray(data)
        for _ in range(6):
            broken[random.randrange(len(broken))] = random.randrange(256)
        path.write_bytes(broken)
        try:
            file = open_blocks(path)
            try:
                for block in file.blocks():
                    for topic, (_, keys) in file.entries(block).items():
                        for key in keys:
                            file.message(block, topic, key)
            finally:
                file.close()
        except RuntimeError as error:
            assert str(error)
            refused += 1
    assert refused


@pytest.mark.parametrize(
    ("name", "content"), [("a.mcap", b""), ("a.db3", b""), ("a.mcap", b"hello"), ("a.db3", b"hello" * 99)]
)
def test_a_file_that_is_no_bag_is_refused(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(RuntimeError, match=r"file too small|storage|Table `topics`"):
        open_blocks(tmp_path / name)
    with pytest.raises(RuntimeError, match=r"No such file|does not exist"):
        open_blocks(tmp_path / f"no_{name}")
