"""The options of `ros2 bag`: what is refused, in which words, and what each option leads to."""

from __future__ import annotations

import pytest
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32

from rclpy.qos import QoSProfile, ReliabilityPolicy
from tests.ros2.bag_commands import counter, heard, information, play, record, wait_for_end

# -- values that the parser refuses ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["play", "--rate", "x"], "argument -r/--rate: x is not the valid type (float)"),
        (["play", "--rate", "0"], "argument -r/--rate: 0 is not in the valid range (> 0.0)"),
        (["play", "--rate=-1"], "argument -r/--rate: -1 is not in the valid range (> 0.0)"),
        (["play", "--start-offset=-0.5"], "argument --start-offset: Value -0.5 is less than zero."),
        (["play", "--start-offset", "x"], "argument --start-offset: x is not the valid type (float)"),
        (["play", "--wait-for-all-acked=-1"], "argument --wait-for-all-acked: Value -1 is less than zero."),
        (["play", "--wait-for-all-acked", "1.5"], "argument --wait-for-all-acked: 1.5 is not the valid type (int)"),
        (["play", "--clock", "0"], "argument --clock: invalid positive_float value: '0'"),
        (["play", "--clock", "x"], "argument --clock: invalid positive_float value: 'x'"),
        (["play", "--delay=-2"], "argument -d/--delay: invalid positive_float value: '-2'"),
        (["burst", "-n", "x"], "argument -n/--num-messages: x is not the valid type (int)"),
        (["burst", "--num-messages=-1"], "argument -n/--num-messages: Value -1 is less than zero."),
        (["play", "nothing"], "argument bag_path: Bag path 'nothing' does not exist!"),
        (["info", "nothing"], "argument bag_path: Bag path 'nothing' does not exist!"),
        *(
            (
                [verb, option, "no.yaml"],
                f"argument {option}: can't open 'no.yaml': [Errno 2] No such file or directory: 'no.yaml'",
            )
            for verb, option in (
                ("record", "--qos-profile-overrides-path"),
                ("play", "--qos-profile-overrides-path"),
                ("burst", "--qos-profile-overrides-path"),
                ("record", "--storage-config-file"),
                ("play", "--storage-config-file"),
            )
        ),
        (["play", "-e", "("], "argument -e/--regex: '(' is not a regular expression"),
    ],
)
def test_values_that_make_no_sense_are_refused_by_the_parser(machine, words, error):
    result = machine.ros2("bag", *words)
    assert result.status == 2
    assert f"ros2 bag {words[0]}: error: {error}" in result.stderr


@pytest.mark.parametrize("words", [["--rate", "0.01"], ["--start-offset", "0"], ["--wait-for-all-acked", "0"]])
def test_the_smallest_values_are_taken(machine, words):
    assert "Must specify exactly one of a bag path" in machine.ros2("bag", "play", *words).stderr


# -- options that do not fit together ----------------------------------------------------------------------------------

EXCLUDE = ("exclude-regex", "exclude-topics", "exclude-topic-types", "exclude-services")
CHOICE = {
    "all": [],
    "all-topics": [],
    "all-services": [],
    "services": ["/s"],
    "topics": ["/t"],
    "topic-types": ["a/msg/B"],
    "regex": ["x"],
}
FITS = {
    "exclude-regex": {"all", "all-topics", "topic-types", "all-services", "regex"},
    "exclude-topics": {"all", "all-topics", "topic-types", "regex"},
    "exclude-topic-types": {"all", "all-topics", "topic-types", "regex"},
    "exclude-services": {"all", "all-services", "regex"},
}
REQUIRES = {
    "exclude-regex": "either --all, --all-topics, --topic-types, --all-services or --regex",
    "exclude-topics": "either --all, --all-topics, --topic-types or --regex",
    "exclude-topic-types": "either --all, --all-topics or --regex",
    "exclude-services": "either --all, --all-services or --regex",
}


def option(name, values):
    return [f"--{name}", *values]


@pytest.mark.parametrize("exclude", EXCLUDE)
@pytest.mark.parametrize("choice", CHOICE)
def test_what_is_excluded_must_be_part_of_what_is_chosen(machine, exclude, choice):
    # The folder is there already: what passes this check is refused by the next one.
    (machine.cwd / "there").mkdir()
    result = machine.ros2("bag", "record", "-o", "there", *option(choice, CHOICE[choice]), *option(exclude, ["y"]))
    refusal = f"[ERROR] [ros2bag]: --{exclude} argument requires {REQUIRES[exclude]}\n"
    taken = "[ERROR] [ros2bag]: Output folder 'there' already exists.\n"
    assert (result.stderr, result.status) == (taken if choice in FITS[exclude] else refusal, 1)


