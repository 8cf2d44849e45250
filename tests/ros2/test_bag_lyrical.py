"""What `ros2 bag` has since Lyrical: a recorder that starts and stops by services, fewer files, repeated topics, times."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import rosbag2_interfaces.srv
import rosbag2_py
from builtin_interfaces.msg import Time
from rosbag2_py import _lost_messages
from rosbag2_py._lost_messages import LostMessages
from std_msgs.msg import Int32, String

from day6_core.interfaces import get_interface, registry
from rclpy.event_handler import QoSMessageLostInfo
from rclpy.qos import DurabilityPolicy, QoSProfile
from tests.ros2.bag_commands import call, counted_bag, counter, heard, information, lines, record

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture(autouse=True)
def lyrical(in_distribution, monkeypatch):
    """Lyrical, with its texts of the services that were others before."""
    in_distribution("lyrical")
    for name in ("Resume", "SplitBagfile", "Stop"):
        for store in (registry._structures, registry._classes, registry.hashes):
            for key in [key for key in store if key.startswith(f"rosbag2_interfaces/srv/{name}")]:
                monkeypatch.delitem(store, key)
        monkeypatch.delattr(rosbag2_interfaces.srv, name, raising=False)


def service(name):
    return get_interface(f"rosbag2_interfaces/srv/{name}")


def asked(machine, node, kind, name, **fields):
    answer = call(machine, node, service(kind), f"/rosbag2_recorder/{name}", **fields)
    return answer.return_code, answer.error_string


def later(machine, seconds):
    moment = machine.clock.now_ns() + round(seconds * 1e9)
    return Time(sec=moment // 10**9, nanosec=moment % 10**9)


def said(folder):
    reader = rosbag2_py.SequentialReader()
    reader.open_uri(str(folder))
    found = []
    while reader.has_next():
        found.append(reader.read_next_message())
    return found


def latched(node):
    node.latched = node.create_publisher(String, "map", LATCHED)
    node.latched.publish(String(data="the map"))


def test_a_recorder_stops_and_starts_again_elsewhere_and_answers_how_it_went(machine):
    machine.node("counter", counter())
    asker = machine.node("asker", lambda node: node)
    command = machine.start("bag", "record", "-o", "bag", "--topics", "/count")
    command.step(0.5)
    assert asked(machine, asker, "Record", "record") == (1, "Called record(uri) while already in recording.")
    assert asked(machine, asker, "Stop", "stop") == (0, "")
    assert asked(machine, asker, "Stop", "stop") == (1, "Recorder is already stopped.")
    assert asked(machine, asker, "SplitBagfile", "split_bagfile")[0] == 1
    assert asked(machine, asker, "StartDiscovery", "start_discovery") == (1, "Recorder is not currently recording.")
    first = information(machine)["message_count"]
    command.step(0.5)
    assert information(machine)["message_count"] == first > 0
    assert asked(machine, asker, "Record", "record", uri="") == (0, "")
    command.step(0.3)
    command.interrupt()
    assert command.status == 0
    (again,) = machine.cwd.glob("bag(1)")
    assert 0 < len(said(again)) < first
    log = lines(command.stderr)
    assert "[INFO] [rosbag2_recorder]: Starting recording to 'bag'" in "\n".join(log).replace(f"{machine.cwd}/", "")
    assert sum("Recording stopped" in line for line in log) == 2
    assert any("Received Stop request while not in recording. Ignoring request." in line for line in log)


def test_new_topics_are_looked_for_only_while_discovery_runs(machine):
    machine.node("counter", counter())
    asker = machine.node("asker", lambda node: node)
    command = machine.start(
        "bag", "record", "-o", "bag", "--all-topics", "--exclude-regex", "/(rosout|parameter_events|events)"
    )
    command.step(0.3)

    def running():
        return call(machine, asker, service("IsDiscoveryRunning"), "/rosbag2_recorder/is_discovery_running").running

    assert running()
    assert asked(machine, asker, "StartDiscovery", "start_discovery") == (1, "Discovery is already running.")
    assert asked(machine, asker, "StopDiscovery", "stop_discovery") == (0, "")
    assert asked(machine, asker, "StopDiscovery", "stop_discovery") == (1, "Discovery is not running.")
    assert not running()
    machine.node("late", counter("late"))
    command.step(0.5)
    assert "'/late'" not in command.stderr
    assert asked(machine, asker, "StartDiscovery", "start_discovery") == (0, "")
    command.step(0.3)
    assert "Subscribed to topic '/late'" in command.stderr
    command.interrupt()


def test_recording_resuming_and_splitting_can_wait_for_a_time(machine):
    machine.node("counter", counter())
    asker = machine.node("asker", lambda node: node)
    command = machine.start("bag", "record", "-o", "bag", "--topics", "/count", "--start-paused")
    command.step(0.3)
    assert asked(machine, asker, "Resume", "resume", resume_time=later(machine, 0.5)) == (0, "")
    command.step(0.4)
    assert "Resuming" not in command.stderr
    command.step(0.2)
    assert "Resuming recording." in command.stderr
    moment = later(machine, 0.55)
    assert asked(
        machine, asker, "SplitBagfile", "split_bagfile", split_time=moment, split_mode=2, tracking_topic_name="count"
    ) == (0, "")
    assert asked(machine, asker, "SplitBagfile", "split_bagfile", split_mode=7) == (
        2,
        "Invalid split_mode for SplitBagfile request.",
    )
    assert (
        asked(
            machine, asker, "SplitBagfile", "split_bagfile", split_mode=1, split_time=moment, tracking_topic_name="1 x"
        )[0]
        == 3
    )
    command.step(1.0)
    assert asked(machine, asker, "Stop", "stop") == (0, "")
    first, second = information(machine)["files"]
    last = first["starting_time"]["nanoseconds_since_epoch"] + first["duration"]["nanoseconds"]
    due = moment.sec * 10**9 + moment.nanosec
    assert due <= last < due + 150_000_000 and second["message_count"] > 2
    assert asked(machine, asker, "Record", "record", uri=str(machine.cwd / "next"), start_time=later(machine, 0.3)) == (
        0,
        "",
    )
    command.step(0.2)
    assert not (machine.cwd / "next").exists()
    command.step(0.3)
    assert (machine.cwd / "next").exists()
    command.interrupt()


def test_only_the_last_files_stay(machine):
    machine.node("counter", counter(hertz=100.0))
    command = record(machine, "--topics", "/count", "-d", "1", "--max-bag-files", "2", seconds=5.1)
    found = information(machine)
    names = sorted(path.name for path in (machine.cwd / "bag").glob("*.mcap"))
    assert len(names) == 2 and names == sorted(found["relative_file_paths"]) and names[0].startswith(("3_", "4_"))
    messages = said(machine.cwd / "bag")
    assert len(messages) == found["message_count"] == found["topics_with_message_count"][0]["message_count"] < 250
    assert found["starting_time"]["nanoseconds_since_epoch"] == messages[0].received_ns
    assert "[INFO] [rosbag2_cpp]: Deleted oldest bagfile: 0_bag_" in "\n".join(lines(command.stderr))


@pytest.mark.parametrize("words", (["--repeat-transient-local", "/map"], ["--repeat-all-transient-local"]))
def test_each_file_begins_with_the_last_messages_of_latched_topics(machine, words):
    machine.node("counter", counter())
    machine.node("mapper", latched)
    command = record(machine, "--topics", "/count", "/map", "-d", "1", *words, seconds=3.5)
    assert "Subscribed to topic '/map' (repeat-transient-local, depth=1)" in command.stderr
    found = information(machine)
    assert len(found["files"]) == 4
    for before, file in zip(found["files"], found["files"][1:], strict=False):
        messages = said(machine.cwd / "bag" / file["path"])
        last = before["starting_time"]["nanoseconds_since_epoch"] + before["duration"]["nanoseconds"]
        assert (messages[0].topic, messages[0].received_ns) == ("/map", last)
        assert {each.topic for each in messages[1:]} == {"/count"}


def test_a_snapshot_has_seconds_and_what_is_latched(machine):
    machine.node("counter", counter())
    machine.node("mapper", latched)
    asker = machine.node("asker", lambda node: node)
    words = (
        "--snapshot-mode",
        "--max-cache-size",
        "0",
        "--max-cache-duration",
        "1",
        "--repeat-transient-local",
        "/map=2",
    )
    command = machine.start("bag", "record", "-o", "bag", "--topics", "/count", "/map", *words)
    command.step(3.0)
    assert call(machine, asker, service("Snapshot"), "/rosbag2_recorder/snapshot").success
    command.interrupt()
    messages = said(machine.cwd / "bag")
    assert messages[0].topic == "/map" and messages[0].received_ns == messages[1].received_ns
    assert 900_000_000 < messages[-1].received_ns - messages[0].received_ns <= 1_000_000_000


def test_static_topics_are_recorded_before_anybody_publishes_them(machine):
    (machine.cwd / "topics.yaml").write_text("static_topics_and_types_list:\n - [count, std_msgs/msg/Int32]\n")
    command = machine.start("bag", "record", "-o", "bag", "--static-topics-path", "topics.yaml")
    command.step(0.2)
    assert "Subscribed to topic '/count'" in command.stderr and "Listening for topics" not in command.stderr
    machine.node("counter", counter())
    command.step(1.0)
    command.interrupt()
    assert information(machine)["message_count"] > 8
    for number, text in enumerate(
        ("other: 1\n", "static_topics_and_types_list: 5\n", "static_topics_and_types_list: [a]\n", "[\n")
    ):
        (machine.cwd / "topics.yaml").write_text(text)
        command = machine.start("bag", "record", "-o", f"bag{number}", "-a", "--static-topics-path", "topics.yaml")
        command.step(0.1)
        command.interrupt()
        assert "Failed to read static topics list: " in command.stderr and command.status == 0


def lost_messages(count):
    info = QoSMessageLostInfo()
    info.total_count_change = count
    return info


@pytest.mark.parametrize("seconds_since_boot", [1.0, 1e6])
def test_lost_messages_are_told_on_a_topic_not_too_often_and_at_the_end(machine, monkeypatch, seconds_since_boot):
    monkeypatch.setattr(_lost_messages, "time", SimpleNamespace(monotonic=lambda: seconds_since_boot))
    told = heard(machine, get_interface("rosbag2_interfaces/msg/MessagesLostEvent"), "/events/rosbag2_messages_lost")
    node = machine.node("recorder", lambda node: node)
    lost = LostMessages(node, 0.001)
    lost.offer()
    lose = {topic: lost.events_of(topic)["event_callbacks"].message_lost for topic in ("/a", "/b")}
    lose["/a"](lost_messages(2))
    lose["/b"](lost_messages(1))
    lost.tell()
    lose["/a"](lost_messages(1))
    lost.tell()
    machine.step(0.01)
    ((_, event),) = told
    assert event.node_name == "/recorder"
    assert [(each.topic_name, each.messages_lost_in_transport) for each in event.messages_lost_statistics] == [
        ("/a", 2),
        ("/b", 1),
    ]
    assert lost.report() == "Number of messages lost on the transport layer: 4"
    assert lost.report() == ""


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["--stats_max_publishing_rate", "1001"], "stats_max_publishing_rate must be between 0 and 1000."),
        (["--max-cache-duration=-1"], "max_cache_duration must be a non-negative integer."),
        (["--max-cache-size", "4294967296"], "max_cache_size must not exceed 4294967295 bytes (~4 GiB, uint32_t max)."),
        (
            ["--snapshot-mode", "--max-cache-size", "0"],
            "In snapshot mode, either the max_cache_duration or max_cache_size shall not be set to zero.",
        ),
        (
            ["--repeat-transient-local", "/map=x"],
            'Invalid depth for --repeat-transient-local: "/map=x". Depth must be a positive integer.',
        ),
        (
            ["--repeat-transient-local", "/map=0"],
            'Invalid depth for --repeat-transient-local: "/map=0". Depth must be greater than 0.',
        ),
        (
            ["--repeat-transient-local", "=1"],
            'Invalid value for --repeat-transient-local: "=1". Topic name must not be empty.',
        ),
    ],
)
def test_values_that_make_no_sense_are_refused(machine, words, error):
    result = machine.ros2("bag", "record", "-a", "-o", "bag", *words)
    assert (result.stderr, result.status) == (f"[ERROR] [ros2bag]: {error}\n", 1)


def test_a_part_of_a_bag_is_read_by_the_options_of_the_input(machine):
    counted_bag(machine)
    found = said(machine.cwd / "bag")
    (machine.cwd / "in.yaml").write_text(f"input_bags:\n- {{uri: bag, start_time_ns: {found[5].received_ns}}}\n")
    (machine.cwd / "out.yaml").write_text("output_bags:\n- {uri: part, all_topics: true}\n")
    result = machine.ros2("bag", "convert", "--input-options", "in.yaml", "-o", "out.yaml")
    assert result.status == 0, result.stderr
    assert [each.received_ns for each in said(machine.cwd / "part")] == [each.received_ns for each in found[5:]]
    (machine.cwd / "in.yaml").write_text("input_bags:\n- {uri: gone}\n")
    result = machine.ros2("bag", "convert", "--input-options", "in.yaml", "-o", "out.yaml")
    assert result.status == 1 and "Bag path 'gone' does not exist!" in result.stderr
    both = machine.ros2("bag", "convert", "-i", "bag", "--input-options", "in.yaml", "-o", "out.yaml")
    assert both.status == 2 and "not allowed with argument" in both.stderr


def test_options_of_later_are_no_attributes_before(machine, in_distribution):
    storage, options = rosbag2_py.StorageOptions(uri="a", max_bag_files=2), rosbag2_py.RecordOptions()
    options.static_topics_uri = "x.yaml"
    in_distribution("kilted")
    for value, name in ((storage, "max_bag_files"), (options, "repeat_transient_local_messages")):
        with pytest.raises(AttributeError, match=name):
            setattr(value, name, 1)
    assert isinstance(Int32(), Int32)
