"""Whatever is typed: an answer as the real command's, never a traceback of ours."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from day6_core.ros.ros2.cli.tree import build_parser, command_names, verb_names
from tests.ros2.ros2_machine import Machine

NOT_HERE = frozenset({"bag", "launch", "multicast", "run"})
"""They have tests of their own: processes, files, the network."""

COMMANDS = [name for name in command_names() if name not in NOT_HERE]
PAIRS = [(command, verb) for command in COMMANDS for verb in verb_names(command) or [""]]
PAIRS = [
    pair
    for pair in PAIRS
    if pair not in (("pkg", "create"), ("doctor", "hello"), ("wtf", "hello"), ("daemon", "start"))
]

WORDS = st.sampled_from(
    [
        *("/chatter", "chatter", "/nope", "", "a b", "~/x", "{x}", "//", "/turtle1/pose", "-1", "0", "1.5", "x", "--"),
        *("std_msgs/msg/String", "std_msgs/String", "std_srvs/srv/Empty", "example_interfaces/action/Fibonacci"),
        *("{data: hi}", "{", "[1, 2", "null", "now", "你好", "a/b/c/d", "std_msgs", "/**", "-", "=", "%", "\t"),
    ]
)
KNOWN_ENDS = (0, 1, 2, None)

ENOUGH = settings(
    max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
)


def answer(*words: str, stdin: str = "") -> tuple[str, str, int | None]:
    """Run `ros2 WORDS` for a short while on a machine with a talker; interrupt what does not end."""
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(Path(folder))
        machine.run("demo_nodes_py", "talker")
        command = machine.start(*words, stdin=stdin)
        for _ in range(30):
            if command.status is not None:
                break
            command.step(0.1)
        if command.status is None:
            command.interrupt()
            command.step(1.0)
        return command.stdout, command.stderr, command.status


def check(words: list[str], stdin: str = "") -> None:
    _, stderr, status = answer(*words, stdin=stdin)
    assert status in KNOWN_ENDS, (words, status, stderr)
    assert "Traceback" not in stderr
    assert "day6_tui" not in re.sub(r"day6_tui\S*(\.py|lib|share)\S*", "", stderr), stderr
    lines = stderr.splitlines()
    # Faults that only a mistake of ours brings forth.
    assert not any(line.startswith(("UnboundLocalError", "ImportError", "RecursionError")) for line in lines)
    if lines and lines[0].startswith("usage: "):
        assert status == 2 and ": error: " in stderr


def options_of(command: str, verb: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        session = Machine(Path(folder)).session(["ros2"])
    parser = build_parser(session, [command, verb] if verb else [command])
    for word in (command, verb):
        for action in parser._actions:
            if word and isinstance(action.choices, dict) and word in action.choices:
                parser = action.choices[word]
    return [option for option in parser._option_string_actions if option not in ("-h", "--help")]


@pytest.mark.long
@pytest.mark.parametrize(("command", "verb"), PAIRS, ids=lambda each: each or "-")
def test_any_words_behind_a_verb_are_answered(command, verb):
    start = [command, verb] if verb else [command]
    option = st.sampled_from([*options_of(command, verb), "--bogus", "-Z"])

    @settings(ENOUGH, max_examples=6)
    @given(st.lists(st.one_of(WORDS, option, st.tuples(option, WORDS).map("=".join)), max_size=6))
    def run(words: list[str]) -> None:
        check([*start, *words])

    run()


@ENOUGH
@given(st.lists(st.one_of(st.sampled_from([*COMMANDS, "-h", "--help", "--version"]), WORDS), max_size=4))
def test_any_words_behind_ros2_are_answered(words):
    if NOT_HERE.isdisjoint(words):
        check(words)


SCALARS = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=12), st.dates(), st.binary(max_size=4)
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(
            st.sampled_from(["data", "x", "linear", "header", "stamp", "position", "name", "layout", "dim"]), inner
        ),
    ),
    max_leaves=8,
)
TYPES = st.sampled_from(
    [
        *(
            "std_msgs/msg/String",
            "std_msgs/msg/UInt8",
            "std_msgs/msg/Bool",
            "std_msgs/msg/Float32",
            "std_msgs/msg/Char",
        ),
        *(
            "geometry_msgs/msg/Twist",
            "sensor_msgs/msg/JointState",
            "std_msgs/msg/Int32MultiArray",
            "std_msgs/msg/Header",
        ),
        *("sensor_msgs/msg/Image", "test_msgs/msg/Arrays", "test_msgs/msg/BoundedSequences", "std_msgs/msg/Byte"),
    ]
)


@ENOUGH
@given(TYPES, VALUES)
def test_any_yaml_is_a_message_or_is_refused(type_name, value):
    import yaml

    text = yaml.dump(value, allow_unicode=True)
    stdout, stderr, status = answer(*["topic", "pub", "-t", "1", "-w", "0", "/x"], type_name, "--stdin", stdin=text)
    assert status in (0, 1)
    assert "Traceback" not in stderr
    if status == 0:
        assert stdout.startswith("publisher: beginning loop\npublishing #1: ")
    else:
        assert stderr


@ENOUGH
@given(st.text(max_size=30))
def test_any_text_is_values_or_is_refused(text):
    for words in (
        ["topic", "pub", "-t", "1", "-w", "0", "/x", "geometry_msgs/msg/Twist", "--stdin"],
        ["action", "send_goal", "/nope", "example_interfaces/action/Fibonacci", "--stdin"],
    ):
        check(words, stdin=text)
    if not text.startswith("-"):
        check(["param", "set", "/talker", "use_sim_time", text])


@ENOUGH
@given(st.text(max_size=20))
def test_any_text_is_a_filter_or_is_refused(text):
    check(["topic", "echo", "/chatter", "--once", f"--filter={text}"])
    check(["topic", "echo", "/chatter", "--once", f"--field={text}"])
