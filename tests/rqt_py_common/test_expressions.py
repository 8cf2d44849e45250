"""What may be typed into a field: a part of Python, of which nothing is ever run."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from day6_core.ros.programs.rqt_py_common.expressions import NAMES, ExpressionError, evaluate
from tests.support.folded import folded


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.5", 1.5),
        ("-2", -2),
        ("0x10", 16),
        ("True", True),
        ("'turtle2'", "turtle2"),
        ('"a" + "b"', "ab"),
        (" 7 ", 7),
        ("[1, 2.0, 'x']", [1, 2.0, "x"]),
        ("(1, 2)", (1, 2)),
        ("[0] * 3", [0, 0, 0]),
        ("2 ** 10 // 3 % 7", 5),
        ("1 << 4 | 1", 17),
        ("2 * pi", 2 * math.pi),
        ("sin(pi / 2)", 1.0),
        ("max([3, 1], [2])", [3, 1]),
        ("round(2.567, 2)", 2.57),
        ("sum([1, 2])", 3),
        ("1 if 2 > 1 else 0", 1),
        ("1 < 2 < 3", True),
        ("not 0 and 5", 5),
        ("'abc'[1:]", "bc"),
        ("'Hello %d' % 7", "Hello 7"),
        ("f'Hello {3:.1f}'", "Hello 3.0"),
        ("len('ab')", 2),
    ],
)
def test_a_value_is_computed_as_python_computes_it(text: str, value: object) -> None:
    found = evaluate(text)
    assert found == value and type(found) is type(value)


def test_names_of_the_caller_can_be_used() -> None:
    assert evaluate("sin(i / 10)", {**NAMES, "i": 5}) == math.sin(0.5)


def test_a_message_can_be_made_of_its_type() -> None:
    point = evaluate("geometry_msgs.msg.Point(x=1.0)")
    assert (point.x, point.y) == (1.0, 0.0)


@folded(
    "text",
    [
        "turtle2",
        "",
        "1 +",
        "1; 2",
        "x = 1",
        "import os",
        "__import__('os')",
        "open('/etc/passwd')",
        "eval('1')",
        "().__class__.__bases__",
        "'a'.upper()",
        "lambda: 1",
        "(lambda: 1)()",
        "[x for x in [1]]",
        "print",
        "log",
        "1 / 0",
        "[1][5]",
        "sqrt(-1)",
        "sin('a')",
        "os.msg.system('ls')",
        "geometry_msgs.msg.Nothing()",
        "geometry_msgs.msg.Point(x='a')",
        "max(*[1, 2])",
        "'\0'",
        "\ud800",
    ],
)
def test_everything_else_is_refused_with_a_reason(text: str) -> None:
    with pytest.raises(ExpressionError) as refusal:
        evaluate(text)
    assert str(refusal.value)


@pytest.mark.parametrize(
    "text",
    [
        "9 ** 9 ** 9",
        "1 << 10 ** 10",
        "[0] * 10 ** 9",
        "'a' * 10 ** 9",
        "10 ** 9 * [0]",
        "[[0] * 1000] * 10 ** 6",
        "str([[0] * 1000] * 10 ** 6)",
        "'%1000000000d' % 1",
        "'%*d' % (10 ** 9, 1)",
        "f'{1:1000000000d}'",
        "f'{1:{10 ** 9}d}'",
        "sum([[1] * 1000] * 1000, [])",
        "factorial(10 ** 6)",
        "-" * 5000 + "1",
        "(" * 5000 + "1" + ")" * 5000,
        "1 +" * 6600 + "1",
    ],
)
def test_what_would_use_up_memory_or_time_is_refused_at_once(text: str) -> None:
    with pytest.raises(ExpressionError):
        evaluate(text)


def test_rounding_to_any_digit_ends() -> None:
    assert evaluate("round(5, -10 ** 9)") == 0


def test_an_image_of_a_million_values_can_be_written() -> None:
    assert len(evaluate("[128] * 640 * 480 * 3")) == 640 * 480 * 3


_LEAVES = st.one_of(st.integers(-9, 9).map(str), st.sampled_from(["0.5", "True", "'ab'", "[1, 2]", "(3,)", "pi", "i"]))
_EXPRESSIONS = st.recursive(
    _LEAVES,
    lambda part: st.one_of(
        st.tuples(
            part, st.sampled_from(["+", "-", "*", "/", "//", "%", "**", "<<", "&", "|", "<", "==", "in"]), part
        ).map(lambda each: f"({' '.join(each)})"),
        part.map(lambda each: f"-({each})"),
        part.map(lambda each: f"(not {each})"),
        part.map(lambda each: f"abs({each})"),
        part.map(lambda each: f"str({each})"),
        st.tuples(part, part).map(lambda each: f"{each[0]}[{each[1]}]"),
        st.tuples(part, part, part).map(lambda each: f"({each[0]} if {each[1]} else {each[2]})"),
        st.tuples(part, part).map(lambda each: f"({each[0]} or {each[1]})"),
    ),
    max_leaves=6,
)


@given(_EXPRESSIONS)
@pytest.mark.filterwarnings("ignore::SyntaxWarning")
def test_what_is_computed_is_what_python_computes(text: str) -> None:
    names = {**NAMES, "i": 3}
    try:
        found = evaluate(text, names)
    except ExpressionError as error:
        if not any(word in str(error) for word in ("too large", "more than")):
            with pytest.raises((ArithmeticError, LookupError, TypeError, ValueError)):
                eval(text, {"__builtins__": {}}, dict(names))
        return
    assert repr(found) == repr(eval(text, {"__builtins__": {}}, dict(names)))
