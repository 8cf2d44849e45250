"""The desktop's side of a class on a network: between the part this machine has in it and what the desktop shows.

News come on Zenoh's threads; here they go to the event loop.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
import logging
import time
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, Protocol

from day6_core.classroom import handed
from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.journal import Journal
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster
from day6_core.link.addresses import ROUTER_PORT, own_address
from day6_core.link.classroom.pupil import Pupil
from day6_core.link.classroom.teacher import Teacher
from day6_core.reason import reason
from day6_core.session.harmless import one_line
from day6_core.session.task import Signal
from day6_tui.classes.broadcast import Broadcast
from day6_tui.classes.handing import Handing, Soon, hand
from day6_tui.panes.pane import Piece

if TYPE_CHECKING:
    from day6_core.link.state import Door
    from day6_core.session.session import Session
    from day6_tui.app import Day6App

_log = logging.getLogger(__name__)

SOURCE = "class"
"""The name of the link among those who observe a desktop."""
MOST_TURNED_AWAY = 20
TURNED_AWAY_SECONDS = 10.0
"""After the last question: who is refused asks again every second, until it is solved."""
NEWS_SECONDS = 5.0
"""For a notice of what a pupil does: meanwhile the keys of the class are not seen."""
LOG = Path(".config", "day6-tui", "class-log")
"""In the home folder of the machine: what happened in the class, a file a day."""
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
        """Open the view of the class, or bring it to the front."""

    def pieces(self, short: bool) -> Sequence[Piece]:
        """For the top line: what has to be seen wherever one is; in short words, if asked for."""

    def joined(self) -> int:
        """How many desktops depend on this one."""


class TurnedAway(NamedTuple):
    """One who asks to join and is refused: the name, why (taken, full, domain), and when it was last (time.monotonic)."""

    name: str
    why: str
    when: float


def link_of(part: Teacher | Pupil) -> ClassLink:
    """Return the desktop's side of a part."""
    return TeacherLink(part) if isinstance(part, Teacher) else PupilLink(part)


class PupilLink:
    """Has a pupil's desktop tell the teacher of itself and do what is asked."""

    teaches = False

    def __init__(self, part: Pupil) -> None:
        self._part = part

    def begin(self, app: Day6App) -> None:
        soon, seen, newest = _soon(), app.classroom.seen, deque[bytes](maxlen=1)

        def see() -> None:
            if newest:
                seen.hear(newest.pop())

        def shown(data: bytes) -> None:
            newest.append(data)  # what a slow desktop has not looked at yet is over
            soon(see)

        seen.name = self._part.name
        if app.machine.desk is not None:
            self._part.handed = partial(handed.receive, app.machine.desk.home)
        self._part.shown = shown
        self._part.met = lambda is_here: soon(partial(self._meet, app, is_here))
        self._part.ordered = lambda data: soon(partial(app.classroom.hear, data))
        app.scenes.namespace = lambda: self._part.name if self._part.is_room else ""

    def _meet(self, app: Day6App, is_here: bool) -> None:
        """The teacher is there, or no longer: then nothing is shown."""
        app.classroom.observe(SOURCE, int(is_here))
        if not is_here:
            app.classroom.seen.end()

    def tell(self, note: bytes) -> None:
        self._part.tell(note)

    def show(self, app: Day6App) -> None:
        """A pupil has no such view."""

    def pieces(self, short: bool) -> Sequence[Piece]:
        """What a pupil has to see comes from `day6_tui/classes/pupil.py`."""
        return ()

    def joined(self) -> int:
        return 0


