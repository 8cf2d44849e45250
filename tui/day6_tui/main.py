"""The `day6-tui` command: determines which part was requested, and imports only that."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from day6_core.session.local import Foreground
    from day6_tui.locale import Texts


def main(arguments: list[str] | None = None) -> int:
    """Entry point of `day6-tui`; returns the exit status."""
    if arguments is None:
        _end_silently_on_ctrl_c()
        threading.excepthook = _thread_failed
    from day6_core.session.harmless import guard_standard_streams

    words = sys.argv[1:] if arguments is None else arguments
    guard_standard_streams()
    from day6_tui.distribution_choice import settle

    words = settle(words)
    if words[:1] == ["demo"]:
        if len(words) == 1 or words[1].startswith("-"):
            print(
                "usage: day6-tui demo DAY [OPTION ...]\n\nDAY is 1 to 6, or the name of a lesson (day6-tui lessons list)."
            )
            return 0 if words[1:] in (["-h"], ["--help"]) else 2
        words = _demo(words[1:])
    command = (_TABLE.get(words[0]) or _named_program(words[0])) if words else None
    if command is not None:
        return command(words[1:])
    keeper = _kept_by()
    from day6_core.language import language_of
    from day6_tui.command_line import build_parser
    from day6_tui.locale import Texts

    language = language_of(os.environ, words)
    texts = Texts(language)
    in_class = words[:1] == ["class"]
    if words and not words[0].startswith("-") and not in_class:
        print(f"day6-tui: {texts('cli.no_command', name=words[0])}", file=sys.stderr)
        return 2
    if in_class:
        from day6_tui.classes.command import class_parser, take_part

        parser = class_parser(language)
        options = parser.parse_args(words[1:])
        take_part(parser, options, texts)
    else:
        parser = build_parser(language)
        options = parser.parse_args(words)
    if options.secret is not None and not (options.listen or options.connect):
        parser.error("argument --secret: needs --listen or --connect")
    if options.version:
        from importlib.metadata import version

        print(f"day6-tui {version('day6-tui')}")
        return 0
    if options.detach and keeper is None:
        from day6_tui.detached.client import start

        return start(words, options.home, texts)
    if not (sys.stdin.isatty() and sys.stderr.isatty()):  # Textual draws on stderr
        print(f"day6-tui: {texts('cli.no_terminal')}", file=sys.stderr)
        return 2
    from day6_tui import textual_private

    if not textual_private.supported():
        there, tested = textual_private.version(), textual_private.TESTED
        print(f"day6-tui: {texts('cli.textual', version=there, tested=tested)}", file=sys.stderr)
        return 2
    if options.record is not None:
        options.record = options.record.absolute()
        if (reason := _cannot_be_made(options.record, texts)) is not None:
            print(f"day6-tui: {reason}", file=sys.stderr)
            return 2
    from day6_core.session.ending import leave
    from day6_tui.app import run
    from day6_tui.options import Options

    del options.version, options.detach
    status = run(Options(**vars(options), keeper=keeper))
    if arguments is None:
        leave(status)
    return status


def _cannot_be_made(path: Path, texts: Texts) -> str | None:
    """Why a new file cannot be made, before there is a screen over it; None if it can."""
    from day6_core.session.harmless import one_line

    if path.exists() or path.is_symlink():
        return one_line(f"{path}: {texts('cast.exists.record')}")
    if not path.parent.is_dir() or not os.access(path.parent, os.W_OK):
        return one_line(f"{path}: {texts('cast.no_folder')}")
    return None


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


def _kept_by() -> int | None:
    """The descriptor of the line to the keeper that started this desktop; also goes to the folder the user is in."""
    descriptor, _, folder = os.environ.pop("DAY6_KEEPER", "").partition(":")
    if not descriptor.isdecimal():
        return None
    os.set_inheritable(int(descriptor), False)
    with contextlib.suppress(OSError):  # it is gone by now
        os.chdir(folder)
    return int(descriptor)


def _end_silently_on_ctrl_c() -> None:
    """Until a handler is installed, let Ctrl-C end this process like a C program: without Python's traceback."""
    if (
        signal.getsignal(signal.SIGINT) is signal.default_int_handler
    ):  # not where it is ignored (`nohup`, a script's `&`)
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def _exec(words: list[str]) -> int:
    from day6_core.shell.outward.execute import main as execute

    return execute(words)


def _python(words: list[str]) -> int:
    """Become `python3 FILE ARG…` with our packages on its path."""
    from day6_core.ros.environment import program_environment

    if words and words[0] in ("-h", "--help"):
        print("usage: day6-tui python FILE [ARG ...]\n")
        print("Run a Python file unmodified as a ROS program: python3 with rclpy on its path.")
        return 0
    argv = [sys.executable, *words]
    environment = program_environment()
    if sys.platform != "win32":
        os.execve(sys.executable, argv, environment)
    from day6_core.shell.outward.subshell import call

    return call(argv, environment)


