"""The `day6-tui` command: determines which part was requested, and imports only that."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import argparse

    from day6_tui.core.session.local import Foreground

_DESCRIPTION = "ROS 2 for people who have no ROS 2. Without a command, opens the desktop."
_COMMANDS = """\
commands:
  shell                       a real sub-shell in which ros2, colcon, rviz2, python3 … are these
  exec [-c COMMANDS] [FILE]   run lines of the simulated terminal without a screen
  python FILE [ARG ...]       run a Python file unmodified as a ROS program
  ros2 ...                    the ros2 command, on the graph of this machine
  colcon ...                  build a workspace
  rviz2                       the robot in 3-D; a window takes this terminal
  rqt, rqt_graph, rqt_console, rqt_plot, rqt_topic
                              the windows of rqt
  check_urdf FILE             check a robot description
  urdf_to_graphviz FILE       draw a robot description
  xacro FILE [NAME:=VALUE]    write the URDF that a xacro file stands for
  export [PKG ...] [-o FILE]  packages of the workspace as a zip that builds on a real ROS 2
  env [--vscode|--pycharm]    print the variables that do the same for this shell, or set up an IDE

day6-tui COMMAND --help says more."""


def build_parser() -> argparse.ArgumentParser:
    """The options of the desktop."""
    import argparse
    from pathlib import Path

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
        "--listen",
        type=partial(_endpoint, listening=True),
        metavar="ENDPOINT",
        help="let other machines in, e.g. tcp/0.0.0.0:7447; without --secret anyone who reaches this port can read and command",
    )
    parser.add_argument(
        "--connect",
        type=partial(_endpoint, listening=False),
        metavar="ENDPOINT",
        help="join another machine, e.g. tcp/192.168.1.5:7447",
    )
    parser.add_argument(
        "--secret",
        type=_secret,
        metavar="FILE|WORD",
        help="what the machines of --listen and --connect must have in common: better a file that only you can read "
        "(chmod 600) than a word, which every user of this machine can see in the list of processes",
    )
    parser.add_argument("--version", action="store_true", help="print the version and exit")
    return parser


def _frame_rate(text: str) -> float:
    try:
        rate = float(text)
    except ValueError:
        rate = 0.0
    if not 1 <= rate <= 120:
        import argparse

        raise argparse.ArgumentTypeError(f"'{text}' is no number from 1 to 120")
    return rate


def _endpoint(text: str, *, listening: bool) -> str:
    import argparse

    from day6_tui.core.link.addresses import address_of

    try:
        address_of(text, listening=listening)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return text


def _secret(text: str) -> str:
    import argparse

    from day6_tui.core.link.secret import secret_of

    try:
        return secret_of(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def main(arguments: list[str] | None = None) -> int:
    """Entry point of `day6-tui`; returns the exit status."""
    if arguments is None:
        _end_silently_on_ctrl_c()
        threading.excepthook = _thread_failed
    from day6_tui.core.session.harmless import guard_standard_streams

    words = sys.argv[1:] if arguments is None else arguments
    guard_standard_streams()
    command = (_TABLE.get(words[0]) or _named_program(words[0])) if words else None
    if command is not None:
        return command(words[1:])
    if words and not words[0].startswith("-"):
        print(f"day6-tui: there is no command '{words[0]}'; day6-tui --help lists them", file=sys.stderr)
        return 2
    parser = build_parser()
    options = parser.parse_args(words)
    if options.secret is not None and not (options.listen or options.connect):
        parser.error("argument --secret: needs --listen or --connect")
    if options.version:
        from importlib.metadata import version

        print(f"day6-tui {version('day6-tui')}")
        return 0
    if not (sys.stdin.isatty() and sys.stderr.isatty()):  # Textual draws on stderr
        print("day6-tui: the desktop needs a terminal; day6-tui exec runs commands without one", file=sys.stderr)
        return 2
    from day6_tui.core.session.ending import leave
    from day6_tui.tui.app import run
    from day6_tui.tui.options import Options

    del options.version
    status = run(Options(**vars(options)))
    if arguments is None:
        leave(status)
    return status


def _thread_failed(failure: threading.ExceptHookArgs) -> None:
    """Report an error in a thread of ours in one line, or in the log if there is one; Python would print a traceback."""
    error = failure.exc_value
    if error is None or isinstance(error, SystemExit):
        return
    logging = sys.modules.get("logging")
    if logging is not None and logging.getLogger().handlers:
        logging.getLogger("day6_tui").error(
            "the thread %s failed", failure.thread and failure.thread.name, exc_info=error
        )
    elif sys.stderr is not None:
        print(f"day6-tui: {type(error).__name__}: {error}", file=sys.stderr)


def _end_silently_on_ctrl_c() -> None:
    """Until a handler is installed, let Ctrl-C end this process like a C program: without Python's traceback."""
    if (
        signal.getsignal(signal.SIGINT) is signal.default_int_handler
    ):  # not where it is ignored (`nohup`, a script's `&`)
        signal.signal(signal.SIGINT, signal.SIG_DFL)


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
    """Draw the program's window. A program without one never calls this, and Textual is not imported for it."""
    from day6_tui.tui.window_app import show

    show(foreground)


def _named_program(name: str) -> Callable[[list[str]], int] | None:
    """Run rqt_graph, rviz2, check_urdf …, which are commands of their own in ROS too."""
    from day6_tui.core.ros.program_index import COMMANDS

    return partial(_program, name) if name in COMMANDS else None


def _program(name: str, words: list[str]) -> int:
    from day6_tui.core.ros.program_index import COMMANDS
    from day6_tui.core.ros.programs import load
    from day6_tui.core.session.local import has_terminal, run_local

    return run_local(load(*COMMANDS[name]), [name, *words], show=_show_window if has_terminal() else None)


def _colcon(words: list[str]) -> int:
    from day6_tui.core.session.local import run_local
    from day6_tui.core.workspace.command import main as colcon

    return run_local(colcon, ["colcon", *words], one_shot=True)


def _export(words: list[str]) -> int:
    from day6_tui.core.workspace.export import main as export

    return export(words)


def _shell(words: list[str]) -> int:
    from day6_tui.core.shell.subshell import main as subshell

    return subshell(words)


def _complete(words: list[str]) -> int:
    from day6_tui.core.shell.real_completion import main as complete

    return complete(words, _own_words)


def _own_words(words: list[str]) -> list[str]:
    """Completions for the last word after `day6-tui`: commands and options; nothing where a file is expected."""
    from day6_tui.core.ros.program_index import COMMANDS

    options = build_parser()._option_string_actions
    option = options.get(words[-2]) if len(words) > 1 else None
    if option is not None and option.choices is not None:
        return [str(choice) for choice in option.choices]
    if words[0] in _TABLE or words[0] in COMMANDS or (option is not None and option.nargs != 0):
        return []
    if words[-1].startswith("-"):
        return list(options)
    return [*(_TABLE.keys() - {"complete"}), *COMMANDS] if len(words) == 1 else []


def _env(words: list[str]) -> int:
    from day6_tui.core.shell.subshell import print_environment

    return print_environment(words)


_TABLE: dict[str, Callable[[list[str]], int]] = {
    "exec": _exec,
    "python": _python,
    "ros2": _ros2,
    "colcon": _colcon,
    "export": _export,
    "shell": _shell,
    "env": _env,
    "complete": _complete,
}

if __name__ == "__main__":
    sys.exit(main())
