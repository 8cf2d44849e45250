"""The distribution of ROS 2 that this process stands in for.

A program belongs to the distribution whose folder is on its Python path (`python_of/<name>`), as a program of real ROS belongs to
the `/opt/ros/<name>` that was sourced. So whatever a program starts has the same one, and changing ROS_DISTRO afterwards
changes nothing, as there. Only a process without such a folder looks at ROS_DISTRO: `day6-tui` where it is started. What the
distributions differ in is in `differences`.
"""

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

NAMES = ("humble", "jazzy", "kilted", "lyrical", "rolling")
"""From the oldest to the newest."""
DEFAULT = "jazzy"
HANDED_ON = "DAY6_DISTRO"
"""The variable by which `day6-tui` tells those it starts (the desktops of `serve`, a keeper)."""
_FOLDERS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "python_of")


def python_folder(name: str) -> str:
    """Return the folder of the Python packages that not every distribution has."""
    return os.path.join(_FOLDERS, name)


def on_path(entries: Iterable[str]) -> str | None:
    """Return the distribution of the first of these entries of a Python path that is its folder, None without one."""
    for entry in entries:
        folder, name = os.path.split(entry)
        if name in NAMES and folder == _FOLDERS:
            return name
    return None


def named_in(environment: Mapping[str, str]) -> str | None:
    """Return the distribution that a `day6-tui` above this process was given, else the one that ROS_DISTRO names.

    None if that is none of ours: a real ROS Foxy may be sourced.
    """
    return next((name for key in (HANDED_ON, "ROS_DISTRO") if (name := environment.get(key, "")) in NAMES), None)


_current = on_path(sys.path) or named_in(os.environ) or DEFAULT


def current() -> str:
    return _current


def setup_script() -> str:
    """Return the file that is sourced to have this distribution in a terminal."""
    return f"/opt/ros/{_current}/setup.bash"


def choose(name: str) -> None:
    """Make it the distribution of this process; before anything of ROS is imported."""
    global _current
    _current = name
