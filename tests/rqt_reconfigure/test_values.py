"""Values as text: what a field shows can be typed again, and what does not fit the type is refused."""

from __future__ import annotations

import pytest

from day6_core.ros.programs.rqt_reconfigure.values import LONGEST, Unfitting, name_of, shown, text_of, value_from
from rclpy.parameter import Parameter

Type = Parameter.Type

VALUES = [
    (Type.BOOL, True),
    (Type.INTEGER, -(2**63)),
    (Type.DOUBLE, 0.1),
    (Type.STRING, " a 'b' \"c\" [1] "),
    (Type.BYTE_ARRAY, [b"\x00", b"\xff"]),
    (Type.BOOL_ARRAY, [True, False]),
    (Type.INTEGER_ARRAY, [1, -2]),
    (Type.DOUBLE_ARRAY, [1.0, 2.5, -1e300]),
    (Type.STRING_ARRAY, ["", "a, b", "\x1b]0;T\x07", 'say "no"', "1", "true"]),
    (Type.STRING_ARRAY, []),
]


@pytest.mark.parametrize(("kind", "value"), VALUES)
def test_what_is_shown_can_be_typed_again(kind, value) -> None:
    assert value_from(text_of(value), kind) == value


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (Type.BOOL, "1"),
        (Type.INTEGER, "1.5"),
        (Type.INTEGER, str(2**63)),
        (Type.INTEGER, ""),
        (Type.DOUBLE, "fast"),
        (Type.BYTE_ARRAY, "[256]"),
        (Type.BOOL_ARRAY, "[1]"),
        (Type.INTEGER_ARRAY, "[1.5]"),
        (Type.INTEGER_ARRAY, "[true]"),
        (Type.DOUBLE_ARRAY, "1.0"),
        (Type.STRING_ARRAY, "[[a]]"),
        (Type.STRING_ARRAY, "[a"),
        (Type.STRING_ARRAY, "{a: 1}"),
        (Type.DOUBLE_ARRAY, "[" * 5000),
        (Type.STRING_ARRAY, "!!python/object/apply:os.system [ls]"),
    ],
)
def test_a_text_of_another_type_is_refused(kind, text) -> None:
    with pytest.raises(Unfitting):
        value_from(text, kind)


def test_whole_numbers_are_doubles_where_doubles_are_meant() -> None:
    assert value_from("2", Type.DOUBLE) == 2.0
    assert value_from("[1, 2.5]", Type.DOUBLE_ARRAY) == [1.0, 2.5]


def test_a_long_value_is_shown_by_its_beginning_and_its_length() -> None:
    text = shown([1] * 1_000_000)
    assert len(text) < 4 * LONGEST and text.endswith("(1000000)")


def test_types_have_the_names_of_ros2_param() -> None:
    assert [name_of(kind) for kind in (1, 2, 6, 9)] == ["boolean", "integer", "boolean array", "string array"]
