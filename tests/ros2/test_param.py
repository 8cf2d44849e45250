"""`ros2 param …` on a stepped machine."""

from __future__ import annotations

import os
import sys

import pytest
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor


def build(node):
    node.declare_parameter(
        "speed",
        3,
        ParameterDescriptor(description="of it", integer_range=[IntegerRange(from_value=0, to_value=10, step=1)]),
    )
    node.declare_parameter("name", "kame")
    node.declare_parameter("wheel.radius", 0.5)
    node.declare_parameter("flags", [True, False])
    node.declare_parameter("raw", [b"\x01", b"\xff"])
    node.declare_parameter("fixed", "x", ParameterDescriptor(read_only=True))
    node.declare_parameter("free", "x", ParameterDescriptor(dynamic_typing=True))


@pytest.fixture
def node(machine):
    return machine.node("robot", build)


def test_the_list_is_sorted_under_the_name_of_the_node(machine, node):
    names = [
        "fixed",
        "flags",
        "free",
        "name",
        "raw",
        "speed",
        "start_type_description_service",
        "use_sim_time",
        "wheel.radius",
    ]
    assert machine.ros2("param", "list").stdout == "/robot:\n" + "".join(f"  {name}\n" for name in names)
    assert machine.ros2("param", "list", "robot", "--filter", "f.*").stdout == "  fixed\n  flags\n  free\n"
    assert machine.ros2("param", "list", "/robot", "--param-prefixes", "wheel").stdout == "  wheel.radius\n"
    assert "  speed (type: integer)\n" in machine.ros2("param", "list", "/robot", "--param-type").stdout


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("speed", "Integer value is: 3\n"),
        ("name", "String value is: kame\n"),
        ("wheel.radius", "Double value is: 0.5\n"),
        ("flags", "Boolean values are: [True, False]\n"),
        ("raw", "Byte values are: [b'\\x01', b'\\xff']\n"),
    ],
)
def test_get_names_the_type(machine, node, name, text):
    assert machine.ros2("param", "get", "/robot", name) == (text, "", 0)


def test_get_of_what_is_not_there(machine, node):
    assert machine.ros2("param", "get", "/robot", "nope") == ("", "Parameter not set\n", 1)
    assert machine.ros2("param", "get", "/nobody", "x") == ("", "Node not found\n", 1)
    assert machine.ros2("param", "get", "--hide-type", "robot", "name").stdout == "kame\n"


@pytest.mark.parametrize(
    ("name", "value", "answer"),
    [
        ("speed", "7", ("Set parameter successful\n", "", 0)),
        ("name", '"5"', ("Set parameter successful\n", "", 0)),
        ("flags", "[false]", ("Set parameter successful\n", "", 0)),
        (
            "speed",
            "11",
            ("", "Setting parameter failed: Parameter speed out of range. Min: 0, Max: 10, value: 11\n", 0),
        ),
        ("speed", "fast", ("", "Setting parameter failed: Wrong parameter type, expected '2' got '4'\n", 0)),
        ("name", "5", ("", "Setting parameter failed: Wrong parameter type, expected '4' got '2'\n", 0)),
        ("fixed", "y", ("", "Setting parameter failed: Trying to set a read-only parameter: fixed.\n", 0)),
    ],
)
def test_set_guesses_the_type_and_passes_the_refusal_on(machine, node, name, value, answer):
    assert machine.ros2("param", "set", "/robot", name, value) == answer


def test_what_was_set_is_what_the_node_has(machine, node):
    machine.ros2("param", "set", "/robot", "wheel.radius", "0.25")
    assert node.get_parameter("wheel.radius").value == 0.25


def test_describe_shows_the_limits(machine, node):
    assert machine.ros2("param", "describe", "/robot", "speed").stdout == (
        "Parameter name: speed\n  Type: integer\n  Description: of it\n  Constraints:\n"
        "    Min value: 0\n    Max value: 10\n    Step: 1\n"
    )


def test_delete_works_for_dynamic_parameters_only(machine, node):
    assert machine.ros2("param", "delete", "/robot", "free").stdout == "Deleted parameter successfully\n"
    assert machine.ros2("param", "delete", "/robot", "name").stderr == (
        "Deleting parameter failed: Static parameter cannot be undeclared\n"
    )


