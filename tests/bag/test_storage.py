"""Bags on the disk: whole at every moment, readable by the tools of others, and theirs by us."""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

import pytest
import rosbag2_py
import yaml
from geometry_msgs.msg import PoseStamped
from rosbag2_py._mcap_write import McapWriter
from rosbag2_py._metadata import MetadataIo
from rosbag2_py._qos import from_yaml, offer_for, yaml_lines
from rosbag2_py._sqlite import SqliteReader
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from rclpy.serialization import deserialize_message, serialize_message
from tests.support.waiting import run

STORAGES = ("mcap", "sqlite3")
SUFFIX = {"mcap": ".mcap", "sqlite3": ".db3"}
START = 1_700_000_000_000_000_000
MILLISECOND = 1_000_000


def write(
    folder: Path, storage: str, count: int = 100, *, close: bool = True, **options
) -> rosbag2_py.SequentialWriter:
    """A bag with `count` texts on /chatter, one a millisecond, and a pose with every tenth."""
    writer = rosbag2_py.SequentialWriter()
    writer.open(
        rosbag2_py.StorageOptions(str(folder), storage_id=storage, **options), rosbag2_py.ConverterOptions("", "")
    )
    lasting = rosbag2_py.QoS(5).transient_local()
    for name, kind, qos in (
        ("/chatter", "std_msgs/msg/String", [rosbag2_py.QoS(10)]),
        ("/pose", "geometry_msgs/msg/PoseStamped", [lasting]),
    ):
        writer.create_topic(rosbag2_py.TopicMetadata(0, name, kind, "cdr", qos))
    for number in range(count):
        moment = START + number * MILLISECOND
        writer.write("/chatter", serialize_message(String(data=f"hi {number}")), moment)
        if number % 10 == 0:
            writer.write("/pose", serialize_message(PoseStamped()), moment + 5, moment)
    if close:
        writer.close()
    return writer


def read(folder: Path, **options) -> list[tuple[str, bytes, int]]:
    reader = rosbag2_py.SequentialReader()
    reader.open(rosbag2_py.StorageOptions(str(folder), **options), rosbag2_py.ConverterOptions("", ""))
    found = []
    while reader.has_next():
        found.append(reader.read_next())
    return found


def texts(messages: list[tuple[str, bytes, int]]) -> list[str]:
    return [deserialize_message(data, String).data for topic, data, _ in messages if topic == "/chatter"]


# -- what is written is read -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("storage", STORAGES)
def test_a_bag_gives_back_every_message_in_the_order_of_time(tmp_path, storage):
    write(tmp_path / "bag", storage)
    messages = read(tmp_path / "bag")
    assert len(messages) == 110
    times = [moment for _, _, moment in messages]
    assert times == sorted(times) and times[0] == START and times[1] == START + 5
    assert texts(messages) == [f"hi {number}" for number in range(100)]


def test_who_stops_in_the_middle_of_a_file_that_is_closed_meanwhile_hears_nothing_of_it(tmp_path):
    write(tmp_path / "bag", "sqlite3")
    reader = SqliteReader(next((tmp_path / "bag").glob("*.db3")))
    rows = reader.rows("SELECT id FROM messages ORDER BY id")
    assert next(rows) == (1,)
    reader.close()
    rows.close()


@pytest.mark.parametrize("storage", STORAGES)
def test_metadata_is_version_nine_with_qos_counts_and_times(tmp_path, storage):
    write(tmp_path / "bag", storage)
    content = yaml.safe_load((tmp_path / "bag" / "metadata.yaml").read_text())["rosbag2_bagfile_information"]
    assert content["version"] == 9 and content["storage_identifier"] == storage
    assert content["message_count"] == 110 and content["duration"] == {"nanoseconds": 99 * MILLISECOND}
    assert content["starting_time"] == {"nanoseconds_since_epoch": START}
    assert content["relative_file_paths"] == [f"bag_0{SUFFIX[storage]}"]
    assert content["custom_data"] is None and content["compression_mode"] == ""
    chatter, pose = content["topics_with_message_count"]
    assert (chatter["message_count"], pose["message_count"]) == (100, 10)
    (profile,) = pose["topic_metadata"]["offered_qos_profiles"]
    assert (profile["durability"], profile["depth"], profile["liveliness"]) == ("transient_local", 5, "automatic")
    assert profile["deadline"] == {"sec": 9223372036, "nsec": 854775807}


