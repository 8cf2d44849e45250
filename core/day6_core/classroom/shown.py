"""A screen that is shown to a class on a network, as it goes to all pupils at once: always whole, and for whom it is.

Who comes late, or has lost one, sees the next. A pupil for whom it is not passes it over: that is a courtesy, no secret.
"""

from __future__ import annotations

import json
import zlib
from dataclasses import asdict
from typing import Any, NamedTuple

from day6_core.classroom.note import LONGEST, PupilScreen, screen_of
from day6_core.classroom.order import LARGEST_NUMBER
from day6_core.classroom.roster import MOST_PUPILS
from day6_core.classroom.show import Show
from day6_core.session.harmless import one_line

LONGEST_NAME = 64
EVERY_SECONDS = 0.2
"""Between two pictures at least."""
AGAIN_SECONDS = 2.0
"""After which the same one is sent again."""
SILENT_SECONDS = 6.0
"""Without a picture, after which it is no longer live."""


class ShownError(ValueError):
    """It isn't a picture; the message says why."""


class Shown(NamedTuple):
    """What is shown and how it looks; `number` is another one each time that the teacher begins, or makes it large or small."""

    number: int
    show: Show
    screen: PupilScreen


def encode(shown: Shown | None) -> bytes:
    """Return it as it is sent; None: nothing is shown any more. Raises ShownError for a picture that nobody would take."""
    found: dict[str, Any] = {}
    if shown is not None:
        names = shown.show.names
        found = {
            "number": shown.number,
            "source": shown.show.source,
            "names": None if names is None else sorted(names),
            "full": shown.show.full,
            "screen": asdict(shown.screen),
        }
    data = json.dumps(found, ensure_ascii=False).encode(errors="replace")
    if len(data) > LONGEST:
        raise ShownError(f"{len(data)} bytes")
    return zlib.compress(data, 1)


def decode(data: bytes) -> Shown | None:
    """Read it from outside: bounded, and harmless on a terminal. Raises ShownError."""
    try:
        unpacking = zlib.decompressobj()
        text = unpacking.decompress(data[:LONGEST], LONGEST)
        if not unpacking.eof:
            raise ShownError(f"it has no end within {LONGEST} bytes")
        found = json.loads(text)
        return _shown(found) if found else None
    except (zlib.error, RecursionError, TypeError, ValueError, KeyError, AttributeError, OverflowError) as error:
        raise ShownError(str(error)) from None


def _shown(found: dict[str, Any]) -> Shown:
    number, names, screen = found["number"], found["names"], screen_of(found["screen"])
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number <= LARGEST_NUMBER or screen is None:
        raise ValueError("a picture has a number and a screen")
    keys = None if names is None else frozenset(one_line(str(name)[:LONGEST_NAME]) for name in names[:MOST_PUPILS])
    return Shown(number, Show(one_line(str(found["source"])[:LONGEST_NAME]), keys, found["full"] is True), screen)


class Pace:
    """When a picture goes out: at once if the last one has been for a while, and again now and then. Times are a clock's."""

    def __init__(self) -> None:
        self._sent: tuple[PupilScreen, float] | None = None

    def is_due(self, screen: PupilScreen, now: float) -> bool:
        """Whether this one is to be sent now; then it counts as sent."""
        if self._sent is not None:
            last, when = self._sent
            if now - when < (EVERY_SECONDS if screen != last else AGAIN_SECONDS):
                return False
        self._sent = screen, now
        return True
