"""Whether the teacher's keys go to a pupil: asked, agreed, taken back.

A key is never a command of the class in one moment and a pupil's in the next without the teacher's doing: when typing is cut
short, it stays `over` until the teacher has acknowledged it.
"""

from __future__ import annotations

from day6_core.classroom.order import Order
from day6_core.classroom.roster import PupilRow, Roster

SETTLE_SECONDS = 3.0
"""After the end of typing, in which a note that still allows it may be an old one."""


class Typing:
    """Holds for whom the teacher types or waits, and sends the keys."""

    def __init__(self, roster: Roster) -> None:
        self._roster = roster
        self.name = ""
        """Who gets the keys, or got them until it was over; '' for nobody."""
        self.over = ""
        """Why typing was cut short: taken_back, gone; '' while it was not."""
        self.awaited = ""
        """Who was asked and has not answered."""
        self._asked_at = 0.0
        self._ended = "", 0.0
        """For whom typing was ended last, and when."""

    @property
    def is_on(self) -> bool:
        """Whether keys go to a pupil."""
        return bool(self.name) and not self.over

    def may_begin(self, name: str) -> bool:
        """Whether this pupil lets the teacher type."""
        ended, when = self._ended
        return _allows(self._roster.row(name)) and (name != ended or self._roster.now - when >= SETTLE_SECONDS)

    def ask(self, name: str) -> list[str]:
        """Ask a pupil; return who could not be reached."""
        missed = self._roster.order([name], Order("ask_to_type"))
        if not missed:
            self.awaited, self._asked_at = name, self._roster.now
        return missed

    def begin(self, name: str) -> None:
        """Send the keys to this pupil from now on."""
        self.name, self.over, self.awaited = name, "", ""

    def send(self, keys: str) -> list[str]:
        """Send keys; return who could not be reached."""
        return self._roster.order([self.name], Order("type", text=keys))

    def end(self) -> None:
        """Type no longer, and wait for nobody; also acknowledges what was cut short."""
        if self.is_on:
            self._roster.order([self.name], Order("stop_typing"))
            self._ended = self.name, self._roster.now
        self.name = self.over = self.awaited = ""

    def wait_no_longer(self) -> None:
        """The teacher does something else: a yes that comes now begins nothing."""
        self.awaited = ""

    def follow(self) -> None:
        """Compare with what the pupils have said."""
        if not _allows(self._roster.row(self._ended[0])):
            self._ended = "", 0.0
        if self.is_on and not _allows(row := self._roster.row(self.name)):
            self.over = "taken_back" if row is not None and row.is_here else "gone"
        if self.awaited and self._has_said_no(self._roster.row(self.awaited)):
            self.awaited = ""

    def _has_said_no(self, row: PupilRow | None) -> bool:
        if row is None or not row.is_here:
            return True
        return row.note is not None and bool(row.note.refused) and row.heard > self._asked_at


def _allows(row: PupilRow | None) -> bool:
    return row is not None and row.is_here and row.note is not None and row.note.may_type