def test_a_dump_can_be_loaded_again(machine, node):
    dumped = machine.ros2("param", "dump", "/robot").stdout
    assert dumped.startswith("/robot:\n  ros__parameters:\n    fixed: x\n    flags:\n    - true\n    - false\n")
    assert "    wheel:\n      radius: 0.5\n" in dumped
    (machine.cwd / "p.yaml").write_text(
        "/robot:\n  ros__parameters:\n    speed: 4\n    wheel:\n      radius: 0.125\n", encoding="utf-8"
    )
    result = machine.ros2("param", "load", "/robot", "p.yaml")
    assert result.stdout == "Set parameter speed successful\nSet parameter wheel.radius successful\n"
    assert node.get_parameter("wheel.radius").value == 0.125


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("/other:\n  ros__parameters:\n    speed: 4\n", "Param file does not contain any valid parameters\n"),
        ("/robot:\n  speed: 4\n", "KeyError: 'ros__parameters'\n"),
        ("/robot: [\n", 'in "p.yaml", line 2, column 1\n'),
        ("", "AttributeError: 'NoneType' object has no attribute 'keys'\n"),
        ("speed\n", "AttributeError: 'str' object has no attribute 'keys'\n"),
    ],
)
def test_wrong_parameter_files(machine, node, text, error):
    (machine.cwd / "p.yaml").write_text(text, encoding="utf-8")
    result = machine.ros2("param", "load", "/robot", "p.yaml")
    assert result.status == 1
    assert result.stderr.endswith(error)


@pytest.mark.skipif(sys.platform == "win32", reason="the words of the system for its errors")
def test_a_missing_parameter_file_is_named(machine, node):
    result = machine.ros2("param", "load", "/robot", "nope.yaml")
    assert result.status == 1
    assert result.stderr.endswith("FileNotFoundError: [Errno 2] No such file or directory: 'nope.yaml'\n")


def test_a_node_that_comes_late_is_waited_for(machine):
    get = machine.start("param", "get", "--timeout", "3", "/robot", "speed")
    get.step(1.0)
    machine.node("robot", build)
    get.step(1.0)
    assert (get.stdout, get.status) == ("Integer value is: 3\n", 0)


@pytest.mark.parametrize(
    ("text", "shown", "kind"),
    [
        ("true", "Boolean value is: True", "boolean"),
        ("no", "Boolean value is: False", "boolean"),
        ("7", "Integer value is: 7", "integer"),
        ("-0.5", "Double value is: -0.5", "double"),
        ("1e3", "String value is: 1e3", "string"),  # YAML 1.1 wants 1.0e+3
        ("hello", "String value is: hello", "string"),
        ("'7'", "String value is: 7", "string"),
        ("null", "String value is: null", "string"),
        ("[1", "String value is: [1", "string"),
        ("[true, no]", "Boolean values are: [True, False]", "boolean array"),
        ("[1, 2]", "Integer values are: [1, 2]", "integer array"),
        ("[1.5, 2.0]", "Double values are: [1.5, 2.0]", "double array"),
        ("[a, b]", "String values are: ['a', 'b']", "string array"),
        ("[1, a]", "String value is: [1, a]", "string"),
    ],
)
def test_every_type_is_guessed_shown_and_described(machine, node, text, shown, kind):
    assert machine.ros2("param", "set", "/robot", "free", text) == ("Set parameter successful\n", "", 0)
    assert machine.ros2("param", "get", "/robot", "free").stdout == f"{shown}\n"
    assert machine.ros2("param", "get", "/robot", "free", "--hide-type").stdout == f"{shown.partition(': ')[2]}\n"
    assert f"  Type: {kind}\n" in machine.ros2("param", "describe", "/robot", "free").stdout
    assert f"  free (type: {kind})\n" in machine.ros2("param", "list", "/robot", "--param-type").stdout


