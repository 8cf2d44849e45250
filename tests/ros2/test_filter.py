"""`--filter` looks at a message and can do nothing else."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from day6_core.ros.ros2.topic._filter import FilterError, evaluate
from tests.support.folded import folded


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("m.data == 'ten 10'", True),
        ("m.data.endswith('0')", True),
        ("'ten' in m.data and not m.data.isdigit()", True),
        ("len(m.data) > 3 or 1 / 0", True),
        ("int(m.data.split()[1]) % 2 == 0", True),
        ("m.data[0] if m.data else None", "t"),
        ("1 < len(m.data) <= 6", True),
        ("sum(int(c) for c in m.data if c.isdigit())", 1),
        ("[c for c in m.data][-1:]", ["0"]),
        ("max(1, 2) + abs(-3)", 5),
    ],
)
def test_an_expression_means_what_python_means(expression, expected):
    assert evaluate(expression, String(data="ten 10")) == expected


def test_fields_of_fields_and_arrays_can_be_read():
    message = Twist()
    message.linear.x = 2.0
    assert evaluate("m.linear.x > 1.5 and m.angular.z == 0", message)
    assert evaluate("any(p > 0.4 for p in m.position)", JointState(position=[0.1, 0.5]))


@pytest.mark.parametrize(
    "expression",
    [
        "m.__class__",
        "().__class__.__bases__",
        "m.data.__len__()",
        "'{0.__class__}'.format(m)",
        "'%s' % m",
        "(lambda: 1)()",
        "m.data.format(1)",
        "[x for x in [1]][0].__add__(1)",
        "m.get_fields_and_field_types()",
        "10 ** 10 ** 10",
        "'a' * 10 ** 9",
        "range(10 ** 9)",
        "bytes(10 ** 9)",
        "1 << 10 ** 9",
        "all(all(True for j in range(99999)) for i in range(99999))",
        "f'{m.__class__}'",
        "(y := 5)",
    ],
)
def test_what_a_filter_must_not_do_is_refused_at_once(expression):
    with pytest.raises((FilterError, NameError)):
        evaluate(expression, String(data="x"))


@pytest.mark.parametrize(
    "expression", ["open('/etc/passwd')", "__import__('os')", "eval('1')", "exec('1')", "getattr(m, 'x')"]
)
def test_functions_that_act_do_not_exist(expression):
    with pytest.raises(NameError):
        evaluate(expression, String())


def test_a_misspelt_field_and_bad_syntax_raise_what_python_raises():
    with pytest.raises(AttributeError, match="'String' object has no attribute 'dat'"):
        evaluate("m.dat", String())
    with pytest.raises(SyntaxError, match="invalid syntax"):
        evaluate("m.data ==", String())


@folded(
    "expression",
    [
        *(
            "2 + 3",
            "2 - 3",
            "2 * 3",
            "7 / 2",
            "7 // 2",
            "7 % 4",
            "2 ** 5",
            "6 & 3",
            "6 | 3",
            "6 ^ 3",
            "1 << 4",
            "64 >> 2",
        ),
        *("-5", "+5", "~5", "not 5", "not 0", "1.5 * 2", "2 * 1.5", "2.0 ** 0.5", "2 ** -1", "[1] * 3", "3 * 'ab'"),
        *("1 == 1", "1 != 1", "1 < 2", "2 <= 2", "3 > 4", "4 >= 4", "None is None", "1 is not None", "1 in [1]"),
        *(
            "2 not in [1]",
            "1 < 2 < 3",
            "1 < 3 < 2",
            "3 < 1 < 2",
            "0 or 5",
            "0 and 5",
            "1 or 5",
            "1 and 5",
            "1 and 0 or 3",
        ),
        *("[1, 2, 3][1]", "[1, 2, 3][:2]", "[1, 2, 3][1:]", "[1, 2, 3, 4][::2]", "(1, 2)", "{1, 2}", "1 if 0 else 2"),
        *("1 if 1 else 2", "[a for a in range(5) if a % 2 if a > 1]", "[a * b for a in (1, 2) for b in (3, 4)]"),
        *("{a % 2 for a in range(5)}", "[a + b for a, b in [(1, 2), (3, 4)]]", "[a for (a, [b, c]) in [(1, [2, 3])]]"),
        *("sum(a for a in range(4))", "max(*[1, 5, 2])", "min([3, 1, 2])", "any([0, 1])", "all([0, 1])", "math.pi"),
        *("round(2.567, ndigits=1)", "int('ff', base=16)", "math.sqrt(16)", "'a,b'.split(',')", "'aXb'.lower()"),
        *("len('x' * 1000)", "len(range(1000000))", "sorted([2, 1], reverse=True)", "bytes(3)", "bytes([1, 2])"),
        *("b'abc'.hex()", "[1, 2, 1].count(1)", "(1, 2).index(2)", "divmod(7, 2)", "list(zip([1], [2]))", "True"),
    ],
)
def test_every_part_of_an_expression_means_what_it_means_in_python(expression):
    import math

    assert evaluate(f" {expression} ", String()) == eval(expression, {"math": math})


@pytest.mark.parametrize(
    ("expression", "error"),
    [
        ("'x' * 1000001", "a filter cannot make a value so large"),
        ("1000001 * [1]", "a filter cannot make a value so large"),
        ("bytes(1000001)", "a filter cannot make a value so large"),
        ("2 ** 500001", "a filter cannot make a value so large"),
        ("1 << 1000000", "a filter cannot make a value so large"),
        ("range(1000001)", "a filter cannot count so far"),
        ("b'%d' % 1", "a filter cannot format text"),
        ("[x for x.y in [1]]", "a filter cannot assign to this"),
        ("lambda: 1", "a filter cannot use Lambda"),
        ("[math.sqrt][0](4)", "a filter cannot call this"),
        ("[1].append(2)", "a filter cannot use .append"),
        ("m._data", "a filter cannot use ._data"),
    ],
)
def test_what_a_filter_cannot_is_said(expression, error):
    with pytest.raises(FilterError) as raised:
        evaluate(expression, String())
    assert str(raised.value) == error


@pytest.mark.parametrize(
    "expression", ["len('x' * 1000000)", "len(bytes(1000000))", "(2 ** 499999) > 1", "(1 << 999999) > 1"]
)
def test_the_largest_values_are_made(expression):
    assert evaluate(expression, String())


def test_a_filter_looks_at_numpy_arrays_by_what_does_not_act():
    from sensor_msgs.msg import Imu

    message = Imu()
    assert evaluate("m.orientation_covariance.max() == 0 and m.orientation_covariance.sum() < 1", message)
    with pytest.raises(FilterError, match=r"a filter cannot use \.tofile"):
        evaluate("m.orientation_covariance.tofile('x')", message)