@pytest.mark.parametrize("choice", CHOICE)
def test_each_choice_is_enough_to_record(machine, choice):
    (machine.cwd / "there").mkdir()
    result = machine.ros2("bag", "record", "-o", "there", *option(choice, CHOICE[choice]))
    assert result == ("", "[ERROR] [ros2bag]: Output folder 'there' already exists.\n", 1)


@pytest.mark.parametrize(
    ("words", "warnings"),
    [
        (["--all", "--services", "/s"], ["--all or --all-services will override --services"]),
        (["--all-services", "--services", "/s"], ["--all or --all-services will override --services"]),
        (["--all", "--topics", "/t"], ["--all or --all-topics will override --topics"]),
        (["--all-topics", "--topics", "/t"], ["--all or --all-topics will override --topics"]),
        (["--all-topics", "-e", "x"], ["--all, --all-topics or --all-services will override --regex"]),
        (["--all-services", "-e", "x"], ["--all, --all-topics or --all-services will override --regex"]),
        (["--all-services", "--topics", "/t"], []),
        (
            ["-a", "--topics", "/t", "--services", "/s"],
            ["--all or --all-services will override --services", "--all or --all-topics will override --topics"],
        ),
    ],
)
def test_what_a_stronger_option_overrides_is_said(machine, words, warnings):
    (machine.cwd / "there").mkdir()
    result = machine.ros2("bag", "record", "-o", "there", *words)
    assert result.stdout.splitlines() == [f"[WARN] [ros2bag]: {warning}" for warning in warnings]


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["--compression-queue-size=-1"], "Compression queue size must be at least 0."),
        (
            ["--compression-format", "zstd"],
            "Invalid choice: Cannot specify compression format without a compression mode.",
        ),
        (["--qos-profile-overrides-path", "list.yaml"], None),
        (["--qos-profile-overrides-path", "broken.yaml"], None),
    ],
)
def test_wrong_ways_to_write_are_refused_and_leave_nothing(machine, words, error):
    (machine.cwd / "list.yaml").write_text("/count: [1]\n")
    (machine.cwd / "broken.yaml").write_text("/count: [\n")
    result = machine.ros2("bag", "record", "-a", "-o", "bag", *words)
    assert result.status == 1 and result.stderr.startswith("[ERROR] [ros2bag]: ")
    assert error is None or result.stderr == f"[ERROR] [ros2bag]: {error}\n"
    assert not (machine.cwd / "bag").exists()


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ([], "Must specify exactly one of a bag path and --input"),
        (["bag", "-i", "bag"], "Must specify exactly one of a bag path and --input"),
        (["-i", "bag", "mcap", "x"], "--input expects 1 or 2 arguments, 3 provided"),
        (["-i", "gone"], "Bag path 'gone' does not exist!"),
    ],
)
def test_what_cannot_be_played_is_refused(counted, words, error):
    assert counted.ros2("bag", "play", *words)[1:] == (f"[ERROR] [ros2bag]: {error}\n", 1)


def test_three_words_are_no_input_of_convert(counted):
    (counted.cwd / "out.yaml").write_text("output_bags: [{uri: other, all_topics: true}]\n")
    result = counted.ros2("bag", "convert", "-i", "bag", "mcap", "x", "-o", "out.yaml")
    assert result == ("", "--input expects 1 or 2 arguments, 3 provided\n", 1)
    assert counted.ros2("bag", "convert", "-i", "bag", "mcap", "-o", "out.yaml").status == 0
    assert "Messages:          20\n" in counted.ros2("bag", "info", "other").stdout


def test_only_a_folder_can_be_indexed_anew(counted):
    result = counted.ros2("bag", "reindex", "bag/bag_0.mcap")
    assert result == ("", "[ERROR] [ros2bag]: Must specify a bag directory\n", 1)


# -- info, list --------------------------------------------------------------------------------------------------------


