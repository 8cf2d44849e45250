"""Who has the class word and waits until the teacher lets them in.

Of an address, a few newcomers come in at once; after them the teacher is asked. So one who makes up names cannot fill a class,
and a school whose browsers all have one address waits for one click. Who says to be a pupil that there is already always waits,
and for a click of their own: it may be that pupil at another machine, or somebody else.
"""

from __future__ import annotations

import itertools
import secrets
import time
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from day6_core.classroom.kept import LESSON_SECONDS, Kept, Unkept
from day6_tui.web.addresses import source

MOST_OF_ONE = 60
"""Who wait from one address."""
MOST_OF_ALL = 200
MOST_KNOWN = 1000
"""Also those whose page has not asked lately."""
CLAIMS = ("listed", "known")
"""Why somebody waits who says to be a pupil that there is already: of the list, or one who came with the word."""
AWAY_SECONDS = 20.0
"""Without a question of its page, somebody is not shown to the teacher."""
GONE_SECONDS = 600.0
"""And is forgotten."""


class LobbyFull(Exception):
    """So many wait already that this one cannot."""


@dataclass
class Newcomer:
    """Somebody who waits."""

    number: int
    """What the teacher's page calls them by."""
    name: str
    address: str
    why: str
    """Why the teacher is asked: about all; many have come from there, or somebody was removed; there are files of this name,
    or there is a pupil of it (CLAIMS)."""
    seen: float
    """When its page asked last."""
    token: str = ""
    """What lets them in, once the teacher has."""
    refusal: str = ""
    """Why they were turned away: the key of a text."""

    @property
    def is_pending(self) -> bool:
        """Whether the teacher has yet to decide."""
        return not (self.token or self.refusal)

    @property
    def is_claim(self) -> bool:
        """Whether this may be a pupil at another machine, and whoever is let in has that pupil's desktop."""
        return self.why in CLAIMS


class Lobby:
    """Decides who has to wait, and knows who does. Everything in the event loop, nothing is awaited."""

    def __init__(self, unasked: int, kept: Kept | None = None, wall: Callable[[], float] = time.time) -> None:
        """`kept` is where it outlives the server which addresses are trusted or not."""
        self._unasked = unasked
        self._kept: Kept = kept or Unkept()
        self._wall = wall
        self._numbers = itertools.count(1)
        self._by_key: dict[str, Newcomer] = {}
        self._came: Counter[str] = Counter()
        """Newcomers who came in unasked, by where from."""
        self._judged: dict[str, tuple[bool, float]] = {}
        """place -> whether it is trusted, and when the teacher said so (seconds since 1970)"""
        self._kept.restore(self._restore)
        self.asks = unasked == 0
        """Whether the teacher is asked about everybody."""

    # -- newcomers -----------------------------------------------------------------------------------------------------

    def why_wait(self, address: str, *, has_files: bool) -> str:
        """Why this newcomer has to wait (see `Newcomer.why`); "" if not."""
        place = source(address)
        reasons = {
            "all": self.asks,
            "files": has_files,
            "removed": self._trusts(place) is False,
            "many": self._trusts(place) is None and self._came[place] >= self._unasked,
        }
        return next((why for why, holds in reasons.items() if holds), "")

    def came_in(self, address: str) -> None:
        """A newcomer came in from there."""
        self._came[source(address)] += 1

    def wait(self, name: str, address: str, why: str, *, before: str = "") -> str:
        """Let somebody wait, in place of whom the same browser was `before`; return what its page shows. Raises LobbyFull."""
        self._by_key.pop(before, None)
        now, waiting = time.monotonic(), self.waiting()
        own = sum(source(each.address) == source(address) for each in waiting)
        if own >= MOST_OF_ONE or len(waiting) >= MOST_OF_ALL:
            raise LobbyFull
        self._forget(now)
        key = secrets.token_urlsafe(16)
        self._by_key[key] = Newcomer(next(self._numbers), name, address, why, now)
        return key

    def _forget(self, now: float) -> None:
        late = sorted(self._by_key, key=lambda key: self._by_key[key].seen)
        spare = len(late) + 1 - MOST_KNOWN
        for place, key in enumerate(late):
            if place < spare or now - self._by_key[key].seen > GONE_SECONDS:
                del self._by_key[key]

    def ask(self, key: str) -> Newcomer | None:
        """The page of a newcomer asks; None if it is not known (any more)."""
        found = self._by_key.get(key)
        if found is not None:
            found.seen = time.monotonic()
        return found

    def leave(self, key: str) -> None:
        """This newcomer has been told what the teacher decided, or has gone."""
        self._by_key.pop(key, None)

    # -- the teacher ---------------------------------------------------------------------------------------------------

    def waiting(self) -> list[Newcomer]:
        """Who waits for the teacher's word, the longest first."""
        since = time.monotonic() - AWAY_SECONDS
        return [each for each in self._by_key.values() if each.is_pending and each.seen >= since]

    def chosen(self, numbers: Iterable[int]) -> list[Newcomer]:
        """Those who wait and have these numbers."""
        wanted = set(numbers)
        return [each for each in self._by_key.values() if each.is_pending and each.number in wanted]

    def trust(self, address: str) -> None:
        """Whoever comes from there with the word may come in, as long as the teacher is not asked about everybody."""
        self._judge(source(address), True)

    def distrust(self, address: str) -> None:
        """Somebody from there was removed or turned away: the teacher is asked about the next one."""
        self._judge(source(address), False)

    def _trusts(self, place: str) -> bool | None:
        return self._judged.get(place, (None,))[0]

    def _judge(self, place: str, is_trusted: bool) -> None:
        self._judged[place] = is_trusted, self._wall()
        self._kept.write(self._judged)

    def _restore(self, found: Any) -> None:
        judged = {str(place): (trusted is True, float(when)) for place, (trusted, when) in found.items()}
        now = self._wall()
        self._judged = {place: each for place, each in judged.items() if abs(now - each[1]) < LESSON_SECONDS}
