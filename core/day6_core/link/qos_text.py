"""A QoS profile as the text rmw_zenoh puts at the end of an endpoint's liveliness token.

An empty field stands for rmw_zenoh's default (reliable, volatile, keep last 42, infinite durations, automatic). Numbers are
rmw's, durations `seconds,nanoseconds`.
"""

from __future__ import annotations

import re
from typing import Any

from day6_core.graph.qos import DURATION_UNSPECIFIED, INFINITE_NS, POLICIES, Choice, Limit, QoS

_LAYOUT = "reliability:durability:history,depth:deadline:lifespan:liveliness,liveliness_lease_duration"
DEFAULT_DEPTH = 42
_SECOND = 1_000_000_000
_LARGEST_DEPTH = 0xFFFF_FFFF_FFFF_FFFF
"""rmw's depth is a size_t."""
_NUMBER = "[0-9]{0,20}"
"""Any number may be omitted. Python's `int` alone would also accept signs, blanks and non-ASCII digits."""


def _pattern(name: re.Match[str]) -> str:
    value = f"{_NUMBER},{_NUMBER}" if isinstance(POLICIES[name[0]], Limit) else _NUMBER
    return f"(?P<{name[0]}>{value})"


_WRITTEN = re.compile(re.sub(r"\w+", _pattern, _LAYOUT), re.ASCII)


def qos_to_text(qos: QoS) -> str:
    """Return the text of a resolved profile. The depth is always written, because other implementations' default differs."""
    return re.sub(r"\w+", lambda name: _written(name[0], getattr(qos, name[0])), _LAYOUT)


def qos_from_text(text: str) -> QoS:
    """Return the profile a text stands for.

    Raises:
        ValueError: the text is not a profile.
    """
    written = _WRITTEN.fullmatch(text)
    values = {name: _value(name, each) for name, each in written.groupdict().items()} if written else {}
    if not values or values["depth"] > _LARGEST_DEPTH:
        raise ValueError(f"not a QoS profile: {text!r}")
    return QoS(**values)


def _written(name: str, value: int) -> str:
    policy = POLICIES[name]
    if isinstance(policy, Limit):
        return _duration(value)
    return "" if isinstance(policy, Choice) and value == policy.default else str(int(value))


def _value(name: str, text: str) -> Any:
    policy = POLICIES[name]
    if isinstance(policy, Limit):
        return _nanoseconds(text)
    default = policy.default if isinstance(policy, Choice) else DEFAULT_DEPTH
    return policy.values(int(text)) if text else default


def _duration(nanoseconds: int) -> str:
    if nanoseconds == DURATION_UNSPECIFIED or nanoseconds >= INFINITE_NS:
        return ","
    seconds, rest = divmod(nanoseconds, _SECOND)
    return f"{seconds},{rest}"


def _nanoseconds(text: str) -> int:
    seconds, _, rest = text.partition(",")
    if not seconds and not rest:
        return DURATION_UNSPECIFIED
    total = int(seconds or 0) * _SECOND + int(rest or 0)
    return DURATION_UNSPECIFIED if total >= INFINITE_NS else total
