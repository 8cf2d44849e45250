"""The pupil's side of a class: what this desktop tells a teacher who observes it, and what it does when a teacher asks.

Without an observer nothing is gathered and no timer runs. A server observes all the time; that a teacher is there (`attend`) it
says by an order. The pupil always sees who watches and who may type.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.note import LessonPlace, Note, PupilScreen, Trouble
from day6_core.classroom.roster import FROZEN_SECONDS
from day6_core.session.harmless import one_line
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.panes.pane import Piece
from day6_tui.terminals.pane import TerminalPane
from day6_tui.textual_private.access import lines_of

if TYPE_CHECKING:
    from textual.strip import Strip
    from textual.timer import Timer

    from day6_core.classroom.order import Order
    from day6_core.shell.runs import Run
    from day6_tui.app import Day6App
    from day6_tui.classes.modals import Consent

_log = logging.getLogger(__name__)

TICK_SECONDS = 0.5
"""Between two looks at what there is to tell, and between two pictures."""
IDLE_STEPS = (0.0, 60.0, 300.0)
"""Seconds without a key after which that is told; in between the teacher's clock goes on."""
SAYING_SECONDS = 20.0
"""Of the words over the desktop; the top line counts what was not looked up."""
MOST_SAYINGS = 50
REFUSED_SECONDS = 30.0
"""For which it is told that an order was not followed."""
LAST_LINES = 2
"""Of a program that still runs, in which a message is looked for: what stands further up is over."""


