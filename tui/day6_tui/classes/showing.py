"""A desktop whose screen is shown to the class: the question whether it may be, what its owner sees of that, and taking it back.

Who shows it is the carrier of the class (`day6_tui/web/class_show.py`); that goes on for as long as the notes say `shown`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_tui.actions import Handlers

if TYPE_CHECKING:
    from textual.timer import Timer

    from day6_tui.app import Day6App
    from day6_tui.classes.modals import Consent

SHOWN_SECONDS = 0.1
"""Between two pictures for those who look; one where nothing was drawn is not told."""


class Showing:
    """Holds the consent. `changed` is called when there is something to tell; `again` for the next picture."""

    def __init__(self, app: Day6App, changed: Callable[[], None], again: Callable[[], None]) -> None:
        self._app = app
        self._changed = changed
        self._again = again
        self._timer: Timer | None = None
        self.may = False
        """Whether this screen may be shown: a yes is good for one time."""
        self.question: Consent | None = None
        """Whether it may: still unanswered."""

    def actions(self) -> Handlers:
        return {"stop_showing": self.take_back}

    @property
    def is_on(self) -> bool:
        """Whether the class sees this screen."""
        return self._timer is not None

    def ask(self, refuse: Callable[[str], None]) -> None:
        """Ask whether the screen may be shown; what stands in the way of asking is told."""
        from day6_tui.classes.modals import Consent

        if self.may or self.question is not None:
            return
        if self._app.desktop.is_asking:
            refuse("class.refused.busy")
            return
        refuse("")
        look = self._app.look
        title, text = look.texts("class.consent_show.title"), look.texts("class.consent_show.text")
        self.question = Consent(look, title, text, self._agree)
        self._app.desktop.open_overlay(self.question)

    def _agree(self) -> None:
        self.may, self.question = True, None
        self._changed()

    def was_refused(self) -> bool:
        """Whether the question was closed without a yes, since this was asked last."""
        if self.question is None or self.question in self._app.screen_stack:
            return False
        self.question = None
        return True

    def begin(self) -> None:
        """The class sees this screen from now on."""
        if self._timer is None:
            self._timer = self._app.set_interval(SHOWN_SECONDS, self._again)
            self._app.classroom.observed.look_again()

    def end(self) -> None:
        """Nobody shows it any more: nothing stays asked or allowed."""
        if self._timer is not None:
            self._timer.stop()
        question, self._timer, self.may, self.question = self.question, None, False, None
        if question is not None and question in self._app.screen_stack:
            question.close()

    def take_back(self) -> None:
        """Show it no longer."""
        if self.is_on:
            self.end()
            self._app.notices.show(self._app.look.texts("class.not_shown"))
            self._changed()
