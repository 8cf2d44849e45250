"""rqt's window: the list of windows to choose from."""

from __future__ import annotations

from collections.abc import Iterable

from rich.segment import Segment
from textual import events

from day6_tui.core.ros.programs.rqt_gui.model import Menu
from day6_tui.core.session.display import Window
from day6_tui.tui.cells import clip
from day6_tui.tui.look import Look
from day6_tui.tui.windows import WindowPane


class RqtPane(WindowPane[Menu]):
    """Draws `Menu.plugins`; keeps which one the cursor is on."""

    def __init__(self, window: Window[Menu], look: Look) -> None:
        super().__init__(window, look)
        self.menu = window.model
        self._at = 0

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        colours, plugins = self.look.colours, self.menu.plugins
        if y == 0:
            return [
                Segment(" " + clip(self.look.texts("rqt.plugins"), width - 1, self.look.glyphs.ellipsis), colours.muted)
            ]
        if not 1 <= y <= len(plugins):
            return ()
        plugin, on = plugins[y - 1], y - 1 == self._at
        text = f" {y} {plugin.title:<16}"
        note = f" {plugin.package:<12} {self.look.texts(f'rqt.about.{plugin.package}')}"
        return [
            Segment(f" {self.look.glyphs.marker if on else ' '}", colours.accent),
            Segment(text, colours.choice if on and self.has_focus else colours.strong),
            Segment(clip(note, max(0, width - 2 - len(text)), self.look.glyphs.ellipsis), colours.muted),
        ]

    def key_hints(self) -> list[tuple[str, str]]:
        return [("Enter", self.look.texts("rqt.open"))]

    def on_key(self, event: events.Key) -> None:
        plugins = self.menu.plugins
        if event.key in ("up", "down"):
            self._at = (self._at + (1 if event.key == "down" else -1)) % len(plugins)
            self.touch()
        elif event.key == "enter":
            self.menu.choose(plugins[self._at])
        elif event.key.isdigit() and 1 <= int(event.key) <= len(plugins):
            self.menu.choose(plugins[int(event.key) - 1])
        else:
            return
        event.stop()
        event.prevent_default()

    def on_click(self, event: events.Click) -> None:
        super().on_click(event)
        line = event.y - self.inner_offset
        if 1 <= line <= len(self.menu.plugins):
            self.menu.choose(self.menu.plugins[line - 1])
