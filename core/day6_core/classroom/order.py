"""What a teacher asks of a pupil's desktop."""

from __future__ import annotations

import json
from dataclasses import dataclass

LONGEST = 8 << 10
"""Bytes of one order."""
LONGEST_SAYING = 1000
LONGEST_NAME = 100
MOST_SECONDS = 60.0
"""For which one order lets a teacher watch; it has to be renewed."""

WITH_TEXT = {"say": LONGEST_SAYING, "scene": LONGEST_NAME, "lesson": LONGEST_NAME, "type": 256}
"""Orders with a text, and how long that may be: a sentence, a name, keys as a terminal sends them."""
WITH_SWITCH = ("freeze", "attend", "seen")
"""Stop the keyboard; a teacher is there; somebody looks by a link that only watches."""
PLAIN = ("tell", "unwatch", "ask_to_type", "stop_typing", "lower_hand", "end")


class OrderError(ValueError):
    """It is no order; the message says why."""


@dataclass(frozen=True)
class Order:
    """`do` is one of the words above, or "watch". What does not belong to it keeps its default."""

    do: str
    text: str = ""
    on: bool = False
    seconds: float = 0.0


def encode(order: Order) -> bytes:
    """Return an order as it is sent."""
    found: dict[str, object] = {"do": order.do}
    if order.do in WITH_TEXT:
        found["text"] = order.text
    elif order.do in WITH_SWITCH:
        found["on"] = order.on
    elif order.do == "watch":
        found["seconds"] = order.seconds
    return json.dumps(found, ensure_ascii=False).encode(errors="replace")


def decode(data: bytes | str) -> Order:
    """Read an order from outside. Raises OrderError."""
    if len(data) > LONGEST:
        raise OrderError(f"{len(data)} bytes")
    try:
        found = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise OrderError(str(error)) from None
    return of(found)


def of(found: object) -> Order:
    """Check an order that was JSON. Raises OrderError."""
    if not isinstance(found, dict) or not isinstance(do := found.get("do"), str):
        raise OrderError("an order says what to do")
    if do in WITH_TEXT:
        text = found.get("text")
        if not isinstance(text, str) or not 0 < len(text) <= WITH_TEXT[do]:
            raise OrderError(f"{do} needs a text of at most {WITH_TEXT[do]} characters")
        return Order(do, text=text)
    if do in WITH_SWITCH:
        return Order(do, on=found.get("on") is True)
    if do == "watch":
        seconds = found.get("seconds")
        if isinstance(seconds, bool) or not isinstance(seconds, (int, float)) or not 0 < seconds <= MOST_SECONDS:
            raise OrderError(f"watch needs a number of seconds up to {MOST_SECONDS:g}")
        return Order(do, seconds=float(seconds))
    if do not in PLAIN:
        raise OrderError("there is no such order")
    return Order(do)
