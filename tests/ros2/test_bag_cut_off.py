"""Bags that were cut off, or are none, in the words of rosbag2 and the mcap library (C++ 1.3.0, run on the same bytes)."""

from __future__ import annotations

import shutil

import pytest
import rosbag2_py
from std_msgs.msg import String

from rclpy.serialization import serialize_message
from tests.ros2.bag_commands import heard, information, lines, wait_for_end

NO_INDEX = "[WARN] [rosbag2_storage_mcap]: attempted to read in receive timestamp order with no message index"


def write(folder, storage, count=3000, preset="", **options):
    """Two topics in turn, every tenth pair the wrong way round in time; returns the file."""
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder), storage, storage_preset_profile=preset, **options))
    for name in ("/a", "/b"):
        writer.create_topic(rosbag2_py.TopicMetadata(0, name, "std_msgs/msg/String", "cdr", [rosbag2_py.QoS(100)]))
    for number in range(count):
        at = 10**18 + number * 10**6 - (2 * 10**6 if number % 10 == 5 else 0)
        writer.write("/ab"[0] + "ab"[number % 2], serialize_message(String(data="x" * 1000 + str(number))), at)
    writer.close()
    return next(path for path in folder.iterdir() if path.suffix in (".mcap", ".db3"))


def cut(file, part, name="cut"):
    """The first part of a file, beside its folder."""
    data = file.read_bytes()
    target = file.parent.with_name(f"{name}{file.suffix}")
    target.write_bytes(data[: part if isinstance(part, int) else int(len(data) * part)])
    return target.name


@pytest.mark.parametrize(("part", "count"), ((0.3, 756), (0.6, 1510), (0.9, 2264), (0.9999, 3000), (-8, 3000)))
def test_info_counts_the_messages_of_whole_chunks(machine, part, count):
    name = cut(write(machine.cwd / "bag", "mcap"), part)
    result = machine.ros2("bag", "info", name)
    assert (result.stderr, result.status) == ("", 0)
    assert f"\nMessages:          {count}\n" in result.stdout
    assert f"Topic: /a | Type: std_msgs/msg/String | Count: {count // 2} |" in result.stdout


@pytest.mark.parametrize("words", ([], ["-s", "mcap"]))
@pytest.mark.parametrize(
    ("content", "reason"),
    (
        (b"", "file too small"),
        (b"\x89MCAP0\r\n" + bytes(50), "file too small"),
        (b"hello " * 20, "invalid magic bytes in Header: 0x68656C6C6F206865"),
    ),
)
def test_what_is_no_mcap_file_is_refused(machine, content, reason, words):
    (machine.cwd / "broken.mcap").write_bytes(content)
    result = machine.ros2("bag", "info", "broken.mcap", *words)
    told, last = lines(result.stderr)[:-1], lines(result.stderr)[-1]
    assert (last, result.status) == ("No plugin detected that could open file broken.mcap", 1)
    if words:
        assert told == [
            f"[ERROR] [rosbag2_storage]: Could not open 'broken.mcap' with 'mcap'. Error: {reason}",
            "[ERROR] [rosbag2_storage]: Could not load/open plugin with storage id 'mcap'",
        ]
    else:
        assert told == ["[ERROR] [rosbag2_storage]: No storage id specified, and no plugin found that could open URI"]


def test_a_file_without_indexes_is_played_as_it_was_written(machine):
    name = cut(write(machine.cwd / "bag", "mcap"), 0.6)
    ear = heard(machine, String, "/a")
    command = machine.start("bag", "play", name, "-r", "10", "--disable-keyboard-controls")
    wait_for_end(command)
    assert lines(command.stderr)[:2] == [
        NO_INDEX,
        "[WARN] [rosbag2_cpp]: Could not set read order on open(), falling back to file order",
    ]
    numbers = [int(message.data.lstrip("x")) for _, message in ear]
    assert len(numbers) == 755 and numbers == sorted(numbers)


