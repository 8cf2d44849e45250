"""Rules about the signs of what goes wrong inside programs although nothing fails.

A program measures (`rclpy._day6.signs`); the rules here say from where on a figure is a fault, one function for each kind.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.process_reports import Place, Sign

MISSED = 0.4
"""Part of a timer's calls that are left out from where on it does not keep its period."""

SELDOM_S = 100.0
"""Who wants a call so seldom may have meant milliseconds."""

LOST, MOST_LOST = 20, 0.5
"""Messages, and part of all, that a subscription loses within two seconds."""

FLOOD_HZ = 2000.0
GROWN = 3
"""Publishers … that a node makes anew each second."""

WAITS_S = 2.0
"""Seconds that an accepted goal, or a cancellation, may wait."""

SWALLOWED, MOSTLY = 3, 0.8
"""Exceptions that a handler swallows, and part of the calls of its function."""

MATCHABLE, PLENTY = 3, 20
"""Messages of every input from which a synchronizer should have made something; and of one, where another has none."""

SHORT_GAP_S = 5.0
"""Times that lie further apart do not differ because a queue is short."""


def of_signs(facts: Facts) -> Iterator[Finding]:
    """Yield what is wrong by the programs' own figures."""
    for process in facts.processes:
        for sign in process.signs:
            judge = _JUDGES.get(sign.kind)
            with suppress(KeyError, TypeError, ValueError):  # an answer of something else than our rclpy
                if judge is not None and (found := judge(sign)) is not None:
                    yield found


def opened(place: Place) -> str:
    """Return the command that opens a place in the editor."""
    return f"nano +{place.line} {shlex.quote(place.file)}" if place.file else ""


def _said(level: str, key: str, sign: Sign, then: str = "", **parameters: object) -> Finding:
    return finding(level, key, node=sign.node, where=sign.place.short, **parameters, then=then or opened(sign.place))


def _number(value: Any) -> float:
    return float(value)


def _late(sign: Sign) -> Finding | None:
    values = sign.values
    wanted, rate = _number(values["wanted"]), _number(values["rate"])
    if not wanted:
        return _said("warning", "timer_zero", sign, what=values["what"], rate=_roughly(rate))
    if _number(values["share"]) < MISSED:
        return None
    said = f"{wanted:,.0f}" if wanted >= 100 else f"{wanted:.3g}"
    return _said("warning", "timer_late", sign, what=values["what"], wanted=said, rate=_roughly(rate))


def _roughly(rate: float) -> str:
    """A rate in as many digits as it was measured: two."""
    return f"{rate:,.0f}" if rate >= 10 else f"{rate:.1f}"


def _seldom(sign: Sign) -> Finding | None:
    period = _number(sign.values["period"])
    if period < SELDOM_S:
        return None
    return _said("info", "timer_seldom", sign, what=sign.values["what"], period=f"{period:g}")


def _losses(sign: Sign) -> Finding | None:
    values = sign.values
    if _number(values["share"]) < MOST_LOST or _number(values["lost"]) < LOST:
        return None
    said: dict[str, Any] = {name: values[name] for name in ("topic", "what", "lost", "count")}
    level = "info" if _number(values["depth"]) == 1 else "warning"  # who keeps one message wants only the newest
    return _said(level, "losses", sign, **said, rate=_roughly(_number(values["rate"])))


def _flood(sign: Sign) -> Finding | None:
    topic, rate = sign.values["topic"], _number(sign.values["rate"])
    return (
        _said("warning", "flood", sign, f"ros2 topic hz {topic}", topic=topic, rate=_roughly(rate))
        if rate >= FLOOD_HZ
        else None
    )


def _grows(sign: Sign) -> Finding | None:
    values = sign.values
    if _number(values["least"]) < GROWN:
        return None
    then = opened(sign.place) or f"ros2 node info {shlex.quote(sign.node)}"
    name = str(values["name"]) or "create_timer"
    return finding("error", f"grows_{values['kind']}", node=sign.node, count=values["count"], name=name, then=then)


def _goal_unsettled(sign: Sign) -> Finding:
    return _said("error", "goal_unsettled", sign, name=sign.values["name"], what=sign.values["what"])


def _after(seconds: float, level: str, key: str) -> Callable[[Sign], Finding | None]:
    """A sign of an action that counts when it has lasted so long."""

    def judge(sign: Sign) -> Finding | None:
        values = sign.values
        if _number(values["seconds"]) < seconds:
            return None
        then = opened(sign.place) or f"ros2 action info {shlex.quote(str(values['name']))}"
        return finding(level, key, node=sign.node, name=values["name"], what=values["what"], then=then)

    return judge


def _empty_list(sign: Sign) -> Finding:
    name = sign.values["name"]
    then = f"ros2 param describe {shlex.quote(sign.node)} {shlex.quote(str(name))}"
    return _said("info", "empty_list", sign, then, name=name)


def _launch_text(sign: Sign) -> Finding:
    name = sign.values["name"]
    then = f"ros2 param get {shlex.quote(sign.node)} {shlex.quote(str(name))}"
    return _said("error", "launch_text", sign, then, name=name, value=sign.values["value"])


def _swallowed(sign: Sign) -> Finding | None:
    values = sign.values
    count, calls = _number(values["count"]), _number(values["calls"])
    if count < SWALLOWED or count < MOSTLY * calls:
        return None
    return _said("error", "swallowed", sign, what=values["what"], error=values["error"], raised=values["raised"])


def _sync(sign: Sign) -> Finding | None:
    values = sign.values
    topics, gap = values["topics"], _number(values["gap"])
    least, most, slop = (_number(values[name]) for name in ("least", "most", "slop"))
    then = f"ros2 topic hz {str(topics).partition(', ')[0]}"
    if values["silent"]:
        if most < PLENTY:
            return None
        level = "info" if values["unpublished"] else "warning"
        return _said(level, "sync_silent", sign, "ros2 topic list -v", topics=topics, silent=values["silent"])
    if least < MATCHABLE:
        return None
    if not values["callbacks"]:
        return _said("error", "sync_no_callback", sign, then, topics=topics)
    if values["matches"]:
        return None
    if values["timeless"]:
        return _said("error", "sync_timeless", sign, then, topics=topics)
    if gap <= slop:
        return None
    said = {"topics": topics, "gap": f"{gap:.3g}", "slop": f"{slop:g}"}
    if values["short"] and gap < SHORT_GAP_S:
        said |= {"short": values["short"], "size": values["queue_size"]}
        return _said(
            "error", "sync_queue", sign, then, **{name: said[name] for name in ("topics", "gap", "short", "size")}
        )
    return _said("error", "sync_stamps" if slop else "sync_exact", sign, then, **said)


_JUDGES: dict[str, Callable[[Sign], Finding | None]] = {
    "late": _late,
    "seldom": _seldom,
    "losses": _losses,
    "flood": _flood,
    "grows": _grows,
    "goal_unsettled": _goal_unsettled,
    "goal_waits": _after(WAITS_S, "error", "goal_waits"),
    "cancel_ignored": _after(WAITS_S, "warning", "cancel_ignored"),
    "cancel_unheard": _after(WAITS_S / 2, "error", "cancel_unheard"),
    "empty_list": _empty_list,
    "launch_text": _launch_text,
    "swallowed": _swallowed,
    "sync": _sync,
}
"""Kind of a sign -> what judges it."""
