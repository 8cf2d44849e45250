"""Checks that were made for hidden scenarios: who sends and who listens, whether contents change, where a joint points."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.graph import _new_buffer, _put
from day6_core.lessons.checks.messages import MISSING, field_of
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_core.lessons.live import Live

MOST_VALUES = 1000
CLOSE = 0.02
"""Radians by which an angle may be wrong."""


@check("talks", names=("node", "topic"))
def talks(live: Live, node: str, topic: str) -> Verdict:
    nodes = live.publishers(topic)
    ok = node in nodes
    saw = Say("talks.saw", nodes=tuple(dict.fromkeys(nodes)))
    return Verdict(ok, Say("talks", node=node, topic=topic), None if ok else saw)


@check("listens", names=("node", "topic"))
def listens(live: Live, node: str, topic: str) -> Verdict:
    nodes = live.subscribers(topic)
    ok = node in nodes
    saw = Say("listens.saw", nodes=tuple(dict.fromkeys(nodes)))
    return Verdict(ok, Say("listens", node=node, topic=topic), None if ok else saw)


@check("changes", event=True, names=("topic",))
def changes(live: Live, topic: str, field: str, count: int = 3) -> Verdict:
    memory, heard = live.remembered, live.heard(topic)
    wanted = Say("changes", topic=topic, field=field, count=count)
    values: set[str] = memory.setdefault("values", set())
    for _, each in heard.since(memory.get("read", 0)):
        value = field_of(each, field)
        if value is not MISSING and len(values) < MOST_VALUES:
            values.add(str(value)[:200])
    memory["read"] = heard.count
    if len(values) >= count:
        return Verdict(True, wanted)
    if not heard.count:
        return Verdict(False, wanted, Say("message.saw_none", topic=topic))
    return Verdict(False, wanted, Say("changes.saw", messages=heard.count, values=tuple(sorted(values)[:3])))


@check("points", event=True)
def points(live: Live, to: str, from_: str, angle: float) -> Verdict:
    """Whether a frame is turned by so many radians in all against another one, about whatever axis."""
    from rclpy.time import Time

    memory = live.remembered
    wanted = Say("points", to=to, frame=from_, angle=f"{angle:g}")
    buffer = memory.setdefault("buffer", _new_buffer())
    read = memory.setdefault("read", {"/tf": 0, "/tf_static": 0})
    for topic in read:
        heard = live.heard(topic)
        for _, message in heard.since(read[topic]):
            for each in getattr(message, "transforms", ()):
                _put(buffer, each, topic == "/tf_static")
        read[topic] = heard.count
    if not buffer.can_transform(from_, to, Time()):
        frames = sorted(buffer._getFrameStrings()) if hasattr(buffer, "_getFrameStrings") else []
        return Verdict(False, wanted, Say("transform.saw", frames=tuple(frames)))
    turn = buffer.lookup_transform(from_, to, Time()).transform.rotation
    found = 2 * math.acos(max(-1.0, min(1.0, abs(turn.w))))
    ok = abs(math.remainder(found - abs(angle), 2 * math.pi)) <= CLOSE
    return Verdict(ok, wanted, None if ok else Say("points.saw", found=f"{found:.2f}"))