def test_a_bag_with_metadata_and_a_cut_off_file(machine):
    file = write(machine.cwd / "bag", "mcap")
    file.write_bytes(file.read_bytes()[:-2000])
    command = machine.start("bag", "play", "bag", "-r", "10", "--disable-keyboard-controls")
    wait_for_end(command)
    assert lines(command.stderr)[0] == NO_INDEX and "falling back" not in command.stderr
    file.write_bytes(b"")
    result = machine.ros2("bag", "play", "bag")
    assert lines(result.stderr) == [
        "[ERROR] [rosbag2_storage]: Could not open 'bag/bag_0.mcap' with 'mcap'. Error: file too small",
        "[ERROR] [rosbag2_storage]: Could not load/open plugin with storage id 'mcap'",
        "No storage could be initialized. Abort",
    ]
    assert result.status == 1


def test_reindex_counts_what_is_there_and_leaves_the_file(machine):
    file = write(machine.cwd / "bag", "mcap")
    file.write_bytes(file.read_bytes()[: file.stat().st_size * 6 // 10])
    (machine.cwd / "bag" / "metadata.yaml").unlink()
    before = file.read_bytes()
    result = machine.ros2("bag", "reindex", "bag")
    assert lines(result.stderr) == [
        "[INFO] [rosbag2_cpp]: Beginning reindexing bag in directory: bag",
        NO_INDEX,
        "[WARN] [rosbag2_cpp]: Could not set read order on open(), falling back to file order",
        "[INFO] [rosbag2_cpp]: Reindexing complete.",
    ]
    assert information(machine)["message_count"] == 1510 and file.read_bytes() == before


def test_a_cut_off_sqlite_bag_is_refused_as_a_whole(machine):
    file = write(machine.cwd / "bag", "sqlite3")
    name = cut(file, 0.6)
    result = machine.ros2("bag", "info", name)
    assert lines(result.stderr) == [
        "[ERROR] [rosbag2_storage]: No storage id specified, and no plugin found that could open URI",
        "No plugin detected that could open file cut.db3",
    ]
    shutil.copy(machine.cwd / name, file)
    result = machine.ros2("bag", "play", "bag")
    setup = "Failed to setup storage. Error: "
    reason = "Error when processing SQL statement. SQLite error (11): database disk image is malformed"
    opening = "[ERROR] [rosbag2_storage]: Could not open 'bag/bag_0.db3' with 'sqlite3'. Error: "
    assert lines(result.stderr)[0] == opening + setup + reason
    assert result.status == 1
    # What is in metadata.yaml is printed without a look at the file.
    assert "Messages:          3000" in machine.ros2("bag", "info", "bag").stdout


def test_an_empty_database_is_no_bag(machine):
    (machine.cwd / "empty.db3").write_bytes(b"")
    result = machine.ros2("bag", "info", "empty.db3", "-s", "sqlite3")
    assert (
        "Could not open 'empty.db3' with 'sqlite3'. Error: field_exists(..) failed. Table `topics` doesn't exist!"
        in result.stderr
    )


@pytest.mark.parametrize(("words", "count"), (([], 1), (["--log-level", "warn"], 0)))
def test_a_database_says_that_it_is_written(machine, words, count):
    command = machine.start("bag", "record", "-o", "bag", "-s", "sqlite3", "--topics", "/x", *words)
    command.step(0.2)
    command.interrupt()
    opened = "[INFO] [rosbag2_storage]: Opened database 'bag/bag_0.db3' for READ_WRITE."
    assert lines(command.stderr).count(opened) == count


def test_a_database_says_that_it_was_opened(machine):
    write(machine.cwd / "bag", "sqlite3", 10)
    result = machine.ros2("bag", "info", "bag/bag_0.db3")
    assert lines(result.stderr) == ["[INFO] [rosbag2_storage]: Opened database 'bag/bag_0.db3' for READ_ONLY."]
