"""joint_state_publisher_gui: its node, what its sliders do, and what happens when somebody else publishes too."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest
from sensor_msgs.msg import JointState

from day6_urdf import shipped_model

if TYPE_CHECKING:
    from tests.support.stepped_machine import SteppedMachine


def open_sliders(machine: SteppedMachine, *args: str) -> Any:
    machine.start("joint_state_publisher_gui", "joint_state_publisher_gui", *args, screen=True)
    window = machine.display.windows[-1]
    assert (window.kind, window.title) == ("joint_state_publisher", "Joint State Publisher")
    return window.model


def value(model: Any, name: str) -> float:
    return float(next(slider.value for slider in model.sliders if slider.name == name))


def test_every_joint_that_can_move_has_a_slider(machine: SteppedMachine, arm: str) -> None:
    model = open_sliders(machine, arm)
    # Not those that follow, are fixed or floating, or whose limits are equal.
    assert [slider.name for slider in model.sliders] == ["turn", "bend", "far", "slide", "soft"]
    turn = model.sliders[0]
    assert (turn.minimum, turn.maximum, turn.step) == (-math.pi, math.pi, 5000)
    assert "joint_state_publisher" in machine.node.get_node_names()


def test_a_slider_has_ten_thousand_steps_and_is_published(machine: SteppedMachine, arm: str) -> None:
    seen = machine.watch(JointState, "/joint_states")
    model = open_sliders(machine, arm)
    model.request("step", "bend", 2500)
    machine.advance(0.2)
    assert value(model, "bend") == pytest.approx(-1 + 3 * 0.25)
    assert dict(zip(seen[-1].name, seen[-1].position, strict=True))["bend"] == pytest.approx(-0.25)
    model.request("step", "bend", 20_000)
    machine.advance(0.1)
    assert value(model, "bend") == 2.0


def test_an_exact_number_is_taken_exactly_and_kept_within_the_limits(machine: SteppedMachine, arm: str) -> None:
    model = open_sliders(machine, arm)
    for requested, got in ((0.123456, 0.123456), (5.0, 2.0), (-9.0, -1.0)):
        model.request("value", "bend", requested)
        machine.advance(0.1)
        assert value(model, "bend") == got


def test_center_goes_to_the_zeros_and_randomize_stays_within_the_limits(machine: SteppedMachine, arm: str) -> None:
    model = open_sliders(machine, arm, "--ros-args", "-p", "zeros.turn:=1.0")
    model.request("randomize")
    machine.advance(0.1)
    assert all(slider.minimum <= slider.value <= slider.maximum for slider in model.sliders)
    assert value(model, "turn") != pytest.approx(1.0, abs=1e-3)
    model.request("center")
    machine.advance(0.1)
    assert value(model, "turn") == pytest.approx(1.0, abs=2 * math.pi / 10_000)
    assert value(model, "far") == pytest.approx(1.5)


def test_its_log_says_centering_and_randomizing(machine: SteppedMachine) -> None:
    running = machine.start("joint_state_publisher_gui", "joint_state_publisher_gui", str(shipped_model()), screen=True)
    machine.display.windows[-1].model.request("randomize")
    machine.advance(0.1)
    assert running.log == [f"[INFO] [joint_state_publisher]: {word}" for word in ("Centering", "Randomizing")]


def test_a_source_moves_the_sliders(machine: SteppedMachine) -> None:
    model = open_sliders(machine, str(shipped_model()), "--ros-args", "-p", "source_list:=[wheels]")
    source = machine.node.create_publisher(JointState, "/wheels", 10)
    machine.advance(0.1)
    source.publish(JointState(name=["left_wheel_joint"], position=[1.0]))
    machine.advance(0.1)
    assert value(model, "left_wheel_joint") == pytest.approx(1.0, abs=1e-3)


def test_wheel_spinner_beside_it_is_named_and_the_wheel_jumps_to_and_fro(machine: SteppedMachine) -> None:
    seen = machine.watch(JointState, "/joint_states", 100)
    model = open_sliders(machine, str(shipped_model()))
    running = machine.start("day6_bot", "wheel_spinner")
    machine.advance(3.0)
    assert model.others == ("wheel_spinner",)
    left = [dict(zip(state.name, state.position, strict=True))["left_wheel_joint"] for state in seen]
    jumps = sum(abs(b - a) > 0.5 for a, b in zip(left, left[1:], strict=False))  # noqa: RUF007
    assert jumps > 20
    running.program.interrupt()
    machine.advance(1.0)
    assert model.others == ()


def test_closing_the_window_ends_it(machine: SteppedMachine) -> None:
    running = machine.start("joint_state_publisher_gui", "joint_state_publisher_gui", screen=True)
    machine.display.windows[0].close_by_user()
    machine.advance(0.1)
    assert running.program.status is not None


def test_limits_that_are_no_numbers_get_no_slider(machine: SteppedMachine, tmp_path: Any) -> None:
    file = tmp_path / "nan.urdf"
    file.write_text(
        '<robot name="r"><joint name="j" type="revolute"><limit lower="nan" upper="inf"/></joint></robot>', "utf-8"
    )
    model = open_sliders(machine, str(file))
    machine.advance(0.5)
    assert model.sliders == () and model.described


def test_without_a_screen_it_says_so_and_publishes_zeros(machine: SteppedMachine) -> None:
    seen = machine.watch(JointState, "/joint_states")
    running = machine.start("joint_state_publisher_gui", "joint_state_publisher_gui", str(shipped_model()))
    machine.advance(0.5)
    assert "There is no screen for the sliders" in running.errors
    assert list(seen[-1].position) == [0.0, 0.0]
