"""Points in time and spans between them: rounding, limits, arithmetic, messages, with rclpy's own words for what is wrong."""

from __future__ import annotations

import operator
from collections.abc import Callable
from math import inf, nan
from typing import Any

import builtin_interfaces.msg
import pytest

from rclpy.clock_type import ClockType
from rclpy.duration import Duration, Infinite
from rclpy.time import Time

SECOND = 1_000_000_000
LARGEST = 2**63 - 1
SMALLEST = -(2**63)


@pytest.mark.parametrize(
    ("given", "nanoseconds"),
    [
        ({}, 0),
        ({"seconds": 1}, SECOND),
        ({"seconds": 0.1}, 100_000_000),
        ({"seconds": 1.9999999999}, 1_999_999_999),
        ({"seconds": 2, "nanoseconds": 5}, 2 * SECOND + 5),
        ({"nanoseconds": 7.9}, 7),
        ({"seconds": 0.0000000015, "nanoseconds": 0.9}, 1),
    ],
)
def test_parts_of_nanoseconds_are_cut_off(given: dict[str, Any], nanoseconds: int) -> None:
    assert Duration(**given).nanoseconds == nanoseconds
    assert Time(**given).nanoseconds == nanoseconds


@pytest.mark.parametrize(
    ("given", "nanoseconds"),
    [({"seconds": -1.5}, -1_500_000_000), ({"nanoseconds": -7.9}, -7), ({"seconds": -1}, -SECOND)],
)
def test_a_negative_duration_is_cut_off_towards_zero(given: dict[str, Any], nanoseconds: int) -> None:
    assert Duration(**given).nanoseconds == nanoseconds


@pytest.mark.parametrize("nanoseconds", [SMALLEST, LARGEST])
def test_a_duration_has_64_bits(nanoseconds: int) -> None:
    assert Duration(nanoseconds=nanoseconds).nanoseconds == nanoseconds


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Duration(nanoseconds=LARGEST + 1), OverflowError, "too large to store in C duration."),
        (lambda: Duration(nanoseconds=SMALLEST - 1), OverflowError, "too large to store in C duration."),
        (lambda: Duration(seconds=LARGEST), OverflowError, "too large to store in C duration."),
        (lambda: Time(nanoseconds=LARGEST + 1), OverflowError, "too large to store in C time point."),
        (lambda: Time(seconds=-1), ValueError, "Seconds value must not be negative"),
        (lambda: Time(nanoseconds=-1), ValueError, "Nanoseconds value must not be negative"),
        (lambda: Time(seconds=1, nanoseconds=-1), ValueError, "Nanoseconds value must not be negative"),
        (lambda: Time(clock_type="ROS_TIME"), TypeError, "Clock type must be a ClockType enum"),  # type: ignore[arg-type]
        (lambda: Time() - Duration(nanoseconds=1), ValueError, "Subtraction leads to negative time."),
        (lambda: Time(nanoseconds=LARGEST) + Duration(nanoseconds=1), OverflowError, "Addition leads to overflow"),
        (lambda: Duration(seconds=1) * nan, ValueError, "Can't multiply duration with nan"),
        (lambda: Duration(seconds=1) * -inf, ValueError, "Can't multiply duration with"),
        (
            lambda: Time.from_msg(builtin_interfaces.msg.Duration()),
            TypeError,
            "Must pass a builtin_interfaces.msg.Time",
        ),  # type: ignore[arg-type]
        (lambda: Duration.from_msg(builtin_interfaces.msg.Time()), TypeError, "Must pass a builtin_interfaces.msg.Dur"),  # type: ignore[arg-type]
    ],
)
def test_what_cannot_be_is_refused(make: Callable[[], Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        make()


def test_the_largest_time_and_the_smallest_are_allowed() -> None:
    assert Time(nanoseconds=LARGEST).nanoseconds == LARGEST
    assert Time().nanoseconds == 0
    assert (Time() - Duration()).nanoseconds == 0


@pytest.mark.parametrize(
    ("result", "expected"),
    [
        (Duration(seconds=2) + Duration(seconds=3), Duration(seconds=5)),
        (Duration(seconds=2) - Duration(seconds=3), Duration(seconds=-1)),
        (Duration(seconds=2) * 3, Duration(seconds=6)),
        (Duration(seconds=2) * 0.25, Duration(seconds=0.5)),
        (Duration(nanoseconds=3) * 0.5, Duration(nanoseconds=1)),
        (Duration(seconds=1) * inf, Infinite),
        (Time(seconds=5) - Time(seconds=3), Duration(seconds=2)),
        (Time(seconds=3) - Time(seconds=5), Duration(seconds=-2)),
        (Time(seconds=5) - Duration(seconds=3), Time(seconds=2)),
        (Time(seconds=5) + Duration(seconds=3), Time(seconds=8)),
        (Duration(seconds=3) + Time(seconds=5), Time(seconds=8)),
    ],
)
def test_times_and_durations_are_added_and_subtracted(result: Any, expected: Any) -> None:
    assert type(result) is type(expected)
    assert result == expected


def test_arithmetic_keeps_the_kind_of_clock() -> None:
    time = Time(seconds=5, clock_type=ClockType.STEADY_TIME)
    assert (time + Duration(seconds=1)).clock_type == ClockType.STEADY_TIME
    assert (time - Duration(seconds=1)).clock_type == ClockType.STEADY_TIME
    assert Time().clock_type == ClockType.SYSTEM_TIME
    assert Time.from_msg(builtin_interfaces.msg.Time()).clock_type == ClockType.ROS_TIME


ORDER = [operator.lt, operator.le, operator.eq, operator.ne, operator.ge, operator.gt]


@pytest.mark.parametrize("kind", [Time, Duration])
@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        (1, 2, [True, True, False, True, False, False]),
        (2, 2, [False, True, True, False, True, False]),
        (3, 2, [False, False, False, True, True, True]),
    ],
)
def test_times_and_durations_are_in_order(kind: Any, one: int, other: int, expected: list[bool]) -> None:
    assert [compare(kind(nanoseconds=one), kind(nanoseconds=other)) for compare in ORDER] == expected


