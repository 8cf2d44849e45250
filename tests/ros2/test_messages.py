"""Messages as text, and text as messages (rosidl_runtime_py)."""

from __future__ import annotations

import hashlib
import sys
from importlib.metadata import version
from types import ModuleType

import pytest
from geometry_msgs.msg import PointStamped, Polygon, PoseWithCovariance, Twist
from rosidl_parser.definition import NamespacedType, UnboundedSequence
from rosidl_runtime_py import (
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)
from rosidl_runtime_py.convert import _convert_value
from rosidl_runtime_py.import_message import import_message_from_namespaced_type
from rosidl_runtime_py.utilities import get_action, get_interface, get_message, get_service
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool, Float64, Int32, Int32MultiArray, String, UInt8MultiArray
from test_msgs import message_fixtures, service_fixtures


def test_yaml_is_nested_unfolded_and_unicode():
    text = message_to_yaml(JointState(name=["a", "关节"], position=[0.5]))
    assert text == (
        "header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ''\nname:\n- a\n- 关节\nposition:\n- 0.5\n"
        "velocity: []\neffort: []\n"
    )
    assert message_to_yaml(String(data="word " * 60)).count("\n") == 1


def test_flow_style_puts_sequences_but_not_messages_on_one_line():
    assert message_to_yaml(JointState(position=[1.0, 2.0]), flow_style=True).splitlines()[0] == "header:"
    assert "position: [1.0, 2.0]\n" in message_to_yaml(JointState(position=[1.0, 2.0]), flow_style=True)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("yes", "data: 'yes'"),
        ("42", "data: '42'"),
        ("", "data: ''"),
        ("a\nb", "data: 'a\n\n  b'"),
        ("你好", "data: 你好"),
    ],
)
def test_strings_that_yaml_would_misread_are_quoted(value, text):
    assert message_to_yaml(String(data=value)) == f"{text}\n"


@pytest.mark.parametrize(
    ("value", "text"), [(float("nan"), ".nan"), (float("inf"), ".inf"), (1e-7, "1.0e-07"), (-0.0, "-0.0")]
)
def test_floats_are_written_as_yaml_floats(value, text):
    assert message_to_yaml(Float64(data=value)) == f"data: {text}\n"


def test_long_arrays_and_strings_are_cut_and_marked():
    cut = message_to_yaml(UInt8MultiArray(data=bytes(5)), truncate_length=2)
    assert cut.endswith("data:\n- 0\n- 0\n- '...'\n")
    assert message_to_yaml(String(data="abcdef"), truncate_length=3) == "data: abc...\n"
    assert message_to_csv(UInt8MultiArray(data=bytes(5)), truncate_length=2) == "0,0,0,..."


def test_left_out_arrays_and_strings_leave_a_note():
    text = message_to_yaml(JointState(name=["x"]), no_arr=True, no_str=True)
    assert "frame_id: '<string length: <0>>'" in text
    assert "name: '<sequence type: string, length: 1>'" in text
    assert "covariance: '<array type: double[36]>'" in message_to_yaml(PoseWithCovariance(), no_arr=True)


def test_csv_has_every_value_but_no_comma_after_an_empty_beginning():
    assert message_to_csv(JointState(name=["a", "b"], position=[0.5])) == "0,0,,a,b,0.5,,"
    assert message_to_csv(UInt8MultiArray(data=[7])) == "0,7"


def test_the_ordered_dict_has_plain_values_only():
    plain = message_to_ordereddict(Twist())
    assert plain == {"linear": {"x": 0.0, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.0}}


@pytest.mark.parametrize(
    ("message", "values", "expected"),
    [
        (String(), {"data": True}, String(data="True")),
        (String(), {"data": None}, String(data="None")),
        (Int32(), {"data": 1.5}, Int32(data=1)),
        (Bool(), {"data": 1}, Bool(data=True)),
        (Float64(), {"data": "2"}, Float64(data=2.0)),
        (Int32MultiArray(), {"data": [1, 2]}, Int32MultiArray(data=[1, 2])),
    ],
)
def test_values_are_converted_by_the_type_of_the_field(message, values, expected):
    assert set_message_fields(message, values) == []
    assert message == expected


def test_arrays_of_messages_are_filled_one_by_one():
    message = Polygon()
    set_message_fields(message, {"points": [{"x": 1.0}, {"y": 2}]})
    assert [(point.x, point.y) for point in message.points] == [(1.0, 0.0), (0.0, 2.0)]


def test_auto_headers_and_now_give_functions_that_stamp():
    message = PointStamped()
    stamps = set_message_fields(message, {"header": "auto"}, expand_header_auto=True)
    stamp = type(message.header.stamp)(sec=3)
    for each in stamps:
        each(stamp)
    assert message.header.stamp.sec == 3
    stamps = set_message_fields(message, {"header": {"stamp": "now"}}, expand_time_now=True)
    assert len(stamps) == 1


@pytest.mark.parametrize(
    ("message", "values", "error"),
    [
        (String(), {"dat": 1}, "'String' object has no attribute 'dat'"),
        (Twist(), {"linear": 2.0}, "Value '2.0' is expected to be a dictionary but is a float"),
        (Twist(), {"linear": {"x": "abc"}}, "could not convert string to float: 'abc'"),
        (Twist(), {False: 1}, "attribute name must be string, not 'bool'"),
        (String(), [1], "Value '[1]' is expected to be a dictionary but is a list"),
    ],
)
def test_wrong_values_fail_in_the_words_a_user_will_search_for(message, values, error):
    with pytest.raises((AttributeError, TypeError, ValueError)) as caught:
        set_message_fields(message, values)
    assert str(caught.value) == error