class TeacherLink:
    """Fills the roster, carries its orders, and is the model of the teacher's window. Everything in the event loop."""

    teaches = True

    def __init__(self, part: Teacher) -> None:
        self._part = part
        self._app: Day6App | None = None
        self.roster = Roster(self)
        self.broadcast = Broadcast(part, self.roster, self._tell_here)
        self._soon: Soon = lambda function: None
        self._listen = ""
        """The endpoint."""
        self._has_secret = False
        self._turned_away: tuple[TurnedAway, ...] = ()
        self.home = Path()
        """Where the report goes."""

    def begin(self, app: Day6App) -> None:
        self._app, self._soon = app, (soon := _soon())
        self._listen, self._has_secret = app.options.listen or "", app.options.secret is not None
        self._part.came = lambda name, is_here: soon(partial(self._came, name, is_here))
        self._part.noted = lambda name, data: soon(partial(self._noted, name, data))
        self._part.turned_away = lambda name, why: soon(partial(self._turn_away, name, why))
        if app.machine.desk is not None:
            self.home = app.machine.desk.home
            if self.home.is_dir():
                self.roster.journal = Journal(self.home / LOG, partial(self._not_logged, app))
        self.roster.attend(True)
        self.broadcast.begin(app)
        self.show(app)

    def _not_logged(self, app: Day6App, error: OSError) -> None:
        app.notices.show(app.look.texts("teacher.no_log", reason=reason(error)), NEWS_SECONDS)

    def tell(self, note: bytes) -> None:
        """A teacher is observed by nobody in the class, but can be shown to all."""
        self.broadcast.own_note(note)

    def show(self, app: Day6App) -> None:
        for pane in app.desktop.panes.values():
            if pane.window.kind == KIND:
                app.desktop.go_to_pane(pane)
                return
        app.machine.start(KIND, self.main)

    async def main(self, session: Session) -> int:
        """The program behind the window, which runs until it is closed."""
        if session.display is not None:
            session.display.open(KIND, KIND, self)
            await session.wait(Signal())
        return 0

    # -- what there is to know -----------------------------------------------------------------------------------------

    @property
    def is_room(self) -> bool:
        """Whether the class shares one graph."""
        return self._part.is_room

    @property
    def door(self) -> Door | None:
        """The way by which pupils come; None before the link is up."""
        doors = self._app.machine.doors() if self._app is not None else ()
        return next((door for door in doors if door.listening), None)

    @property
    def turned_away(self) -> tuple[TurnedAway, ...]:
        """Who asks to join and is refused, the latest last."""
        now = time.monotonic()
        return tuple(each for each in self._turned_away if now - each.when < TURNED_AWAY_SECONDS)

    @property
    def hands(self) -> int:
        """How many hands are up."""
        return sum(row.is_here and row.raised is not None for row in self.roster.rows())

    def joined(self) -> int:
        return len(self.roster.everybody())

    def pieces(self, short: bool) -> Sequence[Piece]:
        """How many hands are up; a click shows whose."""
        if self._app is None or not (hands := self.hands):
            return ()
        look = self._app.look
        text = look.texts("teacher.bar.hand") if hands == 1 else look.texts("teacher.bar.hands", count=hands)
        return Piece(f" {text} ", look.colours.hint, self._app.actions["class"]), Piece("  ", look.colours.bar)

    def invitation(self, name: str) -> str:
        """Return what a pupil types to join."""
        host, _, port = self._listen.partition("/")[2].rpartition(":")
        at = own_address() if host in ("0.0.0.0", "[::]") else host
        secret = " --secret FILE" if self._has_secret else ""
        return f"day6-tui class --join {at}{'' if port == str(ROUTER_PORT) else ':' + port} --name {name}{secret}"

    def send(self, name: str, order: Order) -> bool:
        """Send an order; False if that pupil cannot be reached."""
        return self._part.order(name, orders.encode(order))

    def hand(self, file: str, data: bytes, names: Sequence[str], changed: Callable[[Handing], None]) -> Handing:
        """Begin to hand out a file; `changed` is called after each answer."""
        handing = Handing(file, data, names)
        hand(self._part, self.roster, handing, self._soon, changed)
        return handing

    # -- what comes ----------------------------------------------------------------------------------------------------

    def _came(self, name: str, is_here: bool) -> None:
        if is_here:
            self.roster.here(name)
            self.send(name, Order("tell"))
            self._turned_away = tuple(each for each in self._turned_away if each.name != name)
        else:
            self.roster.gone(name)
            self.broadcast.stage.noted(name, None)
        self._wake()

    def _turn_away(self, name: str, why: str) -> None:
        """One is refused, perhaps once more: that is told of once."""
        known = {(each.name, each.why): each for each in self.turned_away}
        is_new = (name, why) not in known
        known[name, why] = TurnedAway(name, why, time.monotonic())
        self._turned_away = tuple(known.values())[-MOST_TURNED_AWAY:]
        if is_new:
            self._tell_here(f"teacher.turned.{why}", name)

    def _noted(self, name: str, data: bytes) -> None:
        hand = self._has_hand_up(name)
        try:
            note = notes.decode(data)
            self.roster.heard(name, note)
            self.broadcast.stage.noted(name, note)
        except notes.NoteError as error:
            _log.warning("a note of %s that is none: %s", name, one_line(str(error)))
        if not hand and self._has_hand_up(name):
            self._tell_here("teacher.raised", name)
        self._wake()

    def _has_hand_up(self, name: str) -> bool:
        row = self.roster.row(name)
        return row is not None and row.raised is not None

    def _tell_here(self, key: str, name: str) -> None:
        """Tell the teacher of this pupil, wherever the teacher is."""
        if self._app is not None:
            self._app.notices.show(self._app.look.texts(key, name=name), NEWS_SECONDS)

    def _wake(self) -> None:
        if self._app is not None:
            self._app.frames.wake()


def _soon() -> Soon:
    """Return what calls a function in the event loop that runs now, from any thread."""
    loop, context = asyncio.get_running_loop(), contextvars.copy_context()

    def soon(function: Callable[[], object]) -> None:
        with contextlib.suppress(RuntimeError):  # the loop was closed: the desktop is being left
            loop.call_soon_threadsafe(function, context=context)

    return soon