@pytest.mark.parametrize("storage", STORAGES)
def test_the_definitions_of_the_messages_are_in_the_bag(tmp_path, storage):
    write(tmp_path / "bag", storage)
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    found = {each.topic_type: each for each in reader.get_all_message_definitions()}
    text = found["geometry_msgs/msg/PoseStamped"].encoded_message_definition
    for inner in ("std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/Point"):
        assert f"{'=' * 80}\nMSG: {inner}\n" in text
    assert found["std_msgs/msg/String"].encoding == "ros2msg"


@pytest.mark.parametrize("storage", STORAGES)
def test_seek_filter_and_backwards(tmp_path, storage):
    write(tmp_path / "bag", storage)
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    reader.set_filter(rosbag2_py.StorageFilter(topics=["/pose"]))
    reader.seek(START + 50 * MILLISECOND)
    moments = []
    while reader.has_next():
        topic, _, moment = reader.read_next()
        assert topic == "/pose"
        moments.append((moment - START - 5) // MILLISECOND)
    assert moments == [50, 60, 70, 80, 90]
    reader.reset_filter()
    reader.set_filter(rosbag2_py.StorageFilter(regex="/chat.*"))
    assert reader.set_read_order(rosbag2_py.ReadOrder(reverse=True))
    reader.seek(START + 2 * MILLISECOND)
    backwards = []
    while reader.has_next():
        backwards.append(reader.read_next()[2] - START)
    assert backwards == [2 * MILLISECOND, MILLISECOND, 0]


@pytest.mark.parametrize("order", ({}, {"reverse": True}, {"sort_by": rosbag2_py.ReadOrderSortBy.File}))
@pytest.mark.parametrize("storage", STORAGES)
def test_another_filter_goes_on_behind_the_message_that_was_read_last(tmp_path, storage, order):
    writer = write(tmp_path / "bag", storage, 0, close=False)
    said = [("/chatter", 1), ("/pose", 1), ("/chatter", 1), ("/pose", 1), ("/chatter", 1), ("/pose", 2)]
    for number, (topic, moment) in enumerate(said):
        writer.write(topic, serialize_message(String(data=str(number))), moment)
    writer.close()
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(tmp_path / "bag"))
    assert reader.set_read_order(rosbag2_py.ReadOrder(**order))
    numbers = list(range(len(said)))[:: -1 if order.get("reverse") else 1]

    def next_number() -> int:
        return int(deserialize_message(reader.read_next()[1], String).data)

    for place in range(1, len(said)):
        reader.reset_filter()
        reader.seek(2 if order.get("reverse") else 0)
        assert [next_number() for _ in range(place)] == numbers[:place]
        for wanted in ("/pose", "/chatter", "/pose"):  # each hears what comes behind the place, and nothing twice
            reader.set_filter(rosbag2_py.StorageFilter(topics=[wanted]))
            following = [number for number in numbers[place:] if said[number][0] == wanted]
            assert reader.has_next() == bool(following)
            if following:
                assert next_number() == following[0]
                place = numbers.index(following[0]) + 1
        reader.reset_filter()
        assert [next_number() for _ in numbers[place:]] == numbers[place:] and not reader.has_next()


def test_chunks_that_overlap_in_time_are_merged(tmp_path):
    writer = McapWriter(tmp_path / "bag_0.mcap")
    source = rosbag2_py.LocalMessageDefinitionSource()
    topic = rosbag2_py.TopicMetadata(0, "/chatter", "std_msgs/msg/String", "cdr")
    writer.create_topic(topic, source.get_full_text(topic.type))
    for first in (0, 5, 1):
        for number in range(first, first + 50, 7):
            writer.write("/chatter", b"\0\1\0\0", START + number, 0)
        writer.flush()
    writer.close()
    times = [moment for _, _, moment in read(tmp_path / "bag_0.mcap")]
    assert len(times) == 24 and times == sorted(times)


