"""`ros2 bag …` on a stepped machine: what a student sees while recording and playing."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest
import rosbag2_py
import yaml
from geometry_msgs.msg import Twist
from rosbag2_interfaces.srv import Burst, GetRate, IsPaused, Pause, PlayNext, Resume, Seek, SetRate, Stop
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32, String

from day6_tui.core.session.streams import TextInput
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy


class Keyboard(TextInput):
    """A terminal whose user types what a test puts into `keys`."""

    def __init__(self):
        super().__init__("")
        from day6_tui.core.session.task import Signal

        self.keys = []
        self.typed = Signal()

    def isatty(self):
        return True

    def press(self, *keys):
        self.keys += keys
        self.typed.set()

    async def read_key(self):
        from day6_tui.core.session.task import wait_for

        while not self.keys:
            self.typed.clear()
            await wait_for(self.typed)
        return self.keys.pop(0)


def counter(topic="count", hertz=10.0, qos=10):
    """A node that publishes 0, 1, 2 … with so many messages a second."""

    def build(node):
        publisher = node.create_publisher(Int32, topic, qos)
        node.count = 0

        def tick():
            publisher.publish(Int32(data=node.count))
            node.count += 1

        node.timer = node.create_timer(1 / hertz, tick)

    return build


def lines(text: str) -> list[str]:
    """A log without its stamps."""
    return [re.sub(r"\[\d+\.\d{9}\] ", "", line) for line in text.splitlines()]


def record(machine, *words, seconds=2.05):
    command = machine.start("bag", "record", "-o", "bag", *words)
    for _ in range(round(seconds / 0.05)):
        command.step(0.05)
    command.interrupt()
    return command


def play(machine, *words):
    return machine.start("bag", "play", "bag", "--disable-keyboard-controls", *words)


def heard(machine, kind=Int32, topic="count", qos=100):
    found = []
    machine.node(f"ear_{topic.strip('/').replace('/', '_')}", lambda node: node.create_subscription(
        kind, topic, lambda message: found.append((machine.clock.steady_ns(), message)), qos
    ))  # fmt: skip
    return found


def wait_for_end(command, seconds=20.0):
    for _ in range(round(seconds / 0.01)):
        if command.status is not None:
            return
        command.step(0.01)
    raise AssertionError("it goes on and on")


def information(machine):
    return yaml.safe_load((machine.cwd / "bag" / "metadata.yaml").read_text())["rosbag2_bagfile_information"]


@pytest.fixture
def counted(machine):
    """A bag in which /count is published ten times a second for two seconds, and nobody who publishes any more."""
    node = machine.node("counter", counter())
    record(machine, "--topics", "/count")
    node.destroy_timer(node.timer)
    return machine


# -- recording ---------------------------------------------------------------------------------------------------------


def test_recording_says_what_the_real_recorder_says(machine):
    machine.node("counter", counter())
    command = record(machine, "--topics", "/count")
    assert command.stdout == "stdin is not a terminal device. Keyboard handling disabled.\n"
    assert lines(command.stderr) == [
        "[INFO] [rosbag2_recorder]: Press SPACE for pausing/resuming",
        "[INFO] [rosbag2_recorder]: Listening for topics...",
        "[INFO] [rosbag2_recorder]: Subscribed to topic '/count'",
        "[INFO] [rosbag2_recorder]: Recording...",
        "[INFO] [rosbag2_recorder]: All requested topics are subscribed. Stopping discovery...",
        "[INFO] [rosbag2_recorder]: Pausing recording.",
        "[INFO] [rosbag2_recorder]: Recording stopped",
    ]
    assert command.status == 0


@pytest.mark.parametrize("storage", ("mcap", "sqlite3"))
def test_every_message_is_in_the_bag_with_its_time_type_and_qos(machine, storage):
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    machine.node("counter", counter(qos=lasting))
    machine.node("other", counter("other"))
    record(machine, "--topics", "/count", "-s", storage)
    found = information(machine)
    (topic,) = found["topics_with_message_count"]
    assert (topic["topic_metadata"]["name"], topic["message_count"]) == ("/count", 20)
    assert topic["topic_metadata"]["type"] == "std_msgs/msg/Int32"
    assert topic["topic_metadata"]["type_description_hash"].startswith(
        "RIHS01_b6578ded3c58c626cfe8d1a6fb6e04f706f97e9f"
    )
    (profile,) = topic["topic_metadata"]["offered_qos_profiles"]
    assert (profile["durability"], profile["reliability"]) == ("transient_local", "reliable")
    assert found["storage_identifier"] == storage and found["duration"]["nanoseconds"] == 1_900_000_000


def test_all_topics_and_those_that_come_later_but_no_hidden_ones(machine):
    machine.node("counter", counter())
    machine.node("shy", counter("_secret"))
    command = machine.start("bag", "record", "-a", "-o", "bag")
    command.step(0.5)
    machine.node("late", counter("late"))
    machine.node("silent", lambda node: node.create_subscription(Int32, "nobody", print, 1))
    for _ in range(10):
        command.step(0.1)
    command.interrupt()
    names = [each["topic_metadata"]["name"] for each in information(machine)["topics_with_message_count"]]
    assert {"/count", "/late", "/rosout", "/parameter_events", "/events/write_split"} == set(names)
    assert "Hidden topics are not recorded. Enable them with --include-hidden-topics" in command.stderr


def test_regex_types_and_exclusion_choose_topics(machine):
    for name in ("front/scan", "rear/scan", "rear/odom"):
        machine.node(name.replace("/", "_"), counter(name))
    record(machine, "-e", "scan|odom", "--exclude-regex", "^/front", "--exclude-topics", "/rear/odom", seconds=0.5)
    (topic,) = information(machine)["topics_with_message_count"]
    assert topic["topic_metadata"]["name"] == "/rear/scan"


def test_space_pauses_and_resumes_the_recording(machine):
    machine.node("counter", counter())
    session = machine.session(["ros2", "bag", "record", "-o", "bag", "--topics", "/count"])
    keyboard = session.stdin = Keyboard()
    from day6_tui.core.ros import ros2
    from day6_tui.core.session.program import Program

    program = Program(session, ros2.main)
    for key in ("", " ", " ", ""):
        if key:
            keyboard.press(key)
        for _ in range(10):
            machine.step(0.1)
    session.interrupt()
    machine.step()
    assert program.status == 0
    assert information(machine)["message_count"] in (29, 30, 31)
    said = lines(session.stderr.text)
    pauses = [line for line in said if line.endswith(("Pausing recording.", "Resuming recording."))]
    assert [line.split(": ")[1] for line in pauses] == [
        "Pausing recording.",
        "Resuming recording.",
        "Pausing recording.",
    ]


def test_services_pause_split_and_tell_of_the_recorder(machine):
    machine.node("counter", counter())
    splits = []
    from rosbag2_interfaces.msg import WriteSplitEvent

    watcher = machine.node(
        "watcher", lambda node: node.create_subscription(WriteSplitEvent, "/events/write_split", splits.append, 1)
    )
    command = machine.start("bag", "record", "-o", "bag", "--topics", "/count")
    command.step(0.5)
    assert call(machine, watcher, IsPaused, "/rosbag2_recorder/is_paused").paused is False
    call(machine, watcher, Pause, "/rosbag2_recorder/pause")
    assert call(machine, watcher, IsPaused, "/rosbag2_recorder/is_paused").paused is True
    call(machine, watcher, Resume, "/rosbag2_recorder/resume")
    from rosbag2_interfaces.srv import SplitBagfile

    call(machine, watcher, SplitBagfile, "/rosbag2_recorder/split_bagfile")
    command.step(0.5)
    command.interrupt()
    assert information(machine)["relative_file_paths"] == ["bag_0.mcap", "bag_1.mcap"]
    assert splits[0].closed_file.endswith("bag_0.mcap") and splits[0].opened_file.endswith("bag_1.mcap")


_NONE = (
    "Need to specify at least one option out of --all, --all-topics, --all-services, --services, --topics, --topic-types "
    "or --regex"
)
_CLOCK = (
    "--use-sim-time and --no-discovery both set, but are incompatible settings. The /clock topic needs to be discovered to "
    "record with sim time."
)


@pytest.mark.parametrize(
    ("words", "answer"),
    (
        ((), _NONE),
        (("--topics", "/x", "--exclude-topics", "/y"),
         "--exclude-topics argument requires either --all, --all-topics, --topic-types or --regex"),
        (("-a", "--compression-format", "zstd"),
         "Invalid choice: Cannot specify compression format without a compression mode."),
        (("-a", "-o", "there"), "Output folder 'there' already exists."),
        (("-a", "--use-sim-time", "--no-discovery"), _CLOCK),
    ),
)  # fmt: skip
def test_options_that_do_not_fit_are_refused_in_the_words_of_ros2bag(machine, words, answer):
    (machine.cwd / "there").mkdir()
    result = machine.ros2("bag", "record", *words)
    assert (result.stderr, result.status) == (f"[ERROR] [ros2bag]: {answer}\n", 1)


def test_wrong_options_leave_no_folder_behind(machine):
    for words, answer in (
        (("-e", "["), "argument -e/--regex: '[' is no regular expression"),
        (("-a", "--storage-preset-profile", "quick"), "unknown mcap storage preset profile"),
        (("-a", "-b", "5"), "greater than 1024. Specified value of 5"),
    ):
        result = machine.ros2("bag", "record", "-o", "bag", "--disable-keyboard-controls", *words)
        assert answer in result.stderr and result.status != 0
        assert not (machine.cwd / "bag").exists()


def test_old_style_topics_are_taken_with_a_warning(machine):
    machine.node("counter", counter())
    command = record(machine, "/count", seconds=0.5)
    assert command.stdout.startswith(
        '[WARN] [ros2bag]: Positional "topics" argument deprecated. Please use optional "--topics" argument instead.\n'
    )
    assert information(machine)["message_count"] > 2


def test_a_bag_without_a_name_is_called_after_the_time(machine):
    machine.node("counter", counter())
    command = machine.start("bag", "record", "-a")
    command.step(0.2)
    command.interrupt()
    (folder,) = machine.cwd.iterdir()
    assert re.fullmatch(r"rosbag2_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d", folder.name)


def test_simulated_time_is_the_time_of_the_recording(machine):
    def clock(node):
        publisher = node.create_publisher(Clock, "/clock", 1)
        message = Clock()
        message.clock.sec = 100

        def tick():
            message.clock.sec += 1
            publisher.publish(message)

        node.create_timer(0.1, tick)

    machine.node("counter", counter())
    machine.node("simulator", clock)
    record(machine, "--topics", "/count", "--use-sim-time", seconds=1.0)
    assert 100 <= information(machine)["starting_time"]["nanoseconds_since_epoch"] / 1e9 < 120


# -- playing -----------------------------------------------------------------------------------------------------------


def test_a_bag_is_played_with_the_gaps_it_was_recorded_with(counted):
    found = heard(counted)
    command = play(counted)
    wait_for_end(command)
    assert [message.data for _, message in found] == list(range(20))
    gaps = [round((after - before) / 1e6) for (before, _), (after, _) in pairwise(found)]
    assert set(gaps) == {100}
    assert command.status == 0
    assert lines(command.stderr) == [
        "[INFO] [rosbag2_player]: Set rate to 1",
        "[INFO] [rosbag2_player]: Playback until timestamp: -1",
    ]


@pytest.mark.parametrize(("rate", "gap"), (("2", 50), ("0.5", 200)))
def test_the_rate_stretches_time(counted, rate, gap):
    found = heard(counted)
    wait_for_end(play(counted, "-r", rate))
    gaps = {round((after - before) / 1e6) for (before, _), (after, _) in pairwise(found)}
    assert gaps == {gap} and len(found) == 20


def test_offset_duration_remapping_and_choice(counted):
    other, own = heard(counted, topic="elsewhere"), heard(counted)
    wait_for_end(play(counted, "--start-offset", "0.5", "--playback-duration", "0.45", "--remap", "/count:=/elsewhere"))
    assert [message.data for _, message in other] == [5, 6, 7, 8, 9]
    wait_for_end(play(counted, "--topics", "/nothing"))
    wait_for_end(play(counted, "--exclude-topics", "/count"))
    assert own == []


def test_a_loop_begins_again_until_it_is_interrupted(counted):
    found = heard(counted)
    command = play(counted, "--loop", "-r", "10")
    for _ in range(100):
        command.step(0.01)
    command.interrupt()
    data = [message.data for _, message in found]
    assert data[:41] == [*range(20), *range(20), 0]
    assert command.status == 0 and "Stopping playback." in command.stderr


def test_the_clock_is_published_when_asked_for(counted):
    times = heard(counted, Clock, "/clock", QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT))
    wait_for_end(play(counted, "--clock", "100"))
    seconds = [message.clock.sec + message.clock.nanosec / 1e9 for _, message in times]
    assert len(seconds) == pytest.approx(190, abs=3)
    assert seconds == sorted(seconds) and seconds[-1] - seconds[0] == pytest.approx(1.89, abs=0.03)


def test_recorded_qos_is_offered_again(machine):
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node = machine.node("counter", counter(qos=lasting))
    record(machine, "--topics", "/count", seconds=0.5)
    node.destroy_node()
    play(machine, "--start-paused")
    (offer,) = machine.node("watcher").get_publishers_info_by_topic("/count")
    assert offer.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL


def test_qos_can_be_overridden_by_a_file(counted):
    (counted.cwd / "qos.yaml").write_text("/count:\n  reliability: best_effort\n  depth: 3\n  history: keep_last\n")
    command = play(counted, "--start-paused", "--qos-profile-overrides-path", "qos.yaml")
    *_, offer = counted.node("watcher").get_publishers_info_by_topic("/count")
    assert offer.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert "Overriding QoS profile for topic /count" in command.stderr
    (counted.cwd / "qos.yaml").write_text("/count:\n  colour: red\n")
    result = counted.ros2("bag", "play", "bag", "--qos-profile-overrides-path", "qos.yaml")
    assert result.stderr == "[ERROR] [ros2bag]: Unexpected key `colour` for QoS profile.\n"


def call(machine, node, service, name, **fields):
    future = node.create_client(service, name).call_async(service.Request(**fields))
    for _ in range(100):
        machine.step(0.001)
        if future.done():
            return future.result()
    raise AssertionError(f"no answer from {name}")


def test_services_steer_the_player(counted):
    found = heard(counted)
    watcher = counted.node("watcher")
    command = play(counted, "--start-paused")
    command.step(1.0)
    assert found == []

    def ask(service, name, **fields):
        return call(counted, watcher, service, f"/rosbag2_player/{name}", **fields)

    assert ask(IsPaused, "is_paused").paused
    assert ask(PlayNext, "play_next").success and ask(PlayNext, "play_next").success
    assert ask(Burst, "burst", num_messages=3).actually_burst == 3
    assert [message.data for _, message in found] == [0, 1, 2, 3, 4]
    start = information(counted)["starting_time"]["nanoseconds_since_epoch"]
    request = Seek.Request()
    request.time.sec, request.time.nanosec = divmod(start + 1_450_000_000, 1_000_000_000)
    assert ask(Seek, "seek", time=request.time).success
    assert ask(SetRate, "set_rate", rate=5.0).success and not ask(SetRate, "set_rate", rate=-1.0).success
    assert ask(GetRate, "get_rate").rate == 5.0
    ask(Resume, "resume")
    assert not ask(PlayNext, "play_next").success
    command.step(0.03)
    assert [message.data for _, message in found][5:] == [15, 16]
    ask(Stop, "stop")
    command.step(0.1)
    assert command.status == 0 and len(found) <= 8


def test_keys_steer_the_player_and_the_progress_is_shown(counted):
    found = heard(counted)
    from day6_tui.core.ros import ros2
    from day6_tui.core.session.program import Program

    session = counted.session(["ros2", "bag", "play", "bag"])
    keyboard = session.stdin = Keyboard()
    session.stdout.isatty = lambda: True
    program = Program(session, ros2.main)
    counted.step(0.25)
    for keys, expected in (((" ",), 3), (("\x1b[C", "\x1b[C"), 5), (("\x1b[A", "\x1b[A", "\x1b[B"), 5)):
        keyboard.press(*keys)
        counted.step(0.4)
        assert len(found) == expected
    assert "[P]" in session.stdout.text and "====== Playback Progress ======" in session.stdout.text
    keyboard.press(" ")
    for _ in range(200):
        counted.step(0.01)
    assert program.status == 0 and len(found) == 20
    said = lines(session.stderr.text)
    rates = [line.rpartition(" ")[2] for line in said if "Set rate" in line]
    assert rates == ["1", "1.1", "1.2", "1.1"]
    assert "[INFO] [rosbag2_player]: Press CURSOR_RIGHT for Play Next Message" in said
    assert re.search(r"Duration 1\.90/1\.90 \[S\]", session.stdout.text)


def test_burst_sends_messages_at_once_and_stays_paused(counted):
    found = heard(counted)
    command = counted.start("bag", "burst", "bag", "-n", "7")
    command.step(1.0)
    assert [message.data for _, message in found] == list(range(7)) and command.status is None
    assert "Burst 7 messages." in command.stderr
    command.interrupt()


def test_two_bags_are_played_as_one(machine):
    for name in ("even", "odd"):
        writer = rosbag2_py.SequentialWriter()
        writer.open(rosbag2_py.StorageOptions(str(machine.cwd / name)))
        writer.create_topic(rosbag2_py.TopicMetadata(0, "/word", "std_msgs/msg/String", "cdr"))
        from rclpy.serialization import serialize_message

        for number in range(name == "odd", 10, 2):
            writer.write("/word", serialize_message(String(data=str(number))), number * 1_000_000)
        writer.close()
    found = heard(machine, String, "word")
    command = machine.start("bag", "play", "-i", "even", "-i", "odd", "--disable-keyboard-controls")
    wait_for_end(command)
    assert [message.data for _, message in found] == list("0123456789")


def test_a_type_that_is_unknown_here_is_left_out_and_said(machine):
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(machine.cwd / "bag")))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/strange", "my_msgs/msg/Thing", "cdr"))
    writer.write("/strange", b"\0\1\0\0\1\0\0\0", 5)
    writer.close()
    command = play(machine)
    wait_for_end(command)
    assert "Ignoring a topic '/strange', reason: " in command.stderr and command.status == 0


# -- the other verbs ---------------------------------------------------------------------------------------------------


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
    assert information(counted) == before


def test_convert_writes_the_bag_with_another_storage_and_fewer_topics(machine):
    machine.node("counter", counter())
    machine.node("other", counter("other"))
    record(machine, "--topics", "/count", "/other", seconds=1.0)
    (machine.cwd / "out.yaml").write_text(
        "output_bags:\n- uri: converted\n  storage_id: sqlite3\n  topics: [/count]\n- uri: everything\n  all: true\n"
    )
    result = machine.ros2("bag", "convert", "-i", "bag", "-o", "out.yaml")
    assert (result.stderr, result.status) == ("", 0)
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
