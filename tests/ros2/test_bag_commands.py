"""The other verbs of `ros2 bag`, and a whole drive recorded and played."""

from __future__ import annotations

import re

import rosbag2_py
from geometry_msgs.msg import Twist

from tests.ros2.bag_commands import counter, information, lines, play, record, wait_for_end


def test_info_prints_the_columns_of_the_real_one(counted, monkeypatch):
    result = counted.ros2("bag", "info", "bag")
    text = re.sub(r"(Start|End): .*", r"\1: ", result.stdout)
    assert re.sub(r"Bag size: .*", "Bag size: ", text) == (
        "\nFiles:             bag_0.mcap\nBag size: \nStorage id:        mcap\nROS Distro:        jazzy\n"
        "Duration:          1.900000000s\nStart: \nEnd: \nMessages:          20\n"
        "Topic information: Topic: /count | Type: std_msgs/msg/Int32 | Count: 20 | Serialization Format: cdr\n"
        "Service:           0\nService information: \n"
    )
    assert re.search(
        r"Start:             [A-Z][a-z]{2} [ \d]\d \d{4} \d\d:\d\d:\d\d\.\d{9} \(\d+\.\d{9}\)", result.stdout
    )
    assert counted.ros2("bag", "info", "bag", "-t").stdout == "/count\n"
    assert "| Size Contribution: 160 B |" in counted.ros2("bag", "info", "bag/bag_0.mcap", "-v").stdout


def test_info_of_nothing_says_so(machine):
    (machine.cwd / "empty").mkdir()
    assert "error: argument bag_path: Bag path 'nope' does not exist!" in machine.ros2("bag", "info", "nope").stderr
    result = machine.ros2("bag", "info", "empty")
    assert (result.stderr, result.status) == ("Could not find metadata in bag directory empty\n", 1)


def test_reindex_from_the_command_line(counted):
    before = information(counted)
    (counted.cwd / "bag" / "metadata.yaml").unlink()
    result = counted.ros2("bag", "reindex", "bag")
    assert lines(result.stderr) == [
        "[INFO] [rosbag2_cpp]: Beginning reindexing bag in directory: bag",
        "[INFO] [rosbag2_cpp]: Reindexing complete.",
    ]
    assert information(counted) == {**before, "files": []}  # the real one leaves them out, too


def test_convert_writes_the_bag_with_another_storage_and_fewer_topics(machine):
    machine.node("counter", counter())
    machine.node("other", counter("other"))
    record(machine, "--topics", "/count", "/other", seconds=1.0)
    (machine.cwd / "out.yaml").write_text(
        "output_bags:\n- uri: converted\n  storage_id: sqlite3\n  topics: [/count]\n- uri: everything\n  all: true\n"
    )
    result = machine.ros2("bag", "convert", "-i", "bag", "-o", "out.yaml")
    opened = "[INFO] [rosbag2_storage]: Opened database 'converted/converted_0.db3' for READ_WRITE."
    assert (lines(result.stderr), result.status) == ([opened], 0)
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(machine.cwd / "converted"))
    (topic,) = reader.get_metadata().topics_with_message_count
    assert topic.topic_metadata.name == "/count" and topic.message_count == 10
    assert rosbag2_py.Info().read_metadata(str(machine.cwd / "everything")).message_count == 20
    (machine.cwd / "out.yaml").write_text("output_bags:\n- storage_id: mcap\n")
    assert "an output bag has no 'uri'" in machine.ros2("bag", "convert", "-i", "bag", "-o", "out.yaml").stderr


def test_list_names_the_plugins(machine):
    assert machine.ros2("bag", "list", "storage").stdout == "mcap\nsqlite3\n"
    assert machine.ros2("bag", "list", "converter").stdout == ""


def test_bags_complete_with_tab(counted):
    assert counted.complete("bag", "play", "") == ["bag"]
    assert counted.complete("bag", "") == ["burst", "convert", "info", "list", "play", "record", "reindex"]


def test_a_turtle_drives_again_what_was_recorded(machine):
    """The lesson of the tutorial: the same commands give the same way."""
    twists = []
    machine.node("robot", lambda node: node.create_subscription(Twist, "cmd_vel", twists.append, 10))

    def drive(node):
        publisher = node.create_publisher(Twist, "cmd_vel", 10)
        node.timer = node.create_timer(0.1, lambda: publisher.publish(Twist()))

    driver = machine.node("driver", drive)
    record(machine, "--topics", "cmd_vel", seconds=1.0)
    driver.destroy_timer(driver.timer)
    before = len(twists)
    wait_for_end(play(machine))
    assert len(twists) == 2 * before