@pytest.mark.parametrize("storage", STORAGES)
def test_a_bag_splits_when_its_file_is_old_enough(tmp_path, storage):
    write(tmp_path / "bag", storage, 3500, max_bagfile_duration=1)
    names = sorted(path.name for path in (tmp_path / "bag").iterdir())
    assert names == [*(f"bag_{number}{SUFFIX[storage]}" for number in range(4)), "metadata.yaml"]
    metadata = MetadataIo().read_metadata(str(tmp_path / "bag"))
    assert [file.message_count for file in metadata.files] == [1101, 1101, 1101, 547]
    assert len(texts(read(tmp_path / "bag"))) == 3500


@pytest.mark.parametrize(("storage", "size"), (("mcap", 20_000), ("sqlite3", 90_000)))
def test_a_bag_splits_when_its_file_is_large_enough(tmp_path, storage, size):
    write(tmp_path / "bag", storage, 5000, max_bagfile_size=size)
    files = [path for path in (tmp_path / "bag").iterdir() if path.suffix == SUFFIX[storage]]
    assert len(files) > 2
    assert len(texts(read(tmp_path / "bag"))) == 5000


def test_a_snapshot_keeps_the_last_messages_only(tmp_path):
    writer = write(tmp_path / "bag", "mcap", 100, close=False, snapshot_mode=True, max_cache_size=200)
    assert read(tmp_path / "bag") == []
    assert writer.take_snapshot()
    kept = texts(read(tmp_path / "bag"))
    assert kept[-1] == "hi 99" and 2 < len(kept) < 20


# -- wrong input -------------------------------------------------------------------------------------------------------


def test_wrong_use_says_what_is_wrong(tmp_path):
    writer = rosbag2_py.SequentialWriter()
    with pytest.raises(RuntimeError, match=r"Bag is not open. Call open\(\) before writing"):
        writer.write("/x", b"", 0)
    writer = write(tmp_path / "bag", "mcap", close=False)
    with pytest.raises(RuntimeError, match=r"Topic '/nope' has not been created yet! Call 'create_topic' first"):
        writer.write("/nope", b"", 0)
    with pytest.raises(RuntimeError, match=r"Bag directory already exists .*can't overwrite existing bag"):
        write(tmp_path / "bag", "mcap")
    with pytest.raises(RuntimeError, match=r"No storage could be initialized"):
        write(tmp_path / "other", "rosbag_v2")
    with pytest.raises(RuntimeError, match=r"greater than 86016. Specified value of 5"):
        write(tmp_path / "small", "sqlite3", max_bagfile_size=5)
    with pytest.raises(RuntimeError, match=r"No storage could be initialized from the inputs"):
        read(tmp_path / "nothing")


