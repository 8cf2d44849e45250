"""Whatever is typed behind `ros2` is answered, never by a traceback of ours."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from std_msgs.msg import String
from std_srvs.srv import SetBool

from day6_core.ros.ros2.cli.tree import command_names, verb_names
from tests.ros2.ros2_machine import Machine

WORDS = [
    *("topic", "node", "service", "param", "action", "interface", "pkg", "run", "daemon", "doctor", "launch", "nope"),
    *(
        "list",
        "info",
        "echo",
        "pub",
        "hz",
        "bw",
        "delay",
        "type",
        "find",
        "call",
        "get",
        "set",
        "dump",
        "load",
        "describe",
    ),
    *("send_goal", "show", "proto", "package", "packages", "prefix", "executables", "xml", "status", "delete"),
    *(
        "-h",
        "--help",
        "-t",
        "-c",
        "-v",
        "-a",
        "--once",
        "--field",
        "--filter",
        "-r",
        "-w",
        "0",
        "1",
        "-1",
        "--",
        "-",
        "",
    ),
    *(
        "--timeout",
        "--csv",
        "--raw",
        "--stdin",
        "-n",
        "--qos-depth",
        "--qos-profile",
        "reliable",
        "best_effort",
        "--spin-time",
    ),
    *(
        "/chatter",
        "chatter",
        "/robot",
        "robot",
        "/switch",
        "/nope",
        "speed",
        "a b",
        "/1x",
        "~",
        "~x",
        "//",
        "{}",
        "你好",
    ),
    *(
        "std_msgs/msg/String",
        "std_msgs/String",
        "std_srvs/srv/SetBool",
        "turtlesim/action/RotateAbsolute",
        "a/b/c/d",
        ".",
    ),
    *(
        "data: hi",
        "{data: true}",
        "{data: [",
        "[1]",
        "null",
        "{1: 2}",
        "!!python/object:os.system {}",
        "data: !!binary x",
        "\t",
    ),
    *(
        "m.data",
        "m.",
        "()",
        "turtlesim",
        "turtlesim_nod",
        "--include-hidden-topics",
        "--no-daemon",
        "--prefix",
        "nan",
        "inf",
    ),
]


COMMANDS = [
    *(
        [command, verb]
        for command in command_names()
        for verb in verb_names(command)
        if [command, verb] != ["daemon", "start"]
    ),
    *([command] for command in command_names()),
    [],
]


def build(node):
    node.publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.1, lambda: node.publisher.publish(String(data="x")))
    node.create_service(SetBool, "switch", lambda request, response: response)
    node.declare_parameter("speed", 1)


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(COMMANDS), st.lists(st.sampled_from(WORDS), max_size=5))
def test_any_words_are_answered(tmp_path, command_words, rest):
    if command_words[:1] in (["bag"], ["pkg"]):  # which write what they are told to, and where
        rest = [word.lstrip("/") for word in rest]
    words = [*command_words, *rest]
    machine = Machine(tmp_path)
    machine.node("robot", build)
    command = machine.start(*words)
    for _ in range(40):
        if command.status is not None:
            break
        command.step(0.1)
    if command.status is None:
        command.interrupt()
        command.step(0.5)
    assert command.status in (0, 1, 2), (words, command.status, command.stderr)
    assert "Traceback" not in command.stderr
    assert "day6_tui." not in command.stderr
    left = [node.name for node in machine.graph.nodes]
    assert left == ["robot"], f"{words} left {left} behind"


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.text(max_size=30), st.sampled_from(["std_msgs/msg/String", "geometry_msgs/msg/Twist", "std_msgs/msg/Byte"]))
def test_any_yaml_is_answered(tmp_path, text, type_name):
    machine = Machine(tmp_path)
    result = machine.ros2("topic", "pub", "--once", "-w", "0", "/x", type_name, "--", text)
    assert result.status in (0, 1, 2), (text, result)
    assert "Traceback" not in result.stderr
    assert "day6_tui." not in result.stderr
