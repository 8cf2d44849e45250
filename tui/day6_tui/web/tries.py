"""How often somebody may be wrong: for each address, and for all together."""

from __future__ import annotations

import time
from collections import OrderedDict, deque
from collections.abc import Callable

from day6_tui.web.addresses import source

WINDOW = 60.0
"""Seconds."""
MOST_OF_ONE = 20
"""Wrong tries of an address in that time. A whole class may share one."""
MOST_OF_ALL = 120
MOST_ADDRESSES = 4096


class Tries:
    """Wrong tries of the last minute. Nobody can come in between when one is judged and counted: that is one call."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._of: OrderedDict[str, deque[float]] = OrderedDict()
        self._all: deque[float] = deque(maxlen=MOST_OF_ALL)

    def refusal(self, address: str, *, is_right: bool) -> str:
        """Why a try is refused: `often` (whatever it was), `wrong`; "" if it is not. A wrong one counts."""
        place, now = source(address), self._clock()
        since = now - WINDOW
        if _count(self._of.get(place, ()), since) >= MOST_OF_ONE or _count(self._all, since) >= MOST_OF_ALL:
            return "often"
        if is_right:
            return ""
        self._of.setdefault(place, deque(maxlen=MOST_OF_ONE)).append(now)
        self._of.move_to_end(place)
        self._all.append(now)
        while len(self._of) > MOST_ADDRESSES:
            self._of.popitem(last=False)
        return "wrong"


def _count(times: deque[float] | tuple[()], since: float) -> int:
    return sum(each > since for each in times)
