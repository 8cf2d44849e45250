"""What a teacher asks of a pupil's desktop."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields
from functools import partial
from pathlib import PurePosixPath
from typing import Any
from urllib.parse import urlsplit

from day6_core.session.harmless import one_line

LONGEST = 8 << 10
"""Bytes of one order."""
LONGEST_SAYING = 1000
LONGEST_NAME = 100
LONGEST_EXAM = 2000
LONGEST_LINK = 2000
LONGEST_PATH = 400
LARGEST_NUMBER = 1 << 53
MOST_SECONDS = 60.0
"""For which one order lets a teacher watch; it has to be renewed."""


class OrderError(ValueError):
    """It is no order; the message says why."""


@dataclass(frozen=True)
class Order:
    """`do` is a word of `ORDERS`. What does not belong to it keeps its default."""

    do: str
    text: str = ""
    on: bool = False
    seconds: float = 0.0
    number: int = 0
    """Of a saying that asks for an answer, or something handed out of which is told who has opened it; 0: of neither."""


_DEFAULTS = {field.name: field.default for field in fields(Order)}


def encode(order: Order) -> bytes:
    """Return an order as it is sent."""
    found = {name: value for name, value in asdict(order).items() if value != _DEFAULTS[name]}
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
    if do not in ORDERS:
        raise OrderError("there is no such order")
    return Order(do, **{name: value for read in ORDERS[do] for name, value in read(found).items()})


Read = Callable[[Mapping[str, Any]], dict[str, Any]]
"""Takes fields of an order from what was sent. Raises OrderError."""


def _text(found: Mapping[str, Any], most: int) -> dict[str, Any]:
    text = found.get("text")
    if not isinstance(text, str) or not 0 < len(text) <= most:
        raise OrderError(f"{found['do']} needs a text of at most {most} characters")
    return {"text": text}


def _switch(found: Mapping[str, Any]) -> dict[str, Any]:
    return {"on": found.get("on") is True}


def _time(found: Mapping[str, Any]) -> dict[str, Any]:
    seconds = found.get("seconds")
    if isinstance(seconds, bool) or not isinstance(seconds, (int, float)) or not 0 < seconds <= MOST_SECONDS:
        raise OrderError(f"{found['do']} needs a number of seconds up to {MOST_SECONDS:g}")
    return {"seconds": float(seconds)}


def _number(found: Mapping[str, Any]) -> dict[str, Any]:
    number = found.get("number", 0)
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number <= LARGEST_NUMBER:
        raise OrderError(f"{found['do']} has a number from 0 to {LARGEST_NUMBER}")
    return {"number": number}


def _link(found: Mapping[str, Any]) -> dict[str, Any]:
    read = _text(found, LONGEST_LINK)
    if not is_link(read["text"]):
        raise OrderError("a link begins with http:// or https:// and has a host")
    return read


def _path(found: Mapping[str, Any]) -> dict[str, Any]:
    read = _text(found, LONGEST_PATH)
    path = PurePosixPath(text := read["text"])
    if path.is_absolute() or ".." in path.parts or not path.parts or one_line(text) != text:
        raise OrderError("a file is named by its path below the home")
    return read


def is_link(text: str) -> bool:
    """Whether a browser opens a page by this, and nothing else: no script, no name and password before the host."""
    if not text.isprintable() or any(letter in " \\<>\"'`" for letter in text) or one_line(text) != text:
        return False
    try:
        parts = urlsplit(text)
        return (
            parts.scheme in ("http", "https") and bool(parts.hostname) and "@" not in parts.netloc and parts.port != 0
        )
    except ValueError:
        return False


ORDERS: dict[str, tuple[Read, ...]] = {
    "tell": (),
    "attend": (_switch,),  # a teacher is there
    "seen": (_switch,),  # somebody looks by a link that only watches
    "watch": (_time,),
    "unwatch": (),
    "say": (partial(_text, most=LONGEST_SAYING), _number),
    "settle": (_number,),  # the saying with this number waits for no answer any more
    "link": (_link, _number),
    "file": (_path, _number),  # one that lies in the pupil's home now
    "freeze": (_switch,),
    "lower_hand": (),
    "ask_to_type": (),
    "stop_typing": (),
    "type": (partial(_text, most=256),),  # keys as a terminal sends them
    "ask_to_show": (),
    "show": (_switch,),  # this screen is shown to the class from now on, or no longer
    "scene": (partial(_text, most=LONGEST_NAME),),
    "lesson": (partial(_text, most=LONGEST_NAME),),
    "exam": (partial(_text, most=LONGEST_EXAM),),  # names of drills
    "end": (),
}
"""Every order, and what reads the fields that it has."""
