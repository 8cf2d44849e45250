"""The class as the teacher has heard of it: who is there, where they are, who needs somebody."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Protocol

from day6_core.classroom.asked import Questions
from day6_core.classroom.handouts import HandOuts
from day6_core.classroom.journal import ALL, OF_ORDER, WHILE_TYPING, Journal
from day6_core.classroom.kept import Kept, Unkept
from day6_core.classroom.note import Note
from day6_core.classroom.order import Order

STUCK_SECONDS = 60.0
"""With an error that stands for so long somebody may need help."""
IDLE_SECONDS = 300.0
FROZEN_SECONDS = 600.0
"""The longest that screens stay frozen without a new order: nobody is locked in for ever."""
MOST_PUPILS = 200
TYPED_SECONDS = 30.0
"""For which what the teacher typed may still be at work: a step that is solved meanwhile is not the pupil's alone."""


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
    arrived: float | None = None
    """Since when the pupil is at the step."""

    def idle(self, now: float) -> float:
        """Return the seconds since the pupil did anything."""
        return self.note.idle + max(0.0, now - self.heard) if self.note is not None else 0.0

    def is_stuck(self, now: float) -> bool:
        """Whether an error has stood for a while."""
        return self.is_here and self.troubled is not None and now - self.troubled >= STUCK_SECONDS


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
        journal: Journal | None = None,
        kept: Kept | None = None,
    ) -> None:
        """`kept` is where what is open outlives this program."""
        self.carrier = carrier
        self.journal = journal or Journal()
        """What happened in the lesson, and who did it."""
        self._clock = clock
        self._rows: dict[str, PupilRow] = {}
        self.questions = Questions()
        """What was asked of the pupils, and their answers."""
        self.handed = HandOuts()
        """What was handed to the pupils, and who has opened it."""
        self._kept: Kept = kept or Unkept()
        self._kept.restore(self._restore)
        self.version = 0
        """Another number after every change."""
        self._attended = False
        self._frozen_until = 0.0
        self._frozen_alone: dict[str, float] = {}
        """name -> until when that one is frozen, where it is not as with all others; 0: not at all"""
        self._typed: dict[str, float] = {}
        """name -> when the teacher's last key went there, as long as what came of it may be the teacher's"""
        self._lowered: set[str] = set()
        """Whose hand the teacher has lowered, until the pupil's desktop says that it is down."""

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
            self.journal.note("came", name)
            if (last := row.note) is not None:  # of a desktop that has ended: this one has yet to say what it knows
                row = replace(
                    row, note=Note(lesson=last.lesson, trouble=last.trouble, replies=last.replies, opened=last.opened)
                )
        self._put(replace(row, is_here=True, has_come=True))
        self._tell(name, attended=False, frozen=False)

    def heard(self, name: str, note: Note) -> None:
        """A note came."""
        row, now = self._row(name), self._clock()
        is_same = row.note is not None and row.note.trouble == note.trouble
        troubled = _since(row.troubled if is_same else None, now, note.trouble is not None)
        raised = _since(row.raised, now, note.hand)
        self._write_down(name, row.note or Note(), note)
        stays = row.is_here and row.note is not None and _place(row.note) == _place(note)
        arrived = _since(row.arrived if stays else None, now, note.lesson is not None)
        if self.questions.heard(name, note.replies) | self.handed.heard(name, note.opened):
            self._keep()
        self._put(PupilRow(name, True, True, note, now, troubled, raised, _further(row.furthest, note), arrived))
        self._tell(name, attended=note.attended, frozen=note.frozen)

    def _write_down(self, name: str, before: Note, note: Note) -> None:
        """What the note tells that the one before did not; what the teacher did is there already."""
        if not note.may_type and self._clock() - self._typed.get(name, 0.0) > TYPED_SECONDS:
            self._typed.pop(name, None)
        for what, text in _news(before, note):
            if name in self._typed:
                what = WHILE_TYPING.get(what, what)
            if what != "lowered" or name not in self._lowered:
                self.journal.note(what, name, text)
        if not note.hand:
            self._lowered.discard(name)

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
            self.journal.note("left", name)
            self._typed.pop(name, None)
            self._put(replace(row, is_here=False, raised=None, arrived=None))

    def forget(self, name: str) -> None:
        """The pupil does not belong to the class any more."""
        self._frozen_alone.pop(name, None)
        self._lowered.discard(name)
        if self._rows.pop(name, None) is not None:
            self.version += 1

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

    def names(self) -> list[str]:
        """Return everyone's name, as they stand in the list, and then as they came."""
        return list(self._rows)

    def row(self, name: str) -> PupilRow | None:
        """Return one pupil."""
        return self._rows.get(name)

    # -- what is asked -------------------------------------------------------------------------------------------------

    def order(self, names: Iterable[str], order: Order) -> list[str]:
        """Ask something of these pupils; return those who could not be reached. What reached somebody is in the journal."""
        reached: list[str] = []
        missed: list[str] = []
        for name in names:
            (reached if self.carrier is not None and self.carrier.send(name, order) else missed).append(name)
        if order.do in OF_ORDER and reached:
            self.journal.note(OF_ORDER[order.do], self._named(reached), order.text)
        if order.do == "lower_hand":
            self._lowered.update(reached)
        elif order.do == "type":
            self._note_typing(reached)
        return missed

    def _named(self, names: list[str]) -> str:
        """Those to whom something was done, in one line of the journal."""
        return ALL if len(names) > 1 and set(names) == set(self.everybody()) else ", ".join(names)

    def _note_typing(self, names: list[str]) -> None:
        """Keys of the teacher went there: the first of them is an event, where the pupil lets the teacher type."""
        for name in names:
            row = self._rows.get(name)
            if row is not None and row.note is not None and row.note.may_type:
                if name not in self._typed:
                    self.journal.note("typed", name)
                self._typed[name] = self._clock()

    @property
    def is_attended(self) -> bool:
        """Whether a teacher is there."""
        return self._attended

    def ask(self, names: Iterable[str], text: str) -> list[str]:
        """Say something that these pupils are to answer; return those who could not be reached."""
        names, number = list(names), self.questions.next_number()
        self.questions.add(number, text, names)
        self._keep()  # ahead: whoever has it may answer
        missed = self.order(names, Order("say", text=text, number=number))
        for full in self.questions.sent(number, missed):
            self.order(full.silent, Order("settle", number=full.number))
        self._keep()
        self.version += 1
        return missed

    def hand(self, names: Iterable[str], order: Order, name: str = "") -> list[str]:
        """Hand out a link or a file and tell who has opened it; return those who could not be reached.

        `name` is what it is called if that is not the same for all; a second time with a number it goes to more pupils.
        """
        names = list(names)
        order = order if order.number else replace(order, number=self.questions.next_number())
        self.handed.give(order.number, name or order.text, names)
        self._keep()  # ahead, as a question
        missed = self.order(names, order)
        self.handed.sent(order.number, missed)
        self._keep()
        self.version += 1
        return missed

    def _keep(self) -> None:
        self._kept.write({"questions": self.questions.data(), "handed": self.handed.data()})

    def _restore(self, found: Any) -> None:
        """Go on with what was open when the last program ended."""
        self.questions.restore(found["questions"])
        self.handed.restore(found["handed"], self.questions.is_of_now)

    def settle(self, number: int) -> None:
        """Wait for answers to this question no longer."""
        if (question := self.questions.close(number)) is not None:
            self.order(question.silent, Order("settle", number=number))
            self._keep()
            self.version += 1

    def attend(self, is_there: bool) -> None:
        """Tell all desktops whether a teacher is there. Who goes leaves nobody frozen."""
        if is_there != self._attended:
            self._attended = is_there
            self.journal.note("attended" if is_there else "away")
            if not is_there:
                self._frozen_until = 0.0
                self._frozen_alone.clear()
            self.order(self.everybody(), Order("attend", on=is_there))
            self.version += 1

    @property
    def is_frozen(self) -> bool:
        """Whether the class is frozen, and whoever comes."""
        return self._clock() < self._frozen_until

    def freeze(self, on: bool, names: Collection[str] | None = None) -> list[str]:
        """Stop the keyboards of all or of these, or let them go on; return those who could not be reached."""
        until = self._clock() + FROZEN_SECONDS if on else 0.0
        if names is not None:
            self._frozen_alone.update(dict.fromkeys(names, until))
        else:
            self._frozen_until = until
            self._frozen_alone.clear()
        self.version += 1
        self.journal.note("froze" if on else "unfroze", ALL if names is None else self._named(list(names)))
        return self.order(self.everybody() if names is None else names, Order("freeze", on=on))

    def _may_not_type(self, name: str) -> bool:
        return self._clock() < self._frozen_alone.get(name, self._frozen_until)

    def everybody(self) -> list[str]:
        """Return the names of all who are here."""
        return [row.name for row in self._rows.values() if row.is_here]

    def report(self) -> list[Reached]:
        """Return how far each pupil came in each lesson that was seen."""
        rows = sorted(self._rows.values(), key=lambda row: row.name)
        return [Reached(row.name, *place) for row in rows for place in row.furthest or ((),)]


