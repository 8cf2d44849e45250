"""`--filter` looks at a message and can do nothing else."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from day6_tui.core.ros.ros2.topic._filter import FilterError, evaluate


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