def two_topics(machine):
    """A bag with 20 messages on /a and 10 on /b, of which nobody publishes any more."""
    nodes = [machine.node(name, counter(name, hertz)) for name, hertz in (("a", 10.0), ("b", 5.0))]
    record(machine, "--topics", "/b", "/a")
    for node in nodes:
        node.destroy_timer(node.timer)


def test_topics_are_sorted_by_name_or_by_count(machine):
    two_topics(machine)
    assert machine.ros2("bag", "info", "bag", "-t").stdout == "/a\n/b\n"
    assert machine.ros2("bag", "info", "bag", "-t", "--sort", "count").stdout in ("/b\n/a\n", "/a\n/b\n")
    text = machine.ros2("bag", "info", "bag").stdout
    assert text.index("/a | Type: std_msgs/msg/Int32 | Count: 20") < text.index(
        "/b | Type: std_msgs/msg/Int32 | Count: 10"
    )


def test_verbose_is_stronger_than_topic_names(machine):
    two_topics(machine)
    both = machine.ros2("bag", "info", "bag", "-t", "-v").stdout
    verbose = machine.ros2("bag", "info", "bag", "-v").stdout
    warning = "Warning! You have set both the '-t' and '-v' parameters. The '-t' parameter will be ignored.\n"
    assert both == warning + verbose and "Size Contribution" in verbose


@pytest.mark.parametrize(
    ("kind", "names"),
    [("storage", "mcap\nsqlite3\n"), ("converter", ""), ("compressor", "zstd\n"), ("decompressor", "zstd\n")],
)
def test_plugins_are_listed_by_kind(machine, kind, names):
    assert machine.ros2("bag", "list", kind) == (names, "", 0)
    verbose = machine.ros2("bag", "list", kind, "-v").stdout.splitlines()
    assert verbose[0] == f"available {kind} plugins are:"
    assert [line[6:] for line in verbose if line.startswith("name: ")] == names.split()
    assert sum(line.startswith("\ttype: ") for line in verbose) == len(names.split())


def test_bags_are_offered_by_tab(machine):
    for folder in ("a", "deep/b", "deep/c", "nothing"):
        (machine.cwd / folder).mkdir(parents=True)
    (machine.cwd / "a" / "metadata.yaml").touch()
    (machine.cwd / "deep" / "b" / "metadata.yaml").touch()
    for name in ("one.mcap", "two.db3", "three.txt"):
        (machine.cwd / name).touch()
    assert machine.complete("bag", "info", "") == ["a", "one.mcap", "two.db3"]
    assert machine.complete("bag", "info", "deep/") == ["deep/b"]
    assert machine.complete("bag", "info", f"{machine.cwd}/o") == [f"{machine.cwd}/one.mcap"]
    assert machine.complete("bag", "info", "nowhere/") == []


# -- record ------------------------------------------------------------------------------------------------------------


def test_the_recorder_has_the_name_and_the_level_it_was_given(machine):
    machine.node("counter", counter())
    command = machine.start("bag", "record", "-a", "-o", "bag", "--node-name", "scribe", "--log-level", "warn")
    command.step(0.5)
    assert "/scribe\n" in machine.ros2("node", "list").stdout
    command.interrupt()
    assert command.stderr == ""


def test_the_player_logs_from_the_level_it_was_given(counted):
    command = play(counted, "--log-level", "warn", "-r", "10")
    wait_for_end(command)
    assert (command.stderr, command.status) == ("", 0)


def test_nothing_is_said_about_keys_where_they_are_switched_off(machine):
    machine.node("counter", counter())
    command = record(machine, "--topics", "/count", "--disable-keyboard-controls", seconds=0.5)
    assert command.stdout == "" and "Press SPACE" not in command.stderr


def test_a_recording_can_begin_paused(machine):
    machine.node("counter", counter())
    record(machine, "--topics", "/count", "--start-paused", seconds=0.5)
    assert information(machine)["message_count"] == 0


def test_custom_data_stand_in_the_metadata(machine):
    machine.node("counter", counter())
    record(machine, "--topics", "/count", "--custom-data", "a=1", "b=x=y", "a=2", seconds=0.5)
    assert information(machine)["custom_data"] == {"a": "2", "b": "x=y"}


def test_a_bag_is_split_by_its_duration(machine):
    machine.node("counter", counter())
    record(machine, "--topics", "/count", "-d", "1", seconds=2.5)
    assert len(information(machine)["relative_file_paths"]) in (2, 3)


