"""draw_square's plan, driving a turtle of the model: each tick the square sees the pose of the tick before."""

from __future__ import annotations

import math

import pytest

from day6_core.ros.programs.turtlesim.model import CENTRE, Pose, Square, Trail, Turtle

TICK_NS = 16_000_000


def drive(turtle: Turtle, square: Square, corners: int) -> list[str]:
    """Drive until so many goals are reached; return the log."""
    log: list[str] = []
    trail = Trail()
    tick = 0
    while log.count("Reached goal") < corners:
        tick += 1
        command, lines = square.decide(turtle.pose)
        log += lines
        if command is not None:
            turtle.command(*command, tick * TICK_NS)
        turtle.step(tick * TICK_NS, trail)
    return log


def test_the_first_side_ends_just_within_a_tenth_of_a_metre_of_the_goal() -> None:
    turtle = Turtle("turtle1", *CENTRE, 0.0, kind="jazzy", now=0)
    log = drive(turtle, Square(), 1)
    assert log[0] == "New goal [7.544445 5.544445, 0.000000]"
    assert log[1] == "Reached goal"
    x = 5.544444561004639
    while abs(x - 7.544444561004639) >= 0.1:
        x += 0.016
    assert turtle.pose.x == pytest.approx(x, abs=1e-6)
    assert log[2] == f"New goal [{turtle.pose.x:f} 5.544445, 1.570796]"


def test_four_sides_later_the_turtle_is_near_its_start_but_not_there() -> None:
    turtle = Turtle("turtle1", *CENTRE, 0.0, kind="jazzy", now=0)
    drive(turtle, Square(), 8)
    assert math.dist(turtle.pose[:2], CENTRE) == pytest.approx(0.1, abs=0.1)
    assert turtle.pose[:2] != CENTRE


def test_the_new_heading_is_wrapped_but_the_comparison_is_not() -> None:
    square = Square()
    square.decide(Pose(5.0, 5.0, 3.0, 0.0, 0.0))
    square.decide(Pose(3.02, 5.282, 3.0, 1.0, 0.0))
    _, lines = square.decide(Pose(3.02, 5.282, 3.0, 0.0, 0.0))
    assert lines == ["Reached goal", "New goal [3.020000 5.282000, -1.712388]"]


def test_it_commands_a_stop_until_the_turtle_stands() -> None:
    square = Square()
    square.decide(Pose(5.0, 5.0, 0.0, 0.0, 0.0))
    assert square.decide(Pose(6.95, 5.0, 0.0, 1.0, 0.0)) == ((0.0, 0.0), [])
    assert square.decide(Pose(6.966, 5.0, 0.0, 1.0, 0.0)) == ((0.0, 0.0), [])
    command, lines = square.decide(Pose(6.966, 5.0, 0.0, 0.0, 0.0))
    assert command is None
    assert lines[0] == "Reached goal"
