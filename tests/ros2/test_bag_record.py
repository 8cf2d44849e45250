"""`ros2 bag record`: what it says, what is in the bag then, and how it is steered."""

from __future__ import annotations

import re

import pytest
import yaml
from example_interfaces.action import Fibonacci
from rosbag2_interfaces.srv import IsPaused, Pause, Resume
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32

from day6_core.ros.distribution import NAMES
from rclpy.action import ActionServer
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.service_introspection import ServiceIntrospectionState
from tests.ros2.bag_commands import call, counter, information, lines, record
from tests.support.stepped_keyboard import Keyboard


def test_recording_says_what_the_real_recorder_says(machine):
    machine.node("counter", counter())
    command = record(machine, "--topics", "/count")
    assert command.stdout == "stdin is not a terminal device. Keyboard handling disabled.\n"
    assert lines(command.stderr) == [
        "[INFO] [rosbag2_recorder]: Press SPACE for pausing/resuming",
        "[INFO] [rosbag2_recorder]: Event publisher thread: Starting",
        "[INFO] [rosbag2_recorder]: Listening for topics...",
        "[INFO] [rosbag2_recorder]: Subscribed to topic '/count'",
        "[INFO] [rosbag2_recorder]: Recording...",
        "[INFO] [rosbag2_recorder]: All requested topics are subscribed. Stopping discovery...",
        "[INFO] [rosbag2_recorder]: Pausing recording.",
        "[INFO] [rosbag2_cpp]: Writing remaining messages from cache to the bag. It may take a while",
        "[INFO] [rosbag2_recorder]: Event publisher thread: Exiting",
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
    from day6_core.ros import ros2
    from day6_core.session.program import Program

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
        (("-e", "["), "argument -e/--regex: '[' is not a regular expression"),
        (("-a", "--storage-preset-profile", "quick"), "unknown mcap storage preset profile"),
        (("-a", "-b", "5"), "greater than 1024. Specified value of 5"),
    ):
        result = machine.ros2("bag", "record", "-o", "bag", "--disable-keyboard-controls", *words)
        assert answer in result.stderr and result.status != 0
        assert not (machine.cwd / "bag").exists()


@pytest.mark.parametrize("name", NAMES)
def test_old_style_topics_are_warned_of_in_kilted_and_refused_since_lyrical(machine, in_distribution, name):
    in_distribution(name)
    if name in ("lyrical", "rolling"):
        command = machine.ros2("bag", "record", "/count")
        assert command.status == 2 and "unrecognized arguments: /count" in command.stderr
        return
    machine.node("counter", counter())
    command = record(machine, "/count", seconds=0.5)
    assert command.stdout.startswith(
        '[WARN] [ros2bag]: Positional "topics" argument deprecated. Please use optional "--topics" argument instead.\n'
    ) == (name == "kilted")
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


# -- actions -----------------------------------------------------------------------------------------------------------


def counting_action(name="count_up", *, told=False):
    """A node with an action server that tells of its goals on the event topics, if `told`."""

    def build(node):
        node.server = ActionServer(node, Fibonacci, name, lambda goal: Fibonacci.Result())
        if told:
            node.server.configure_introspection(
                node.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.METADATA
            )

    return build


def topics_in(bag):
    if not bag.is_dir():
        return []
    content = yaml.safe_load((bag / "metadata.yaml").read_text(encoding="utf-8"))
    return sorted(
        each["topic_metadata"]["name"] for each in content["rosbag2_bagfile_information"]["topics_with_message_count"]
    )


REGEX = "[ERROR] [ros2bag]: --exclude-regex argument requires either"
OF_COUNT_UP = [f"/count_up/_action/{end}" for end in ("feedback", "status")]
EVENTS = [f"/count_up/_action/{end}/_service_event" for end in ("cancel_goal", "get_result", "send_goal")]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--actions", "/count_up"], sorted([*OF_COUNT_UP, *EVENTS])),
        (["--all-actions", "--exclude-actions", "/other"], sorted([*OF_COUNT_UP, *EVENTS])),
        (["--all-actions", "--exclude-regex", "o.her"], sorted([*OF_COUNT_UP, *EVENTS])),
        (["-e", "^/count_"], sorted([*OF_COUNT_UP, *EVENTS])),
        (["--all", "--exclude-actions", "/count_up", "/other"], ["/rosout"]),
        (["--all-topics"], ["/rosout"]),
        (["--all-services"], []),
    ],
)
def test_since_kilted_the_topics_of_actions_are_recorded_by_the_names_of_actions(
    machine, in_distribution, words, expected
):
    in_distribution("kilted")
    machine.node("server", counting_action(told=True))
    machine.node("another", counting_action("other"))
    record(machine, *words, seconds=0.5)
    names = topics_in(machine.cwd / "bag")
    assert [name for name in names if name not in ("/parameter_events", "/events/write_split")] == expected


def test_before_kilted_there_is_no_such_option(machine, in_distribution):
    in_distribution("jazzy")
    assert "unrecognized arguments: --all-actions" in machine.ros2("bag", "record", "--all-actions").stderr


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--all-topics", "--exclude-actions", "/a"],
         "[ERROR] [ros2bag]: --exclude-actions argument requires either --all, --all-actions or --regex"),
        (["--all-actions", "--actions", "/a"], "[WARN] [ros2bag]: --all or --all-actions will override --actions"),
        (["--all-actions", "-e", "x"],
         "[WARN] [ros2bag]: --all, --all-topics --all-services or --all-actions will override --regex"),
        (["--topics", "/t", "--exclude-regex", "x"],
         f"{REGEX} --all, --all-topics, --topic-types, --all-services, --all-actions or --regex"),
    ],
)  # fmt: skip
def test_since_kilted_options_of_actions_contradict_others(machine, in_distribution, words, text):
    in_distribution("kilted")
    (machine.cwd / "there").mkdir()
    result = machine.ros2("bag", "record", "-o", "there", *words)
    assert text in (result.stdout + result.stderr).splitlines()


def test_since_kilted_convert_chooses_actions_too(machine, in_distribution):
    in_distribution("kilted")
    machine.node("server", counting_action())
    record(machine, "--all-actions", seconds=0.5)
    for name, chosen in (("with", "all_actions: true"), ("without", "all_topics: true")):
        out = machine.cwd / f"{name}.yaml"
        out.write_text(f"output_bags:\n- uri: {name}\n  {chosen}\n", encoding="utf-8")
        assert machine.ros2("bag", "convert", "-i", "bag", "-o", out.name).status == 0
    assert topics_in(machine.cwd / "with") == OF_COUNT_UP
    assert topics_in(machine.cwd / "without") == []
