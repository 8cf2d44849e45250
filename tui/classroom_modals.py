"""What a teacher opens over a pupil's desktop: the sheet over a frozen screen, and the question for consent."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from textual import events
from textual.app import ComposeResult
from textual.content import Content

from day6_tui.tui.look import Look
from day6_tui.tui.modal import Modal, lines_of
from day6_tui.tui.question import Answer, Question

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
    """Asks whether the teacher may type. What the fingers still type for a terminal is no answer."""

    def __init__(self, look: Look, answer: Answer) -> None:
        texts = look.texts
        title, text, no = (texts(f"class.consent.{part}") for part in ("title", "text", "no"))
        super().__init__(look, title, text, [answer], careful=True, back=no)
        self._since = time.monotonic()

    def on_key(self, event: events.Key) -> None:
        if time.monotonic() - self._since >= GRACE_SECONDS or event.character is None:
            super().on_key(event)
        else:
            self._since = time.monotonic()
            event.stop()
            event.prevent_default()
