"""`day6-tui shell`: the real terminal, with our `ros2` and `python3`."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.language import VARIABLE, language_of
from day6_core.ros.environment import program_environment

_SELF = [sys.executable, "-m", "day6_tui.main"]
"""The words that run `day6-tui` wherever its own script may be."""


def environment() -> dict[str, str]:
    """The variables of such a shell: those of a program, with pip and the rest of our Python's scripts on the path."""
    env = program_environment()
    ours, *others = env["PATH"].split(os.pathsep)
    env["PATH"] = os.pathsep.join(dict.fromkeys([ours, str(Path(sys.executable).parent), *others]))
    return env


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui shell`."""
    return command_parser("shell", language)


def main(arguments: list[str]) -> int:
    """`day6-tui shell`: run a real sub-shell and return its status."""
    language = language_of(os.environ, arguments)
    parser = build_parser(language)
    if parser.parse_args(arguments).lang is not None:
        os.environ[VARIABLE] = language
    # Git's bash sets SHELL on Windows too, to a path that only it understands.
    shell = os.environ.get("COMSPEC", "cmd.exe") if os.name == "nt" else os.environ.get("SHELL") or "/bin/sh"
    for number in (signal.SIGTERM, getattr(signal, "SIGHUP", signal.SIGTERM)):
        signal.signal(number, lambda number, frame: sys.exit(128 + number))  # leaves through the `with` below
    # compinit of zsh stumbles over Chinese letters in the path of its .zshrc.
    place = None if os.name == "nt" or tempfile.gettempdir().isascii() else "/tmp"
    with tempfile.TemporaryDirectory(prefix="day6-shell-", dir=place) as name:
        env = environment()
        words = [shell, *_start_file(Path(shell).name, Path(name), env)]
        print(parser.texts("cli.shell.starts", name=Path(shell).name), file=sys.stderr)
        return call(words, env)


def _start_file(shell: str, folder: Path, env: dict[str, str]) -> list[str]:
    """Write what bash or zsh reads at its start into `folder`, and return the arguments for that; other shells start as they do.

    The user's own file may put other folders first, so ours come after it.
    """
    if shell not in ("bash", "zsh"):
        return []
    own = "~" if shell == "bash" else shlex.quote(env.get("ZDOTDIR", env.get("HOME", "")))
    from day6_core.shell.outward.real_completion import functions

    lines = [
        f"[ -f {own}/.{shell}rc ] && . {own}/.{shell}rc",
        f'export PATH={shlex.quote(env["PATH"].partition(os.pathsep)[0])}:"$PATH"',
        f"export PYTHONPATH={shlex.quote(env['PYTHONPATH'])}",
        "PS1='(day6) '\"$PS1\"",
        functions(shell, _SELF),
    ]
    file = folder / f".{shell}rc"
    file.write_text("\n".join([*lines, ""]), encoding="utf-8")
    if shell == "bash":
        return ["--rcfile", str(file), "-i"]
    (folder / ".zshenv").write_text(f"[ -f {own}/.zshenv ] && . {own}/.zshenv\n", encoding="utf-8")
    env["ZDOTDIR"] = str(folder)
    return ["-i"]


def call(words: list[str], env: dict[str, str]) -> int:
    """Run a program that has the terminal for itself until it ends, and return its status: only that program gets Ctrl-C."""
    # A function, because a child would inherit that Ctrl-C is ignored, but not what we do about it.
    before = {signal.SIGINT: signal.signal(signal.SIGINT, lambda number, frame: None)}
    child = subprocess.Popen(words, env=env)
    # What ends us ends it too; our caller has to clean up afterwards.
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None:
            before[number] = signal.signal(number, lambda number, frame: _pass_on(child, number))
    try:
        code = child.wait()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    return code if code >= 0 else 128 - code


def _pass_on(child: subprocess.Popen[bytes], number: int) -> None:
    # An interactive bash ignores SIGTERM, but not that its terminal is gone.
    child.send_signal(number)
    if sys.platform != "win32" and number != signal.SIGHUP:
        child.send_signal(signal.SIGHUP)
