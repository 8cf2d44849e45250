"""`ros2 bag play`: when messages come again, and how it is steered."""

from __future__ import annotations

import re
from itertools import pairwise

import pytest
import rosbag2_py
from rosbag2_interfaces.srv import Burst, GetRate, IsPaused, PlayNext, Resume, Seek, SetRate, Stop
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from tests.ros2.bag_commands import call, counter, heard, information, lines, play, record, wait_for_end
from tests.support.stepped_keyboard import Keyboard


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
    from day6_core.ros import ros2
    from day6_core.session.program import Program

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


def test_a_rule_that_renames_nothing_is_told_in_the_words_of_rclcpp(counted):
    played = play(counted, "--remap", "nonsense")
    assert played.status == 1
    assert played.stderr.startswith(
        "failed to parse arguments: Couldn't parse remap rule: '--remap nonsense'. Error: Expected lexeme type"
    )
