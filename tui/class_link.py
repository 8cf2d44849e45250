"""The desktop's side of a class on a network: between the part this machine has in it and what the desktop shows.

News come on Zenoh's threads; here they go to the event loop.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
import logging
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from day6_tui.core.classroom import note as notes
from day6_tui.core.classroom import order as orders
from day6_tui.core.classroom.order import Order
from day6_tui.core.classroom.roster import Roster
from day6_tui.core.link.addresses import ROUTER_PORT, own_address
from day6_tui.core.link.classroom.pupil import Pupil
from day6_tui.core.link.classroom.teacher import Teacher
from day6_tui.core.session.harmless import one_line
from day6_tui.core.session.task import Signal

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from day6_tui.tui.app import Day6App

_log = logging.getLogger(__name__)

SOURCE = "class"
"""The name of the link among those who observe a desktop."""
MOST_TURNED_AWAY = 20
KIND = "classroom"
"""The kind of the teacher's window."""


class ClassLink(Protocol):
    """What the application needs of either part."""

    teaches: bool

    def begin(self, app: Day6App) -> None:
        """Take part from now on. In the event loop, when the simulated machine runs."""

    def tell(self, note: bytes) -> None:
        """Send what this desktop says of itself."""

    def show(self, app: Day6App) -> None:
        """Open the view of the class, or close it."""


def link_of(part: Teacher | Pupil) -> ClassLink:
    """Return the desktop's side of a part."""
    return TeacherLink(part) if isinstance(part, Teacher) else PupilLink(part)


class PupilLink:
    """Has a pupil's desktop tell the teacher of itself and do what is asked."""

    teaches = False

    def __init__(self, part: Pupil) -> None:
        self._part = part

    def begin(self, app: Day6App) -> None:
        soon = _soon()
        self._part.met = lambda is_here: soon(partial(app.classroom.observe, SOURCE, int(is_here)))
        self._part.ordered = lambda data: soon(partial(app.classroom.hear, data))
        app.scenes.namespace = lambda: self._part.name if self._part.is_room else ""

    def tell(self, note: bytes) -> None:
        self._part.tell(note)

    def show(self, app: Day6App) -> None:
        """A pupil has no such view."""


class TeacherLink:
    """Fills the roster, carries its orders, and is the model of the teacher's window. Everything in the event loop."""

    teaches = True

    def __init__(self, part: Teacher) -> None:
        self._part = part
        self.roster = Roster(self)
        self.changed: Callable[[], None] = lambda: None
        """Called after every change; the window writes it."""
        self._listen = ""
        """The endpoint."""
        self._has_secret = False
        self.turned_away: tuple[tuple[str, str], ...] = ()
        """Who asked to join lately and was refused, and why: taken, full, domain."""
        self.home = Path()
        """Where the report goes."""

    def begin(self, app: Day6App) -> None:
        soon = _soon()
        self._listen, self._has_secret = app.options.listen or "", app.options.secret is not None
        self._part.came = lambda name, is_here: soon(partial(self._came, name, is_here))
        self._part.noted = lambda name, data: soon(partial(self._noted, name, data))
        self._part.turned_away = lambda name, why: soon(partial(self._turned_away, name, why))
        self.roster.attend(True)
        if app.machine.desk is not None:
            self.home = app.machine.desk.home
        self.show(app)

    def tell(self, note: bytes) -> None:
        """A teacher is observed by nobody in the class."""

    def show(self, app: Day6App) -> None:
        for pane in app.desktop.panes.values():
            if pane.window.kind == KIND:
                pane.window.close_by_user()
                return
        app.machine.start(KIND, self.main)

    async def main(self, session: Session) -> int:
        """The program behind the window, which runs until it is closed."""
        if session.display is not None:
            session.display.open(KIND, KIND, self)
            await session.wait(Signal())
        return 0

    def invitation(self, name: str) -> str:
        """Return what a pupil types to join."""
        host, _, port = self._listen.partition("/")[2].rpartition(":")
        at = own_address() if host in ("0.0.0.0", "[::]") else host
        secret = " --secret FILE" if self._has_secret else ""
        return f"day6-tui class --join {at}{'' if port == str(ROUTER_PORT) else ':' + port} --name {name}{secret}"

    def send(self, name: str, order: Order) -> bool:
        """Send an order; False if that pupil cannot be reached."""
        return self._part.order(name, orders.encode(order))

    def _came(self, name: str, is_here: bool) -> None:
        if is_here:
            self.roster.here(name)
            self.send(name, Order("tell"))
            self.turned_away = tuple(each for each in self.turned_away if each[0] != name)
        else:
            self.roster.gone(name)
        self.changed()

    def _turned_away(self, name: str, why: str) -> None:
        self.turned_away = (*self.turned_away, (name, why))[-MOST_TURNED_AWAY:]
        self.changed()

    def _noted(self, name: str, data: bytes) -> None:
        try:
            self.roster.heard(name, notes.decode(data))
        except notes.NoteError as error:
            _log.warning("a note of %s that is none: %s", name, one_line(str(error)))
        self.changed()


def _soon() -> Callable[[Callable[[], object]], None]:
    """Return what calls a function in the event loop that runs now, from any thread."""
    loop, context = asyncio.get_running_loop(), contextvars.copy_context()

    def soon(function: Callable[[], object]) -> None:
        with contextlib.suppress(RuntimeError):  # the loop was closed: the desktop is being left
            loop.call_soon_threadsafe(function, context=context)

    return soon
