"""How much numbers that only grow have grown lately: they are noted when somebody asks, and at no other time."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple

WINDOW_S = 2.0
LONGEST_S = 10.0
PAUSE_S = 2.0
"""After so long without a question everything begins anew: the program, or who asks, was stopped."""


class Half(NamedTuple):
    """One half of the time looked at."""

    seconds: float
    grown: tuple[int, ...]


class Lately:
    """Keeps what was counted at the last questions."""

    def __init__(self) -> None:
        self._counts: dict[object, deque[tuple[float, tuple[int, ...]]]] = {}
        self._asked: set[object] = set()
        self._last = 0.0

    def begin(self, now: float) -> None:
        """Begin a question at `now` (monotonic seconds)."""
        if now - self._last > PAUSE_S:
            self._counts.clear()
        for key in self._counts.keys() - self._asked:
            del self._counts[key]
        self._asked.clear()
        self._last = now

    def halves(self, key: object, *counts: int, window: float = WINDOW_S) -> tuple[Half, Half] | None:
        """Note the counts; return how they grew in both halves of the last `window` seconds, None where less is known."""
        now = self._last
        window = min(window, LONGEST_S)
        self._asked.add(key)
        noted = self._counts.setdefault(key, deque())
        noted.append((now, counts))
        while len(noted) > 2 and now - noted[1][0] >= window:
            noted.popleft()
        began, first = noted[0]
        if now - began < window:
            return None
        middle, between = next(each for each in noted if now - each[0] <= window / 2)
        if middle == now:
            return None
        return (
            Half(middle - began, tuple(after - before for before, after in zip(first, between, strict=True))),
            Half(now - middle, tuple(after - before for before, after in zip(between, counts, strict=True))),
        )
