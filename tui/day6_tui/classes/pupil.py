"""The pupil's side of a class: what this desktop tells a teacher who observes it, and what it does when a teacher asks.

Without an observer nothing is gathered and no timer runs. A server observes all the time; that a teacher is there (`attend`) it
says by an order. The pupil always sees who watches and who may type.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.note import Note
from day6_core.classroom.roster import FROZEN_SECONDS
from day6_core.session.harmless import one_line
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.classes.keys import TeachersKeys
from day6_tui.classes.marks import Marks
from day6_tui.classes.observed import Observed
from day6_tui.classes.sayings import Sayings
from day6_tui.classes.seen import Seen
from day6_tui.classes.showing import Showing
from day6_tui.panes.pane import Piece
from day6_tui.terminals.pane import TerminalPane

if TYPE_CHECKING:
    from textual.timer import Timer

    from day6_core.classroom.order import Order
    from day6_tui.app import Day6App
    from day6_tui.classes.modals import Consent

_log = logging.getLogger(__name__)

TICK_SECONDS = 0.5
"""Between two looks at what there is to tell, and between two pictures."""
IDLE_STEPS = (0.0, 60.0, 300.0)
"""Seconds without a key after which that is told; in between the teacher's clock goes on."""
REFUSED_SECONDS = 30.0
"""For which it is told that an order was not followed."""


