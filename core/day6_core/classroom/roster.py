"""The class as the teacher has heard of it: who is there, where they are, who needs somebody."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

from day6_core.classroom.note import Note
from day6_core.classroom.order import Order

STUCK_SECONDS = 60.0
"""With an error that stands for so long somebody may need help."""
IDLE_SECONDS = 300.0
FROZEN_SECONDS = 600.0
"""The longest that screens stay frozen without a new order: nobody is locked in for ever."""
MOST_PUPILS = 200
MOST_EVENTS = 20_000


class Carrier(Protocol):
    """Takes orders to the desktops."""

    def send(self, name: str, order: Order) -> bool:
        """Send an order; False if that pupil cannot be reached."""


@dataclass(frozen=True)
class PupilRow:
    """One pupil. Times are those of the roster's clock."""

    name: str
    is_here: bool = True
    """Whether the desktop runs and is reached."""
    has_come: bool = True
    """Whether it ever did; False for who is only expected."""
    note: Note | None = None
    heard: float = 0.0
    """When the note came."""
    troubled: float | None = None
    """Since when the same error stands."""
    raised: float | None = None
    """Since when the hand is up."""
    furthest: tuple[tuple[str, int, int], ...] = ()
    """For each lesson that was seen: its name, the furthest step that was solved or reached, and how many there are."""

    def idle(self, now: float) -> float:
        """Return the seconds since the pupil did anything."""
        return self.note.idle + max(0.0, now - self.heard) if self.note is not None else 0.0

    def is_stuck(self, now: float) -> bool:
        """Whether an error has stood for a while."""
        return self.is_here and self.troubled is not None and now - self.troubled >= STUCK_SECONDS


class ClassEvent(NamedTuple):
    """Something that happened; `time` in seconds since 1970."""

    time: float
    name: str
    what: str
    """came, left, lesson, step, error, mended, hand, lowered."""
    text: str = ""


class Reached(NamedTuple):
    """How far a pupil came in a lesson; "" and 0 without one."""

    name: str
    lesson: str = ""
    step: int = 0
    """The furthest that was solved or reached."""
    steps: int = 0


