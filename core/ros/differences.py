"""What differs between the distributions of ROS 2, with the source of each row. Code asks the functions below.

A source names repository and file, with the branch or the change. Whole Python packages that a distribution lacks are not in its
`python_of/<name>`; interfaces whose text was another one are in `share_of/<name>`. Where no source could settle it, `UNSETTLED`
says what is done.
"""

from __future__ import annotations

import os

from day6_tui.core.ros.distribution import NAMES, current

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SHARES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "share_of")

_RELEASE = "ros2_documentation: source/Releases/Release-"

VALUES: dict[str, tuple[tuple[Any, Any, Any, Any], str]] = {
    "turtlesim.interfaces": (
        ("turtlesim", "turtlesim", "turtlesim_msgs", "turtlesim_msgs"),
        "ros/ros_tutorials#169 (turtlesim_msgs 1.9.2); ros2/ros2_documentation#5131: Jazzy and older use turtlesim",
    ),
    "messages.check_fields": (
        ("always", "option", "option", "option"),
        "ros2/rosidl_python#194: resource/_msg.py.em, branches humble and jazzy (where day6-tui checks unless told not to)",
    ),
    "messages.have_hashes": (
        (False, True, True, True),
        "REP 2016 (Iron); ros2/rmw_zenoh#388: in Humble the key says TypeHashNotSupported",
    ),
}
"""Key -> (the values in the order of `NAMES`, the source)."""


def _since(name: str, source: str) -> tuple[tuple[str, ...], str]:
    return NAMES[NAMES.index(name) :], source


def _until(name: str, source: str) -> tuple[tuple[str, ...], str]:
    return NAMES[: NAMES.index(name) + 1], source


_SPLIT = VALUES["turtlesim.interfaces"][1]
_IRON = "ros2/rcl_interfaces: no such folder or file in branch humble, in branch jazzy there is (Iron)"
_GONE = "ros2/common_interfaces: REMOVED"

PACKAGES: dict[str, tuple[tuple[str, ...], str]] = {
    "turtlesim_msgs": _since("kilted", _SPLIT),
    "service_msgs": _since("jazzy", _IRON),
    "type_description_interfaces": _since("jazzy", _IRON),
}
"""Package -> (the distributions that have it, the source); all others are in every one."""

INTERFACES: dict[str, tuple[tuple[str, ...], str]] = {
    "turtlesim": _until("jazzy", _SPLIT),
    "rcl_interfaces/msg/LoggerLevel": _since("jazzy", _IRON),
    "rcl_interfaces/msg/SetLoggerLevelsResult": _since("jazzy", _IRON),
    "rcl_interfaces/srv/GetLoggerLevels": _since("jazzy", _IRON),
    "rcl_interfaces/srv/SetLoggerLevels": _since("jazzy", _IRON),
}
"""Interface, or package for all of its interfaces -> (the distributions that have it, the source); all others are everywhere."""

UNSETTLED: dict[str, str] = {}
"""What no source could settle -> what is done."""


def value(key: str) -> Any:
    """Return the value of a row of `VALUES` in this process's distribution."""
    return VALUES[key][0][NAMES.index(current())]


def has_package(name: str) -> bool:
    """Return whether one of our packages is in this distribution."""
    return name not in PACKAGES or current() in PACKAGES[name][0]


def has_interface(name: str) -> bool:
    """Return whether an interface ('std_msgs/msg/String') of our packages is in this distribution."""
    package = name.partition("/")[0]
    rows = (INTERFACES.get(name), INTERFACES.get(package))
    return has_package(package) and all(current() in row[0] for row in rows if row is not None)


def path_of(interface: str, share: str) -> str:
    """Return the file with the text of an interface of our packages, which are in `share`."""
    package, kind, name = interface.split("/")
    below = os.path.join(package, kind, f"{name}.{kind}")
    own = os.path.join(_SHARES, current(), below)
    return own if os.path.isfile(own) else os.path.join(share, below)
