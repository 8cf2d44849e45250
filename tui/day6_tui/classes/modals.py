"""What a teacher opens over a pupil's desktop: the sheet over a frozen screen, and the question for consent."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding
from textual.content import Content

from day6_tui.appearance.look import Look
from day6_tui.overlays.message import LogModal
from day6_tui.overlays.modal import Modal, lines_of
from day6_tui.overlays.question import Answer, Question

if TYPE_CHECKING:
    from textual.widgets import Static

GRACE_SECONDS = 1.0
"""Without a key, before one is an answer: who was typing when the question came, and types on, has not read it."""


class Frozen(Modal):
    """Says that the teacher wants to be looked at. The teacher or the time takes it away; Ctrl-Q leaves as ever."""

    waits = True
    BINDINGS = []

    def __init__(self, look: Look) -> None:
        super().__init__(look, look.texts("class.frozen.title"), look.texts("class.frozen.keys"))

    def inside(self) -> ComposeResult:
        from textual.widgets import Static

        self._text: Static = Static(Content("\n").join(lines_of(self.look.texts("class.frozen.text"))), classes="text")
        yield self._text

    def on_key(self, event: events.Key) -> None:
        event.stop()

    def on_click(self, event: events.Click) -> None:
        event.stop()

    def action_close(self) -> None:
        """Esc does not take it away."""

    def action_copy_or_close(self) -> None:
        """Nor does Ctrl-C."""


class Consent(Question):
    """Asks whether the teacher may do something. What the fingers still type for a terminal is no answer."""

    def __init__(self, look: Look, title: str, text: str, agree: Callable[[], None]) -> None:
        answer = Answer("y", look.texts("class.consent.yes"), agree)
        super().__init__(look, title, text, [answer], careful=True, back=look.texts("class.consent.no"))
        self._since = math.inf
        """When it was on the screen, or the last key came that was no answer; by the clock of events."""

    def on_mount(self) -> None:
        self.call_after_refresh(self._be_seen)

    def _be_seen(self) -> None:
        self._since = events.Event().time

    def on_key(self, event: events.Key) -> None:
        """Keep a key that comes too early from being an answer (`Question.on_key`)."""
        # Its time is that of its coming: a slow machine may take longer than the grace to deal with it.
        if event.character is not None and event.time - self._since < GRACE_SECONDS:
            self._since = max(self._since, event.time)
            event.stop()
            event.prevent_default()


class Asked(Question):
    """What the teacher asks or has handed over, opened by the pupil. It keeps nothing from being done meanwhile."""

    waits = False

    def __init__(self, look: Look, title: str, text: str, answers: Sequence[Answer], *, careful: bool = True) -> None:
        super().__init__(look, title, text, answers, careful=careful, back=look.texts("class.later"))


class SaidModal(LogModal):
    """All that the teacher has said; `again` opens what was handed over last."""

    BINDINGS = [Binding("o", "open", show=False)]

    def __init__(self, look: Look, lines: Sequence[str], again: Callable[[], object] | None) -> None:
        super().__init__(look, look.texts("class.sayings"), lines)
        self._again = again
        if again is not None:
            self._keys = f"{look.texts('class.sayings.open')}  {self._keys}"

    def action_open(self) -> None:
        """o."""
        if self._again is not None and self.is_active:
            self.close()
            self._again()
