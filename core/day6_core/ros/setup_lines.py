"""Lines that source a distribution of ROS 2, `source /opt/ros/NAME/setup.bash`, in what a user has written."""

from __future__ import annotations

import re

from day6_core.ros.distribution import NAMES

_SETUP = r"/opt/ros/(?P<name>[^/\s]+)/(?:local_)?setup\.(?:bash|sh|zsh)"
_FILE = re.compile(_SETUP)
_LINE = re.compile(
    rf"(?:^|[;&|{{]|\b(?:then|do|else))[ \t]*(?:source|\.)[ \t]+(?P<quote>[\"']?){_SETUP}(?P=quote)(?=$|[\s;&|])", re.M
)


def distribution_of(path: str) -> str | None:
    """Return the distribution whose setup script has this path, any one; None for other files."""
    found = _FILE.fullmatch(path)
    return found["name"] if found else None


def last_sourced(text: str) -> str | None:
    """Return the distribution that the lines of a shell source last, None without one of ours."""
    return next((found["name"] for found in reversed([*_LINE.finditer(text)]) if found["name"] in NAMES), None)
