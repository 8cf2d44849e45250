"""The `day6-tui` command: finds out which part was asked for, and imports only that."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

_DESCRIPTION = "ROS 2 for people who have no ROS 2. Without a command, opens the desktop."
_COMMANDS = """\
commands:
  exec [-c COMMANDS] [FILE]   run lines of the simulated terminal without a screen
  python FILE [ARG ...]       run a Python file unmodified as a ROS program
  ros2 ...                    the ros2 command, on the graph of this machine
  check_urdf FILE             check a robot description
  urdf_to_graphviz FILE       draw a robot description
  shell                       a real sub-shell in which ros2 and python3 are these
  env                         print the variables that do the same for this shell or an IDE

day6-tui COMMAND --help says more."""


def build_parser() -> argparse.ArgumentParser:
    """The options of the desktop."""
    parser = argparse.ArgumentParser(
        prog="day6-tui",
        description=_DESCRIPTION,
        epilog=_COMMANDS,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--scene", choices=("turtle", "car", "empty"), help="what to begin with (default: the welcome choices)"
    )
    parser.add_argument("--robot", metavar="FILE", help="a URDF file of your own instead of the shipped car")
    parser.add_argument("--lang", choices=("zh", "en"), help="language of the screen (default: that of the system)")
    parser.add_argument(
        "--glyphs",
        choices=("half", "braille", "cell", "ascii"),
        help="what pictures are drawn with (default: by terminal)",
    )
    parser.add_argument("--fps", type=_frame_rate, metavar="N", help="most frames a second (default: 30)")
    parser.add_argument("--reduced-motion", action="store_true", help="no pulses and no animation")
    parser.add_argument("--home", type=Path, metavar="DIR", help="the folder that is ~ in the terminals")
    parser.add_argument(
        "--listen", type=_endpoint, metavar="ENDPOINT", help="let other machines in, e.g. tcp/0.0.0.0:7447"
    )
    parser.add_argument(
        "--connect", type=_endpoint, metavar="ENDPOINT", help="join another machine, e.g. tcp/192.168.1.5:7447"
    )
    parser.add_argument("--version", action="store_true", help="print the version and exit")
    return parser


def _frame_rate(text: str) -> float:
    try:
        rate = float(text)
    except ValueError:
        rate = 0.0
    if not 1 <= rate <= 120:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from 1 to 120")
    return rate


def _endpoint(text: str) -> str:
    protocol, slash, address = text.partition("/")
    if not (protocol.isalnum() and slash and address):
        raise argparse.ArgumentTypeError(f"'{text}' is no endpoint like tcp/192.168.1.5:7447")
    return text


def main(arguments: list[str] | None = None) -> int:
    """Entry point of `day6-tui`; returns the exit status."""
    words = sys.argv[1:] if arguments is None else arguments
    command = _TABLE.get(words[0]) if words else None
    if command is not None:
        return command(words[1:])
    if words and not words[0].startswith("-"):
        print(f"day6-tui: there is no command '{words[0]}'; day6-tui --help lists them", file=sys.stderr)
        return 2
    options = build_parser().parse_args(words)
    if options.version:
        from importlib.metadata import version

        print(f"day6-tui {version('day6-tui')}")
        return 0
    if not (sys.stdin.isatty() and sys.stderr.isatty()):  # Textual draws on stderr
        print("day6-tui: the desktop needs a terminal; day6-tui exec runs commands without one", file=sys.stderr)
        return 2
    from day6_tui.tui.app import run

    return run(options) or 0


def _exec(words: list[str]) -> int:
    from day6_tui.core.shell.execute import main as execute

    return execute(words)


def _python(words: list[str]) -> int:
    """Become `python3 FILE ARG…` with our packages on its path."""
    from day6_tui.core.ros.environment import program_environment

    if words and words[0] in ("-h", "--help"):
        print("usage: day6-tui python FILE [ARG ...]\n")
        print("Run a Python file unmodified as a ROS program: python3 with rclpy on its path.")
        return 0
    argv = [sys.executable, *words]
    environment = program_environment()
    if sys.platform != "win32":
        os.execve(sys.executable, argv, environment)
    from day6_tui.core.shell.subshell import call

    return call(argv, environment)


def _ros2(words: list[str]) -> int:
    import importlib

    from day6_tui.core.session.local import run_local

    lasting = words[:1] in (["run"], ["launch"], ["daemon"]) or "echo" in words or "hz" in words
    return run_local(importlib.import_module("day6_tui.core.ros.ros2").main, ["ros2", *words], one_shot=not lasting)


def _urdf_tool(name: str, words: list[str]) -> int:
    from day6_tui.core.ros.programs import load
    from day6_tui.core.session.local import run_local

    return run_local(load("urdfdom", name), [name, *words], one_shot=True)


def _shell(words: list[str]) -> int:
    from day6_tui.core.shell.subshell import main as subshell

    return subshell(words)


def _env(words: list[str]) -> int:
    from day6_tui.core.shell.subshell import print_environment

    return print_environment(words)


_TABLE: dict[str, Callable[[list[str]], int]] = {
    "exec": _exec,
    "python": _python,
    "ros2": _ros2,
    "check_urdf": partial(_urdf_tool, "check_urdf"),
    "urdf_to_graphviz": partial(_urdf_tool, "urdf_to_graphviz"),
    "shell": _shell,
    "env": _env,
}

if __name__ == "__main__":
    sys.exit(main())
