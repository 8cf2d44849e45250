"""`day6-tui bag-csv`: what is in the tables, read back by Python's own reader, and what is said where something is wrong."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
import rosbag2_py
from geometry_msgs.msg import PoseStamped
from rcl_interfaces.msg import Parameter, ParameterValue
from rosbag2_py import _csv
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Byte, Float32MultiArray, MultiArrayDimension, MultiArrayLayout, String

from day6_tui.commands.bag_csv import main
from rclpy.serialization import serialize_message
from tests.bag.test_storage import START, STORAGES, write

SECOND = 1_000_000_000


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("DAY6_LANG", "en")
    return tmp_path


def bag(*said: tuple[str, object, int], storage: str = "mcap", compression: str = "NONE") -> None:
    """The bag `bag` with messages: topic, message, nanoseconds after START."""
    options = rosbag2_py.CompressionOptions("zstd", rosbag2_py.compression_mode_from_string(compression))
    writer = rosbag2_py.SequentialCompressionWriter(options) if compression != "NONE" else rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions("bag", storage_id=storage), rosbag2_py.ConverterOptions("", ""))
    for topic, message, moment in said:
        kind = f"{type(message).__module__.partition('.')[0]}/msg/{type(message).__name__}"
        writer.create_topic(rosbag2_py.TopicMetadata(0, topic, kind, "cdr"))
        writer.write(topic, serialize_message(message), START + moment)
    writer.close()


def table(name: str, folder: str = "bag_csv") -> list[list[str]]:
    data = Path(folder, name).read_bytes()
    assert data.startswith(b"\xef\xbb\xbf") and b"\r\n" in data
    return list(csv.reader(data.decode("utf-8-sig").splitlines(keepends=True)))


@pytest.mark.parametrize("storage", STORAGES)
@pytest.mark.parametrize("compression", ("NONE", "FILE", "MESSAGE"))
def test_a_row_is_a_message_and_a_column_a_value(
    storage: str, compression: str, capsys: pytest.CaptureFixture[str]
) -> None:
    pose = PoseStamped()
    pose.header.frame_id, pose.pose.position.x, pose.pose.orientation.w = "map", -1.25, float("nan")
    bag(
        ("/a/text", String(data='早\n上,"好"'), 0),
        ("/pose", pose, 1_500_000_000),
        storage=storage,
        compression=compression,
    )
    assert main(["bag"]) == 0
    assert table("a_text.csv") == [["bag_time", "bag_time_ns", "data"], ["0.000000000", str(START), '早\n上,"好"']]
    head, row = table("pose.csv")
    assert head[2:7] == [
        "header.stamp.sec",
        "header.stamp.nanosec",
        "header.frame_id",
        "pose.position.x",
        "pose.position.y",
    ]
    assert row[:2] == ["1.500000000", str(START + 1_500_000_000)] and row[4:6] == ["map", "-1.25"] and row[-1] == "nan"
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        f"{Path('bag_csv', 'a_text.csv')}: /a/text, 1 rows, 3 columns",
        f"{Path('bag_csv', 'pose.csv')}: /pose, 1 rows, 12 columns",
    ]


def test_a_sequence_has_as_many_columns_as_the_longest_one() -> None:
    layout = MultiArrayLayout(dim=[MultiArrayDimension(label="x", size=2), MultiArrayDimension(label="y", size=3)])
    bag(
        ("/joints", JointState(name=["a"], position=[1.0]), 0),
        ("/joints", JointState(name=["a", "b"], position=[2.0, 3.5]), 1),
        ("/joints", JointState(), 2),
        ("/array", Float32MultiArray(layout=layout, data=[0.5]), 3),
        ("/byte", Byte(data=b"\x07"), 4),
        ("/parameter", Parameter(name="on", value=ParameterValue(type=1, bool_value=True)), 5),
    )
    assert main(["bag"]) == 0
    head, *rows = table("joints.csv")
    assert head[5:] == ["name[0]", "name[1]", "position[0]", "position[1]"]
    assert [row[5:] for row in rows] == [["a", "", "1.0", ""], ["a", "b", "2.0", "3.5"], ["", "", "", ""]]
    head, row = table("array.csv")
    assert head[2:4] == ["layout.dim[0].label", "layout.dim[0].size"] and head[-1] == "data[0]" and row[-1] == "0.5"
    assert table("byte.csv")[1][2] == "7"
    head, row = table("parameter.csv")
    assert row[head.index("value.bool_value")] == "True"


def test_of_a_very_long_sequence_only_the_length_is_written(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    bag(("/camera", Image(data=bytes(3000), width=10), 0), ("/joints", JointState(position=[0.0] * 1500), 1))
    monkeypatch.setattr(_csv, "MOST_COLUMNS", 800)
    assert main(["bag"]) == 0
    head, row = table("camera.csv")
    assert head[-1] == "len(data)" and row[-1] == "3000"
    assert table("joints.csv")[0][5:] == ["len(position)"]
    assert "/camera: of data only the length is written, it is up to 3000" in capsys.readouterr().err


def test_no_text_of_a_message_becomes_a_formula() -> None:
    for number, text in enumerate(("=1+1", "+1", "-1", "@x", "\t=1", "1=1")):
        bag_of = [("/t", String(data=text), 0)]
        Path("bag").exists() and Path("bag").rename(f"old{number}")
        bag(*bag_of)
        assert main(["bag", "-o", f"out{number}"]) == 0
        assert table("t.csv", f"out{number}")[1][2] == (text if text[0] == "1" else f"'{text}")


def test_files_have_names_that_every_system_takes() -> None:
    topics = ("/a/b", "/a_b", "/A_B", "/con", "/com1", "/../../etc/passwd", "/")
    assert list(_csv.file_names(topics).values()) == [
        "a_b.csv", "a_b-2.csv", "A_B-3.csv", "con_.csv", "com1_.csv", "______etc_passwd.csv", "_.csv",
    ]  # fmt: skip


def test_topics_and_a_folder_can_be_chosen_and_only_our_own_files_are_replaced(
    capsys: pytest.CaptureFixture[str],
) -> None:
    bag(("/a", String(data="1"), 0), ("/b", String(data="2"), 1))
    assert main(["bag", "a", "-o", "here/there"]) == 0
    assert [path.name for path in Path("here/there").iterdir()] == ["a.csv"]
    assert main(["bag", "/a", "-o", "here/there"]) == 1
    assert "exists: --force replaces it, -o DIR chooses another folder" in capsys.readouterr().err
    Path("here/there/b.csv").write_text("my own\n")
    assert main(["bag", "-f", "-o", "here/there"]) == 1
    assert "isn't a table from a bag: it is left alone" in capsys.readouterr().err
    assert Path("here/there/b.csv").read_text() == "my own\n"
    assert main(["bag", "/a", "-f", "-o", "here/there"]) == 0
    assert main(["bag", "/c"]) == 1 and not Path("bag_csv").exists()
    assert capsys.readouterr().err.endswith("there is no topic /c in 'bag'; it has /a, /b\n")


def test_a_bag_that_is_cut_off_a_type_from_elsewhere_and_a_message_that_does_not_fit(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    writer = write(here / "bag", "sqlite3", 20, close=False)
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/alien", "their_msgs/msg/Thing", "cdr"))
    writer.write("/alien", b"\0\1\0\0", START)
    writer.write("/chatter", b"\0\1\0\0\xff\xff\xff\xff", START)
    writer.close()
    assert main(["bag"]) == 1
    said = capsys.readouterr().err
    assert (
        "/alien is left out: its type their_msgs/msg/Thing isn't known here; source the workspace that has it" in said
    )
    assert "/chatter: 1 messages don't fit their type and are left out" in said
    assert len(table("chatter.csv")) == 21 and not Path("bag_csv/alien.csv").exists()

    file = next((here / "bag").glob("*.db3"))
    data = bytearray(file.read_bytes())
    data[4096:] = b"\x55" * len(data[4096:])
    file.write_bytes(data)
    assert main(["bag", "-o", "other"]) == 1
    assert "Traceback" not in (said := capsys.readouterr().err) and ("damaged" in said or "can't be read" in said), said


def test_what_is_no_bag_is_told_and_one_without_metadata_may_be_mended(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["nothing"]) == 1
    assert capsys.readouterr().err == "day6-tui bag-csv: there is no bag 'nothing'\n"
    write(here / "bag", "mcap", 5)
    (here / "bag" / "metadata.yaml").unlink()
    assert main(["bag"]) == 1
    said = capsys.readouterr().err
    assert "'bag' can't be read: " in said and "metadata.yaml is missing" in said and "ros2 bag reindex bag" in said
    assert main([str(next((here / "bag").glob("*.mcap")))]) == 0
    (here / "notes.txt").write_text("not a bag")
    assert main(["notes.txt"]) == 1 and "can't be read" in capsys.readouterr().err


def test_many_topics_are_written_a_part_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_csv, "AT_ONCE", 2)
    bag(*((f"/t{number}", String(data=str(number)), number) for number in range(5)))
    assert main(["bag"]) == 0
    assert [table(f"t{number}.csv")[1][2] for number in range(5)] == list("01234")