class Roster:
    """Holds the class. Not for several threads."""

    def __init__(
        self,
        carrier: Carrier | None = None,
        clock: Callable[[], float] = time.monotonic,
        wall: Callable[[], float] = time.time,
    ) -> None:
        self.carrier = carrier
        self._clock = clock
        self._wall = wall
        self._rows: dict[str, PupilRow] = {}
        self.events: deque[ClassEvent] = deque(maxlen=MOST_EVENTS)
        """What happened in the lesson, the oldest first."""
        self.version = 0
        """Another number after every change."""
        self._attended = False
        self._frozen_until = 0.0
        self._frozen_alone: dict[str, float] = {}
        """name -> until when that one is frozen, where it is not as with all others; 0: not at all"""

    # -- what is heard -------------------------------------------------------------------------------------------------

    def expect(self, names: Iterable[str]) -> None:
        """These pupils belong to the class, whether they come or not."""
        for name in names:
            if name not in self._rows:
                self._put(PupilRow(name, is_here=False, has_come=False))

    def here(self, name: str) -> None:
        """A pupil's desktop is reached. It is told whether a teacher is there, and whether the class is frozen."""
        row = self._row(name)
        if not (name in self._rows and row.is_here):
            self._note(name, "came")
        self._put(replace(row, is_here=True, has_come=True))
        self._tell(name, attended=False, frozen=False)

    def heard(self, name: str, note: Note) -> None:
        """A note came."""
        row, now = self._row(name), self._clock()
        is_same = row.note is not None and row.note.trouble == note.trouble
        troubled = _since(row.troubled if is_same else None, now, note.trouble is not None)
        raised = _since(row.raised, now, note.hand)
        for what, text in _news(row.note or Note(), note):
            self._note(name, what, text)
        self._put(PupilRow(name, True, True, note, now, troubled, raised, _further(row.furthest, note)))
        self._tell(name, attended=note.attended, frozen=note.frozen)

    def _tell(self, name: str, *, attended: bool, frozen: bool) -> None:
        """Tell a desktop what it does not know: an order may have been lost, or come before the desktop was ready for it."""
        if attended != self._attended:
            self.order([name], Order("attend", on=self._attended))
        if frozen != (wanted := self._may_not_type(name)):
            self.order([name], Order("freeze", on=wanted))

    def gone(self, name: str) -> None:
        """A pupil's desktop has ended, or is out of reach."""
        row = self._rows.get(name)
        if row is not None and row.is_here:
            self._note(name, "left")
            self._put(replace(row, is_here=False, raised=None))

    def forget(self, name: str) -> None:
        """The pupil does not belong to the class any more."""
        self._frozen_alone.pop(name, None)
        if self._rows.pop(name, None) is not None:
            self.version += 1

    def _note(self, name: str, what: str, text: str = "") -> None:
        self.events.append(ClassEvent(self._wall(), name, what, text))

    def _row(self, name: str) -> PupilRow:
        return self._rows.get(name) or PupilRow(name)

    def _put(self, row: PupilRow) -> None:
        if row.name not in self._rows and len(self._rows) >= MOST_PUPILS:
            return
        self._rows[row.name] = row
        self.version += 1

    # -- what is seen --------------------------------------------------------------------------------------------------

    @property
    def now(self) -> float:
        """The time on the roster's clock."""
        return self._clock()

    def rows(self) -> list[PupilRow]:
        """Return the class: raised hands first, the longest first, then who is stuck, then by name; who is gone comes last."""
        now = self._clock()

        def place(row: PupilRow) -> tuple[object, ...]:
            if not row.is_here:
                return (3 if row.has_come else 4, 0.0, row.name)
            if row.raised is not None:
                return (0, row.raised, row.name)
            return (1, row.troubled, row.name) if row.is_stuck(now) else (2, 0.0, row.name)

        return sorted(self._rows.values(), key=place)

    def row(self, name: str) -> PupilRow | None:
        """Return one pupil."""
        return self._rows.get(name)

    # -- what is asked -------------------------------------------------------------------------------------------------

    def order(self, names: Iterable[str], order: Order) -> list[str]:
        """Ask something of these pupils; return those who could not be reached."""
        return [name for name in names if self.carrier is None or not self.carrier.send(name, order)]

    def attend(self, is_there: bool) -> None:
        """Tell all desktops whether a teacher is there. Who goes leaves nobody frozen."""
        if is_there != self._attended:
            self._attended = is_there
            if not is_there:
                self._frozen_until = 0.0
                self._frozen_alone.clear()
            self.order(self.everybody(), Order("attend", on=is_there))
            self.version += 1

    @property
    def is_frozen(self) -> bool:
        """Whether the class is frozen, and whoever comes."""
        return self._clock() < self._frozen_until

    def freeze(self, on: bool, name: str | None = None) -> list[str]:
        """Stop the keyboards of all or of one, or let them go on; return those who could not be reached."""
        until = self._clock() + FROZEN_SECONDS if on else 0.0
        if name is not None:
            self._frozen_alone[name] = until
        else:
            self._frozen_until = until
            self._frozen_alone.clear()
        self.version += 1
        return self.order(self.everybody() if name is None else [name], Order("freeze", on=on))

    def _may_not_type(self, name: str) -> bool:
        return self._clock() < self._frozen_alone.get(name, self._frozen_until)

    def everybody(self) -> list[str]:
        """Return the names of all who are here."""
        return [row.name for row in self._rows.values() if row.is_here]

    def report(self) -> list[Reached]:
        """Return how far each pupil came in each lesson that was seen."""
        rows = sorted(self._rows.values(), key=lambda row: row.name)
        return [Reached(row.name, *place) for row in rows for place in row.furthest or ((),)]


def _news(before: Note, note: Note) -> Iterator[tuple[str, str]]:
    """Yield what a note tells that the one before did not: the kind of event, and its text."""
    if (lesson := note.lesson) is not None:
        old = before.lesson
        if old is None or old.name != lesson.name:
            yield "lesson", f"{lesson.name} {lesson.step}/{lesson.all}"
        elif lesson.step > old.step:
            yield "step", f"{lesson.name} {lesson.step}/{lesson.all}"
    if note.trouble is not None and (before.trouble is None or before.trouble.line != note.trouble.line):
        yield "error", note.trouble.line
    elif note.trouble is None and before.trouble is not None:
        yield "mended", before.trouble.line
    if note.hand != before.hand:
        yield ("hand" if note.hand else "lowered"), ""


def _since(before: float | None, now: float, holds: bool) -> float | None:
    """Return since when something holds, if it does: since `before`, if that is known."""
    if not holds:
        return None
    return now if before is None else before


def _further(before: tuple[tuple[str, int, int], ...], note: Note) -> tuple[tuple[str, int, int], ...]:
    lesson = note.lesson
    if lesson is None:
        return before
    known = {name: (step, steps) for name, step, steps in before}
    step = max(lesson.step, known.get(lesson.name, (0, 0))[0])
    if lesson.name in known or len(known) < 100:
        known[lesson.name] = (min(step, lesson.all), lesson.all)
    return tuple((name, *place) for name, place in known.items())