def test_interfaces_are_found_by_full_and_short_names():
    assert get_message("std_msgs/msg/String") is String
    assert get_message("std_msgs/String") is String
    assert get_service("std_srvs/srv/Empty").__name__ == "Empty"
    assert get_action("turtlesim/action/RotateAbsolute").__name__ == "RotateAbsolute"
    assert get_interface("turtlesim/action/RotateAbsolute_FeedbackMessage").__name__.endswith("FeedbackMessage")


@pytest.mark.parametrize(
    "name",
    [
        "std_msg/msg/String",
        "std_msgs/msg/Strng",
        "String",
        "std_srvs/srv/Empty",
        "",
        "os/path/join",
        "std_msgs//String",
    ],
)
def test_what_is_no_message_raises_one_of_three_errors(name):
    with pytest.raises((AttributeError, ModuleNotFoundError, ValueError)):
        get_message(name)


@pytest.mark.parametrize("name", ["/", "/std_msgs/msg/String", "../x/y"])
def test_a_name_that_begins_with_a_slash_or_dots_is_taken_for_a_relative_import(name):
    with pytest.raises(TypeError, match=r"required to perform a relative import for '.*'"):
        get_message(name)


def test_an_action_s_parts_are_not_beside_it_but_in_its_own_module():
    import test_msgs.action
    from test_msgs.action._fibonacci import Fibonacci_Goal

    assert test_msgs.action.Fibonacci.Goal is Fibonacci_Goal
    assert hasattr(test_msgs.action, "Fibonacci_SendGoal_Request")
    for part in ("Goal", "Result", "Feedback", "SendGoal", "FeedbackMessage"):
        assert not hasattr(test_msgs.action, f"Fibonacci_{part}")


def test_the_lists_of_interfaces_leave_parts_of_services_out():
    assert "msg/String" in get_message_interfaces()["std_msgs"]
    assert get_interfaces(["std_srvs"]) == {"std_srvs": ["srv/Empty", "srv/SetBool", "srv/Trigger"]}
    with pytest.raises(LookupError, match="Unknown package 'nope'"):
        get_interfaces(["nope"])


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("String", "Expected at least two parts"),
        ("std_msgs//String", "Must not contain empty parts"),
        ("std_msgs/../x", r"Must not contain '\.\.'"),
        ("nope/msg/X", "Unknown package 'nope'"),
        ("std_msgs/msg/Strng", "Could not find the interface '.*Strng.idl'"),
        ("std_msgs/msg/String.idl", "Could not find the interface '.*/String.idl'"),
    ],
)
def test_paths_of_definitions_that_are_not_there(name, error):
    with pytest.raises((ValueError, LookupError), match=error):
        get_interface_path(name)
    assert get_interface_path("std_msgs/msg/String").endswith("String.msg")


def test_another_thread_may_just_be_importing_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numpy", ModuleType("numpy"))  # as it is before its first line has run
    message = JointState()
    set_message_fields(message, {"name": ["wheel"], "position": [0.5]})
    assert message_to_ordereddict(message)["position"] == [0.5]


def test_values_are_converted_and_shortened_as_real_tools_do():
    assert _convert_value({1: ("123", b"456", 7)}, truncate_length=2) == {1: ("12...", "45...", "...")}
    assert _convert_value(True) is True


def test_an_array_of_a_type_finds_its_class_with_a_warning():
    kind = NamespacedType(["std_msgs", "msg"], "String")
    with pytest.warns(DeprecationWarning, match="please pass a NamespacedType object directly"):
        assert import_message_from_namespaced_type(UnboundedSequence(kind)) is String
    assert import_message_from_namespaced_type(kind) is String


_FIXTURES = {
    "Builtins": "3e69d05a8eeb",
    "Empty": "e9bdd07b6bd3",
    "BasicTypes": "a9fc7a7b694c",
    "Constants": "1e4e0cce5b33",
    "Defaults": "d74433611e24",
    "Strings": "1c1f3cc45b81",
    "Nested": "5e850a73d6a1",
    "Arrays": "8b8378d3fac5",
    "BoundedPlainSequences": "02276bc47848",
    "BoundedSequences": "45fb7134f26f",
    "UnboundedSequences": "9630f09cd6f5",
    "MultiNested": "deb5b23b9009",
    "WStrings": "06db4ec4e53a",
}
_SERVICE_FIXTURES = {
    "Arrays": "3a7a8e1db75c",
    "BasicTypes": "7ed3d59e406d",
    "Empty": "e8455d98f3d6",
}
"""The beginning of the SHA-1 of what real Kilted's fixtures look like as text."""


@pytest.mark.skipif(version("numpy").startswith("1."), reason="recorded with NumPy 2: 1 has other names and defaults")
def test_the_fixtures_of_test_msgs_are_the_real_ones():
    def begin(value: object) -> str:
        return hashlib.sha1(repr(value).encode()).hexdigest()[:12]

    assert {name: begin(message_fixtures.get_test_msg(name)) for name in _FIXTURES} == _FIXTURES
    assert {name: begin(service_fixtures.get_test_srv(name)) for name in _SERVICE_FIXTURES} == _SERVICE_FIXTURES
    assert [message_fixtures.int_from_uint(value, 8) for value in (0, 127, 128, 255, 700)] == [0, 127, -128, -1, -68]
    for find in (message_fixtures.get_test_msg, service_fixtures.get_test_srv):
        with pytest.raises(NotImplementedError):
            find("Nothing")
