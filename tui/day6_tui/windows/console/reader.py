"""A message of the console in full, over the desktop."""

from __future__ import annotations

from pathlib import Path

from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import VerticalScroll
from textual.content import Content
from textual.widget import Widget
from textual.widgets import Static

from day6_core.ros.programs.rqt_console.model import Record
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, lines_of, plain
from day6_tui.windows.console.table import whole_time

LONGEST = 50_000
"""Characters of a message that are shown."""


class ConsoleReader(Modal):
    """All that is known of a message; it can be scrolled, selected and copied."""

    CSS = Path(__file__).with_suffix(".tcss").read_text(encoding="utf-8")
    BINDINGS = [Binding("enter,q", "close", show=False)]

    def __init__(self, look: Look, record: Record) -> None:
        super().__init__(look, f"#{record.number} {record.severity}", look.texts("error.continue"))
        self._record = record

    def inside(self) -> ComposeResult:
        record, texts = self._record, self.look.texts
        text = record.text if len(record.text) <= LONGEST else record.text[:LONGEST] + self.look.glyphs.ellipsis
        facts = (("node", record.node), ("stamp", whole_time(record.stamp_ns)), ("location", record.location))
        heads = [plain(texts("list.head", name=texts(f"console.{key}")) + text) for key, text in facts if text]
        self._scroll = VerticalScroll(
            Static(Content("\n").join(heads), classes="note"),
            Static(Content("\n").join(["", *lines_of(text)]), classes="text"),
        )
        yield self._scroll

    @property
    def keyboard(self) -> Widget:
        return self._scroll