_REFUSED = {"class.refused.no": "declined", "class.refused.taken_back": "took_back"}
"""What a pupil did by refusing, by the key of the refusal."""


def _news(before: Note, note: Note) -> Iterator[tuple[str, str]]:
    """Yield what a note tells that the one before did not: the kind of event, and its text."""
    if (lesson := note.lesson) is not None:
        old = before.lesson
        if old is None or old.name != lesson.name:
            yield "lesson", f"{lesson.name} {lesson.step}/{lesson.all}"
        elif lesson.step > old.step:
            yield "step", f"{lesson.name} {lesson.step}/{lesson.all}"
        elif lesson.step == old.step and lesson.solved and not old.solved:
            yield "solved", f"{lesson.name} {lesson.step}/{lesson.all}"
    if note.trouble is not None and (before.trouble is None or before.trouble.line != note.trouble.line):
        yield "error", note.trouble.line
    elif note.trouble is None and before.trouble is not None:
        yield "mended", before.trouble.line
    if note.hand != before.hand:
        yield ("hand" if note.hand else "lowered"), ""
    for reply in note.replies:
        if reply not in before.replies:
            yield "answered", reply.text or reply.kind
    if note.may_type and not before.may_type:
        yield "allowed", ""
    if note.may_show and not before.may_show:
        yield "allowed_show", ""
    if note.refused != before.refused and note.refused in _REFUSED:
        yield "declined_show" if before.asked_show else _REFUSED[note.refused], ""


def _place(note: Note) -> tuple[str, int] | None:
    """The lesson and the step."""
    return None if note.lesson is None else (note.lesson.name, note.lesson.step)


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