def test_a_parameter_without_a_value_is_not_set(machine):
    machine.node("robot", lambda node: node.declare_parameter("bare", None, ParameterDescriptor(dynamic_typing=True)))
    assert machine.ros2("param", "get", "/robot", "bare") == ("Parameter not set.\n", "", 0)
    assert machine.ros2("param", "get", "/robot", "bare", "--hide-type") == ("None\n", "", 0)
    assert "  Type: not set\n" in machine.ros2("param", "describe", "/robot", "bare").stdout
    assert "    bare: null\n" in machine.ros2("param", "dump", "/robot").stdout


def test_describe_tells_what_is_there_and_nothing_else(machine):
    ranged = FloatingPointRange(from_value=-1.5, to_value=2.0)

    def build(node):
        node.declare_parameter("plain", 1)
        node.declare_parameter(
            "full",
            0.5,
            ParameterDescriptor(read_only=True, additional_constraints="even", floating_point_range=[ranged]),
        )

    machine.node("robot", build)
    assert machine.ros2("param", "describe", "/robot", "full", "plain").stdout == (
        "Parameter name: full\n  Type: double\n  Constraints:\n    Read only: true\n    Min value: -1.5\n"
        "    Max value: 2.0\n    Additional constraints: even\nParameter name: plain\n  Type: integer\n  Constraints:\n"
    )


VERBS = {
    "get": ["speed"],
    "set": ["speed", "1"],
    "delete": ["speed"],
    "describe": ["speed"],
    "dump": [],
    "load": ["p.yaml"],
}


@pytest.mark.parametrize("verb", VERBS)
def test_a_node_that_does_not_come_is_given_up_after_the_timeout(machine, verb):
    for options, seconds in (([], 1.0), (["--timeout", "3"], 3.0), (["--timeout", "0"], 0.0)):
        command = machine.start("param", verb, "/nobody", *VERBS[verb], *options)
        command.step(seconds - 0.05 if seconds else 0.0)
        assert command.status is None
        command.step(0.16)
        assert (command.stdout, command.stderr, command.status) == ("", "Node not found\n", 1)


@pytest.mark.parametrize("verb", VERBS)
def test_a_hidden_node_must_be_asked_for(machine, verb):
    machine.node("_shy", build)
    (machine.cwd / "p.yaml").write_text("/_shy:\n  ros__parameters:\n    speed: 4\n", encoding="utf-8")
    words = ("param", verb, "/_shy", *VERBS[verb])
    assert machine.ros2(*words).stderr == "Node not found\n"
    assert machine.ros2(*words, "--include-hidden-nodes").stderr != "Node not found\n"


def test_a_negative_timeout_waits_for_ever(machine):
    get = machine.start("param", "get", "--timeout", "-1", "/robot", "speed")
    get.step(1000.0)
    machine.node("robot", build)
    get.step(0.2)
    assert (get.stdout, get.status) == ("Integer value is: 3\n", 0)


def without_services(machine):
    machine.node("mute", start_parameter_services=False)


TIMED_OUT = "Wait for service timed out waiting for parameter services for node "


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        (["list"], (f"{TIMED_OUT}NodeName(name='mute', namespace='/', full_name='/mute')\n", "", 0)),
        (["get", "/mute", "x"], ("", f"{TIMED_OUT}/mute\n", 1)),
        (["set", "/mute", "x", "1"], ("", f"{TIMED_OUT}/mute\n", 1)),
        (["describe", "/mute", "x"], ("", f"{TIMED_OUT}/mute\n", 1)),
        (["dump", "mute"], ("", f"{TIMED_OUT}/mute\n", 0)),
        (["load", "mute", "p.yaml"], ("", f"{TIMED_OUT}/mute\n", 1)),
    ],
)
def test_a_node_without_parameter_services_is_given_five_seconds(machine, words, answer):
    without_services(machine)
    command = machine.start("param", *words)
    command.step(4.9)
    assert command.status is None
    command.step(0.2)
    assert (command.stdout, command.stderr, command.status) == answer


