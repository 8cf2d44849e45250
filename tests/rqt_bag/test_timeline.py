"""What the index says of the messages in bags: how many there are in a time, and which is next to a moment."""

from __future__ import annotations

import pytest
from std_msgs.msg import Float64

from day6_core.ros.programs.rqt_bag.model import timeline as timeline_module
from day6_core.ros.programs.rqt_bag.model.loading import index_bag, is_bag, open_bag
from day6_core.ros.programs.rqt_bag.model.timeline import Timeline
from rclpy.serialization import deserialize_message
from tests.rqt_bag.bag_desk import SECOND, START, write_bag


def indexed(*paths):
    timeline = Timeline()
    for path in paths:
        index_bag(open_bag(path), timeline, lambda: False)
    return timeline


def number(found):
    return deserialize_message(found.read().data, Float64).data


def test_every_column_has_the_messages_of_its_time(tmp_path, storage):
    timeline = indexed(write_bag(tmp_path / "bag", storage))
    assert (timeline.start_ns, timeline.end_ns) == (START, START + 99 * SECOND // 10)
    assert timeline.count("/number") == 100 and timeline.count("/nothing") == 0
    assert timeline.look_at(START, START + 10 * SECOND)
    assert timeline.columns("/number", START, START + 10 * SECOND - 1, 10) == [10.0] * 10
    assert timeline.columns("/word", START, START + 2 * SECOND - 1, 4) == [0, 1, 0, 1]
    assert timeline.columns("/number", START - SECOND, START, 2) == [0, 1]
    assert timeline.columns("/nothing", START, START + 1, 2) == [0, 0]
    assert not timeline.look_at(START, START + 10 * SECOND), "it is read once"


def test_before_a_block_is_looked_into_its_messages_are_spread(tmp_path, storage):
    timeline = indexed(write_bag(tmp_path / "bag", storage))
    assert sum(timeline.columns("/number", START, START + 10 * SECOND, 7)) == pytest.approx(100)
    assert timeline.estimate(["/number", "/word"], START - 1, START + 10 * SECOND) == pytest.approx(110)


def test_the_newest_message_before_a_moment(tmp_path, storage):
    timeline = indexed(write_bag(tmp_path / "bag", storage))
    assert number(timeline.newest("/number", START + 5 * SECOND)[0]) == 50.0
    assert number(timeline.newest("/number", START + 5 * SECOND - 1)[0]) == 49.0
    assert [number(each) for each in timeline.newest("/number", START + SECOND, 3)] == [8.0, 9.0, 10.0]
    assert timeline.newest("/number", START - 1) == [] and timeline.newest("/nothing", START + SECOND) == []
    assert len(timeline.newest("/static", START + 9 * SECOND, 10)) == 2


def test_the_messages_after_a_moment(tmp_path, storage):
    timeline = indexed(write_bag(tmp_path / "bag", storage))
    assert timeline.next_time(["/number", "/word"], START) == START + SECOND // 10
    assert timeline.next_time(["/word"], START) == START + SECOND // 2
    assert timeline.next_time(["/number"], START + 10 * SECOND) is None
    assert timeline.previous_time(["/number", "/word"], START + SECOND // 2) == START + 4 * SECOND // 10
    assert timeline.previous_time(["/number"], START) is None
    found = timeline.between(["/number", "/word"], START + 4 * SECOND // 10, START + 6 * SECOND // 10)
    assert [each.topic for each in found] == ["/number", "/word", "/number"]


def test_two_bags_lie_on_one_timeline_even_if_their_times_overlap(tmp_path):
    first = write_bag(tmp_path / "first", "mcap")
    second = write_bag(tmp_path / "second", "sqlite3", seconds=20)
    timeline = indexed(second, first)
    assert timeline.count("/number") == 300
    assert len(timeline.between(["/number"], START - 1, START + 10 * SECOND - 1)) == 200
    assert timeline.next_time(["/number"], START) == START + SECOND // 10
    assert number(timeline.newest("/number", START + 15 * SECOND)[0]) == 150.0


def test_only_so_many_blocks_keep_the_times_of_their_messages(tmp_path, monkeypatch):
    from rosbag2_py import _sqlite_blocks

    monkeypatch.setattr(_sqlite_blocks, "LEAST_ROWS", 5)
    monkeypatch.setattr(timeline_module, "KEPT", 3)
    timeline = indexed(write_bag(tmp_path / "bag", "sqlite3"))
    blocks = [block for _, block in timeline._lanes["/number"].places]
    assert len(blocks) > 15
    for tenth in range(0, 100, 7):
        assert number(timeline.newest("/number", START + tenth * SECOND // 10)[0]) == tenth
    assert sum(block.entries is not None for block in blocks) <= 3


@pytest.mark.parametrize("preset", ["zstd_fast", "none"])
def test_what_rqt_bag_takes_for_a_bag(tmp_path, preset):
    bag = write_bag(tmp_path / "bag", preset=preset)
    (tmp_path / "empty").mkdir()
    assert is_bag(bag) and is_bag(bag / "metadata.yaml") and is_bag(bag / "bag_0.mcap")
    assert not is_bag(tmp_path / "empty") and not is_bag(tmp_path / "nothing")
    assert open_bag(bag / "metadata.yaml").path == bag
    assert indexed(bag / "bag_0.mcap").count("/number") == 100


@pytest.mark.parametrize("mode", ["FILE", "MESSAGE"])
def test_compressed_bags(tmp_path, mode):
    import rosbag2_py

    writer = rosbag2_py.SequentialCompressionWriter(
        rosbag2_py.CompressionOptions("zstd", rosbag2_py.CompressionMode.__members__[mode], 0, 0)
    )
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "bag"), storage_id="sqlite3"))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/number", "std_msgs/msg/Float64", "cdr"))
    from rclpy.serialization import serialize_message

    writer.write("/number", serialize_message(Float64(data=7.0)), START)
    writer.close()
    timeline = indexed(tmp_path / "bag")
    assert number(timeline.newest("/number", START)[0]) == 7.0
