"""`ros2 param …` on a stepped machine."""

from __future__ import annotations

import pytest
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor


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
