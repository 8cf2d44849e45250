"""Searching a terminal's scrollback: a line to type in at the edge of the screen, which leaves the text in sight."""

from __future__ import annotations

from textual.app import ComposeResult
from textual.binding import Binding
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, plain
from day6_tui.terminals.pane import TerminalPane
from day6_tui.terminals.search import TerminalSearch


class Find(Modal):
    """Finds what is typed in the terminal of `pane`, upwards from the newest. What was found stays selected."""

    BINDINGS = [
        Binding("up,shift+f3", "step(-1)", show=False),
        Binding("down,f3", "step(1)", show=False, priority=True),
    ]

    def __init__(self, look: Look, pane: TerminalPane) -> None:
        super().__init__(look, look.texts("find.title"), look.texts("find.keys"))
        self._pane = pane

    def inside(self) -> ComposeResult:
        from textual.widgets import Static

        from day6_tui.overlays.input_line import InputLine

        self._line = InputLine(self.look, placeholder=self.look.texts("find.what"))
        yield self._line
        self._note = Static("", classes="note")
        yield self._note

    @property
    def keyboard(self) -> Widget:
        return self._line

    def on_input_changed(self) -> None:
        self._show(-1, anew=True)

    def accept(self) -> None:
        """Enter: the next one above."""
        self._show(-1)

    def action_step(self, step: int) -> None:
        """The next one above or below."""
        self._show(step)

    def _show(self, step: int, *, anew: bool = False) -> None:
        view = self._pane.view
        search = TerminalSearch(view, self._line.value)
        here = None if anew else view.selection
        place = search.previous(here) if step < 0 else search.next(here)
        if place is None:
            view.selection = None
            self._note.update(plain(self.look.texts("find.none") if self._line.value else ""))
        else:
            search.show(place)
            places = search.found()
            self._note.update(plain(self.look.texts("find.count", number=places.index(place) + 1, count=len(places))))
        self._pane.touch()
        self.look.wake()