class Classroom:
    """Holds the hand, the watching, the freezing and the consent; `tell` sends a note to who observes."""

    def __init__(self, app: Day6App, tell: Callable[[bytes], None], *, is_possible: bool) -> None:
        self._app = app
        self._tell = tell
        self.is_possible = is_possible
        """Whether anybody can observe this desktop."""
        self.typed_at = time.monotonic()
        """When the pupil did something last; the application writes it."""
        self.observed = Observed(app)
        self._showing = Showing(app, changed=self._tick, again=self._tell_picture)
        self.seen = Seen(app)
        """What another screen is shown here; a browser's page does that itself."""
        self._observers_by: dict[str, int] = {}
        """source -> how many of it observe this desktop: the server's teachers through the keeper, the teacher of a class"""
        self._timer: Timer | None = None
        self._attended = False
        """Whether a teacher is there."""
        self._seen = False
        """Whether somebody looks by a link that only watches."""
        self._hand = False
        self._asked: Consent | None = None
        """The question whether the teacher may type."""
        self._may_type = False
        self._refusal = ""
        self._refused_at = 0.0
        self._watched_until = 0.0
        self._frozen_until = 0.0
        self._told: Note | None = None
        self.sayings = Sayings(app, self._tick)
        self.keys = TeachersKeys(app, lambda: self._may_type, lambda: self._refuse("class.refused.place"))
        self._marks = Marks(app, self.sayings.hear)
        self.sayings.opened = self._marks.opened
        self._obeys: dict[str, Callable[[Order], None]] = {
            "tell": self._tell_again,
            "attend": self._attend,
            "seen": self._be_seen,
            "watch": self._be_watched,
            "unwatch": self._be_unwatched,
            "say": self.sayings.hear,
            "settle": self.sayings.settle,
            "link": self.sayings.hear,
            "file": self.sayings.hear,
            "freeze": self._freeze,
            "lower_hand": self._lower_hand,
            "ask_to_type": self._ask,
            "stop_typing": self._stop_typing,
            "type": self._type,
            "ask_to_show": self._ask_to_show,
            "show": self._be_shown,
            "scene": self._start_scene,
            "lesson": self._open_lesson,
            "exam": self._open_lesson,
            "end": self._end,
        }

    @property
    def _refused(self) -> str:
        """Why the last order was not followed, for a while; '' if it was."""
        return self._refusal if time.monotonic() - self._refused_at < REFUSED_SECONDS else ""

    @_refused.setter
    def _refused(self, why: str) -> None:
        self._refusal, self._refused_at = why, time.monotonic()

    # -- what the pupil does and sees ----------------------------------------------------------------------------------

    def actions(self) -> Handlers:
        return {
            "hand": self.toggle_hand,
            "take_back": self.take_back,
            **self.sayings.actions(),
            **self._showing.actions(),
            **self.seen.actions(),
        }

    def toggle_hand(self) -> None:
        """Raise the hand, or lower it."""
        self._hand = not self._hand
        texts = self._app.look.texts
        key = "class.hand.lowered" if not self._hand else "class.hand.raised" if self._attended else "class.hand.alone"
        self._app.notices.show(texts(key))
        self._tick()

    def take_back(self) -> None:
        """The teacher may type no longer."""
        if self._may_type:
            self._may_type, self._refused = False, "class.refused.taken_back"
            self._app.notices.show(self._app.look.texts("class.taken_back"))
            self._tick()

    def pieces(self, short: bool) -> list[Piece]:
        """For the top line, always: who may type or watches; the hand, which a click raises or lowers."""
        look, actions, found = self._app.look, self._app.actions, []
        if self._showing.is_on:
            found.append(Piece(self._words("shown", short), look.colours.error, actions["stop_showing"]))
        if self._may_type:
            found.append(Piece(self._words("types", short), look.colours.error, actions["take_back"]))
        elif self.is_watched:
            found.append(Piece(self._words("watched", short), look.colours.warning))
        elif self._seen and self._observers:
            found.append(Piece(self._words("seen", short), look.colours.warning))
        if self._hand:
            found.append(Piece(self._words("hand", short), look.colours.hint, actions["hand"]))
        elif self._attended:
            found.append(Piece(self._words("raise", short), look.colours.key, actions["hand"]))
        found += self.sayings.pieces(short)
        return [*found, Piece("  ", look.colours.bar)] if found else []

    def offers(self, short: bool) -> list[Piece]:
        """For the top line, where there is room: what can be looked at."""
        return [*self.seen.offers(short), *self.sayings.offers(short)]

    def _words(self, what: str, short: bool) -> str:
        return f" {self._app.look.texts(f'class.bar.{what}' + '.short' * short)} "

    @property
    def is_watched(self) -> bool:
        """Whether the teacher looks at this screen."""
        return self._attended and time.monotonic() < self._watched_until

    @property
    def _is_frozen(self) -> bool:
        return self._attended and time.monotonic() < self._frozen_until

    # -- what comes from who observes ----------------------------------------------------------------------------------

    @property
    def _observers(self) -> int:
        return sum(self._observers_by.values())

    def observe(self, source: str, count: int) -> None:
        """So many of this source observe this desktop now."""
        self._observers_by[source] = count
        count = self._observers
        if count and self._timer is None:
            self._timer = self._app.set_interval(TICK_SECONDS, self._tick)
            self._told = None
        elif not count:
            if self._timer is not None:
                self._timer.stop()
                self._timer = None
            self._seen = False
            self._have_teacher(False)
            self._showing.end()
        self._tick()
        self._app.frames.wake()

    def _have_teacher(self, is_there: bool) -> None:
        """A teacher is there, or no longer: then nobody watches or types, and the screen is free."""
        self._attended = is_there
        if not is_there:
            asked, self._asked, self._may_type = self._asked, None, False
            if asked is not None and asked in self._app.screen_stack:
                asked.close()  # a later teacher has asked nothing
            self._showing.end()
            self._frozen_until = self._watched_until = 0.0

    def hear(self, data: bytes) -> None:
        """An order came."""
        try:
            order = orders.decode(data)
        except orders.OrderError as error:
            _log.warning("an order that is none: %s", one_line(str(error)))
            return
        self._obeys[order.do](order)
        self._tick()
        self._app.frames.wake()

    # -- what is done for each order: `_obeys` says which ---------------------------------------------------------------

    def _tell_again(self, order: Order) -> None:
        self._told = None

    def _attend(self, order: Order) -> None:
        self._have_teacher(order.on)

    def _be_seen(self, order: Order) -> None:
        self._seen = order.on

    def _be_watched(self, order: Order) -> None:
        self._watched_until = time.monotonic() + order.seconds
        self.observed.look_again()

    def _be_unwatched(self, order: Order) -> None:
        self._watched_until = 0.0

    def _freeze(self, order: Order) -> None:
        self._frozen_until = time.monotonic() + FROZEN_SECONDS if order.on else 0.0

    def _lower_hand(self, order: Order) -> None:
        if self._hand:
            self._hand = False
            self._app.notices.show(self._app.look.texts("class.hand.seen"))

    def _end(self, order: Order) -> None:
        self._app.leaving.end_by_signal(self._app.look.texts("class.ended"))

    def _ask(self, order: Order) -> None:
        from day6_tui.classes.modals import Consent

        if self._may_type or self._asked is not None:
            return
        if self._app.desktop.is_asking:
            self._refused = "class.refused.busy"
            return
        self._refused = ""
        look = self._app.look
        title, text = look.texts("class.consent.title"), look.texts("class.consent.text")
        self._asked = Consent(look, title, text, self._consent)
        self._app.desktop.open_overlay(self._asked)

    def _stop_typing(self, order: Order) -> None:
        self._may_type = False

    def _type(self, order: Order) -> None:
        desktop, self._refused = self._app.desktop, ""
        pane = desktop.focused_pane
        if not self._may_type:
            self._refused = "class.refused.type"
        elif not self.keys.have_place():
            self._refused = "class.refused.place"
        elif self.keys.are_coming or desktop.overlay or not isinstance(pane, TerminalPane) or not pane.has_terminal:
            self.keys.type(order.text)
        else:
            pane.view.terminal.send(order.text)

    def _ask_to_show(self, order: Order) -> None:
        self._showing.ask(self._refuse)

    def _refuse(self, why: str) -> None:
        self._refused = why

    def _be_shown(self, order: Order) -> None:
        if not order.on:
            self._showing.end()
        elif self._showing.may or not self._attended:  # the teacher's own desktop is asked nothing
            self._showing.begin()

    def _start_scene(self, order: Order) -> None:
        """A scene as if chosen here: it types where nothing runs."""
        from day6_core.lessons.scene import scenes

        app, scene = self._app, scenes().get(order.text)
        if scene is None:
            self._refused = "class.refused.unknown"
        elif not scene.is_action and (app.leaving.running() or app.desktop.panes):
            self._refused = "class.refused.full"
        else:
            self._start(partial(app.scenes.start, scene.name))

    def _open_lesson(self, order: Order) -> None:
        """A lesson or a drill as if chosen here: what runs goes on."""
        app = self._app

        def go() -> None:
            if app.lessons.go_to(order.text):
                app.notices.show(app.look.texts("class.opened"), NOTICE_SECONDS)
            else:
                self._refused = "class.refused.unknown"

        self._start(go)

    def _start(self, start: Callable[[], object]) -> None:
        """Start something, unless a question stands open."""
        if self._app.desktop.is_asking:
            self._refused = "class.refused.busy"
        else:
            self._refused = ""
            start()

    # -- what is open ---------------------------------------------------------------------------------------------------

    def _consent(self) -> None:
        self._may_type, self._asked = self._attended, None
        self._tick()

    def _look_for_answer(self) -> None:
        """The question was closed without a yes; a question that was in the way is no longer."""
        if self._asked is not None and self._asked not in self._app.screen_stack:
            self._asked, self._refused = None, "class.refused.no"
        if self._showing.was_refused():
            self._refused = "class.refused.no"
        if self._refused == "class.refused.busy" and not self._app.desktop.is_asking:
            self._refused = ""

    # -- what is told --------------------------------------------------------------------------------------------------

    def _tick(self) -> None:
        self._keep_frozen()
        self._look_for_answer()
        if not self._observers:
            return
        self._marks.look()
        note = self._note()
        if note != self._told:
            self._told = note
            self._send(note)

    def _tell_picture(self) -> None:
        """The class sees this screen: between two notes it is told alone."""
        if self._told is None:
            self._tick()
        elif (screen := self.observed.screen()) is not self._told.screen:
            self._told = replace(self._told, screen=screen)
            self._send(self._told)

    def _send(self, note: Note) -> None:
        self._tell(notes.encode(replace(note, idle=time.monotonic() - self.typed_at)))

    def _keep_frozen(self) -> None:
        from day6_tui.classes.modals import Frozen

        desktop = self._app.desktop
        if not self._is_frozen:
            if isinstance(desktop.overlay, Frozen):
                desktop.overlay.close()
        elif not desktop.is_asking and not self._app.detachment.away:
            self._app.push_screen(Frozen(self._app.look))  # over what is being filled in, which stays as it is

    def _note(self) -> Note:
        """What there is to tell; `idle` in steps, so that an idle desktop is silent."""
        idle = time.monotonic() - self.typed_at
        return Note(
            lesson=self.observed.lesson(),
            trouble=self.observed.trouble(),
            nodes=self.observed.nodes(),
            programs=tuple(self._app.leaving.running()),
            hand=self._hand,
            idle=max(step for step in IDLE_STEPS if step <= idle),
            attended=self._attended,
            watched=self.is_watched,
            seen=self._seen,
            frozen=self._is_frozen,
            asked=self._asked is not None,
            may_type=self._may_type,
            asked_show=self._showing.question is not None,
            may_show=self._showing.may,
            shown=self._showing.is_on,
            refused=self._refused,
            replies=self.sayings.replies,
            opened=self.sayings.numbers_opened,
            screen=self.observed.screen() if self.is_watched or self._showing.is_on else None,
        )
