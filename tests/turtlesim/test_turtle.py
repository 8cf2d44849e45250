"""One turtle, tick by tick, against the numbers of the real turtlesim (turtlesim/turtle.cpp)."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from day6_core.ros.programs.turtlesim.model import HEIGHT, WIDTH, Rotation, Trail, Turtle, TurtleStep, float32

MS = 1_000_000
TICK_NS = 16 * MS


class World:
    """A turtle, its trail, and a clock that each tick moves on by 16 ms."""

    def __init__(self, x: float = WIDTH / 2, y: float = HEIGHT / 2, theta: float = 0.0) -> None:
        self.now = 0
        self.trail = Trail()
        self.turtle = Turtle("turtle1", x, y, theta, kind="jazzy", now=0)

    def tick(self) -> TurtleStep:
        self.now += TICK_NS
        return self.turtle.step(self.now, self.trail)

    def drive(self, linear: float = 0.0, angular: float = 0.0, sideways: float | None = None) -> None:
        """A command that is taken at the coming tick."""
        self.turtle.command(linear, angular, self.now + TICK_NS, linear_y=sideways)

    def ticks_until_still(self) -> int:
        count = 0
        while True:
            before = self.turtle.pose[:3]
            self.tick()
            if self.turtle.pose[:3] == before:
                return count
            count += 1

    def rotate(self, theta: float) -> tuple[Rotation, list[float]]:
        """Turn to the end; return the rotation and every feedback."""
        rotation = self.turtle.rotate(float32(theta))
        feedback = []
        while rotation.outcome is None:
            self.tick()
            feedback.append(rotation.remaining)
        return rotation, feedback


def test_the_world_is_499_pixels_of_45_to_the_metre() -> None:
    assert WIDTH == HEIGHT == 11.088889122009277
    assert World().turtle.pose == (5.544444561004639, 5.544444561004639, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(("linear", "x"), [(2.0, 7.560444355010986), (-2.0, 3.528444528579712)], ids=["UP", "DOWN"])
def test_one_key_press_moves_the_turtle_for_63_ticks(linear: float, x: float) -> None:
    world = World()
    world.drive(linear)
    assert world.ticks_until_still() == 63
    assert world.turtle.pose == (x, 5.544444561004639, 0.0, 0.0, 0.0)


def test_one_left_key_turns_the_turtle_by_two_radians_and_a_bit() -> None:
    world = World()
    world.drive(angular=2.0)
    assert world.ticks_until_still() == 63
    assert world.turtle.pose.theta == 2.0160000324249268


def test_one_twist_of_the_tutorial_draws_an_arc() -> None:
    world = World()
    world.drive(2.0, 1.8)
    world.ticks_until_still()
    x, y, theta = world.turtle.pose[:3]
    assert f"{x:.6f} {y:.6f} {theta:.6f}" == "6.602817 6.938990 1.814400"


def test_a_command_holds_for_exactly_one_second_and_a_new_one_prolongs_it() -> None:
    world = World()
    world.drive(1.0)
    for _ in range(40):
        world.tick()
    world.drive(1.0)
    assert world.ticks_until_still() == 63


def test_speed_is_reported_without_sign() -> None:
    world = World()
    world.drive(-2.0, -0.5)
    step = world.tick()
    assert step.pose.linear_velocity == 2.0
    assert step.pose.angular_velocity == -0.5


def test_only_a_holonomic_turtle_moves_sideways() -> None:
    world = World()
    world.drive(3.0, sideways=4.0)
    step = world.tick()
    assert step.pose.linear_velocity == 5.0
    assert step.pose.y > 5.6
    plain = World()
    plain.drive(3.0)
    assert plain.tick().pose.y == 5.544444561004639


def test_the_heading_stays_between_minus_pi_and_pi() -> None:
    world = World(theta=3.14)
    world.drive(angular=1.0)
    assert world.tick().pose.theta == pytest.approx(3.14 + 0.016 - 2 * math.pi, abs=1e-6)


@pytest.mark.parametrize(
    ("theta", "line"),
    [(0.0, "[x=11.112445, y=5.544445]"), (math.pi / 2, "[x=5.544445, y=-0.023555]")],
    ids=["right", "up"],
)
def test_the_wall_is_reported_in_canvas_coordinates(theta: float, line: str) -> None:
    world = World()
    world.turtle.theta = theta
    wall = None
    while wall is None:
        world.drive(2.0)
        wall = world.tick().wall
    assert "[x={:f}, y={:f}]".format(*wall) == line
    assert world.turtle.pose.x <= WIDTH
    assert world.turtle.pose.y <= HEIGHT


def test_the_wall_is_reported_at_every_tick_that_pushes_against_it() -> None:
    world = World(x=WIDTH)
    world.drive(2.0)
    walls = [world.tick().wall for _ in range(64)]
    assert [wall is not None for wall in walls] == [True] * 63 + [False]


@pytest.mark.parametrize(
    ("goal", "ticks", "first", "theta"),
    [
        (1.57, 98, 1.5700000524520874, "1.552000"),
        (0.7854, 49, 0.7853999733924866, "0.768000"),
        (1.5708, 98, 1.5707999467849731, "1.552000"),
        (2.3562, 148, 2.3561999797821045, "2.352000"),
        (3.1416, 197, -3.141585350036621, "-3.136000"),
    ],
    ids=["1.57", "T", "R", "E", "D turns clockwise"],
)
def test_rotation_goals_take_as_many_ticks_as_the_real_ones(goal: float, ticks: int, first: float, theta: str) -> None:
    world = World()
    rotation, feedback = world.rotate(goal)
    assert rotation.outcome == "succeeded"
    assert len(feedback) == ticks
    assert feedback[0] == first
    assert f"{world.turtle.pose.theta:f}" == theta


def test_the_result_of_a_rotation_is_start_minus_end() -> None:
    rotation, feedback = World().rotate(1.57)
    assert feedback[-1] == 0.018000006675720215
    assert rotation.delta == -1.5520000457763672


def test_a_rotation_outlasts_the_command_timeout() -> None:
    world = World()
    _, feedback = world.rotate(2.3562)
    assert len(feedback) * 0.016 > 1.0
    assert world.turtle.pose.angular_velocity == 0.0


def test_a_command_aborts_a_rotation() -> None:
    world = World()
    rotation = world.turtle.rotate(1.5)
    for _ in range(10):
        world.tick()
    assert world.turtle.command(1.0, 0.0, world.now) is rotation
    assert rotation.outcome == "aborted"
    assert rotation.delta == pytest.approx(-0.144)
    assert world.tick().rotation is None


def test_a_second_rotation_aborts_the_first() -> None:
    world = World()
    first = world.turtle.rotate(1.5)
    world.tick()
    second, _ = world.rotate(-0.5)
    assert (first.outcome, second.outcome) == ("aborted", "succeeded")


def test_a_cancelled_rotation_stops_at_the_next_tick() -> None:
    world = World()
    rotation = world.turtle.rotate(1.5)
    world.tick()
    rotation.canceling = True
    before = world.turtle.pose.theta
    step = world.tick()
    assert step.rotation is rotation
    assert rotation.outcome == "canceled"
    assert (step.pose.theta, step.pose.angular_velocity) == (before, 0.0)


def test_teleport_absolute_waits_for_the_tick_and_draws_the_way() -> None:
    world = World()
    world.turtle.teleport_absolute(1.0, 2.0, 0.5)
    assert world.turtle.pose.x == 5.544444561004639
    step = world.tick()
    assert (step.pose.x, step.pose.theta) == (1.0, 0.5)
    assert step.pose.y == pytest.approx(2.0)
    assert world.trail.drawn == 1


def test_teleport_relative_turns_first_then_goes() -> None:
    world = World()
    world.turtle.teleport_relative(1.0, math.pi / 2)
    pose = world.tick().pose
    assert (pose.x, pose.y) == (pytest.approx(5.544445, abs=1e-6), pytest.approx(6.544445, abs=1e-6))
    assert pose.theta == pytest.approx(math.pi / 2)


def test_teleports_are_worked_off_in_order_in_one_tick() -> None:
    world = World()
    world.turtle.teleport_absolute(2.0, 2.0, 0.0)
    world.turtle.teleport_relative(3.0, 0.0)
    assert world.tick().pose.x == 5.0
    assert world.trail.drawn == 2


def test_teleporting_beyond_the_right_wall_hits_it_but_beyond_the_top_does_not() -> None:
    world = World()
    world.turtle.teleport_absolute(20.0, 5.0, 0.0)
    step = world.tick()
    assert step.wall is not None
    assert step.wall[0] == 20.0
    assert step.pose.x == WIDTH
    world.turtle.teleport_absolute(5.0, 20.0, 0.0)
    step = world.tick()
    assert step.wall is None
    assert step.pose.y == HEIGHT


def test_the_pen_lifted_keeps_its_colour_and_draws_nothing() -> None:
    world = World()
    world.turtle.set_pen(255, 0, 0, 5, off=1)
    world.drive(2.0)
    world.ticks_until_still()
    assert world.trail.drawn == 0
    assert world.turtle.pen_rgb == 0xB3B8FF


def test_pen_width_zero_draws_one_pixel() -> None:
    world = World()
    world.turtle.set_pen(255, 0, 0, 0, off=0)
    world.drive(2.0)
    world.ticks_until_still()
    segments = world.trail.segments_since(0)
    assert segments is not None
    assert len(segments) == 63
    assert {(segment.rgb, segment.width) for segment in segments} == {(0xFF0000, 1)}
    column = 300
    assert sum(world.trail.colour_at(column, row) != (255, 255, 255) for row in range(499)) == 1


def test_the_colour_sensor_sees_white_beside_the_trail_and_the_pen_on_it() -> None:
    world = World()
    assert world.tick().colour == (255, 255, 255)
    world.drive(2.0)
    world.ticks_until_still()
    assert world.tick().colour == (179, 184, 255)
    world.turtle.set_pen(0, 0, 0, 3, off=1)
    world.turtle.teleport_relative(2.0, 1.0)
    assert world.tick().colour == (255, 255, 255)


def test_the_line_of_a_tick_is_drawn_after_its_colour_was_read() -> None:
    world = World()
    world.drive(100.0)  # 72 pixels a tick
    assert world.tick().colour == (255, 255, 255)


def test_a_turtle_at_rest_changes_nothing() -> None:
    world = World()
    world.tick()
    assert world.tick().changed is False
    world.drive(1.0)
    assert world.tick().changed is True


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e300])
@pytest.mark.parametrize(
    "command",
    [
        lambda turtle, v: turtle.command(v, 0.0, TICK_NS, linear_y=v),
        lambda turtle, v: turtle.command(0.0, v, TICK_NS),
        lambda turtle, v: turtle.teleport_absolute(v, v, v),
        lambda turtle, v: turtle.teleport_relative(v, v),
        lambda turtle, v: turtle.rotate(v),
    ],
    ids=["linear", "angular", "teleport_absolute", "teleport_relative", "rotate"],
)
def test_numbers_that_are_none_stop_no_program(command: Callable[[Turtle, float], object], value: float) -> None:
    world = World()
    command(world.turtle, value)
    for _ in range(3):
        step = world.tick()
    assert all(0 <= channel <= 255 for channel in step.colour)
