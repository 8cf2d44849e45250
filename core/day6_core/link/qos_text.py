"""A QoS profile as the text rmw_zenoh puts at the end of an endpoint's liveliness token.

`reliability:durability:history,depth:deadline s,ns:lifespan s,ns:liveliness,lease s,ns`, where an empty field stands
for rmw_zenoh's default (reliable, volatile, keep last 42, infinite durations, automatic). Numbers are rmw's.
"""

from __future__ import annotations

import re
from enum import IntEnum
from typing import TypeVar

from day6_core.graph.qos import (
    DURATION_UNSPECIFIED,
    INFINITE_NS,
    Durability,
    History,
    Liveliness,
    QoS,
    Reliability,
)

DEFAULT_DEPTH = 42
_SECOND = 1_000_000_000
_LARGEST_DEPTH = 0xFFFF_FFFF_FFFF_FFFF
"""rmw's depth is a size_t."""
_WRITTEN = re.compile(r"[0-9]{0,20}(?:[:,][0-9]{0,20}){10}", re.ASCII)
"""Eleven numbers, each of which may be omitted. Python's `int` alone would also accept signs, blanks and non-ASCII digits."""

Policy = TypeVar("Policy", bound=IntEnum)


def qos_to_text(qos: QoS) -> str:
    """Return the text of a resolved profile. The depth is always written, because other implementations' default differs."""
    reliability = _unless(qos.reliability, Reliability.RELIABLE)
    durability = _unless(qos.durability, Durability.VOLATILE)
    history = _unless(qos.history, History.KEEP_LAST)
    liveliness = _unless(qos.liveliness, Liveliness.AUTOMATIC)
    return (
        f"{reliability}:{durability}:{history},{qos.depth}:{_duration(qos.deadline)}:{_duration(qos.lifespan)}"
        f":{liveliness},{_duration(qos.liveliness_lease_duration)}"
    )


def qos_from_text(text: str) -> QoS:
    """Return the profile a text stands for.

    Raises:
        ValueError: the text is not a profile.
    """
    fields = [field.split(",") for field in text.split(":")]
    if not _WRITTEN.fullmatch(text) or [len(field) for field in fields] != [1, 1, 2, 2, 2, 3]:
        raise ValueError(f"not a QoS profile: {text!r}")
    (reliability,), (durability,), (history, depth), deadline, lifespan, (liveliness, *lease) = fields
    if depth and int(depth) > _LARGEST_DEPTH:
        raise ValueError(f"not a QoS profile: {text!r}")
    return QoS(
        depth=int(depth) if depth else DEFAULT_DEPTH,
        history=_policy(history, History.KEEP_LAST),
        reliability=_policy(reliability, Reliability.RELIABLE),
        durability=_policy(durability, Durability.VOLATILE),
        deadline=_nanoseconds(deadline),
        lifespan=_nanoseconds(lifespan),
        liveliness=_policy(liveliness, Liveliness.AUTOMATIC),
        liveliness_lease_duration=_nanoseconds(lease),
    )


def _unless(policy: IntEnum, default: IntEnum) -> str:
    return "" if policy == default else str(int(policy))


def _duration(nanoseconds: int) -> str:
    if nanoseconds == DURATION_UNSPECIFIED or nanoseconds >= INFINITE_NS:
        return ","
    seconds, rest = divmod(nanoseconds, _SECOND)
    return f"{seconds},{rest}"


def _policy(text: str, default: Policy) -> Policy:
    return type(default)(int(text)) if text else default


def _nanoseconds(parts: list[str]) -> int:
    seconds, rest = parts
    if not seconds and not rest:
        return DURATION_UNSPECIFIED
    total = int(seconds or 0) * _SECOND + int(rest or 0)
    return DURATION_UNSPECIFIED if total >= INFINITE_NS else total
