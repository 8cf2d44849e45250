"""Resolves a command line to a program: one that day6-tui's host runs, or a process.

- *Ours*: executables of the packages that come with day6-tui (their "files" `<prefix>/lib/<package>/<name>` do not exist), and
  commands such as `ros2`. They are cooperative programs, so they run in the day6-tui process that started this launch, and have
  their windows there; see `_host`. Without such a host (a script with its own LaunchService) they run as processes, started
  through `LAUNCH_PROCESS`.
- *Everything else* is a process of this launch. Python scripts, and `python3`, run with the Python that runs day6-tui.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Container, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from day6_core.ros.environment import LAUNCH_PROCESS
from day6_core.ros.program_index import named_by, place_of_command

_SHELL_SYNTAX = re.compile(r"[|&;<>()$`*?\[\]{}~#!\n]")
_COMMAND_PLACE = re.compile(r"((?:^|[|&;(`])\s*(?:(?:then|do|else|exec|time)\s+)*)([^\s|&;()<>'\"`]+)")
"""The places of a shell line where the name of a command is."""
_MORE_THAN_ONE = re.compile(r"[|&;(`\n]")
_WORD_ENDS = re.compile(r"[\s|&;()<>]+")


class BuiltIn(NamedTuple):
    """A program of ours. `kind` is 'program' (argv[0] is its "file"), 'command', or 'line' (one text for the shell)."""

    kind: str
    argv: list[str]


class ProcessPlan(NamedTuple):
    """A process: the arguments for `subprocess.Popen`."""

    args: str | list[str]
    shell: bool


def resolve(cmd: Sequence[str], shell: bool, *, hosted: bool, terminals: Container[str] = ()) -> BuiltIn | ProcessPlan:
    """Return the program of a command line. `hosted`: there is a host that runs our programs and opens these `terminals`."""
    if shell:
        line = " ".join(cmd)
        if not any(is_command(word) for word in _WORD_ENDS.split(line)):
            return ProcessPlan(line, True)
        if not _SHELL_SYNTAX.search(line):
            return _ours("command", shlex.split(line), hosted)
        return BuiltIn("line", [line]) if hosted else ProcessPlan(_with_our_commands(line), True)
    if named_by(Path(cmd[0])) is not None:
        return _ours("program", list(cmd), hosted)
    if is_command(cmd[0]) or _opens_a_terminal(cmd[0], terminals):
        return _ours("command", list(cmd), hosted)
    return ProcessPlan(_with_our_python(list(cmd)), False)


def _ours(kind: str, argv: list[str], hosted: bool) -> BuiltIn | ProcessPlan:
    return BuiltIn(kind, argv) if hosted else ProcessPlan([sys.executable, str(LAUNCH_PROCESS), kind, *argv], False)


def _with_our_commands(line: str) -> str:
    """Replace the names of our commands with command lines that start them as processes, for the system's own shell."""

    def replaced(found: re.Match[str]) -> str:
        before, word = found.groups()
        if not is_command(word):
            return found[0]
        words = [sys.executable, str(LAUNCH_PROCESS), "command", word]
        return before + (subprocess.list2cmdline(words) if os.name == "nt" else shlex.join(words))

    changed = _COMMAND_PLACE.sub(replaced, line)
    # If it is the line's only command, signals must reach it and not a shell that waits for it.
    alone = os.name != "nt" and changed != line and not _MORE_THAN_ONE.search(line)
    return f"exec {changed}" if alone else changed


def is_command(word: str) -> bool:
    """Return whether a word is one of our ROS commands: `ros2`, or the path that `which ros2` prints."""
    name = word.rpartition("/")[2]
    return bool(place_of_command(name)) and (word == name or word.startswith("/opt/ros/"))


def _opens_a_terminal(word: str, terminals: Container[str]) -> bool:
    """Return whether a word is a terminal that the desktop opens itself; with a display it is a real terminal."""
    return word.rpartition("/")[2] in terminals and "DISPLAY" not in os.environ


def which(name: str) -> str | None:
    """Return the path of an executable: from the PATH, or beside our Python (xacro and others come with it)."""
    if name in ("python3", "python"):
        return sys.executable
    if is_command(name):
        return place_of_command(name.rpartition("/")[2])
    return shutil.which(name) or shutil.which(name, path=os.path.dirname(sys.executable))


def run_captured(words: Sequence[str], stderr: int) -> subprocess.CompletedProcess[str]:
    """Run a command to its end and capture its output. Raises FileNotFoundError if there is no such command."""
    plan = resolve(words, False, hosted=False)
    args = list(plan.args) if isinstance(plan, ProcessPlan) else plan.argv
    if os.path.basename(args[0]) == args[0]:
        args[0] = which(args[0]) or args[0]
    options: dict[str, Any] = {"encoding": "utf-8", "errors": "replace"}
    return subprocess.run(args, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=stderr, check=False, **options)


def _with_our_python(cmd: list[str]) -> list[str]:
    if cmd[0] in ("python3", "python"):
        return [sys.executable, *cmd[1:]]
    path = which(cmd[0]) if os.path.dirname(cmd[0]) == "" else cmd[0]
    if path is None:
        return cmd
    return [sys.executable, path, *cmd[1:]] if _is_python_script(path) else [path, *cmd[1:]]


def _is_python_script(path: str) -> bool:
    try:
        with open(path, "rb") as file:
            line = file.readline(256)
    except OSError:
        return False
    return line.startswith(b"#!") and b"python" in line and (os.name == "nt" or os.access(path, os.X_OK))