@pytest.mark.parametrize(("options", "there"), [([], True), (["--no-discovery"], False)])
def test_topics_that_appear_later_are_found_unless_discovery_is_off(machine, options, there):
    machine.node("counter", counter())
    command = machine.start("bag", "record", "--all-topics", "-o", "bag", *options)
    command.step(0.5)
    machine.node("late", counter("late"))
    for _ in range(10):
        command.step(0.1)
    command.interrupt()
    names = [each["topic_metadata"]["name"] for each in information(machine)["topics_with_message_count"]]
    assert ("/late" in names, "/count" in names) == (there, True)


def test_topics_are_looked_for_at_the_polling_interval(machine):
    def found_after(options, seconds):
        command = machine.start("bag", "record", "--topics", "/late", "-o", f"bag{seconds}", *options)
        command.step(0.0)
        node = machine.node("late", counter("late"))
        command.step(seconds)
        said = "Subscribed to topic '/late'" in command.stderr
        command.interrupt()
        node.destroy_node()
        return said

    assert found_after([], 0.11)
    assert not found_after([], 0.09)
    assert not found_after(["-p", "500"], 0.45)
    assert found_after(["-p", "500"], 0.55)


@pytest.mark.parametrize(
    ("options", "names"),
    [
        ([], {"/count", "/heard"}),
        (["--ignore-leaf-topics"], {"/heard"}),
        (["--include-unpublished-topics"], {"/count", "/heard", "/wanted"}),
        (["--include-hidden-topics"], {"/count", "/heard", "/_secret"}),
        (["--exclude-topic-types", "std_msgs/msg/Int32"], set()),
    ],
)
def test_which_topics_of_all_are_recorded(machine, options, names):
    machine.node("counter", counter())
    machine.node("shy", counter("_secret"))
    machine.node("said", counter("heard"))
    machine.node("ear", lambda node: node.create_subscription(Int32, "heard", print, 1))
    machine.node("wish", lambda node: node.create_subscription(Int32, "wanted", print, 1))
    record(machine, "--all-topics", *options, seconds=0.5)
    found = {each["topic_metadata"]["name"] for each in information(machine)["topics_with_message_count"]}
    assert {name for name in found if name in ("/count", "/heard", "/wanted", "/_secret")} == names


def test_types_choose_topics(machine):
    machine.node("counter", counter())
    record(machine, "--topic-types", "std_msgs/msg/Int32", seconds=0.5)
    (topic,) = information(machine)["topics_with_message_count"]
    assert topic["topic_metadata"]["name"] == "/count"


# -- play --------------------------------------------------------------------------------------------------------------


def numbers(found):
    return [message.data for _, message in found]


def test_a_delay_comes_before_the_first_message_of_each_loop(counted):
    found = heard(counted)
    began = counted.clock.steady_ns()
    command = play(counted, "--delay", "1.5", "--loop", "-r", "10")
    for _ in range(400):
        command.step(0.01)
    command.interrupt()
    times = [when - began for when, message in found if message.data == 0]
    assert times[0] == pytest.approx(1.5e9, abs=3e7)
    assert times[1] - times[0] == pytest.approx(1.69e9, abs=3e7)


@pytest.mark.parametrize("unit", ["sec", "nsec"])
def test_playing_ends_at_a_time(counted, unit):
    found = heard(counted)
    start = information(counted)["starting_time"]["nanoseconds_since_epoch"]
    until = start + 450_000_000
    words = (f"--playback-until-{unit}", str(until if unit == "nsec" else until / 1e9))
    wait_for_end(play(counted, *words))
    assert numbers(found) == [0, 1, 2, 3, 4]


def test_a_negative_duration_is_no_limit_and_0_is_one(counted):
    found = heard(counted)
    wait_for_end(play(counted, "--playback-duration=-5", "-r", "10"))
    assert numbers(found) == list(range(20))
    found.clear()
    wait_for_end(play(counted, "--playback-duration", "0", "-r", "10"))
    assert len(found) <= 1


def clock_times(machine):
    return heard(machine, Clock, "/clock", QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT))


@pytest.mark.parametrize(
    ("options", "count"),
    [(["--clock"], 76), (["--clock", "10"], 19), (["--clock-topics-all"], 20), (["--clock-topics", "/count"], 20),
     (["--clock-topics", "/other"], 0), ([], 0)],
)  # fmt: skip
def test_who_publishes_the_clock_and_how_often(counted, options, count):
    times = clock_times(counted)
    wait_for_end(play(counted, *options))
    assert len(times) == pytest.approx(count, abs=2)