@pytest.mark.parametrize("compare", ORDER)
def test_times_of_different_clocks_cannot_be_compared(compare: Callable[[Any, Any], bool]) -> None:
    with pytest.raises(TypeError, match="Can't compare times with different clock types"):
        compare(Time(), Time(clock_type=ClockType.ROS_TIME))


def test_times_of_different_clocks_cannot_be_subtracted() -> None:
    with pytest.raises(TypeError, match="Can't subtract times with different clock types"):
        Time() - Time(clock_type=ClockType.ROS_TIME)


@pytest.mark.parametrize("value", [Time(seconds=1), Duration(seconds=1)])
@pytest.mark.parametrize("compare", [operator.lt, operator.le, operator.ge, operator.gt, operator.add, operator.sub])
def test_a_number_is_neither_a_time_nor_a_duration(value: Any, compare: Callable[[Any, Any], Any]) -> None:
    with pytest.raises(TypeError, match=r"not supported between|unsupported operand"):
        compare(value, 1)
    assert value != SECOND


def test_a_duration_is_multiplied_by_numbers_only() -> None:
    with pytest.raises(TypeError):
        Duration(seconds=1) * "2"  # type: ignore[operator]


@pytest.mark.parametrize("kind", [Time, Duration])
def test_times_and_durations_are_no_keys(kind: Any) -> None:
    with pytest.raises(TypeError, match="unhashable"):
        hash(kind())


@pytest.mark.parametrize(
    ("nanoseconds", "parts"), [(0, (0, 0)), (SECOND - 1, (0, SECOND - 1)), (3 * SECOND + 4, (3, 4))]
)
def test_a_time_becomes_a_message_and_comes_back(nanoseconds: int, parts: tuple[int, int]) -> None:
    time = Time(nanoseconds=nanoseconds, clock_type=ClockType.ROS_TIME)
    message = time.to_msg()
    assert (message.sec, message.nanosec) == time.seconds_nanoseconds() == parts
    assert Time.from_msg(message) == time
    assert Time.from_msg(message, ClockType.STEADY_TIME).clock_type == ClockType.STEADY_TIME


@pytest.mark.parametrize(
    ("nanoseconds", "parts"), [(3 * SECOND + 4, (3, 4)), (-1, (-1, SECOND - 1)), (-3 * SECOND, (-3, 0)), (0, (0, 0))]
)
def test_a_duration_becomes_a_message_and_comes_back(nanoseconds: int, parts: tuple[int, int]) -> None:
    message = Duration(nanoseconds=nanoseconds).to_msg()
    assert (message.sec, message.nanosec) == parts
    assert Duration.from_msg(message).nanoseconds == nanoseconds


def test_times_and_durations_show_their_nanoseconds() -> None:
    assert repr(Time(seconds=1, clock_type=ClockType.ROS_TIME)) == "Time(nanoseconds=1000000000, clock_type=ROS_TIME)"
    assert repr(Duration(seconds=-1)) == "Duration(nanoseconds=-1000000000)"
    assert str(Duration(nanoseconds=5)) == "5 nanoseconds"
    assert str(Infinite) == "Infinite"
    assert Infinite.nanoseconds == LARGEST
    assert Duration(nanoseconds=5).get_c_duration().nanoseconds == 5


def test_a_time_is_a_datetime_but_not_that_of_a_steady_clock() -> None:
    from datetime import datetime

    assert Time(seconds=3, nanoseconds=500_000_000).to_datetime() == datetime.fromtimestamp(3.5)
    with pytest.raises(TypeError, match="should be either ROS_TIME or SYSTEM_TIME"):
        Time(clock_type=ClockType.STEADY_TIME).to_datetime()
