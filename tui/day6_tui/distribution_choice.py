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

SETTING = "distro"


def settle(name: str | None) -> None:
    """Choose the distribution of this process, and of all it starts: the one that was named on the command line, if one was."""
    if name is None and distribution.on_path(sys.path) is None and distribution.named_in(os.environ) is None:
        name = _remembered()
    if name is not None:
        distribution.choose(name)
        os.environ[distribution.HANDED_ON] = name


def option_in(words: list[str]) -> str | None:
    """Return the last distribution that the options of the desktop name, None without one; argparse refuses a wrong one."""
    from day6_core.command_line.leading import DISTRIBUTION

    found = [after for word, after in pairwise(words) if word == DISTRIBUTION]
    found += [word.partition("=")[2] for word in words if word.startswith(f"{DISTRIBUTION}=")]
    return found[-1] if found and found[-1] in distribution.NAMES else None


def _remembered() -> str | None:
    from day6_tui.settings import Settings

    name = Settings().text(SETTING)
    return name if name in distribution.NAMES else None
