"""turtle_teleop_key: which key does what, and what it prints."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose

if TYPE_CHECKING:
    from tests.support.stepped_keyboard import Keyboard
    from tests.turtlesim.conftest import Machine

UP, DOWN, RIGHT, LEFT = "\x1b[A", "\x1b[B", "\x1b[C", "\x1b[D"


def drives(machine: Machine, keyboard: Keyboard, *keys: str, args: tuple[str, ...] = ()) -> list[tuple[float, float]]:
    """Press the keys; return linear x and angular z of what was published."""
    twists = machine.watch(Twist, "/turtle1/cmd_vel")
    machine.start("turtle_teleop_key", *args, keyboard=keyboard)
    keyboard.press(*keys)
    machine.advance(0.1)
    return [(twist.linear.x, twist.angular.z) for twist in twists]


def test_the_help_is_that_of_the_real_one(machine: Machine, keyboard: Keyboard) -> None:
    teleop = machine.start("turtle_teleop_key", keyboard=keyboard)
    keyboard.press(UP, "t", "x", "\x7f")
    machine.advance(1.0)
    assert teleop.output.splitlines() == [
        "Reading from keyboard",
        "---------------------------",
        "Use arrow keys to move the turtle.",
        "Use g|b|v|c|d|e|r|t keys to rotate to absolute orientations. 'f' to cancel a rotation.",
        "'q' to quit.",
    ]
    assert teleop.log == []


def test_the_help_of_humble_has_capitals(
    machine: Machine, keyboard: Keyboard, in_distribution: Callable[[str], None]
) -> None:
    in_distribution("humble")
    teleop = machine.start("turtle_teleop_key", keyboard=keyboard)
    assert teleop.output.splitlines()[3:] == [
        "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.",
        "'Q' to quit.",
    ]


def test_each_arrow_is_one_twist(machine: Machine, keyboard: Keyboard) -> None:
    assert drives(machine, keyboard, UP, DOWN, LEFT, RIGHT) == [(2.0, 0.0), (-2.0, 0.0), (0.0, 2.0), (0.0, -2.0)]


def test_arrows_of_a_terminal_in_application_mode_drive_too(machine: Machine, keyboard: Keyboard) -> None:
    assert drives(machine, keyboard, "\x1bOA", "\x1bOD") == [(2.0, 0.0), (0.0, 2.0)]


def test_capital_a_to_d_drive_because_arrows_end_in_them(machine: Machine, keyboard: Keyboard) -> None:
    assert drives(machine, keyboard, "A", "B", "C", "D") == [(2.0, 0.0), (-2.0, 0.0), (0.0, -2.0), (0.0, 2.0)]


def test_a_sequence_that_comes_in_pieces_is_the_same_key(machine: Machine, keyboard: Keyboard) -> None:
    assert drives(machine, keyboard, "\x1b", "[", "A") == [(2.0, 0.0)]


def test_other_keys_do_nothing(machine: Machine, keyboard: Keyboard) -> None:
    assert drives(machine, keyboard, "w", "Q", "F", "\r", "\x04", "龟", "\x1b[3~", "\x1b[5~") == []


def test_the_scales_are_parameters(machine: Machine, keyboard: Keyboard) -> None:
    args = ("--ros-args", "-p", "scale_linear:=0.5", "-p", "scale_angular:=1.0")
    assert drives(machine, keyboard, UP, LEFT, args=args) == [(0.5, 0.0), (0.0, 1.0)]


def test_one_press_of_up_ends_at_the_golden_place(machine: Machine, keyboard: Keyboard) -> None:
    machine.start("turtlesim_node")
    poses = machine.watch(Pose, "/turtle1/pose")
    machine.start("turtle_teleop_key", keyboard=keyboard)
    machine.advance(0.1)
    keyboard.press(UP)
    machine.advance(1.2)
    assert poses[-1].x == 7.560444355010986
    assert sum(pose.linear_velocity > 0 for pose in poses) == 63


@pytest.mark.parametrize(
    ("key", "theta"),
    [("t", 0.768), ("r", 1.552), ("e", 2.352), ("d", -3.136), ("c", -2.352), ("v", -1.552), ("b", -0.768)],
)
def test_a_letter_turns_the_turtle_to_its_heading(machine: Machine, keyboard: Keyboard, key: str, theta: float) -> None:
    turtlesim = machine.start("turtlesim_node")
    poses = machine.watch(Pose, "/turtle1/pose")
    machine.start("turtle_teleop_key", keyboard=keyboard)
    machine.advance(0.1)
    keyboard.press(key)
    machine.advance(3.5)
    assert poses[-1].theta == pytest.approx(theta, abs=1e-6)
    assert turtlesim.log[-1] == "[INFO] [turtlesim]: Rotation goal completed successfully"


def test_f_cancels_the_rotation(machine: Machine, keyboard: Keyboard) -> None:
    turtlesim = machine.start("turtlesim_node")
    machine.start("turtle_teleop_key", keyboard=keyboard)
    machine.advance(0.1)
    keyboard.press("f", "d")
    machine.advance(0.5)
    keyboard.press("f")
    machine.advance(0.1)
    assert turtlesim.log[2:] == ["[INFO] [turtlesim]: Rotation goal canceled"]
    keyboard.press("f")
    machine.advance(0.1)
    assert turtlesim.log[3:] == []


@pytest.mark.parametrize("leave", ["q", "Ctrl-C"])
def test_it_leaves_quietly_and_gives_the_terminal_back(machine: Machine, keyboard: Keyboard, leave: str) -> None:
    teleop = machine.start("turtle_teleop_key", keyboard=keyboard)
    assert keyboard.is_raw
    if leave == "q":
        keyboard.press("q", UP)
    else:
        teleop.program.interrupt()
    machine.advance()
    assert teleop.program.status == 0
    assert teleop.log == []
    assert not keyboard.is_raw
    assert machine.node.get_node_names() == ["watcher"]


def test_without_a_terminal_it_dies_as_the_real_one_does(machine: Machine) -> None:
    teleop = machine.start("turtle_teleop_key")
    assert teleop.program.status == 134
    assert teleop.log == [
        "terminate called after throwing an instance of 'std::runtime_error'",
        "  what():  Failed to get old console mode",
    ]
