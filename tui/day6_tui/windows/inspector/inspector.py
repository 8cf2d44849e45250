"""The inspector's window: what is wrong with the graph, the worst first, in the user's language."""

from __future__ import annotations

from textual import on

from day6_core.ros.programs.day6_inspector.model import Inspector
from day6_core.session.display import Window
from day6_tui.appearance.look import Look
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.windows.inspector.finding_list import FindingList
from day6_tui.windows.parts.pane_list import ListPane


class InspectorPane(ListPane[Inspector, FindingList]):
    """Keeps the list up to date."""

    needs = PaneNeeds(Extent(36, 8), Extent(50, 8), Extent(70, 14))

    def __init__(self, window: Window[Inspector], look: Look) -> None:
        super().__init__(window, look, FindingList(look))
        self.inspector = window.model
        self._shown: tuple[object, ...] = ()

    @property
    def label(self) -> str:
        return self.look.texts("inspector.title")

    def status(self) -> list[Piece]:
        if self.inspector.quiet:
            return [Piece(f" {self.look.texts('inspector.quiet')} ", self.look.colours.muted)]
        errors = sum(finding.level == "error" for finding in self.inspector.findings)
        key = "inspector.count.one" if errors == 1 else "inspector.count"
        text = self.look.texts(key, errors=errors, all=len(self.inspector.findings))
        return [Piece(f" {text} ", self.look.colours.warning if errors else self.look.colours.muted)]

    def pull(self, now: float) -> bool:
        state = (self.inspector.version, self.look.texts.language)
        if state != self._shown and self.list.is_attached:
            self._shown = state
            model = self.inspector
            self.list.show(model.findings, model.looked, model.unseen, model.quiet)
            self.touch()
        return False

    @on(FindingList.Chosen)
    def type_command(self, event: FindingList.Chosen) -> None:
        """Have the command that helps typed into a terminal."""
        event.stop()
        if event.finding.next:
            self.post_message(self.CommandChosen(self, event.finding.next))

    def restyle(self) -> None:
        self._shown = ()
        super().restyle()
