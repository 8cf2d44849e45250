"""Which distribution of ROS 2 the command `day6-tui` stands in for.

That of `--distro`; else that of the terminal it was started in, where a ROS is sourced (one of ours, or a real one that names
one of ours in ROS_DISTRO); else that which the lines of `exec -c` or the simulated home's `.bashrc` source; else what was chosen
last; else Jazzy. `--distro` before a command is for that command, without one it is remembered, as is what a line sources in a
terminal of the desktop, which then starts again.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path

from day6_core.places import default_home
from day6_core.ros import distribution

SETTING = "distro"
KEEPER = "DAY6_KEEPER"
"""The variable with the descriptor of the line to the keeper that started this desktop, and the folder of its user."""


LARGEST = 64_000
"""Bytes of a .bashrc that are looked at."""


def settle(name: str | None, words: Sequence[str] = ()) -> None:
    """Choose the distribution of this process, and of all it starts: the one that was named on the command line, if one was.

    `words` are those of the command.
    """
    if name is None and distribution.on_path(sys.path) is None and distribution.named_in(os.environ) is None:
        name = sourced_by(words) or _remembered()
    if name is not None:
        distribution.choose(name)
        os.environ[distribution.HANDED_ON] = name


def option_in(words: list[str]) -> str | None:
    """Return the last distribution that the options of the desktop name, None without one; argparse refuses a wrong one."""
    from day6_core.command_line.leading import DISTRIBUTION

    name = _value(DISTRIBUTION, words)
    return name if name in distribution.NAMES else None


def _value(option: str, words: Sequence[str]) -> str:
    found = [after for word, after in pairwise(words) if word == option]
    found += [word.partition("=")[2] for word in words if word.startswith(f"{option}=")]
    return found[-1] if found else ""


def sourced_by(words: Sequence[str]) -> str | None:
    """Return the distribution that is sourced in the lines of a command with these words, else in its home's .bashrc."""
    home = Path(_value("--home", words) or default_home()).expanduser()
    try:
        with open(home / ".bashrc", "rb") as file:
            text = file.read(LARGEST).decode(errors="replace")
    except OSError:
        text = ""
    lines = f"{text}\n{_value('-c', words)}" if "/opt/ros/" in text or "-c" in words else ""
    if not lines:
        return None
    from day6_core.ros.setup_lines import last_sourced

    return last_sourced(lines)


def start_again(name: str, environ: Mapping[str, str], keeper: int | None) -> int:
    """Start this process's command again as another distribution; return the status where that is another process."""
    from day6_core.command_line.leading import DISTRIBUTION

    words, first = sys.argv[1:], len(sys.orig_argv) - len(sys.argv) + 1
    rest = [
        word
        for before, word in zip(["", *words], words, strict=False)
        if DISTRIBUTION not in (before, word.partition("=")[0])
    ]
    command = [sys.executable, *sys.orig_argv[1:first], DISTRIBUTION, name, *rest]
    variables = dict(environ)
    if keeper is not None:
        os.set_inheritable(keeper, True)
        variables[KEEPER] = f"{keeper}:{os.getcwd()}"
    if os.name == "nt":  # where exec would leave the terminal to two of them
        import subprocess

        return subprocess.call(command, env=variables)
    os.execve(command[0], command, variables)


def _remembered() -> str | None:
    from day6_tui.settings import Settings

    name = Settings().text(SETTING)
    return name if name in distribution.NAMES else None
