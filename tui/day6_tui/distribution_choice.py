"""Which distribution of ROS 2 the command `day6-tui` stands in for.

That of `--distro`; else that of the terminal it was started in, where a ROS is sourced (one of ours, or a real one that names one
of ours in ROS_DISTRO); else what was chosen last; else Jazzy. `--distro` before a command is for that command, without one it
is remembered.
"""

from __future__ import annotations

import os
import sys
from itertools import pairwise

from day6_core.ros import distribution

OPTION = "--distro"
SETTING = "distro"
_DESKTOPS = ("class", "demo")
"""Commands that take the options of the desktop."""


def settle(words: list[str]) -> list[str]:
    """Choose the distribution of this process, and of all it starts; return the words without an option before a command.

    Raises SystemExit, with argparse's message, for an option before a command that names no distribution.
    """
    name, rest = _before_command(words)
    if name is None and rest and (rest[0].startswith("-") or rest[0] in _DESKTOPS):
        name = option_in(rest)
    if name is None and distribution.on_path(sys.path) is None and distribution.named_in(os.environ) is None:
        name = _remembered()
    if name is not None:
        distribution.choose(name)
        os.environ[distribution.HANDED_ON] = name
    return rest


def option_in(words: list[str]) -> str | None:
    """Return the last distribution that the options of the desktop name, None without one; argparse tells a wrong one."""
    found = [after for word, after in pairwise(words) if word == OPTION]
    found += [word.partition("=")[2] for word in words if word.startswith(f"{OPTION}=")]
    return found[-1] if found and found[-1] in distribution.NAMES else None


def _before_command(words: list[str]) -> tuple[str | None, list[str]]:
    length = 2 if words[:1] == [OPTION] else 1
    option, rest = words[:length], words[length:]
    if not rest or rest[0].startswith("-") or option[0].partition("=")[0] != OPTION:
        return None, words
    from day6_tui.command_line import build_parser

    return build_parser().parse_args(option).distro, rest


def _remembered() -> str | None:
    from day6_tui.settings import Settings

    name = Settings().text(SETTING)
    return name if name in distribution.NAMES else None
