"""The inspector's findings as a list: Textual's OptionList, whose entries are as high as their text needs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rich.segment import Segment
from textual import events
from textual.message import Message
from textual.scrollbar import ScrollBar
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions, Visual
from textual.widgets import OptionList

from day6_tui.core.ros.programs.day6_inspector.rules import Finding
from day6_tui.tui.cells import fit, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.poor_terminals import renderer_for
from day6_tui.tui.scrollbars import colour_scrollbar
from day6_tui.tui.survival import survive

MARK = 3
"""Cells before the text, for the mark of its level."""


class FindingList(OptionList):
    """What is wrong; the finding with the cursor keeps it while others come and go."""

    def __init__(self, look: Look) -> None:
        super().__init__(compact=True, markup=False)
        self._look = look
        self._findings: list[Finding] = []
        self.take_look(look)

    async def on_event(self, event: events.Event) -> None:
        await survive(self.app, event, super().on_event(event))

    async def _on_message(self, message: Message) -> None:
        await survive(self.app, message, super()._on_message(message))

    def take_look(self, look: Look) -> None:
        """Take the colours and characters of the desktop."""
        ScrollBar.renderer = renderer_for(look)
        colour_scrollbar(self, look)
        self.refresh()

    def show(self, findings: Sequence[Finding]) -> None:
        """Show these findings, the first one at the top."""
        at, offset = self.highlighted, self.scroll_offset.y
        chosen = self._findings[at] if at is not None and at < len(self._findings) else None
        self._findings = list(findings)
        self.display = bool(findings)
        self.set_options([Row(finding, self._look, self, index) for index, finding in enumerate(findings)])
        self.scroll_to(y=offset, animate=False)
        if findings:
            self.highlighted = (
                self._findings.index(chosen) if chosen in self._findings else min(at or 0, len(findings) - 1)
            )

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()


class Row(Visual):
    """A finding as Textual draws it in the list: the mark of its level, and the text beside it."""

    def __init__(self, finding: Finding, look: Look, list_: FindingList, index: int) -> None:
        self._finding = finding
        self._look = look
        self._list = list_
        self._index = index

    def _lines(self, width: int) -> list[str]:
        text = self._look.texts(self._finding.id, **dict(self._finding.parameters))
        return wrap(text, max(10, width - MARK - 1))

    def render_strips(self, width: int, height: int | None, style: Style, options: RenderOptions) -> list[Strip]:
        colours, glyphs = self._look.colours, self._look.glyphs
        mark, own = {
            "error": (glyphs.warning, colours.warning),
            "warning": (glyphs.warning, colours.text),
            "info": (glyphs.dot, colours.muted),
        }[self._finding.level]
        chosen = self._list.highlighted == self._index and self._list.has_focus
        drawn = colours.choice if chosen else own
        return [
            Strip([Segment(fit(f" {mark if not number else ' '} {line}", width), drawn)], width)
            for number, line in enumerate(self._lines(width))
        ]

    def get_optimal_width(self, rules: Any, container_width: int) -> int:
        return container_width

    def get_minimal_width(self, rules: Any) -> int:
        return 1

    def get_height(self, rules: Any, width: int) -> int:
        return len(self._lines(width))
