"""A turtle that stands and that nobody hears costs hardly a tick, and nobody can tell."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from turtlesim.srv import TeleportAbsolute

from day6_core.ros.programs.turtlesim.turtlesim_node import TurtleFrame

if TYPE_CHECKING:
    from tests.turtlesim.conftest import Machine


@pytest.fixture
def worked(monkeypatch: pytest.MonkeyPatch) -> list[TurtleFrame]:
    """One entry for every tick in which turtlesim did something."""
    ticks: list[TurtleFrame] = []
    tick = TurtleFrame.tick

    def counted(frame: TurtleFrame, now: int | None = None) -> None:
        ticks.append(frame)
        tick(frame, now)

    monkeypatch.setattr(TurtleFrame, "tick", counted)
    return ticks


def numbered(machine: Machine) -> list[tuple[Pose, int]]:
    """A list that fills with the poses and their numbers."""
    seen: list[tuple[Pose, int]] = []

    def note(pose: Pose, info: dict[str, Any]) -> None:
        seen.append((pose, info["publication_sequence_number"]))

    machine.node.create_subscription(Pose, "/turtle1/pose", note, 10)
    machine.advance()
    return seen


def test_a_standing_turtle_that_nobody_hears_works_twice_a_second(machine: Machine, worked: list[TurtleFrame]) -> None:
    machine.start("turtlesim_node")
    machine.ticks(1000)
    assert 30 < len(worked) < 40


def test_who_comes_to_a_resting_turtle_hears_the_very_next_tick_with_its_number(machine: Machine) -> None:
    machine.start("turtlesim_node")
    machine.ticks(100)
    machine.advance(0.004)
    poses = numbered(machine)
    assert poses == []
    machine.advance(0.012)
    assert [number for _, number in poses] == [100]  # the first tick has none
    machine.ticks(3)
    assert [number for _, number in poses] == [100, 101, 102, 103]


def test_who_leaves_and_comes_back_finds_the_ticks_counted_that_nobody_heard(machine: Machine) -> None:
    machine.start("turtlesim_node")
    poses = numbered(machine)
    machine.ticks(10)
    for subscription in list(machine.node.subscriptions):
        machine.node.destroy_subscription(subscription)
    machine.ticks(57)
    again = numbered(machine)
    machine.ticks(1)
    assert (poses[-1][1], again[0][1]) == (9, 67)


def test_a_key_wakes_a_resting_turtle_for_63_ticks_from_the_next_one(
    machine: Machine, worked: list[TurtleFrame]
) -> None:
    machine.start("turtlesim_node", screen=True)
    keys = machine.node.create_publisher(Twist, "/turtle1/cmd_vel", 10)
    machine.ticks(50)
    machine.advance(0.01)
    (turtle,) = machine.display.windows[0].model.turtles.values()  # type: ignore[attr-defined]
    before, worked[:] = turtle.pose.x, []
    twist = Twist()
    twist.linear.x = 2.0
    keys.publish(twist)
    machine.advance(0.006)
    assert turtle.pose.x == pytest.approx(before + 0.032)
    machine.ticks(200)
    assert turtle.pose.x == pytest.approx(before + 63 * 0.032, abs=1e-5)
    assert len(worked) < 80


def test_a_service_does_not_wait_for_the_end_of_a_rest(machine: Machine) -> None:
    machine.start("turtlesim_node", screen=True)
    machine.ticks(40)
    machine.call(TeleportAbsolute, "/turtle1/teleport_absolute", x=1.0, y=2.0)
    machine.ticks(1)
    assert machine.display.windows[0].model.scene.turtles[0][2:4] == (1.0, 2.0)  # type: ignore[attr-defined]


def test_whoever_counts_its_messages_sees_them_pass_one_by_one(machine: Machine) -> None:
    machine.start("turtlesim_node")
    machine.ticks(100)
    (poses,) = (each for each in machine.graph.nodes if each.name == "turtlesim")
    (publisher,) = (each for each in poses.endpoints if each.topic == "/turtle1/pose")
    counts = []
    for _ in range(60):
        counts.append(publisher.delivered)  # type: ignore[attr-defined]
        machine.ticks(1)
    assert counts[35:] == list(range(counts[35], counts[35] + 25))
