"""The teacher's side of a screen that is shown to a class on a network: the projector of the stage.

The own desktop is observed like a pupil's, but only as long as it is wanted, and asks nobody.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom import shown
from day6_core.classroom.note import PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster
from day6_core.classroom.show import OWN, Show, Stage
from day6_core.classroom.shown import Pace, Shown, ShownError
from day6_core.link.classroom.teacher import Teacher

if TYPE_CHECKING:
    from textual.timer import Timer

    from day6_tui.app import Day6App

_log = logging.getLogger(__name__)

SOURCE = "own"
"""The teacher among those who observe the own desktop."""
ENDS = 3
"""So often the end is told: a pupil whose network is slow may lose a message."""


class Broadcast:
    """Sends what the stage has. `say` tells the teacher of a pupil: a key of the catalogue, and the name."""

    def __init__(self, part: Teacher, roster: Roster, say: Callable[[str, str], None]) -> None:
        self._part = part
        self._roster = roster
        self._say = say
        self._app: Day6App | None = None
        self.stage = Stage(roster, self, lambda *what: asyncio.get_running_loop().call_later(*what))
        self.cover: Callable[[], None] = lambda: None
        """Takes pupils' screens out of the window of the class at once; set by the window."""
        self._number = secrets.randbits(32)
        """Another one than that of an earlier teacher."""
        self._show: Show | None = None
        self._screen: PupilScreen | None = None
        self._pace = Pace()
        self._ends = 0
        """How often the end has yet to be told."""
        self._timer: Timer | None = None

    def begin(self, app: Day6App) -> None:
        """From now on there is a desktop."""
        self._app = app

    def press(self, name: str, *, full: bool) -> None:
        """The key that shows this pupil's screen (OWN: the own one), in one of its forms: once more ends what it began."""
        show, now = Show(name, None, full), self.stage.wanted or self.stage.on
        if now == show:
            self.stage.stop()
        else:
            self.stage.start(show)

    def own_note(self, data: bytes) -> None:
        """The own desktop says this of itself; it may be in the middle of doing what it was told."""
        if self.shows_own:
            asyncio.get_running_loop().call_soon(self.stage.noted, OWN, notes.decode(data))

    @property
    def shows_own(self) -> bool:
        """Whether the class sees the own desktop, or is about to."""
        return any(show is not None and show.source == OWN for show in (self.stage.on, self.stage.wanted))

    # -- for the stage -------------------------------------------------------------------------------------------------

    def send(self, name: str, order: Order) -> bool:
        if name != OWN:
            return not self._roster.order([name], order)
        if self._app is None:
            return False
        if order.on:
            self.cover()
            self._app.classroom.observed.has_drawn = True
            self._app.classroom.observe(SOURCE, 1)
        self._app.classroom.hear(orders.encode(order))
        return True

    def say(self, key: str, name: str) -> None:
        self._say(f"class.show.{key}", name)

    def changed(self) -> None:
        if self._app is None:
            return
        if self.stage.on != self._show:
            if self._show is None or self.stage.on is None or self._show.source != self.stage.on.source:
                self._screen = None
            self._show, self._pace, self._number = self.stage.on, Pace(), self._number + 1
            self._ends = ENDS if self._show is None else 0
            self._timer = self._timer or self._app.set_interval(shown.EVERY_SECONDS, self._send)
            self._send()
        if not self.shows_own:
            self._app.classroom.observe(SOURCE, 0)
        self._app.frames.wake()

    def project(self, screen: PupilScreen) -> None:
        self._screen = screen
        self._send()

    def _send(self) -> None:
        """The picture, if it is time for one; or the end, until it was told often enough."""
        if self._show is None:
            self._ends -= 1
            self._part.show(shown.encode(None))
            if self._ends <= 0 and self._timer is not None:
                self._timer.stop()
                self._timer = None
        elif self._screen is not None and self._pace.is_due(self._screen, time.monotonic()):
            try:
                self._part.show(shown.encode(Shown(self._number, self._show, self._screen)))
            except ShownError as error:
                _log.warning("a screen that is not shown: %s", error)