@pytest.mark.parametrize("name", ("broken.mcap", "broken.db3"))
@pytest.mark.parametrize(
    "content", (b"", b"\x89MCAP0\r\n", b"SQLite format 3\0", b"hello" * 100, b"\x89MCAP0\r\n" + b"\xff" * 50)
)
def test_a_file_that_is_no_bag_is_refused_or_empty_but_never_a_traceback(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    try:
        assert read(tmp_path / name) == []
    except RuntimeError as error:
        assert str(error)


@pytest.mark.parametrize("damage", ("version: x", "{}", "[1, 2", "rosbag2_bagfile_information: 3"))
def test_a_damaged_metadata_file_is_told(tmp_path, damage):
    write(tmp_path / "bag", "mcap")
    (tmp_path / "bag" / "metadata.yaml").write_text(damage)
    with pytest.raises(RuntimeError, match=r"Exception on parsing info file"):
        read(tmp_path / "bag")


def test_qos_is_read_as_words_and_as_numbers():
    new = from_yaml("\n".join(yaml_lines([rosbag2_py.QoS(7).best_effort()])))
    old = from_yaml(
        "- history: 1\n  depth: 7\n  reliability: 2\n  durability: 2\n  deadline: {sec: 2147483647, nsec: 4294967295}\n"
        "  lifespan: {sec: 0, nsec: 0}\n  liveliness: 1\n  liveliness_lease_duration: {sec: 0, nsec: 0}\n"
        "  avoid_ros_namespace_conventions: false"
    )
    assert [each.profile.reliability for each in (*new, *old)] == [2, 2]
    assert old[0].profile.deadline == 0 and new[0].profile.depth == old[0].profile.depth == 7
    mixed = [rosbag2_py.QoS(1).best_effort(), rosbag2_py.QoS(1)]
    assert offer_for(mixed) == (rosbag2_py.QoS(), False)
    assert offer_for([rosbag2_py.QoS(1).transient_local()])[0].profile.durability == 1


# -- killed ------------------------------------------------------------------------------------------------------------


@pytest.mark.process
@pytest.mark.parametrize("storage", STORAGES)
def test_a_recording_that_was_killed_is_readable_at_once(tmp_path, storage):
    program = textwrap.dedent(f"""
        import os, sys, time
        sys.path[:0] = {sys.path!r}
        import rosbag2_py._writer
        rosbag2_py._writer.FLUSH_SECONDS = rosbag2_py._writer.SLOWER_PER_PIECE = 0.0
        from tests.bag import test_storage
        from pathlib import Path
        writer = test_storage.write(Path("bag"), {storage!r}, 300, close=False)
        os.kill(os.getpid(), 9)
    """)
    done = run([sys.executable, "-c", program], cwd=tmp_path)
    assert done.returncode == -9, done.stderr
    assert len(texts(read(tmp_path / "bag"))) == 300
    count = MetadataIo().read_metadata(str(tmp_path / "bag")).message_count
    assert count == 330


def test_a_cut_off_mcap_file_is_read_as_far_as_it_goes_and_reindex_leaves_it_as_it_is(tmp_path):
    writer = write(tmp_path / "bag", "mcap", 50, close=False)
    writer.flush()
    for number in range(50, 100):
        writer.write("/chatter", serialize_message(String(data=f"hi {number}")), START + number * MILLISECOND)
    writer.close()
    file = tmp_path / "bag" / "bag_0.mcap"
    whole = file.read_bytes()
    # The last chunk was begun only: its beginning, over what was the summary before it.
    at = whole.rindex(b"\x06", 0, whole.rindex(b"hi 50"))
    file.write_bytes(whole[: at + 400])
    (tmp_path / "bag" / "metadata.yaml").unlink()
    assert texts(read(file)) == [f"hi {number}" for number in range(50)]
    said: list[str] = []
    cut = file.read_bytes()
    log = lambda level, logger, text: said.append(f"{level} {logger} {text}")  # noqa: E731
    rosbag2_py.Reindexer(log).reindex(rosbag2_py.StorageOptions(str(tmp_path / "bag")))
    assert said[-1] == "INFO rosbag2_cpp Reindexing complete."
    assert file.read_bytes() == cut
    assert texts(read(tmp_path / "bag")) == [f"hi {number}" for number in range(50)]
    assert rosbag2_py.Info().read_metadata(str(tmp_path / "bag")).message_count == 55


@pytest.mark.parametrize("storage", STORAGES)
def test_reindex_makes_the_metadata_anew(tmp_path, storage):
    write(tmp_path / "bag", storage, 3500, max_bagfile_duration=1, custom_data={"robot": "小车"})
    path = tmp_path / "bag" / "metadata.yaml"
    before = yaml.safe_load(path.read_text(encoding="utf-8"))["rosbag2_bagfile_information"]
    path.unlink()
    rosbag2_py.Reindexer().reindex(rosbag2_py.StorageOptions(str(tmp_path / "bag")))
    after = yaml.safe_load(path.read_text(encoding="utf-8"))["rosbag2_bagfile_information"]
    # The real one adds up the durations of the files, and lists none of them.
    durations = sum(file["duration"]["nanoseconds"] for file in before["files"])
    assert after == {**before, "files": [], "duration": {"nanoseconds": durations}}


@pytest.mark.process
def test_a_bag_that_nobody_closed_is_closed_when_the_program_ends(tmp_path):
    program = textwrap.dedent(f"""
        import sys
        sys.path[:0] = {sys.path!r}
        from tests.bag import test_storage
        from pathlib import Path
        writer = test_storage.write(Path("bag"), "mcap", 20, close=False)
    """)
    assert run([sys.executable, "-c", program], cwd=tmp_path).returncode == 0
    assert len(texts(read(tmp_path / "bag"))) == 20


# -- the tools of others -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("storage", STORAGES)
def test_rosbags_reads_our_bags(tmp_path, storage):
    rosbags = pytest.importorskip("rosbags.highlevel")
    write(tmp_path / "bag", storage, 3500, max_bagfile_duration=1)
    with rosbags.AnyReader([tmp_path / "bag"]) as bag:
        assert bag.message_count == 3850
        assert {each.topic: each.msgtype for each in bag.connections}["/pose"] == "geometry_msgs/msg/PoseStamped"
        heard = [
            bag.deserialize(data, connection.msgtype).data
            for connection, _, data in bag.messages()
            if connection.topic == "/chatter"
        ]
    assert heard == [f"hi {number}" for number in range(3500)]


def test_mcap_ros2_support_decodes_our_bags_by_the_definitions_in_them(tmp_path):
    mcap_ros2 = pytest.importorskip("mcap_ros2.reader")
    write(tmp_path / "bag", "mcap")
    found = list(mcap_ros2.read_ros2_messages(str(tmp_path / "bag" / "bag_0.mcap")))
    assert len(found) == 110
    assert [each.ros_msg.data for each in found if each.channel.topic == "/chatter"][-1] == "hi 99"
    assert found[0].channel.metadata["offered_qos_profiles"].startswith("- history: keep_last\n")


@pytest.mark.parametrize("storage", STORAGES)
@pytest.mark.parametrize("version", (8, 9))
def test_we_read_the_bags_of_rosbags(tmp_path, storage, version):
    rosbags = pytest.importorskip("rosbags.rosbag2")
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    plugin = getattr(rosbags.StoragePlugin, storage.upper())
    with rosbags.Writer(tmp_path / "bag", version=version, storage_plugin=plugin) as writer:
        kind = store.types["sensor_msgs/msg/JointState"]
        connection = writer.add_connection("/joint_states", kind.__msgtype__, typestore=store)
        header = store.types["std_msgs/msg/Header"]
        stamp = store.types["builtin_interfaces/msg/Time"]
        numpy = pytest.importorskip("numpy")
        for number in range(20):
            message = kind(
                header=header(stamp=stamp(sec=number, nanosec=0), frame_id="base"),
                name=["left", "right"],
                position=numpy.array([number, -number], dtype=float),
                velocity=numpy.array([]),
                effort=numpy.array([]),
            )
            writer.write(connection, START + number, store.serialize_cdr(message, kind.__msgtype__))
    messages = read(tmp_path / "bag")
    last = deserialize_message(messages[-1][1], JointState)
    assert len(messages) == 20 and list(last.position) == [19.0, -19.0] and last.header.frame_id == "base"


# -- compression -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("storage", "mode"), [(storage, mode) for storage in STORAGES for mode in ("FILE", "MESSAGE")])
def test_compressed_bags_are_written_and_read(tmp_path, storage, mode):
    options = rosbag2_py.CompressionOptions("zstd", rosbag2_py.compression_mode_from_string(mode))
    writer = rosbag2_py.SequentialCompressionWriter(options)
    writer.open(rosbag2_py.StorageOptions(str(tmp_path / "bag"), storage_id=storage))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/chatter", "std_msgs/msg/String", "cdr"))
    for number in range(500):
        writer.write("/chatter", serialize_message(String(data="the same " * 20)), START + number)
    writer.close()
    metadata = MetadataIo().read_metadata(str(tmp_path / "bag"))
    assert (metadata.compression_mode, metadata.compression_format) == (mode, "zstd")
    assert texts(read(tmp_path / "bag")) == ["the same " * 20] * 500
    assert metadata.bag_size < 80_000


@pytest.mark.parametrize("preset", ("zstd_fast", "zstd_small"))
def test_chunks_can_be_compressed(tmp_path, preset):
    write(tmp_path / "bag", "mcap", storage_preset_profile=preset)
    assert len(read(tmp_path / "bag")) == 110
    rosbags = pytest.importorskip("rosbags.highlevel")
    with rosbags.AnyReader([tmp_path / "bag"]) as bag:
        assert sum(1 for _ in bag.messages()) == 110