def _ros2(words: list[str]) -> int:
    import importlib

    from day6_core.session.local import has_terminal, run_local

    lasting = words[:1] in (["run"], ["launch"], ["daemon"], ["bag"]) or "echo" in words or "hz" in words
    show = _show_window if words[:1] == ["run"] and has_terminal() else None
    main = importlib.import_module("day6_core.ros.ros2").main
    status = run_local(main, ["ros2", *words], one_shot=not lasting, show=show)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C comes too late to change how it has ended
    return status


def _show_window(foreground: Foreground) -> None:
    """Draw the program's window. A program without one never calls this, and Textual is not imported for it."""
    from day6_tui.window_app import show

    show(foreground)


def _named_program(name: str) -> Callable[[list[str]], int] | None:
    """Run rqt_graph, rviz2, check_urdf …, which are commands of their own in ROS too."""
    from day6_core.ros.program_index import COMMANDS

    return partial(_program, name) if name in COMMANDS else None


def _program(name: str, words: list[str]) -> int:
    from day6_core.ros.program_index import COMMANDS
    from day6_core.ros.programs import load
    from day6_core.session.local import has_terminal, run_local

    return run_local(load(*COMMANDS[name]), [name, *words], show=_show_window if has_terminal() else None)


def _colcon(words: list[str]) -> int:
    from day6_core.session.local import run_local
    from day6_core.workspace.command import main as colcon

    return run_local(colcon, ["colcon", *words], one_shot=True)


def _export(words: list[str]) -> int:
    from day6_core.workspace.export import main as export

    return export(words)


def _shell(words: list[str]) -> int:
    from day6_core.shell.outward.subshell import main as subshell

    return subshell(words)


def _lessons(words: list[str]) -> int:
    from day6_core.ros.environment import activate

    activate()
    from day6_core.lessons.command import main as lessons

    return lessons(words)


def _demo(words: list[str]) -> list[str]:
    """`day6-tui demo 3 …` is the desktop with lesson day3 that is played by itself."""
    name = f"day{words[0]}" if words[0].isdecimal() else words[0]
    return ["--lesson", name, "--demo", *words[1:]]


def _why(words: list[str]) -> int:
    """Explain a message: the words, or the last line with a card of what is piped in."""
    from day6_core.session.local import run_local
    from day6_core.shell.builtins.why import why

    if words and words[0] in ("-h", "--help"):
        print("usage: day6-tui why [TEXT | TOPIC | NUMBER]\n")
        print("Explain a message of ROS 2, Python, colcon or launch; A 2>&1 | day6-tui why explains what A said.")
        return 0
    return run_local(why, ["why", *words], one_shot=True)


def _office(name: str, words: list[str]) -> int:
    """Run `submit`, `grade` or `report`, in the user's language."""
    import importlib

    from day6_core.language import language_of
    from day6_core.ros.environment import activate

    activate()
    module = importlib.import_module(f"day6_core.lessons.{_OFFICE[name]}")
    status: int = module.main(words, language_of(os.environ, words))
    return status


def _attach(words: list[str]) -> int:
    from day6_tui.detached.client import attach

    return attach(words)


def _serve(words: list[str]) -> int:
    from day6_tui.web.command import main as serve

    return serve(words)


def _wheelhouse(words: list[str]) -> int:
    from day6_tui.wheelhouse.command import main as wheelhouse

    return wheelhouse(words)


def _cast(words: list[str]) -> int:
    from day6_tui.cast.command import main as cast

    return cast(words)


def _complete(words: list[str]) -> int:
    from day6_core.shell.outward.real_completion import main as complete

    return complete(words, _own_words)


def _own_words(words: list[str]) -> list[str]:
    """Completions for the last word after `day6-tui`: commands and options; nothing where a file is expected."""
    from day6_core.ros.program_index import COMMANDS
    from day6_tui.command_line import build_parser
    from day6_tui.distribution_choice import OPTION

    if words[0] == OPTION and len(words) > 2:  # a command may follow
        words = words[2:]
    options = build_parser()._option_string_actions
    option = options.get(words[-2]) if len(words) > 1 else None
    if option is not None and option.choices is not None:
        return [str(choice) for choice in option.choices]
    if words[0] in _TABLE or words[0] in COMMANDS or (option is not None and option.nargs != 0):
        return []
    if words[-1].startswith("-"):
        return list(options)
    return [*(_TABLE.keys() - {"complete"}), "class", *COMMANDS] if len(words) == 1 else []


def _env(words: list[str]) -> int:
    from day6_core.shell.outward.subshell import print_environment

    return print_environment(words)


_OFFICE = {"submit": "submission", "grade": "grading.command", "report": "report"}
_TABLE: dict[str, Callable[[list[str]], int]] = {
    "attach": _attach,
    "exec": _exec,
    "python": _python,
    "ros2": _ros2,
    "colcon": _colcon,
    "export": _export,
    "lessons": _lessons,
    "submit": partial(_office, "submit"),
    "grade": partial(_office, "grade"),
    "report": partial(_office, "report"),
    "shell": _shell,
    "env": _env,
    "cast": _cast,
    "serve": _serve,
    "wheelhouse": _wheelhouse,
    "complete": _complete,
    "why": _why,
}

if __name__ == "__main__":
    sys.exit(main())
