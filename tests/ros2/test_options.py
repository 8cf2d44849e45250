"""The options of every verb: names, defaults, what they accept. Written down in options.txt, one line for each argument.

After a change made on purpose: `python tests/ros2/test_options.py`, then look at the difference.
"""

from __future__ import annotations

import argparse
import re
import tempfile
from pathlib import Path

import pytest

from day6_core.ros import environment

WRITTEN = Path(__file__).with_name("options.txt")


def commands() -> list[tuple[str, ...]]:
    from day6_core.ros.ros2.cli.tree import command_names, verb_names

    found: list[tuple[str, ...]] = [()]
    for command in command_names():
        found.append((command,))
        found.extend((command, verb) for verb in verb_names(command))
    return found


def parser_of(machine, words) -> argparse.ArgumentParser:
    """The parser that reads what stands behind these words."""
    environment.activate()
    from day6_core.ros.ros2.cli.tree import build_parser

    parser = build_parser(machine.session(["ros2", *words]), list(words))
    for word in words:
        (choices,) = (each.choices for each in parser._actions if isinstance(each, argparse._SubParsersAction))
        parser = choices[word]
    return parser


def described(parser: argparse.ArgumentParser) -> list[str]:
    """A line for each argument, and one for each group of arguments that exclude each other."""
    left_out = (argparse._SubParsersAction, argparse._HelpAction)
    lines = [_line(action) for action in parser._actions if not isinstance(action, left_out)]
    lines += [
        f"either: {' | '.join(each.dest for each in group._group_actions)}{' (required)' if group.required else ''}"
        for group in parser._mutually_exclusive_groups
    ]
    return lines


def _line(action: argparse.Action) -> str:
    default = re.sub(r"[0-9a-f]{12}", "<12 hex digits>", repr(action.default))
    words = [" ".join(action.option_strings) or action.dest, f"= {default}"]
    if action.option_strings:
        words.append(f"dest {action.dest}")
    for name in ("nargs", "const", "metavar"):
        if getattr(action, name) is not None:
            words.append(f"{name} {getattr(action, name)!r}")
    if action.choices is not None:
        words.append(f"choices {list(action.choices)}")
    if action.type is not None:
        words.append("checked")
    if action.required and action.option_strings:  # which positional ones are differs between Pythons
        words.append("required")
    completer = getattr(action, "completer", None)
    if completer is not None:
        words.append(f"completed by {completer.__name__}")
    return f"  {', '.join(words)}"


def written() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for line in WRITTEN.read_text(encoding="utf-8").splitlines():
        if line.startswith("ros2"):
            lines = found[line] = []
        elif line:
            lines.append(line)
    return found


@pytest.mark.parametrize("words", commands(), ids=" ".join)
def test_options_are_those_written_down(machine, words):
    parser = parser_of(machine, words)
    assert described(parser) == written()[" ".join(["ros2", *words])]


@pytest.mark.parametrize("words", commands()[1:], ids=" ".join)
def test_help_begins_with_the_usage_and_says_what_the_command_is_for(machine, words):
    from day6_core.ros.ros2.cli.tree import summary

    result = machine.ros2(*words, "--help")
    assert (result.status, result.stderr) == (0, "")
    usage, _, rest = result.stdout.partition("\n\n")
    assert usage.startswith(f"usage: ros2 {' '.join(words)} [-h]")
    assert rest.startswith(f"{summary(*words)}\n\n")


def _write() -> None:
    from tests.ros2.ros2_machine import Machine

    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(Path(folder))
        blocks = [
            "\n".join([" ".join(["ros2", *words]), *described(parser_of(machine, words))]) for words in commands()
        ]
    WRITTEN.write_text("\n\n".join(blocks) + "\n", encoding="utf-8")


if __name__ == "__main__":
    _write()


def test_the_choices_of_qos_options_are_rclpys() -> None:
    from day6_core.graph.qos import CHOICES
    from day6_core.ros.ros2.cli import options
    from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSPresetProfiles, ReliabilityPolicy

    policies = (HistoryPolicy, ReliabilityPolicy, DurabilityPolicy, LivelinessPolicy, QoSPresetProfiles)
    words = [*(policy.words for policy in CHOICES), options.PROFILES]
    assert [tuple(policy.short_keys()) for policy in policies] == words
