"""Which program a command line means, and who runs it.

- *Ours*: executables of the packages that came with day6-tui (their "files" `<prefix>/lib/<package>/<name>` do not exist), and
  commands such as `ros2`. They are cooperative programs, so they run in the day6-tui that started this launch, and have their
  windows there; see `_host`. A launch that nobody started (a script with a LaunchService of its own) runs them as processes.
- *Everything else* is a process here. Python scripts, and `python3`, run with the Python that runs day6-tui.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

STARTER = str(Path(__file__).with_name("_process"))
_SHELL_SIGNS = re.compile(r"[|&;<>()$`*?\[\]{}~#!\n]")
_COMMAND_PLACE = re.compile(r"((?:^|[|&;(`])\s*(?:(?:then|do|else|exec|time)\s+)*)([^\s|&;()<>'\"`]+)")
"""Where a shell line has the name of a command."""
_MORE_THAN_ONE = re.compile(r"[|&;(`\n]")
_WORD_ENDS = re.compile(r"[\s|&;()<>]+")


class Ours(NamedTuple):
    """A program of ours. `kind` is 'program' (argv[0] is its "file"), 'command', or 'line' (one text for the shell)."""

    kind: str
    argv: list[str]


class Foreign(NamedTuple):
    """A process: what `subprocess.Popen` takes."""

    args: str | list[str]
    shell: bool


def what_runs(cmd: Sequence[str], shell: bool, *, hosted: bool) -> Ours | Foreign:
    """Say what a command line starts. `hosted`: there is somebody who runs programs of ours."""
    if shell:
        line = " ".join(cmd)
        if not any(is_command(word) for word in _WORD_ENDS.split(line)):
            return Foreign(line, True)
        if not _SHELL_SIGNS.search(line):
            return _ours("command", shlex.split(line), hosted)
        return Ours("line", [line]) if hosted else Foreign(_with_our_commands(line), True)
    if built_in(cmd[0]) is not None:
        return _ours("program", list(cmd), hosted)
    if is_command(cmd[0]) or (hosted and _opens_a_terminal(cmd[0])):
        return _ours("command", list(cmd), hosted)
    return Foreign(_with_our_python(list(cmd)), False)


def _ours(kind: str, argv: list[str], hosted: bool) -> Ours | Foreign:
    return Ours(kind, argv) if hosted else Foreign([sys.executable, STARTER, kind, *argv], False)


def _with_our_commands(line: str) -> str:
    """Put what starts our commands as processes in the place of their names, for the system's own shell."""

    def replaced(found: re.Match[str]) -> str:
        before, word = found.groups()
        if not is_command(word):
            return found[0]
        words = [sys.executable, STARTER, "command", word]
        return before + (subprocess.list2cmdline(words) if os.name == "nt" else shlex.join(words))

    changed = _COMMAND_PLACE.sub(replaced, line)
    # Where it is all there is to do, signals are for it and not for a shell that waits for it.
    alone = os.name != "nt" and changed != line and not _MORE_THAN_ONE.search(line)
    return f"exec {changed}" if alone else changed


def built_in(path: str) -> tuple[str, str] | None:
    """Return package and name of the executable of ours whose "file" a path names, None for any other path."""
    from day6_tui.core.ros.programs import named_by

    return named_by(Path(path))


def is_command(word: str) -> bool:
    """Say whether a word is a ROS command of ours: `ros2`, or the place where `which ros2` says that it is."""
    name = word.rpartition("/")[2]
    if not name or (word != name and not word.startswith("/opt/ros/")):
        return False
    from day6_tui.core.shell.commands import place_of

    return place_of(name).startswith("/opt/ros/")


def _opens_a_terminal(word: str) -> bool:
    """Say whether a word is a terminal, which the desktop has of its own; where there is a display it is a real one."""
    from day6_tui.core.shell.commands import MODULES

    return word.rpartition("/")[2] in MODULES["terminals"] and "DISPLAY" not in os.environ


def which(name: str) -> str | None:
    """Return where an executable is: on the PATH, or beside our Python (xacro and others that came with it)."""
    if name in ("python3", "python"):
        return sys.executable
    if is_command(name):
        from day6_tui.core.shell.commands import place_of

        return place_of(name)
    return shutil.which(name) or shutil.which(name, path=os.path.dirname(sys.executable))


def run_captured(words: Sequence[str], stderr: int) -> subprocess.CompletedProcess[str]:
    """Run a command to its end. Raises FileNotFoundError if there is no such command."""
    plan = what_runs(words, False, hosted=False)
    args = list(plan.args) if isinstance(plan, Foreign) else plan.argv
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
