"""The places of a slider: which values a range allows, and which keys lead to them."""

from __future__ import annotations

import math
import sys

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor

from day6_core.ros.programs.rqt_reconfigure.ranges import Range, range_of


def whole(low: int, high: int, step: int = 0) -> Range | None:
    return range_of(ParameterDescriptor(integer_range=[IntegerRange(from_value=low, to_value=high, step=step)]))


def real(low: float, high: float, step: float = 0.0) -> Range | None:
    found = FloatingPointRange(from_value=low, to_value=high, step=step)
    return range_of(ParameterDescriptor(floating_point_range=[found]))


def test_an_arrow_key_moves_by_the_step_of_the_descriptor() -> None:
    assert whole(0, 255).moved(69, 1) == 70
    assert whole(0, 100, 25).moved(50, -1) == 25
    assert real(0.0, 1.0, 0.1).moved(0.2, 1) == 0.3


def test_without_a_step_a_number_moves_by_a_hundredth_of_its_range() -> None:
    assert real(-1.0, 1.0).moved(0.0, 1) == 0.02


def test_the_ends_are_reached_and_not_passed() -> None:
    assert whole(0, 255).moved(250, 10) == 255
    assert whole(0, 255).moved(3, -10) == 0
    assert real(0.0, 1.0, 0.4).moved(0.8, 1) == 1.0


def test_an_end_between_two_steps_leads_back_to_the_last_step() -> None:
    assert whole(0, 10, 3).moved(10, -1) == 9
    assert whole(0, 10, 3).moved(9, 1) == 10
    assert whole(0, 10, 3).moved(7, 1) == 9


def test_a_value_outside_or_not_a_number_comes_back_into_the_range() -> None:
    assert whole(0, 10).moved(40, -1) == 9
    assert real(0.0, 1.0).moved(math.nan, 1) == 0.01
    assert real(0.0, 1.0).moved(math.inf, -1) == 0.99
    assert real(0.0, 1.0).place(math.nan) == 0.0
    assert (real(0.0, 1.0).place(7.0), real(0.0, 1.0).place(-7.0)) == (1.0, 0.0)


def test_the_mouse_finds_the_allowed_value_next_to_it() -> None:
    assert [whole(0, 4).at(place / 8) for place in (0, 3, 8)] == [0, 2, 4]
    assert real(0.0, 1.0, 0.25).at(0.4) == 0.5
    assert whole(0, 10, 3).at(1.0) == 10


@pytest.mark.parametrize(
    "found",
    [real(1.0, 0.0), real(math.nan, 1.0), real(0.0, math.inf), real(2.0, 2.0), whole(5, 1), real(-1e308, 1e308)],
)
def test_a_range_that_says_nothing_is_no_slider(found) -> None:
    assert found is None


@pytest.mark.parametrize("step", [0.0, -1.0, math.nan, math.inf])
def test_a_step_that_says_nothing_is_none(step) -> None:
    assert real(0.0, 10.0, step).moved(5.0, 1) == 5.1


def test_the_largest_integers_stay_exact() -> None:
    least, greatest = -(2**63), 2**63 - 1
    found = whole(least, greatest)
    assert found.moved(greatest - 1, 1) == greatest
    assert found.moved(2**62 + 1, 1) == 2**62 + 2
    assert least <= found.at(0.3) <= greatest
    assert found.moved(sys.maxsize, 10) == greatest