@pytest.mark.parametrize(("options", "gets"), [([], True), (["--clock", "10"], False)])
def test_a_recorded_clock_gives_way_to_the_players(machine, options, gets):
    def build(node):
        publisher = node.create_publisher(Clock, "/clock", 10)
        message = Clock()
        message.clock.sec = 12345
        node.timer = node.create_timer(0.1, lambda: publisher.publish(message))

    node = machine.node("simulation", build)
    record(machine, "--topics", "/clock", seconds=0.5)
    node.destroy_timer(node.timer)
    times = clock_times(machine)
    wait_for_end(play(machine, *options))
    assert any(message.clock.sec == 12345 for _, message in times) is gets


def test_a_bag_may_be_opened_as_what_it_is_only(counted):
    assert counted.ros2("bag", "play", "bag", "-s", "mcap", "-r", "100").status == 0
    wrong = counted.ros2("bag", "play", "bag", "-s", "sqlite3", "-r", "100")
    assert wrong.status == 1


def test_burst_without_a_number_sends_everything_from_the_offset(counted):
    found = heard(counted)
    command = counted.start("bag", "burst", "bag", "--start-offset", "1.55")
    command.step(0.5)
    assert numbers(found) == [16, 17, 18, 19]
    command.interrupt()
    assert command.status == 0


def test_burst_can_send_some_topics_under_other_names(machine):
    two_topics(machine)
    found, own = heard(machine, topic="new"), heard(machine, topic="a")
    command = machine.start("bag", "burst", "bag", "--topics", "/b", "-n", "3", "-m", "/b:=/new")
    command.step(0.5)
    assert (numbers(found), numbers(own)) == ([0, 1, 2], [])
    command.interrupt()


def test_where_there_is_no_terminal_the_player_shows_no_progress(counted):
    command = counted.start("bag", "play", "bag", "-r", "10")
    wait_for_end(command)
    assert command.stdout == "stdin is not a terminal device. Keyboard handling disabled.\n"
    assert "Progress bar" not in command.stderr


def on_a_terminal(machine, *words):
    command = machine.start("bag", "play", "bag", "--disable-keyboard-controls", "--start-paused", *words)
    return command


@pytest.mark.parametrize(("options", "drawn"), [([], 4), (["--progress-bar-update-rate", "10"], 11)])
def test_progress_is_drawn_so_many_times_a_second(counted, monkeypatch, options, drawn):
    from day6_core.session.streams import Captured

    monkeypatch.setattr(Captured, "isatty", lambda self: True)
    command = on_a_terminal(counted, *options)
    shown = command.stdout.count("Playback Progress")
    command.step(1.0)
    assert command.stdout.count("Playback Progress") - shown in (drawn - 1, drawn)
    hertz = options[1] if options else "3"
    assert f"[rosbag2_player]: Progress bar enabled at {hertz} Hz." in command.stderr
    before = command.stdout
    command.interrupt()
    assert command.stdout.startswith(before) and "\x1b[J\n" in command.stdout[len(before) :]
    assert not command.stdout.endswith("\x1b[3A\r"), "the last state stays on the screen"


def test_progress_can_be_switched_off(counted, monkeypatch):
    from day6_core.session.streams import Captured

    monkeypatch.setattr(Captured, "isatty", lambda self: True)
    command = on_a_terminal(counted, "--progress-bar-update-rate", "0")
    command.step(1.0)
    assert command.stdout == "" and "Progress bar" not in command.stderr
    command.interrupt()


def test_the_log_is_written_where_the_progress_stands_and_the_progress_below_it(counted, monkeypatch):
    from day6_core.session.streams import Captured

    monkeypatch.setattr(Captured, "isatty", lambda self: True)
    command = on_a_terminal(counted)
    command.step(0.1)
    before, log = command.stdout, command.stderr
    counted.ros2("service", "call", "/rosbag2_player/set_rate", "rosbag2_interfaces/srv/SetRate", "{rate: 2.0}")
    added = command.stdout[len(before) :]
    assert "Set rate to 2" in command.stderr[len(log) :]
    assert added.startswith("\x1b[J\x1b[J\n") and "\x1b[3A\r" in added
    command.interrupt()
