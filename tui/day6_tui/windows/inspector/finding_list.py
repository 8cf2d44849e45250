"""The inspector's findings as a list, each with the command that helps below it."""

from __future__ import annotations

from collections.abc import Sequence

from textual.message import Message
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from day6_core.ros.programs.day6_inspector.rules import Finding
from day6_core.ros.programs.day6_inspector.sight import said_of
from day6_tui.appearance.look import Look
from day6_tui.windows.parts.pane_list import ListRow, PaneList


class FindingList(PaneList):
    """What is wrong; the finding with the cursor keeps it while others come and go."""

    class Chosen(Message):
        """Enter or a click on a finding."""

        def __init__(self, finding: Finding) -> None:
            super().__init__()
            self.finding = finding

    def __init__(self, look: Look) -> None:
        super().__init__(look)
        self._findings: list[Finding] = []

    def show(
        self,
        findings: Sequence[Finding],
        looked: Sequence[tuple[str, int]] = (),
        unseen: Sequence[tuple[str, str]] = (),
        quiet: str = "",
    ) -> None:
        """Show these findings, the first one at the top, or that there are none; then what was looked at and what was not.

        `quiet` ('drill', 'exam'): why nothing is said.
        """
        at, offset = self.highlighted, self.scroll_offset.y
        chosen = self._findings[at] if at is not None and at < len(self._findings) else None
        self._findings = list(findings)
        colours, texts = self.look.colours, self.look.texts
        rows = [self._row(index, finding) for index, finding in enumerate(findings)]
        if quiet:
            rows = [ListRow(self, -1, texts(f"inspector.quiet.{quiet}"), "", colours.text)]
        elif not findings:
            rows.append(ListRow(self, -1, texts("inspector.well"), "", colours.publisher))
        rows += [ListRow(self, -1, line, "", colours.muted) for line in said_of(looked, unseen, texts)]
        self.set_options([Option(row, disabled=index >= len(findings)) for index, row in enumerate(rows)])
        if findings:
            self.scroll_to(y=offset, animate=False)
            last = len(findings) - 1
            self.highlighted = self._findings.index(chosen) if chosen in self._findings else min(at or 0, last)

    def action_cursor_down(self) -> None:
        """Go to the next finding; after the last one to the lines below, and at their end back to the first."""
        is_last = self.highlighted is None or self.highlighted == len(self._findings) - 1
        if is_last and self.scroll_offset.y < self.max_scroll_y:
            self.scroll_down(animate=False)
        else:
            super().action_cursor_down()

    def action_cursor_up(self) -> None:
        """Go to the finding before; without any, up in the lines."""
        if self.highlighted is None:
            self.scroll_up(animate=False)
        else:
            super().action_cursor_up()

    def _row(self, index: int, finding: Finding) -> ListRow:
        colours, glyphs = self.look.colours, self.look.glyphs
        mark, style = {
            "error": (glyphs.warning, colours.warning),
            "warning": (glyphs.warning, colours.text),
            "info": (glyphs.dot, colours.muted),
        }[finding.level]
        texts = self.look.texts
        text = finding.of_card(texts.language) or texts(finding.id, **dict(finding.parameters))
        below = f"$ {finding.next}" if finding.next else ""
        return ListRow(self, index, text, mark, style, below, colours.accent)

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        if event.option_index < len(self._findings):
            self.post_message(self.Chosen(self._findings[event.option_index]))
