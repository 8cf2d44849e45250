"""The inspector's window: what is wrong with the graph, the worst first, in the user's language."""

from __future__ import annotations

from pathlib import Path

from textual import events
from textual.app import ComposeResult
from textual.widget import Widget

from day6_tui.core.ros.programs.day6_inspector.model import Inspector
from day6_tui.core.session.display import Window
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Piece
from day6_tui.tui.windows import WindowPane
from day6_tui.tui.windows.inspector_list import FindingList


class InspectorPane(WindowPane[Inspector]):
    """Draws the frame; the findings are a list that has the keyboard."""

    DEFAULT_CSS = Path(__file__).with_suffix(".tcss").read_text(encoding="utf-8")

    def __init__(self, window: Window[Inspector], look: Look) -> None:
        super().__init__(window, look)
        self.inspector = window.model
        self.list = FindingList(look)
        self._shown: tuple[object, ...] = ()

    def compose(self) -> ComposeResult:
        yield self.list

    @property
    def focus_target(self) -> Widget:
        return self.list if self.list.is_attached else self

    def focus(self, scroll_visible: bool = True) -> InspectorPane:
        self.list.focus(scroll_visible)
        return self

    @property
    def label(self) -> str:
        return self.look.texts("inspector.title")

    def status(self) -> list[Piece]:
        errors = sum(finding.level == "error" for finding in self.inspector.findings)
        text = self.look.texts("inspector.count", errors=errors, all=len(self.inspector.findings))
        return [Piece(f" {text} ", self.look.colours.warning if errors else self.look.colours.muted)]

    def pull(self, now: float) -> bool:
        state = (self.inspector.version, self.look.texts.language)
        if state != self._shown and self.list.is_attached:
            self._shown = state
            self.list.show(self.inspector.findings)
            self.touch()
        return False

    def restyle(self) -> None:
        self._shown = ()
        self.list.take_look(self.look)
        super().restyle()

    def on_focus(self, event: events.Focus) -> None:
        super().on_focus(event)
        if self.focus_target is not self:
            self.screen.set_focus(self.focus_target, scroll_visible=False)
