"""What is shown to the class and what shall be: one screen, the teacher's own or a pupil's who has said yes.

The same in browser tabs and on a network; who carries it, and to whom pictures go, is the projector's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

from day6_core.classroom.homes import same_name
from day6_core.classroom.note import Note, PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster

OWN = ""
"""In place of a pupil's name: the teacher's own desktop."""

WANTED_SECONDS = 120.0
"""For which a pupil can take time to answer, and the teacher's desktop to start."""


class Show(NamedTuple):
    """What is shown, to whom."""

    source: str
    """The name of the pupil, or OWN."""
    names: frozenset[str] | None
    """The pupils (`same_name`); None for all, also those who come later, and the teacher's own desktop."""
    full: bool
    """Whether it shall cover all else: the pupil can make it small."""

    def is_for(self, name: str) -> bool:
        """Whether this desktop shows it."""
        key = same_name(name)
        return key != same_name(self.source) and (self.names is None or key in self.names)


class Projector(Protocol):
    """Reaches the desktops, and those who look."""

    def send(self, name: str, order: Order) -> bool:
        """Send an order to a pupil's desktop, or to the own one; False if it cannot be reached."""

    def say(self, key: str, name: str) -> None:
        """Tell the teacher: `class.show.<key>` of the catalogue."""

    def changed(self) -> None:
        """Another screen is shown, or to others, or none; or another one is wanted."""

    def project(self, screen: PupilScreen) -> None:
        """The screen that is shown, as it is now."""


class Stage:
    """Holds both. Not for several threads; `later` calls a function after so many seconds."""

    def __init__(
        self, roster: Roster, projector: Projector, later: Callable[[float, Callable[[], None]], object]
    ) -> None:
        self._roster = roster
        self._projector = projector
        self._later = later
        self.on: Show | None = None
        self.wanted: Show | None = None
        """Asked for; its pupil has not answered, or the desktop is yet to start."""
        self._has_asked = False
        """Whether the question was seen on the pupil's screen."""

    # -- what the teacher wants ----------------------------------------------------------------------------------------

    def start(self, show: Show) -> None:
        """Show this as soon as it may be; what is shown goes on until then."""
        if self.wanted is not None:
            self._drop_wanted()
        if self.on is not None and self.on.source == show.source:
            self._begin(show)  # for others, or larger
            return
        own = show.source == OWN
        self.wanted, self._has_asked = show, False
        order = Order("show", on=True) if own else Order("ask_to_show")
        if not self._projector.send(show.source, order) and not own:
            self.wanted = None
            self._projector.say("gone", show.source)
            return
        self._later(WANTED_SECONDS, lambda: self._give_up(show))
        self._projector.changed()

    def again(self, *, full: bool) -> None:
        """Show what is shown large, or as a pane among others."""
        if self.on is not None:
            self._begin(self.on._replace(full=full))

    def stop(self) -> None:
        """Show nothing, and want nothing."""
        if self.wanted is not None:
            self._drop_wanted()
        if self.on is not None:
            self._end()

    def look_for_teacher(self) -> None:
        """Nothing is shown without a teacher."""
        if not self._roster.is_attended:
            self.stop()

    def _give_up(self, show: Show) -> None:
        if self.wanted is show:
            self._refused("not_mine" if show.source == OWN else "silent")

    def _drop_wanted(self) -> None:
        show, self.wanted = self.wanted, None
        if show is not None:
            self._projector.send(show.source, Order("show"))
            self._projector.changed()

    def _refused(self, key: str) -> None:
        assert self.wanted is not None
        name = self.wanted.source
        self._drop_wanted()
        self._projector.say(key, name)

    def _begin(self, show: Show) -> None:
        before, self.on = self.on, show
        if before is None or before.source != show.source:
            self._roster.journal.note("showed", show.source)
            if before is not None:
                self._projector.send(before.source, Order("show"))
        self._projector.changed()

    def _end(self) -> None:
        show, self.on = self.on, None
        if show is not None:
            self._projector.send(show.source, Order("show"))
            self._projector.changed()

    # -- what the desktops say -----------------------------------------------------------------------------------------

    def noted(self, name: str, note: Note | None) -> None:
        """A desktop said this of itself, or (None) has ended."""
        if self.wanted is not None and name == self.wanted.source:
            self._look_at_wanted(self.wanted, note)
        if self.on is not None and name == self.on.source:
            self._look_at_shown(note)

    def _look_at_wanted(self, show: Show, note: Note | None) -> None:
        own = show.source == OWN
        if note is None:
            if not own:  # which may just be starting
                self._refused("gone")
        elif note.shown and note.screen is not None:
            self.wanted = None
            self._begin(show)
        elif own or note.may_show:
            if not note.shown:
                self._projector.send(show.source, Order("show", on=True))
        elif note.asked_show:
            self._has_asked = True
        elif self._has_asked:
            self._refused("no")
        elif note.refused == "class.refused.busy":
            self._refused("busy")

    def _look_at_shown(self, note: Note | None) -> None:
        assert self.on is not None
        name = self.on.source
        if note is None or not note.shown:
            self._end()
            self._projector.say("mine_over" if name == OWN else "over", name)
        elif note.screen is not None:
            self._projector.project(note.screen)