class Classroom:
    """Holds the hand, the watching, the freezing and the consent; `tell` sends a note to who observes."""

    def __init__(self, app: Day6App, tell: Callable[[bytes], None], *, is_possible: bool) -> None:
        self._app = app
        self._tell = tell
        self.is_possible = is_possible
        """Whether anybody can observe this desktop."""
        self.typed_at = time.monotonic()
        """When the pupil did something last; the application writes it."""
        self.has_drawn = True
        """Whether the screen has changed since the last picture; the application writes it."""
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
        self._picture: PupilScreen | None = None
        self._told: Note | None = None
        self._looked: tuple[object, Trouble | None] = (None, None)
        """What was run last when a card was looked for, and how much it had printed; and the card."""
        self.sayings: list[str] = []
        self._unread = 0
        """How many of them the pupil has not looked up: the toast may have been missed."""

    @property
    def _refused(self) -> str:
        """Why the last order was not followed, for a while; '' if it was."""
        return self._refusal if time.monotonic() - self._refused_at < REFUSED_SECONDS else ""

    @_refused.setter
    def _refused(self, why: str) -> None:
        self._refusal, self._refused_at = why, time.monotonic()

    # -- what the pupil does and sees ----------------------------------------------------------------------------------

    def actions(self) -> Handlers:
        return {"hand": self.toggle_hand, "sayings": self.show_sayings, "take_back": self.take_back}

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

    def show_sayings(self) -> None:
        """What the teacher has said."""
        from day6_tui.overlays.message import LogModal

        look, self._unread = self._app.look, 0
        self._app.clear_notifications()
        said = self.sayings or [look.texts("class.sayings.none")]
        self._app.desktop.open_overlay(LogModal(look, look.texts("class.sayings"), said))
        self._app.frames.wake()

    def pieces(self, short: bool) -> list[Piece]:
        """For the top line, always: who may type or watches; the hand, which a click raises or lowers."""
        look, actions, found = self._app.look, self._app.actions, []
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
        return [*found, Piece("  ", look.colours.bar)] if found else []

    def offers(self, short: bool) -> list[Piece]:
        """For the top line where there is room: that the teacher said something; a click looks it up."""
        if not self._unread:
            return []
        look = self._app.look
        text = self._words("unread", short, count=self._unread)
        return [Piece(text, look.colours.hint, self._app.actions["sayings"]), Piece("  ", look.colours.bar)]

    def _words(self, what: str, short: bool, **values: object) -> str:
        return f" {self._app.look.texts(f'class.bar.{what}' + '.short' * short, **values)} "

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
            self._attend(False)
        self._tick()
        self._app.frames.wake()

    def _attend(self, is_there: bool) -> None:
        """A teacher is there, or no longer: then nobody watches or types, and the screen is free."""
        self._attended = is_there
        if not is_there:
            self._may_type = False
            self._frozen_until = self._watched_until = 0.0

    def hear(self, data: bytes) -> None:
        """An order came."""
        try:
            order = orders.decode(data)
        except orders.OrderError as error:
            _log.warning("an order that is none: %s", one_line(str(error)))
            return
        self._follow(order)
        self._tick()
        self._app.frames.wake()

    def _follow(self, order: Order) -> None:
        now = time.monotonic()
        if order.do == "tell":
            self._told = None
        elif order.do == "watch":
            self._watched_until, self.has_drawn = now + order.seconds, self.has_drawn or self._picture is None
        elif order.do == "unwatch":
            self._watched_until = 0.0
        elif order.do == "say":
            self._say(order.text)
        elif order.do == "attend":
            self._attend(order.on)
        elif order.do == "seen":
            self._seen = order.on
        elif order.do == "freeze":
            self._frozen_until = now + FROZEN_SECONDS if order.on else 0.0
        elif order.do == "lower_hand":
            self._lower_hand()
        elif order.do == "ask_to_type":
            self._ask()
        elif order.do == "stop_typing":
            self._may_type = False
        elif order.do == "type":
            self._type(order.text)
        elif order.do == "end":
            self._app.leaving.end_by_signal(self._app.look.texts("class.ended"))
        else:
            self._open(order)

    def _lower_hand(self) -> None:
        if self._hand:
            self._hand = False
            self._app.notices.show(self._app.look.texts("class.hand.seen"))

    def _say(self, text: str) -> None:
        said = one_line(text)
        self.sayings = [*self.sayings, said][-MOST_SAYINGS:]
        self._unread += 1
        title = self._app.look.texts("class.says")
        self._app.notify(said, title=title, timeout=SAYING_SECONDS, markup=False)

    def _ask(self) -> None:
        from day6_tui.classes.modals import Consent
        from day6_tui.overlays.question import Answer

        if self._may_type or self._asked is not None:
            return
        overlay = self._app.desktop.overlay
        if overlay is not None and overlay.waits:
            self._refused = "class.refused.busy"
            return
        self._refused = ""
        look = self._app.look
        self._asked = Consent(look, Answer("y", look.texts("class.consent.yes"), self._consent))
        self._app.desktop.open_overlay(self._asked)

    def _consent(self) -> None:
        self._may_type, self._asked = self._attended, None
        self._tick()

    def _look_for_answer(self) -> None:
        """The question was closed without a yes; a question that was in the way is no longer."""
        if self._asked is not None and self._asked not in self._app.screen_stack:
            self._asked, self._refused = None, "class.refused.no"
        overlay = self._app.desktop.overlay
        if self._refused == "class.refused.busy" and (overlay is None or not overlay.waits):
            self._refused = ""

    def _type(self, keys: str) -> None:
        pane = self._app.desktop.focused_pane
        if not self._may_type:
            self._refused = "class.refused.type"
        elif self._app.desktop.overlay is not None or not isinstance(pane, TerminalPane) or not pane.has_terminal:
            self._refused = "class.refused.place"
        else:
            self._refused = ""
            pane.view.terminal.send(keys)

    def _open(self, order: Order) -> None:
        """A scene or a lesson, as if chosen here: what runs goes on, and a scene types where nothing runs."""
        from day6_core.lessons.scene import scenes

        app, self._refused = self._app, ""
        overlay = app.desktop.overlay
        scene = scenes().get(order.text) if order.do == "scene" else None
        if overlay is not None and overlay.waits:
            self._refused = "class.refused.busy"
        elif scene is not None and not scene.is_action and (app.leaving.running() or app.desktop.panes):
            self._refused = "class.refused.full"
        elif scene is not None:
            app.scenes.start(scene.name)
        elif order.do == "lesson" and app.lessons.go_to(order.text):
            app.notices.show(app.look.texts("class.opened"), NOTICE_SECONDS)
        else:
            self._refused = "class.refused.unknown"

    # -- what is told --------------------------------------------------------------------------------------------------

    def _tick(self) -> None:
        self._keep_frozen()
        self._look_for_answer()
        if not self._observers:
            return
        note = self._note()
        if note != self._told:
            self._told = note
            self._tell(notes.encode(replace(note, idle=time.monotonic() - self.typed_at)))

    def _keep_frozen(self) -> None:
        from day6_tui.classes.modals import Frozen
        from day6_tui.overlays.question import Question

        overlay = self._app.desktop.overlay
        if not self._is_frozen:
            if isinstance(overlay, Frozen):
                overlay.close()
        elif not isinstance(overlay, (Frozen, Question)) and not self._app.detachment.away:
            self._app.push_screen(Frozen(self._app.look))  # over what is being filled in, which stays as it is

    def _note(self) -> Note:
        """What there is to tell; `idle` in steps, so that an idle desktop is silent."""
        app, idle = self._app, time.monotonic() - self.typed_at
        nodes = app.machine.desk.graph.nodes if app.machine.desk is not None else ()
        return Note(
            lesson=self._lesson(),
            trouble=self._trouble(),
            nodes=tuple(sorted({node.full_name for node in nodes if not node.name.startswith("_")})),
            programs=tuple(app.leaving.running()),
            hand=self._hand,
            idle=max(step for step in IDLE_STEPS if step <= idle),
            attended=self._attended,
            watched=self.is_watched,
            seen=self._seen,
            frozen=self._is_frozen,
            asked=self._asked is not None,
            may_type=self._may_type,
            refused=self._refused,
            screen=self._screen() if self.is_watched else None,
        )

    def _lesson(self) -> LessonPlace | None:
        pane = self._app.lessons.pane
        state = pane.course.state if pane is not None else None
        if state is None or state.lesson is None:
            return None
        lesson = state.lesson
        return LessonPlace(
            lesson.name, dict(lesson.title), state.index + 1, len(lesson.steps), state.solved, state.hints
        )

    def _trouble(self) -> Trouble | None:
        """The card of what was run last in any terminal, if it has failed, or of what it waits for."""
        from day6_core.shell.builtins.why import is_own

        runs: list[Run] = []
        for pane in self._app.desktop.terminals():
            if pane.has_terminal:
                runs += [run for run in pane.view.terminal.runs.all if not is_own(run.source)][-1:]
        last = max(runs, key=lambda run: run.began_ns, default=None)
        if last is None or last.status == 0:
            return None
        looked = (last, last.status, last.written)
        if self._looked[0] != looked:
            self._looked = (looked, _card_of(last.output, LAST_LINES if last.status is None else None))
        return self._looked[1]

    def _screen(self) -> PupilScreen | None:
        """The screen as it is now, the last one where nothing was drawn since."""
        app = self._app
        if app.detachment.away or not app.screen.size:
            return self._picture
        if self.has_drawn or self._picture is None:
            self.has_drawn = False
            ansi = "\n".join(strip.render(app.console) for strip in strips_of(app))
            self._picture = PupilScreen(app.size.width, app.size.height, ansi)
        return self._picture


def strips_of(app: Day6App) -> list[Strip]:
    """The lines of the screen; pictures of real pixels as half blocks."""
    strips = lines_of(app)
    pictures = app.look.pixels
    return strips if pictures is None else pictures.drawn_over(strips)


def _card_of(output: str, lines: int | None) -> Trouble | None:
    """The card of an output, of its last lines only where it may go on."""
    from day6_core.advice.matching import cards_in
    from day6_core.advice.wording import filled_in
    from day6_core.language import LANGUAGES

    if lines is not None:
        output = "\n".join(output.rstrip().splitlines()[-lines:])
    match = next(cards_in(output), None)
    if match is None:
        return None
    titles = {language: filled_in(match.card.words[language].first, match.values) for language in LANGUAGES}
    return Trouble(titles, one_line(match.line))
