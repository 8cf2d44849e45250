"""Range: where the cone of a distance sensor is, how large, and when there is none."""

from __future__ import annotations

import math
from typing import Any

import pytest
from sensor_msgs.msg import Range

from day6_core.ros.programs.rviz2.model.scene import CONE, Shape, placed
from tests.rviz2.rviz_machine import RVizMachine, lines


def measured(metres: float, low: float = 0.1, high: float = 4.0, view: float = math.pi / 2) -> Range:
    message = Range(field_of_view=view, min_range=low, max_range=high, range=metres)
    message.header.frame_id = "sonar"
    return message


@pytest.fixture
def display(machine: RVizMachine) -> Any:
    """A sonar one metre in front of the middle of the car."""
    machine.open()
    machine.transform("base_link", "sonar", (1.0, 0.0, 0.0))
    machine.fix("base_link")
    return machine.add("Range", "/sonar")


def cones(machine: RVizMachine) -> list[Shape]:
    return [shape for shape in machine.rviz.scene.shapes if shape.kind == CONE]


def test_the_tip_is_at_the_sensor_and_the_foot_where_something_was_found(machine: RVizMachine, display: Any) -> None:
    machine.publish("/sonar", measured(2.0))
    (cone,) = cones(machine)
    assert cone.size == pytest.approx((4.0, 4.0, 2.0))  # 90 degrees: at two metres four metres wide
    assert placed(cone.pose, (0.0, 0.0, 1.0)) == pytest.approx((1.0, 0.0, 0.0))
    assert placed(cone.pose, (0.0, 0.0, -1.0)) == pytest.approx((3.0, 0.0, 0.0))
    assert lines(display)["Transform"] == ("Ok", "Ok")


def test_a_new_display_shows_one_half_transparent_white_cone(machine: RVizMachine, display: Any) -> None:
    assert [child.name for child in display.children[-4:]] == ["Topic", "Color", "Alpha", "Buffer Length"]
    for metres in (1.0, 2.0):
        machine.publish("/sonar", measured(metres))
    (cone,) = cones(machine)
    assert cone.colour == (1.0, 1.0, 1.0, 0.5) and cone.size[2] == 2.0


def test_colour_and_alpha_change_the_cones_that_are_there(machine: RVizMachine, display: Any) -> None:
    machine.publish("/sonar", measured(1.0))
    machine.do(lambda: (display.child("Color").set((255, 0, 0)), display.child("Alpha").set(0.25)))
    assert [cone.colour for cone in cones(machine)] == [(1.0, 0.0, 0.0, 0.25)]


def test_the_buffer_keeps_as_many_measurements_as_it_is_long(machine: RVizMachine, display: Any) -> None:
    machine.do(lambda: display.child("Buffer Length").set(3))
    for metres in (0.5, 1.0, 2.0, 3.0):
        machine.publish("/sonar", measured(metres))
    assert [cone.size[2] for cone in cones(machine)] == [1.0, 2.0, 3.0]
    machine.publish("/sonar", measured(math.inf))
    assert [cone.size[2] for cone in cones(machine)] == [2.0, 3.0], "nothing found takes the place of a measurement"
    machine.do(lambda: display.child("Buffer Length").set(2))
    assert [cone.size[2] for cone in cones(machine)] == [3.0]


@pytest.mark.parametrize("metres", [0.05, 4.5, -1.0, math.inf, -math.inf, math.nan])
def test_what_is_no_measurement_has_no_cone(machine: RVizMachine, display: Any, metres: float) -> None:
    machine.publish("/sonar", measured(1.0))
    machine.publish("/sonar", measured(metres))
    assert cones(machine) == [] and lines(display)["Transform"] == ("Ok", "Ok")


@pytest.mark.parametrize(("metres", "heights"), [(-math.inf, [0.5]), (0.5, [0.5]), (math.inf, []), (math.nan, [])])
def test_a_sensor_of_one_fixed_distance_says_yes_or_no(
    machine: RVizMachine, display: Any, metres: float, heights: list[float]
) -> None:
    machine.publish("/sonar", measured(metres, 0.5, 0.5))
    assert [cone.size[2] for cone in cones(machine)] == heights


@pytest.mark.parametrize("view", [0.0, math.nan, math.inf])
def test_a_field_of_view_that_is_none_has_no_cone(machine: RVizMachine, display: Any, view: float) -> None:
    machine.publish("/sonar", measured(1.0, view=view))
    assert cones(machine) == []


def test_reset_forgets_the_cones(machine: RVizMachine, display: Any) -> None:
    machine.publish("/sonar", measured(1.0))
    machine.do(machine.rviz.reset)
    assert cones(machine) == []


def test_a_topic_of_ranges_is_offered_as_a_range() -> None:
    from day6_core.ros.programs.rviz2.model.displays import types_for

    assert types_for("sensor_msgs/msg/Range") == ["Range"]
