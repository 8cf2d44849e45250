"""`ros2 topic hz`, `bw` and `delay`: the numbers, their units, the window, and time that jumps."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import PointStamped
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32, String, UInt8MultiArray


class Source:
    """Publishes on /data exactly when it is told to."""

    def __init__(self, machine, kind):
        self.machine = machine
        self.kind = kind
        self.publisher = machine.node("source").create_publisher(kind, "data", 10)

    def after(self, seconds, **fields):
        self.machine.step(seconds)
        self.publisher.publish(self.kind(**fields))
        self.machine.step()

    def stamped(self, seconds, age):
        """Publish a message whose stamp is so many seconds old."""
        self.machine.step(seconds)
        message = PointStamped()
        stamp = self.machine.clock.now_ns() - round(age * 1e9)
        message.header.stamp.sec, message.header.stamp.nanosec = divmod(stamp, 1_000_000_000)
        self.publisher.publish(message)
        self.machine.step()


def reports(command):
    """What it has printed, two lines each, without what it says at the start."""
    lines = [line for line in command.stdout.splitlines() if not line.startswith("Subscribed")]
    return ["\n".join(lines[at : at + 2]) for at in range(0, len(lines), 2)]


# -- hz ----------------------------------------------------------------------------------------------------------------


def test_hz_tells_the_shortest_the_longest_and_the_deviation_of_the_periods(machine):
    source = Source(machine, Int32)
    hz = machine.start("topic", "hz", "/data")
    for pause in (0.0, 0.1, 0.2, 0.3):
        source.after(pause)
    hz.step(0.45)
    assert reports(hz) == ["average rate: 5.000\n\tmin: 0.100s max: 0.300s std dev: 0.08165s window: 3"]


def test_hz_is_silent_until_there_are_two_messages_and_when_nothing_is_new(machine):
    source = Source(machine, Int32)
    hz = machine.start("topic", "hz", "/data")
    source.after(0.5)
    hz.step(1.0)
    assert hz.stdout == ""
    source.after(0.5)
    hz.step(3.0)
    assert [report.splitlines()[0] for report in reports(hz)] == ["average rate: 0.667"]


def test_hz_counts_a_message_that_comes_with_the_report(machine):
    source = Source(machine, Int32)
    hz = machine.start("topic", "hz", "/data")
    source.after(0.5)
    source.after(0.5)
    hz.step(0.002)
    assert reports(hz) == ["average rate: 2.000\n\tmin: 0.500s max: 0.500s std dev: 0.00000s window: 1"]


def test_hz_forgets_what_is_older_than_its_window(machine):
    source = Source(machine, Int32)
    hz = machine.start("topic", "hz", "-w", "2", "/data")
    for pause in (0.0, 0.4, 0.1, 0.2):
        source.after(pause)
    hz.step(0.5)
    assert reports(hz) == ["average rate: 6.667\n\tmin: 0.100s max: 0.200s std dev: 0.05000s window: 2"]


def test_hz_of_messages_that_come_all_at_once_is_0(machine):
    source = Source(machine, Int32)
    hz = machine.start("topic", "hz", "/data")
    for _ in range(3):
        source.after(0.0)
    hz.step(1.5)
    assert reports(hz) == ["average rate: 0.000\n\tmin: 0.000s max: 0.000s std dev: 0.00000s window: 2"]


class Simulation:
    """Publishes the time that it is told on /clock."""

    def __init__(self, machine):
        self.machine = machine
        self.publisher = machine.node("simulation").create_publisher(Clock, "/clock", 1)

    def tell(self, seconds):
        message = Clock()
        message.clock.sec, message.clock.nanosec = divmod(round(seconds * 1e9), 1_000_000_000)
        self.publisher.publish(message)
        self.machine.step()


def test_hz_measures_in_simulated_time_only_when_it_is_asked_to(machine):
    source, simulation = Source(machine, Int32), Simulation(machine)
    simulated = machine.start("topic", "hz", "--use-sim-time", "/data")
    in_wall_time = machine.start("topic", "hz", "-s", "--wall-time", "/data")
    for second in (10.0, 12.0, 14.0):
        simulation.tell(second)
        source.after(0.1)
    machine.step(1.0)
    assert reports(simulated)[0].startswith("average rate: 0.500\n\tmin: 2.000s max: 2.000s")
    if in_wall_time.stdout:
        assert "max: 2.000s" not in in_wall_time.stdout


@pytest.mark.parametrize(("verb", "kind"), [("hz", Int32), ("delay", PointStamped)])
def test_without_a_simulated_time_nothing_is_measured(machine, verb, kind):
    source, simulation = Source(machine, kind), Simulation(machine)
    command = machine.start("topic", verb, "-s", "/data")
    for _ in range(3):
        source.after(0.1)
    machine.step(1.0)
    assert command.stdout == ""
    for second in (10.0, 11.0):
        simulation.tell(second)
        source.after(0.1)
    simulation.tell(0.0)
    source.after(0.1)
    source.after(0.1)
    assert command.stdout == "time has reset, resetting counters\n"
    machine.step(1.0)
    assert command.stdout == "time has reset, resetting counters\n", "nothing is left of what was measured before"


@pytest.mark.parametrize(("verb", "kind"), [("hz", Int32), ("delay", PointStamped)])
def test_when_simulated_time_begins_again_so_does_the_measurement(machine, verb, kind):
    source, simulation = Source(machine, kind), Simulation(machine)
    command = machine.start("topic", verb, "-s", "/data")
    for second in (10.0, 11.0, 12.0, 5.0, 7.0):
        simulation.tell(second)
        source.after(0.01)
    if verb == "delay":
        simulation.tell(8.0)  # its reports come in simulated time, too
        simulation.tell(14.0)
    machine.step(1.0)
    assert command.stdout.splitlines()[1].endswith(" window: 1")
    if verb == "hz":
        assert command.stdout.startswith("average rate: 0.500\n")


def test_hz_in_a_table_leaves_out_what_has_nothing_new(machine):
    source = Source(machine, Int32)
    other = machine.node("other").create_publisher(Int32, "another_topic", 10)
    hz = machine.start("topic", "hz", "/data", "/another_topic")
    for pause in (0.0, 0.25, 0.25):
        source.after(pause)
        other.publish(Int32())
    hz.step(0.6)
    for pause in (0.2, 0.2):
        source.after(pause)
    hz.step(1.0)
    assert hz.stdout == (
        "Subscribed to [/data]\nSubscribed to [/another_topic]\n"
        "    topic         rate   min_delta   max_delta   std_dev   window\n"
        f"{'=' * 65}\n"
        "/data            4.000   0.250       0.250       0.00000   2     \n"
        "/another_topic   4.000   0.250       0.250       0.00000   2     \n\n"
        "topic    rate   min_delta   max_delta   std_dev   window\n"
        "========================================================\n"
        "/data   2.667   0.200       0.800       0.24622   4     \n\n"
    )


# -- bw ----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("sizes", "expected"),
    [
        # 16 bytes of every message are not data: the kind of CDR (4) and three lengths of 4.
        # Fast DDS fills their last four bytes, except in messages that it takes apart.
        ((100, 200, 301), "652 B/s from 3 messages\n\tMessage size mean: 217 B min: 116 B max: 320 B"),
        ((963, 0), "996 B/s from 2 messages\n\tMessage size mean: 498 B min: 16 B max: 980 B"),
        ((968, 0), "1.00 KB/s from 2 messages\n\tMessage size mean: 0.50 KB min: 0.02 KB max: 0.98 KB"),
        ((1_200_000, 300_000), "1.50 MB/s from 2 messages\n\tMessage size mean: 0.75 MB min: 0.30 MB max: 1.20 MB"),
        ((999_967, 0), "1000.00 KB/s from 2 messages\n\tMessage size mean: 500.00 KB min: 0.02 KB max: 999.98 KB"),
        ((999_968, 0), "1.00 MB/s from 2 messages\n\tMessage size mean: 0.50 MB min: 0.00 MB max: 1.00 MB"),
    ],
)
def test_bw_chooses_the_unit_by_the_rate(machine, sizes, expected):
    source = Source(machine, UInt8MultiArray)
    bw = machine.start("topic", "bw", "/data")
    for size in sizes:
        source.after(0.0, data=bytes(size))
    bw.step(1.0)
    assert reports(bw) == [expected]


def test_bw_counts_at_most_its_window(machine):
    source = Source(machine, String)
    default, two = machine.start("topic", "bw", "/data"), machine.start("topic", "bw", "-w", "2", "/data")
    for number in range(120):
        source.after(0.005, data="x" * (number < 118))
    machine.step(0.4)
    assert reports(default)[0].splitlines()[0].endswith(" from 100 messages")
    assert reports(two) == ["59 B/s from 2 messages\n\tMessage size mean: 12 B min: 12 B max: 12 B"]


def test_bw_is_silent_until_there_are_two_messages(machine):
    source = Source(machine, String)
    bw = machine.start("topic", "bw", "/data")
    source.after(0.1)
    bw.step(2.0)
    assert bw.stdout == "Subscribed to [/data]\n"
    source.after(0.0)
    bw.step(1.0)
    assert reports(bw)[0].startswith("8 B/s from 2 messages\n")


# -- delay -------------------------------------------------------------------------------------------------------------


def test_delay_tells_the_smallest_the_largest_and_the_deviation(machine):
    source = Source(machine, PointStamped)
    delay = machine.start("topic", "delay", "/data")
    for age in (9.0, 0.1, 0.2, 0.3):  # real ros2 does not count the first one either
        source.stamped(0.1, age)
    delay.step(0.65)
    assert reports(delay) == ["average delay: 0.200\n\tmin: 0.100s max: 0.300s std dev: 0.08165s window: 3"]


def test_delay_counts_at_most_its_window_and_says_when_nothing_is_new(machine):
    source = Source(machine, PointStamped)
    delay = machine.start("topic", "delay", "-w", "2", "/data")
    for age in (0.0, 0.9, 0.2, 1.2):
        source.stamped(0.1, age)
    delay.step(1.65)
    assert delay.stdout == (
        "average delay: 0.700\n\tmin: 0.200s max: 1.200s std dev: 0.50000s window: 2\nno new messages\n"
    )


def test_a_message_of_the_future_has_a_negative_delay(machine):
    source = Source(machine, PointStamped)
    delay = machine.start("topic", "delay", "/data")
    for age in (0.0, -0.5, -0.25):
        source.stamped(0.1, age)
    delay.step(0.75)
    assert reports(delay) == ["average delay: -0.375\n\tmin: -0.500s max: -0.250s std dev: 0.12500s window: 2"]


def test_delay_is_silent_before_the_second_message(machine):
    source = Source(machine, PointStamped)
    delay = machine.start("topic", "delay", "/data")
    source.stamped(0.1, 0.5)
    delay.step(3.0)
    assert delay.stdout == ""


# -- all three ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("verb", ["hz", "bw", "delay"])
def test_a_window_must_be_a_positive_number(machine, verb):
    for window in ("0", "-1", "x", "1.5"):
        result = machine.ros2("topic", verb, f"--window={window}", "/data")
        assert result.status == 2
        assert result.stderr.endswith("error: argument --window/-w: value must be a positive integer\n")


@pytest.mark.parametrize(("verb", "status"), [("hz", 0), ("bw", 2), ("delay", 2)])
def test_ctrl_c_ends_a_measurement(machine, verb, status):
    Source(machine, PointStamped)
    command = machine.start("topic", verb, "/data")
    command.step(2.5)
    command.interrupt()
    assert command.status == status
