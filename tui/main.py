"""The `day6-tui` command: finds out which part was asked for, and imports only that."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.local import Foreground

_DESCRIPTION = "ROS 2 for people who have no ROS 2. Without a command, opens the desktop."
_COMMANDS = """\
commands:
  exec [-c COMMANDS] [FILE]   run lines of the simulated terminal without a screen
  python FILE [ARG ...]       run a Python file unmodified as a ROS program
  ros2 ...                    the ros2 command, on the graph of this machine
  rqt_graph, rqt_topic ...    a program with a window; takes this terminal
  check_urdf FILE             check a robot description
  urdf_to_graphviz FILE       draw a robot description
  xacro FILE [NAME:=VALUE]    write the URDF that a xacro file stands for
  colcon ...                  build a workspace
  export [PKG ...] [-o FILE]  packages of the workspace as a zip that builds on a real ROS 2
  shell                       a real sub-shell in which ros2, colcon and python3 are these
  env [--vscode|--pycharm]    print the variables that do the same for this shell, or set up an IDE

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
        "--scene", choices=("turtle", "car", "world", "empty"), help="what to begin with (default: the welcome choices)"
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
    command = (_TABLE.get(words[0]) or _window_command(words[0])) if words else None
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

    from day6_tui.core.session.local import has_terminal, run_local

    lasting = words[:1] in (["run"], ["launch"], ["daemon"], ["bag"]) or "echo" in words or "hz" in words
    show = _show_window if words[:1] == ["run"] and has_terminal() else None
    main = importlib.import_module("day6_tui.core.ros.ros2").main
    return run_local(main, ["ros2", *words], one_shot=not lasting, show=show)


def _show_window(foreground: Foreground) -> None:
    """Draw the program's window; a program without one never gets here, and Textual is not imported for it."""
    from day6_tui.tui.window_app import show

    show(foreground)


def _window_command(name: str) -> Callable[[list[str]], int] | None:
    """rqt_graph, rviz2 …: a command that is the program with a window of the package of the same name."""
    if not name.startswith(("rqt_", "rviz")):
        return None
    from day6_tui.core.ros.programs import executables

    return partial(_window, name) if name in executables(name) else None


def _window(name: str, words: list[str]) -> int:
    from day6_tui.core.ros.programs import load
    from day6_tui.core.session.local import has_terminal, run_local

    return run_local(load(name, name), [name, *words], show=_show_window if has_terminal() else None)


def _colcon(words: list[str]) -> int:
    from day6_tui.core.session.local import run_local
    from day6_tui.core.workspace.command import main as colcon

    return run_local(colcon, ["colcon", *words], one_shot=True)


def _export(words: list[str]) -> int:
    from day6_tui.core.workspace.export import main as export

    return export(words)


def _urdf_tool(name: str, words: list[str]) -> int:
    from day6_tui.core.ros.programs import load
    from day6_tui.core.session.local import run_local

    return run_local(load("urdfdom", name), [name, *words], one_shot=True)


def _xacro(words: list[str]) -> int:
    from day6_tui.core.ros.programs import load
    from day6_tui.core.session.local import run_local

    return run_local(load("xacro", "xacro"), ["xacro", *words], one_shot=True)


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
    "colcon": _colcon,
    "export": _export,
    "check_urdf": partial(_urdf_tool, "check_urdf"),
    "urdf_to_graphviz": partial(_urdf_tool, "urdf_to_graphviz"),
    "xacro": _xacro,
    "shell": _shell,
    "env": _env,
}

if __name__ == "__main__":
    sys.exit(main())
