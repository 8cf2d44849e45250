"""What is measured and stamped on a running desk is real, although programs move by the world's time."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from rcl_interfaces.msg import Log
from turtlesim.msg import Pose

from day6_core.session.clock import WorldClock
from day6_core.session.session import Session
from day6_core.session.streams import Captured, TextInput
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from rclpy.qos import qos_profile_sensor_data
from tests.support.waiting import until

pytestmark = pytest.mark.process

LINE = re.compile(r"\[INFO\] \[(\d+)\.(\d{9})\] \[turtlesim\]: (.*)")


class RunningDesk:
    """A desk paced by the wall, and a node of the test's own on it."""

    def __init__(self, home: Path) -> None:
        self.desk = Desk(home, domain_id=0, join_link=False, clock=WorldClock(), display=False)
        self.node = None

        async def watch(session: Session) -> None:
            self.node = session.create_node("watcher")
            await session.spin(self.node)

        self._start(["watcher"], watch)
        self.until(lambda: self.node is not None)

    def _start(self, words, main) -> Streams:
        streams = Streams(TextInput(""), Captured(), Captured())
        self.desk.start_program(words, main, streams, env=self.desk.environment(), cwd=self.desk.home)
        return streams

    def ros2(self, *words: str) -> Streams:
        """Start `ros2 WORDS…`; returns its streams."""
        from day6_core.ros import ros2

        return self._start(["ros2", *words], ros2.main)

    def until(self, condition) -> None:
        until(lambda: self.desk.scheduler.run(condition, 0.01), every=0)


@pytest.fixture
def running(tmp_path: Path) -> Iterator[RunningDesk]:
    made = RunningDesk(tmp_path / "home")
    yield made
    made.desk.close()


def test_hz_tells_how_often_messages_really_came_and_that_they_were_not_all_alike(running):
    arrivals, later = [], []  # before and after the report, which may have one more or one less
    running.ros2("run", "turtlesim", "turtlesim_node")
    hear = lambda _: (later if "window" in hz.stdout.text else arrivals).append(time.monotonic())  # noqa: E731
    running.node.create_subscription(Pose, "/turtle1/pose", hear, qos_profile_sensor_data)
    hz = running.ros2("topic", "hz", "/turtle1/pose")
    running.until(lambda: later)
    report = re.search(r"rate: (\S+)\n.* std dev: (\S+)s window: (\d+)", hz.stdout.text)
    rate, deviation, window = (float(word) for word in report.groups())
    times, count = [*arrivals, later[0]], int(window)
    spans = [times[last] - times[last - count] for last in range(max(count, len(times) - 3), len(times))]
    assert spans and any(rate == pytest.approx(count / span, rel=0.1) for span in spans), (rate, count, times)
    assert deviation > 0


def test_lines_of_a_log_have_the_time_at_which_they_were_written(running):
    logged = []
    running.node.create_subscription(Log, "/rosout", logged.append, 100)
    before = time.time_ns()
    turtlesim = running.ros2("run", "turtlesim", "turtlesim_node")
    running.until(lambda: len(logged) >= 2)
    lines = LINE.findall(turtlesim.stderr.text)
    stamps = [int(seconds) * 10**9 + int(rest) for seconds, rest, _ in lines]
    assert [text.split()[0] for _, _, text in lines] == ["Starting", "Spawning"]
    assert before <= stamps[0] < stamps[1] <= time.time_ns()
    assert [(each.stamp.sec, each.stamp.nanosec) for each in logged] == [divmod(stamp, 10**9) for stamp in stamps]


def test_bw_and_delay_go_by_the_real_clock_in_a_world_of_half_speed(running):
    running.desk.set_speed(0.5)
    arrivals, later = [], []  # before and after the report of bw, which may have one more or one less
    running.ros2("run", "day6_bot", "wheel_spinner")
    from sensor_msgs.msg import JointState

    def hear(message) -> None:
        (later if "messages" in bw.stdout.text else arrivals).append((time.time(), message.header.stamp))

    running.node.create_subscription(JointState, "/joint_states", hear, qos_profile_sensor_data)
    bw = running.ros2("topic", "bw", "/joint_states", "--window", "10000")
    delay = running.ros2("topic", "delay", "/joint_states")
    running.until(lambda: later and "average" in delay.stdout.text)
    speed, count, size = re.search(r"(\S+) KB/s from (\d+) .*\n.* mean: (\S+) KB", bw.stdout.text).groups()
    rate, number = float(speed) / float(size), int(count)
    begins = [came for came, _ in arrivals[max(0, len(arrivals) - number - 1) :][:3]]
    least, most = (last + 1e-9 for last in (arrivals[-1][0], later[0][0]))  # the report came in between
    assert any(0.85 * number / (most - begin) <= rate <= 1.15 * number / (least - begin) for begin in begins), arrivals
    mean = float(re.search(r"average delay: (\S+)\n", delay.stdout.text)[1])
    assert 0 <= mean < 0.5
    assert all(0 <= came - (stamp.sec + stamp.nanosec / 1e9) < 0.5 for came, stamp in [*arrivals, *later])
