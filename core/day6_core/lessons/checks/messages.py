"""Checks of what is sent: contents, rates, movements."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.graph import same
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

RATE_SECONDS, RATE_PERIODS = 3.0, 4.0
"""Over how long a rate is measured: at least so many seconds, and so many periods of the least rate that is asked for."""

_PART = re.compile(r"([A-Za-z_]\w*)((?:\[\d+\])*)\Z")
MISSING = object()


def field_of(message: Any, path: str) -> Any:
    """The value at 'linear.x' or 'position[0]', MISSING if the message has none."""
    value = message
    for part in path.split("."):
        match = _PART.match(part)
        if match is None or not hasattr(value, match[1]):
            return MISSING
        value = getattr(value, match[1])
        for index in re.findall(r"\d+", match[2]):
            try:
                value = value[int(index)]
            except (IndexError, TypeError, KeyError):
                return MISSING
    return value


@check("message", event=True, patterns=("matches",), names=("topic",))
def message(
    live: Live,
    topic: str,
    field: str = "",
    equals: Any = None,
    above: float | None = None,
    below: float | None = None,
    matches: str | None = None,
    count: int = 1,
    by: list[str] | None = None,
) -> Verdict:
    memory = live.remembered
    heard = live.heard(topic)
    how = _how(equals, above, below, matches)
    if not field:
        wanted = Say("message", topic=topic) if count == 1 else Say("message.count", topic=topic, count=count)
    elif count == 1:
        wanted = Say("message.field", topic=topic, field=field, how=how)
    else:
        wanted = Say("message.field_count", topic=topic, field=field, how=how, count=count)
    if by is not None:
        wanted = Say("message.by", inner=wanted, nodes=tuple(by))
    for _, each, sender in heard.arrivals(memory.get("read", 0)):
        value = field_of(each, field) if field else None
        if not field or (value is not MISSING and _fits(value, equals, above, below, matches)):
            if by is not None and not _is_one_of(sender, by):
                memory["others"] = sender
                continue
            memory["fit"] = memory.get("fit", 0) + 1
        memory["last"] = value
    memory["read"] = heard.count
    found = memory.get("fit", 0)
    if found >= count:
        return Verdict(True, wanted)
    if not heard.count:
        return Verdict(False, wanted, Say("message.saw_none", topic=topic))
    if "last" not in memory and "others" in memory:
        return Verdict(False, wanted, Say("message.saw_others", sender=memory["others"]))
    if not field:
        return Verdict(False, wanted, Say("message.saw_count", found=found))
    if memory.get("last") is MISSING:
        return Verdict(False, wanted, Say("message.no_field", field=field))
    return Verdict(False, wanted, Say("message.saw", found=found, field=field, value=_short(memory.get("last"))))


def _fits(value: Any, equals: Any, above: float | None, below: float | None, matches: str | None) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return (
        (equals is None or same(value, equals))
        and (above is None or (number and value > above))
        and (below is None or (number and value < below))
        and (matches is None or re.search(matches, str(value)) is not None)
    )


def _is_one_of(sender: str, names: Iterable[str]) -> bool:
    """Whether a node is named; a name without a slash is meant in any namespace."""
    return any(sender == name if name.startswith("/") else sender.rpartition("/")[2] == name for name in names)


def _how(equals: Any, above: float | None, below: float | None, matches: str | None) -> tuple[Say, ...]:
    pattern = None if matches is None else readable(matches)
    parts = (("equals", equals), ("above", above), ("below", below), ("matches", pattern))
    return tuple(Say(f"message.{name}", value=value) for name, value in parts if value is not None)


def _short(value: Any) -> str:
    text = str(value)
    return text if len(text) <= 60 else text[:59] + "…"


@check("rate", names=("topic",))
def rate(live: Live, topic: str, least: float, most: float | None = None) -> Verdict:
    wanted = Say("rate", topic=topic, least=f"{least:g}")
    if most is not None:
        wanted = Say("rate.most", topic=topic, least=f"{least:g}", most=f"{most:g}")
    now = live.now_ns()
    window = max(RATE_SECONDS, RATE_PERIODS / least if least > 0 else 0.0)
    times = [when for when, _ in live.heard(topic).since(0) if now - when <= window * 1e9]
    if len(times) < 3 or now - times[-1] > max(1.0, 2 / least if least else 1.0) * 1e9:
        return Verdict(False, wanted, Say("rate.saw_none"))
    measured = (len(times) - 1) * 1e9 / max(1, times[-1] - times[0])
    ok = measured >= least and (most is None or measured <= most)
    return Verdict(ok, wanted, None if ok else Say("rate.saw", rate=f"{measured:.1f}"))


@check("turned", event=True, names=("topic",))
def turned(live: Live, joint: str, least: float = 1.0, topic: str = "/joint_states") -> Verdict:
    memory, heard = live.remembered, live.heard(topic)
    wanted = Say("turned", joint=joint, least=f"{least:g}")
    for _, each in heard.since(memory.get("read", 0)):
        memory["names"] = names = list(getattr(each, "name", ()))
        positions = getattr(each, "position", ())
        if joint not in names or names.index(joint) >= len(positions):
            continue
        angle = float(positions[names.index(joint)])
        if "angle" in memory:
            memory["turned"] = memory.get("turned", 0.0) + abs(math.remainder(angle - memory["angle"], 2 * math.pi))
        memory["angle"] = angle
    memory["read"] = heard.count
    total = memory.get("turned", 0.0)
    if total >= least:
        return Verdict(True, wanted)
    if not heard.count:
        return Verdict(False, wanted, Say("message.saw_none", topic=topic))
    if "angle" not in memory:
        return Verdict(False, wanted, Say("turned.saw_names", names=tuple(memory.get("names", ()))))
    return Verdict(False, wanted, Say("turned.saw", found=f"{total:.2f}"))


@check("moved", event=True, names=("topic",))
def moved(live: Live, topic: str = "/turtle1/pose", least: float = 1.0) -> Verdict:
    memory, heard = live.remembered, live.heard(topic)
    wanted = Say("moved", topic=topic, least=f"{least:g}")
    for _, each in heard.since(memory.get("read", 0)):
        at = _place(each)
        if at is None:
            continue
        if "at" in memory:
            memory["moved"] = memory.get("moved", 0.0) + math.dist(at, memory["at"])
        memory["at"] = at
    memory["read"] = heard.count
    total = memory.get("moved", 0.0)
    if total >= least:
        return Verdict(True, wanted)
    if not heard.count:
        return Verdict(False, wanted, Say("message.saw_none", topic=topic))
    return Verdict(False, wanted, Say("moved.saw", found=f"{total:.2f}"))


def _place(message: Any) -> tuple[float, float] | None:
    """x and y of a turtle's pose, or of a pose in an odometry."""
    for path in ("", "pose.pose.position.", "pose.position.", "position."):
        x, y = field_of(message, f"{path}x"), field_of(message, f"{path}y")
        if x is not MISSING and y is not MISSING:
            return float(x), float(y)
    return None
