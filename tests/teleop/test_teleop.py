"""The two keyboard teleops: help, keys, speeds, and that Ctrl-C stops the robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from geometry_msgs.msg import Twist, TwistStamped

from day6_core.ros.programs.teleop_twist_keyboard.teleop_twist_keyboard import HELP, MOVES

if TYPE_CHECKING:
    from tests.support.stepped_keyboard import Keyboard
    from tests.support.stepped_machine import Running, SteppedMachine


def start(machine: SteppedMachine, keyboard: Keyboard, *args: str) -> Running:
    return machine.start("teleop_twist_keyboard", "teleop_twist_keyboard", *args, stdin=keyboard)


def press(machine: SteppedMachine, keyboard: Keyboard, *keys: str) -> None:
    keyboard.press(*keys)
    machine.advance(0.01)


def moved(twist: Any) -> tuple[float, float, float, float]:
    return (twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.z)


def test_it_greets_with_its_keys_and_speeds(machine: SteppedMachine, keyboard: Keyboard) -> None:
    running = start(machine, keyboard)
    assert running.output == HELP + "\ncurrently:\tspeed 0.5\tturn 1.0 \n"
    assert keyboard.is_raw
    assert "teleop_twist_keyboard" in machine.node.get_node_names()


@pytest.mark.parametrize("key", sorted(MOVES))
def test_every_moving_key_publishes_its_direction_once(machine: SteppedMachine, keyboard: Keyboard, key: str) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    start(machine, keyboard)
    press(machine, keyboard, key)
    x, y, z, turn = MOVES[key]
    assert [moved(twist) for twist in seen] == [(x * 0.5, y * 0.5, z * 0.5, turn * 1.0)]


def test_a_key_that_means_nothing_stops(machine: SteppedMachine, keyboard: Keyboard) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    start(machine, keyboard)
    press(machine, keyboard, "i", "k")
    assert [moved(twist) for twist in seen] == [(0.5, 0, 0, 0), (0, 0, 0, 0)]


def test_speeds_change_by_ten_per_cent_and_the_direction_goes_on(machine: SteppedMachine, keyboard: Keyboard) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    running = start(machine, keyboard)
    press(machine, keyboard, "u", "q", "x", "c")
    assert [line for line in running.output.splitlines() if line.startswith("currently")] == [
        "currently:\tspeed 0.5\tturn 1.0 ",
        "currently:\tspeed 0.55\tturn 1.1 ",
        "currently:\tspeed 0.49500000000000005\tturn 1.1 ",
        "currently:\tspeed 0.49500000000000005\tturn 0.9900000000000001 ",
    ]
    assert moved(seen[-1])[0] == pytest.approx(0.495) and moved(seen[-1])[3] == pytest.approx(0.99)


def test_after_fifteen_changes_the_help_comes_again(machine: SteppedMachine, keyboard: Keyboard) -> None:
    running = start(machine, keyboard)
    press(machine, keyboard, *"q" * 14)
    assert running.output.count("Moving around") == 1
    press(machine, keyboard, "q")
    assert running.output.count("Moving around") == 2


def test_ctrl_c_stops_the_robot_and_ends_quietly(machine: SteppedMachine, keyboard: Keyboard) -> None:
    seen = machine.watch(Twist, "/cmd_vel")
    running = start(machine, keyboard)
    press(machine, keyboard, "i")
    running.program.interrupt()
    machine.advance(0.01)
    assert running.program.status == 0 and running.errors == ""
    assert moved(seen[-1]) == (0, 0, 0, 0) and not keyboard.is_raw


def test_stamped_it_publishes_twist_stamped_in_a_frame(machine: SteppedMachine, keyboard: Keyboard) -> None:
    seen = machine.watch(TwistStamped, "/cmd_vel")
    start(machine, keyboard, "--ros-args", "-p", "stamped:=true", "-p", "frame_id:=base_link")
    press(machine, keyboard, "i")
    assert (seen[0].header.frame_id, seen[0].twist.linear.x) == ("base_link", 0.5)
    assert seen[0].header.stamp.sec == 1_700_000_000


def test_a_frame_without_stamped_is_refused(machine: SteppedMachine, keyboard: Keyboard) -> None:
    running = start(machine, keyboard, "--ros-args", "-p", "frame_id:=base_link")
    assert running.program.status == 1
    assert "'frame_id' can only be set when 'stamped' is True" in running.errors


@pytest.mark.parametrize("program", [("teleop_twist_keyboard",) * 2, ("turtlebot3_teleop", "teleop_keyboard")])
def test_without_a_terminal_there_are_no_keys(machine: SteppedMachine, program: tuple[str, str]) -> None:
    running = machine.start(*program)
    assert running.program.status == 1
    assert running.errors == "termios.error: (25, 'Inappropriate ioctl for device')\n"


def test_the_turtlebot_gets_faster_step_by_step_and_gently(machine: SteppedMachine, keyboard: Keyboard) -> None:
    seen = machine.watch(TwistStamped, "/cmd_vel", 1000)
    running = machine.start("turtlebot3_teleop", "teleop_keyboard", stdin=keyboard)
    press(machine, keyboard, *"www")
    assert "currently:\tlinear velocity 0.03\t angular velocity 0.0 " in running.output
    told = [message.twist.linear.x for message in seen]
    assert told == sorted(told) and told[-1] < 0.03
    machine.advance(1.0)
    assert seen[-1].twist.linear.x == pytest.approx(0.03)
    press(machine, keyboard, "s")
    assert seen[-1].twist.linear.x == 0.0


def test_a_burger_has_its_limits(machine: SteppedMachine, keyboard: Keyboard) -> None:
    running = machine.start("turtlebot3_teleop", "teleop_keyboard", stdin=keyboard)
    press(machine, keyboard, *"w" * 40, *"a" * 40)

    lines = [line for line in running.output.splitlines() if line.startswith("currently")]
    assert lines[-1].startswith("currently:\tlinear velocity 0.22\t angular velocity 2.84")
