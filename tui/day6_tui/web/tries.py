"""How often somebody may be wrong: for each address, and for all together."""

from __future__ import annotations

import time
from collections import OrderedDict, deque

WINDOW = 60.0
"""Seconds."""
MOST_OF_ONE = 20
"""Wrong tries of an address in that time. A whole class may share one."""
MOST_OF_ALL = 120
MOST_ADDRESSES = 4096


class Tries:
    """Wrong tries of the last minute."""

    def __init__(self) -> None:
        self._of: OrderedDict[str, deque[float]] = OrderedDict()
        self._all: deque[float] = deque(maxlen=MOST_OF_ALL)

    def are_too_many(self, address: str) -> bool:
        """Whether this address has to wait."""
        since = time.monotonic() - WINDOW
        own = self._of.get(address, ())
        return _count(own, since) >= MOST_OF_ONE or _count(self._all, since) >= MOST_OF_ALL

    def add(self, address: str) -> None:
        """One more that was wrong."""
        now = time.monotonic()
        self._of.setdefault(address, deque(maxlen=MOST_OF_ONE)).append(now)
        self._of.move_to_end(address)
        self._all.append(now)
        while len(self._of) > MOST_ADDRESSES:
            self._of.popitem(last=False)


def _count(times: deque[float] | tuple[()], since: float) -> int:
    return sum(each > since for each in times)
