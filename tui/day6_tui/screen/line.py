"""The way to the terminal: how much of what was written is still under way, and how much more may follow.

Over ssh, what a program writes waits in buffers that say nothing of it: a key's echo would come after all that was written
before it. So the terminal is asked now and then whether it is ready, which every terminal answers once it has read everything
before the question. Where answers take longer than the quickest one, something waits, and less is sent ahead. A terminal that
answers nothing is written to as if it were fast.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass

LOST_SECONDS, STOPPED_SECONDS = 4.0, 15.0
"""After this there will be no answer, from a terminal that has never given one, and from one that has."""
WAIT_SECONDS = 0.1
"""How long what is written may wait for what was written before it."""
NOTICED_SECONDS = 0.3
"""A fast terminal that answers later than this is no longer one: anything can take so long once."""
LEAST_AHEAD = 700
"""Bytes that may be under way on the slowest line: of fewer, most were cursor movements."""
FIRST_AHEAD = 8192
"""Bytes that may be under way as long as nothing is known."""
FREE = 65_536
"""Where so many bytes may be under way, nothing is held back."""
LEAST_ASKED, MOST_ASKED = 256, 4096
"""Bytes between two questions."""
BURST_SECONDS, BURST = 0.01, 1024
"""So many bytes, written at once to a terminal that had read everything, tell how fast the line is."""


def may_ask(environ: Mapping[str, str]) -> bool:
    """Whether the terminal is one that understands questions."""
    return environ.get("TERM", "") not in ("", "dumb")


@dataclass(slots=True)
class _Question:
    end: int
    """Bytes written up to here, in all."""
    unread: int
    """How many of them had not been read, as far as was known."""
    asked: float
    is_burst: bool
    """Whether all of these had only just been written."""
    is_ours: bool


class Line:
    """Counts what is written and what has been read. Any thread may call anything."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._lock = threading.Lock()
        self.begin(may_ask=False)

    def begin(self, *, may_ask: bool) -> None:
        """Another line: nothing is under way, and nothing known."""
        with self._lock:
            self.may_ask = may_ask
            """Whether the terminal may be asked."""
            self.answers = False
            """Whether the terminal is known to answer."""
            self._written = self._read = 0
            self._questions: deque[_Question] = deque()
            self._begun = 0.0
            """When the first byte that has not been read was written."""
            self._quickest: float | None = None
            """Seconds of the quickest answer: the line's own delay."""
            self._ahead = float(FIRST_AHEAD)
            """Bytes that may be under way."""
            self._was_full = False
            """Whether so many were, since that was changed."""

    # -- writing -------------------------------------------------------------------------------------------------------

    def wrote(self, count: int, *, asks: bool = False) -> bool:
        """So many bytes are written, with a question of somebody else's at their end if it `asks`; whether to ask now."""
        with self._lock:
            if self._written == self._read:
                self._begun = self._clock()
            self._written += count
            if asks:
                self._ask(is_ours=False)
                return False
            last = self._questions[-1].end if self._questions else self._read
            spacing = max(LEAST_ASKED, min(self._ahead / 2, MOST_ASKED))
            return self.may_ask and self._written - last >= spacing

    def asked(self) -> None:
        """The question has been written."""
        with self._lock:
            self._ask(is_ours=True)

    def _ask(self, *, is_ours: bool) -> None:
        now = self._clock()
        unread = self._written - self._read
        self._questions.append(_Question(self._written, unread, now, now - self._begun < BURST_SECONDS, is_ours))

    # -- reading -------------------------------------------------------------------------------------------------------

    def answered(self) -> bool:
        """The terminal has read everything up to the oldest question; returns whether nobody else waits for this answer."""
        with self._lock:
            self.answers = True
            if not self._questions:
                return True  # it was given up, by whoever asked
            question, now = self._questions.popleft(), self._clock()
            self._read, self._begun = question.end, now
            seconds = now - question.asked
            if self._quickest is None:
                self._quickest = seconds
            else:
                self._quickest = min(self._quickest, seconds)
                self._measure(question, seconds - self._quickest)
            return question.is_ours

    def _measure(self, question: _Question, waited: float) -> None:
        before = self._ahead
        if waited > (NOTICED_SECONDS if before >= FREE else WAIT_SECONDS):
            self._ahead = self._as_slow(question, waited)
        elif question.is_burst and question.unread >= BURST:
            self._ahead = max(before, min(FREE, question.unread * WAIT_SECONDS / max(waited, 0.001)))
        elif self._was_full and waited < WAIT_SECONDS / 2:
            self._ahead = min(FREE, before * 2)
        if self._ahead != before:
            self._was_full = False

    def _as_slow(self, question: _Question, waited: float) -> float:
        return max(LEAST_AHEAD, min(self._ahead, question.unread) * WAIT_SECONDS / waited)

    # -- how much may follow -------------------------------------------------------------------------------------------

    @property
    def waits(self) -> bool:
        """Whether an answer is to come."""
        with self._lock:
            self._give_up()
            return bool(self._questions)

    def room(self, share: float = 1.0) -> int | None:
        """Bytes that may be written now, None where nothing is held back; `share` of what may be under way in all."""
        with self._lock:
            self._give_up()
            if not self.answers:
                return None
            ahead = self._ahead
            if self._questions and self._quickest is not None:
                oldest = self._questions[0]
                late = self._clock() - oldest.asked - self._quickest
                if late > NOTICED_SECONDS:
                    ahead = self._as_slow(oldest, late)
            room = int(ahead * share) - (self._written - self._read)
            self._was_full = self._was_full or room <= 0
            return None if ahead >= FREE else room

    def _give_up(self) -> None:
        patience = STOPPED_SECONDS if self.answers else LOST_SECONDS
        if self._questions and self._clock() - self._questions[0].asked > patience:
            self._questions.clear()
            self._read = self._written
            self.answers = False