def test_the_list_goes_by_the_names_of_nodes_and_leaves_out_hidden_ones(machine):
    def one(node):
        node.declare_parameter("p.q", 1)

    for name, namespace in (("b", "/a"), ("a", "/z"), ("a", "/b"), ("_c", "/")):
        machine.node(name, one, namespace=namespace)
    titles = [line for line in machine.ros2("param", "list", "--filter", "p").stdout.splitlines() if line[0] == "/"]
    assert titles == ["/b/a:", "/z/a:", "/a/b:"]
    assert "/_c:\n  p.q\n" in machine.ros2("param", "list", "--filter", "p", "--include-hidden-nodes").stdout
    assert machine.ros2("param", "list", "--filter", "q").stdout == "", "a pattern fits from the beginning"
    assert machine.ros2("param", "list", "/b", "--filter", "p") == ("", "Node not found\n", 1)


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("/**:\n  ros__parameters: {speed: 1}\n", 1),
        ("/**:\n  ros__parameters: {speed: 1}\n/arm/robot:\n  ros__parameters: {speed: 2}\n", 2),
        ("/arm/robot:\n  ros__parameters: {speed: 2}\n/**:\n  ros__parameters: {speed: 1}\n", 2),
        ("/arm:\n  robot:\n    ros__parameters: {speed: 5}\n  other:\n    ros__parameters: {speed: 6}\n", 5),
        ("robot:\n  ros__parameters: {speed: 7}\n/**:\n  ros__parameters: {speed: 1}\n", 1),
    ],
)
def test_a_file_is_read_for_the_node_and_what_names_it_wins(machine, text, speed):
    node = machine.node("robot", build, namespace="/arm")
    (machine.cwd / "p.yaml").write_text(text, encoding="utf-8")
    assert machine.ros2("param", "load", "/arm/robot", "p.yaml").stdout == "Set parameter speed successful\n"
    assert node.get_parameter("speed").value == speed


def test_a_file_may_name_a_node_without_a_slash_where_it_has_no_namespace(machine, node):
    (machine.cwd / "p.yaml").write_text("robot:\n  ros__parameters:\n    speed: 9\n", encoding="utf-8")
    machine.ros2("param", "load", "robot", "p.yaml")
    assert node.get_parameter("speed").value == 9


def test_the_wildcard_can_be_left_out(machine, node):
    (machine.cwd / "p.yaml").write_text("/**:\n  ros__parameters:\n    speed: 9\n", encoding="utf-8")
    result = machine.ros2("param", "load", "--no-use-wildcard", "/robot", "p.yaml")
    assert (result.stderr, result.status) == ("Param file does not contain any valid parameters\n", 1)
    assert node.get_parameter("speed").value == 3


def test_what_a_file_cannot_set_is_told_and_the_rest_is_set(machine, node):
    (machine.cwd / "p.yaml").write_text(
        "/robot:\n  ros__parameters:\n    speed: 99\n    name: new\n    fixed: y\n", encoding="utf-8"
    )
    assert machine.ros2("param", "load", "/robot", "p.yaml") == (
        "Set parameter name successful\n",
        (
            "Set parameter speed failed: Parameter speed out of range. Min: 0, Max: 10, value: 99\n"
            "Set parameter fixed failed: Trying to set a read-only parameter: fixed.\n"
        ),
        0,
    )


def test_a_pipe_is_no_parameter_file(machine, node):
    if not hasattr(os, "mkfifo"):
        pytest.skip("there are no pipes with names")
    os.mkfifo(machine.cwd / "p.yaml")
    assert machine.ros2("param", "load", "/robot", "p.yaml").status == 1


def test_a_file_with_too_many_parameters_is_refused(machine, node, monkeypatch):
    from day6_core.ros.ros2.param import load

    monkeypatch.setattr(load, "MOST_PARAMETERS", 5)
    text = "/robot:\n  ros__parameters:\n" + "".join(f"    p{number}: 1\n" for number in range(6))
    (machine.cwd / "p.yaml").write_text(text, encoding="utf-8")
    assert machine.ros2("param", "load", "/robot", "p.yaml").status == 0
    (machine.cwd / "p.yaml").write_text(text + "    q: 1\n", encoding="utf-8")
    assert machine.ros2("param", "load", "/robot", "p.yaml")[1:] == ("Param file contains too many parameters\n", 1)
