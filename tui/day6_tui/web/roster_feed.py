"""Fills the teacher's roster: a line to the keeper of each desktop, on which its notes come and orders go."""

from __future__ import annotations

import socket
from collections import deque
from collections.abc import Callable
from functools import partial
from pathlib import Path

from day6_core.classroom import note
from day6_core.classroom import order as orders
from day6_core.classroom.journal import Journal
from day6_core.classroom.kept import KeptFile
from day6_core.classroom.note import Note, NoteError
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster
from day6_core.reason import reason
from day6_tui.detached import wire
from day6_tui.detached.loop_line import LoopLine
from day6_tui.web.names import TEACHERS
from day6_tui.web.told import News

MOST_ORDERS = 1 << 16
"""Bytes of orders that may wait for a desktop."""


MOST_NEWS = 20


class RosterFeed:
    """The carrier of the roster. Everything is done in the event loop."""

    def __init__(self, log: Path | None, tell: Callable[..., None]) -> None:
        self._tell = tell
        """Prints a text for whoever has started the server, who is there before any page is."""
        self._lines: dict[str, LoopLine] = {}
        self._seen: set[str] = set()
        """Whose desktops somebody looks at by a link that only watches."""
        self.news: deque[News] = deque(maxlen=MOST_NEWS)
        """What the teacher should know besides, the latest last."""
        self.told = 0
        """How many news there were, also those that are forgotten."""
        self._changed: list[Callable[[], None]] = []
        self.noted: Callable[[str, Note | None], None] = lambda name, note: None
        """Called with each note of a desktop, also the teacher's, and with None when the desktop has ended."""
        kept = None if log is None else self.kept(log.with_name("asked.json"))
        self.roster = Roster(self, journal=Journal(log, self._not_logged), kept=kept)
        """Its journal is kept in the folder `log`, what is open beside that."""

    def subscribe(self, changed: Callable[[], None]) -> Callable[[], None]:
        """Have this called after every change; returns what ends that."""
        self._changed.append(changed)
        return lambda: self._changed.remove(changed)

    def begin(self, name: str, connection: socket.socket) -> None:
        """A desktop runs, and this is a new line to its keeper."""
        self._drop(name)
        line = self._lines[name] = LoopLine(connection)
        line.send(wire.WATCH)
        line.on_readable(partial(self._hear, name, line))
        if name != TEACHERS:
            self.roster.here(name)
        self.tell()

    def seen(self, name: str, is_seen: bool) -> None:
        """Somebody looks at this desktop by a link that only watches, or nobody does any more: the pupil is told."""
        if is_seen != (name in self._seen):
            (self._seen.add if is_seen else self._seen.discard)(name)
            self.send(name, Order("seen", on=is_seen))

    def end(self, name: str) -> None:
        """The desktop has ended."""
        self._drop(name)
        self._gone(name)
        self.tell()

    def _gone(self, name: str) -> None:
        self.roster.gone(name)
        self.noted(name, None)

    def send(self, name: str, order: Order) -> bool:
        """Send an order; False if that pupil cannot be reached."""
        line = self._lines.get(name)
        if line is None or line.closed or line.unsent > MOST_ORDERS:
            return False
        line.send(wire.ORDER, orders.encode(order))
        return True

    def close(self) -> None:
        """Let all desktops go on without being observed."""
        for name in list(self._lines):
            self._drop(name)

    def _drop(self, name: str) -> None:
        line = self._lines.pop(name, None)
        if line is not None:
            line.close()

    def _hear(self, name: str, line: LoopLine) -> None:
        for kind, data in line.receive():
            if kind == wire.NOTE:
                try:
                    heard = note.decode(data)
                except NoteError:
                    continue  # a desktop that was tampered with: its pupil stays where the last note said
                if name != TEACHERS:
                    self.roster.heard(name, heard)
                self.noted(name, heard)
                if heard.seen != (name in self._seen):  # it was not ready when it was told
                    self.send(name, Order("seen", on=name in self._seen))
        if line.closed and self._lines.get(name) is line:
            self._drop(name)
            self._gone(name)
        self.tell()

    def say(self, key: str, **values: object) -> None:
        """Tell the teacher something, wherever the page is."""
        self.told += 1
        self.news.append(News(self.told, key, values))
        self.tell()

    def _not_logged(self, error: OSError) -> None:
        self._warn("serve.no_log", file=str(error.filename), reason=reason(error))

    def kept(self, file: Path) -> KeptFile:
        """A file in which something outlives the server; the teacher is told where that cannot be."""
        return KeptFile(file, self._not_kept, lambda file: self._warn("serve.kept.unread", file=str(file)))

    def _not_kept(self, error: OSError) -> None:
        self._warn("serve.kept.unkept", file=str(error.filename), reason=reason(error))

    def _warn(self, key: str, **values: object) -> None:
        self._tell(key, **values)
        self.say(key, **values)

    def tell(self) -> None:
        """Something has changed."""
        for changed in self._changed:
            changed()
