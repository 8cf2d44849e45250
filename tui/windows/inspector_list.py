"""The inspector's findings as a list: Textual's OptionList, whose entries are as high as their text needs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rich.segment import Segment
from rich.style import Style as RichStyle
from textual import events
from textual.message import Message
from textual.scrollbar import ScrollBar
from textual.strip import Strip
from textual.style import Style
from textual.visual import RenderOptions, Visual
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from day6_tui.core.ros.programs.day6_inspector.rules import Finding
from day6_tui.tui.cells import fit, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.poor_terminals import renderer_for
from day6_tui.tui.scrollbars import colour_scrollbar
from day6_tui.tui.survival import survive


class FindingList(OptionList):
    """What is wrong; the finding with the cursor keeps it while others come and go."""

    def __init__(self, look: Look) -> None:
        super().__init__(compact=True, markup=False)
        self.look = look
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
        """Show these findings, the first one at the top; if there are none, that all is well."""
        at, offset = self.highlighted, self.scroll_offset.y
        chosen = self._findings[at] if at is not None and at < len(self._findings) else None
        self._findings = list(findings)
        if not findings:
            colours, texts = self.look.colours, self.look.texts
            well = Row(self, 0, texts("inspector.well"), "", colours.publisher)
            self.set_options([Option(well, disabled=True)])
            return
        self.set_options([self._row(index, finding) for index, finding in enumerate(findings)])
        self.scroll_to(y=offset, animate=False)
        last = len(findings) - 1
        self.highlighted = self._findings.index(chosen) if chosen in self._findings else min(at or 0, last)

    def _row(self, index: int, finding: Finding) -> Row:
        colours, glyphs = self.look.colours, self.look.glyphs
        mark, style = {
            "error": (glyphs.warning, colours.warning),
            "warning": (glyphs.warning, colours.text),
            "info": (glyphs.dot, colours.muted),
        }[finding.level]
        text = self.look.texts(finding.id, **dict(finding.parameters))
        return Row(self, index, text, mark, style)

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()


class Row(Visual):
    """A finding as Textual draws it in the list: the mark of its level, and the text beside it."""

    def __init__(self, findings: FindingList, index: int, text: str, mark: str, style: RichStyle) -> None:
        self._list = findings
        self._index = index
        self._text = text
        self._mark = mark
        self._style = style

    def _lines(self, width: int) -> list[str]:
        before = f" {self._mark} " if self._mark else " "
        lines = wrap(self._text, max(10, width - len(before) - 1))
        return [(before if not number else " " * len(before)) + line for number, line in enumerate(lines)]

    def render_strips(self, width: int, height: int | None, style: Style, options: RenderOptions) -> list[Strip]:
        findings = self._list
        chosen = findings.highlighted == self._index and findings.has_focus
        drawn = findings.look.colours.choice if chosen else self._style
        return [Strip([Segment(fit(line, width), drawn)], width) for line in self._lines(width)]

    def get_optimal_width(self, rules: Any, container_width: int) -> int:
        return container_width

    def get_minimal_width(self, rules: Any) -> int:
        return 1

    def get_height(self, rules: Any, width: int) -> int:
        return len(self._lines(width))
