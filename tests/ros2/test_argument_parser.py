"""The words of argparse as Python 3.11 says them, whatever Python runs."""

from __future__ import annotations

import argparse
import sys

import pytest

from day6_core.session.argument_parser import SessionParser


def test_the_bare_command_prints_help_with_every_command_and_exits_0(machine):
    result = machine.ros2()
    assert result.status == 0
    assert result.stdout.startswith(
        "usage: ros2 [-h] [--use-python-default-buffering]\n            Call `ros2 <command> -h`"
    )
    assert "  topic      Various topic related sub-commands\n" in result.stdout
    assert "extension_points" not in result.stdout


def test_an_unknown_command_names_all_choices_in_quotes(machine):
    result = machine.ros2("topics")
    assert result.status == 2
    assert "invalid choice: 'topics' (choose from 'action', 'bag', 'component', 'daemon'," in result.stderr


def test_an_unknown_verb_is_answered_by_the_usage_of_its_command(machine):
    result = machine.ros2("topic", "lst")
    assert (result.status, result.stdout) == (2, "")
    assert result.stderr == (
        "usage: ros2 topic [-h] [--include-hidden-topics]\n"
        "                  Call `ros2 topic <command> -h` for more detailed usage. ...\n"
        "ros2 topic: error: argument Call `ros2 topic <command> -h` for more detailed usage.: invalid choice: 'lst' "
        "(choose from 'bw', 'delay', 'echo', 'find', 'hz', 'info', 'list', 'pub', 'type')\n"
    )


def test_an_unknown_option_is_answered_by_the_usage_of_ros2_itself(machine):
    result = machine.ros2("node", "list", "--nope")
    assert result.status == 2
    assert result.stderr.endswith("usage. ...\nros2: error: unrecognized arguments: --nope\n")


def test_missing_arguments_are_named_and_the_rest_of_run_counts_as_one(machine):
    assert machine.ros2("run").stderr == (
        "usage: ros2 run [-h] [--prefix PREFIX] package_name executable_name ...\n"
        "ros2 run: error: the following arguments are required: package_name, executable_name, argv\n"
    )


def test_help_is_laid_out_for_the_width_of_the_terminal(machine):
    machine.env["COLUMNS"] = "120"
    wide = machine.ros2("topic", "-h").stdout
    assert "Call `ros2 topic <command> -h` for more detailed usage. ...\n" in wide
    machine.env["COLUMNS"] = "40"
    narrow = machine.ros2("topic", "-h").stdout
    assert narrow.startswith("usage: ros2 topic [-h]\n                  [--include-hidden-topics]\n")


@pytest.mark.skipif(sys.version_info[:2] != (3, 11), reason="the recorded texts are those of Python 3.11")
@pytest.mark.parametrize("width", [20, 33, 40, 57, 64, 78, 79, 80, 81, 120, 200])
def test_help_equals_that_of_python_3_11_at_every_width(machine, monkeypatch, width):
    monkeypatch.setenv("COLUMNS", str(width))
    machine.env["COLUMNS"] = str(width)
    session = machine.session(["x"])
    for fill in (fill_many, fill_positional_only, fill_nothing):
        ours = SessionParser(session, prog="prog with words", description="What it does.")
        plain = argparse.ArgumentParser(
            prog="prog with words", description="What it does.", formatter_class=argparse.RawDescriptionHelpFormatter
        )
        fill(ours)
        fill(plain)
        assert ours.format_help() == plain.format_help()
        assert ours.format_usage() == plain.format_usage()


def fill_nothing(parser):
    pass


def fill_positional_only(parser):
    for name in ("first", "second_longer", "third_even_longer_name"):
        parser.add_argument(name, help=f"The {name} of them")
    parser.add_argument("rest", nargs=argparse.REMAINDER)


def fill_many(parser):
    parser.add_argument("-q", "--quality", choices=["low", "middle", "high"], help="How well, of 100%% at most")
    either = parser.add_mutually_exclusive_group(required=True)
    either.add_argument("-1", "--once", action="store_true")
    either.add_argument(
        "-t", "--times", type=int, metavar="N", help="This number of times (default: %(default)s)", default=3
    )
    mixed = parser.add_mutually_exclusive_group()
    mixed.add_argument("values", nargs="?")
    mixed.add_argument("--stdin", action="store_true")
    parser.add_argument("--required-thing", required=True, nargs=2)
    parser.add_argument("--some", nargs="*")
    parser.add_argument("--hidden", help=argparse.SUPPRESS)
    parser.add_argument("names", nargs="+", help="One or more")
    parser.add_argument("more", nargs="*")


def test_version_is_answered_with_a_note_that_a_real_one_does_not(machine):
    result = machine.ros2("--version")
    assert result.status == 0
    assert result.stdout.startswith("ros2 ")
    assert "usage" in result.stderr
