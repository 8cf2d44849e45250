"""A pupil's side of a screen that is shown to a class on a network: a window beside what the pupil does.

It opens by itself and takes no key, unless it shall cover all else; closed, it stays so until the teacher shows something again.
"""

from __future__ import annotations

import logging
import time
from typing import TYPE_CHECKING

from day6_core.classroom import shown
from day6_core.classroom.shown import SILENT_SECONDS, Shown, ShownError
from day6_core.session.harmless import one_line
from day6_core.session.task import Signal
from day6_tui.actions import Handlers
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.panes.pane import Piece

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_tui.app import Day6App
    from day6_tui.panes.pane import Pane

_log = logging.getLogger(__name__)

KIND = "shown"
"""The kind of the window."""


class Seen:
    """Holds what is shown to this pupil, and is the model of the window. Everything in the event loop."""

    def __init__(self, app: Day6App) -> None:
        self._app = app
        self.name = ""
        """The pupil's, for whom a picture may be or not."""
        self.now: Shown | None = None
        self._came = 0.0
        self._opened = -1
        """The number of the show for which the window was opened: if it is not there, the pupil has closed it."""
        self._large = -1
        """That for which it was made large or small."""

    def actions(self) -> Handlers:
        return {"see_shown": self.open}

    @property
    def is_waiting(self) -> bool:
        """Whether no picture has come for a while."""
        return time.monotonic() - self._came >= SILENT_SECONDS

    # -- what comes ----------------------------------------------------------------------------------------------------

    def hear(self, data: bytes) -> None:
        """A picture came, or the end."""
        try:
            found = shown.decode(data)
        except ShownError as error:
            _log.warning("not a picture: %s", one_line(str(error)))
            return
        if found is None or not found.show.is_for(self.name):
            self.end()
            return
        self.now, self._came = found, time.monotonic()
        if found.number != self._opened:
            self.open()
        self._app.frames.wake()

    def end(self) -> None:
        """Nothing is shown any more, or not to this pupil; or there is no teacher."""
        if self.now is None:
            return
        self.now, self._opened, self._large = None, -1, -1
        if (pane := self._pane()) is not None:
            pane.close()
            self._app.notices.show(self._app.look.texts("shown.over"), NOTICE_SECONDS)
        self._app.frames.wake()

    # -- the window ----------------------------------------------------------------------------------------------------

    def _pane(self) -> Pane | None:
        return next((pane for pane in self._app.desktop.panes.values() if pane.window.kind == KIND), None)

    def open(self) -> None:
        """Open the window, or bring it to the front."""
        if self.now is None:
            self._app.notices.show(self._app.look.texts("shown.none"), NOTICE_SECONDS)
            return
        is_new, self._opened = self.now.number != self._opened, self.now.number
        if (pane := self._pane()) is None:
            self._app.machine.start(KIND, self.main)
        elif not is_new:
            self._app.desktop.go_to_pane(pane)

    async def main(self, session: Session) -> int:
        """The program behind the window, which runs until it is closed."""
        if session.display is not None:
            session.display.open(KIND, KIND, self)
            await session.wait(Signal())
        return 0

    def drawn(self, pane: Pane) -> None:
        """The window is on the screen: it is made as large as the teacher wants it, once each time."""
        if self.now is not None and self.now.number != self._large:
            self._large = self.now.number
            self._app.arranging.show_large(pane, self.now.show.full)

    def offers(self, short: bool) -> list[Piece]:
        """That there is something to see, where its window was closed."""
        look = self._app.look
        if self.now is None or self._opened != self.now.number or self._pane() is not None:
            return []
        text = look.texts("class.bar.see" + ".short" * short)
        return [Piece(f" {text} ", look.colours.hint, self._app.actions["see_shown"]), Piece("  ", look.colours.bar)]
