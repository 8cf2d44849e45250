"""The terminal pane: shows one terminal; the others are tabs on its upper edge that show what runs and what is new."""

from __future__ import annotations

import time
import weakref
from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Offset
from textual.message import Message

from day6_tui.tui.cells import cell_len, clip, fit
from day6_tui.tui.look import Look
from day6_tui.tui.overlay import PaneHost
from day6_tui.tui.pane import Pane, Piece
from day6_tui.tui.terminal_keys import encode
from day6_tui.tui.terminal_view import TerminalView, tab_name

if TYPE_CHECKING:
    from day6_tui.core.shell.terminal import Terminal

TAB_WIDTH = 20
"""Cells the name of a tab may take."""

SHORTEST_NAME = 5
"""With fewer cells a tab's name says nothing: only its number is shown."""

WHEEL_LINES = 3

ARROWS = ("up", "down", "left", "right")

NEXT_SLICE = 0.001
"""Seconds between two slices of reading a flood, so that the threads of programs get their turn."""

NEXT_LOOK = 0.004
"""Seconds after which a flood whose output has all been read is looked at again."""

FLOOD_SECONDS = 0.1
"""A flood is over when nothing had to be read between two frames for so long."""

NEXT_PICTURE = 0.1
"""Seconds between two pictures of a flood: nobody can read faster, and drawing costs as much as reading."""


class HeldKeys:
    """Holds back keys for the terminal in which a scene types, until it has finished; Esc stops the scene."""

    def __init__(self) -> None:
        self.holding = False
        self.view: TerminalView | None = None
        """The terminal the scene types in; None before it has chosen one, when every key is held."""
        self.keys: list[events.Key] = []

    def begin(self) -> None:
        """A scene begins."""
        self.holding, self.view, self.keys = True, None, []

    def end(self) -> None:
        """It has ended; what is held is forgotten."""
        self.holding, self.view, self.keys = False, None, []

    def take(self, event: events.Key, view: TerminalView | None) -> bool:
        """Keep a key for `view`; False if it has to go there now."""
        if not self.holding or (self.view is not None and view is not self.view):
            return False
        if event.key == "escape":
            self.end()
        else:
            self.keys.append(event)
        return True


class TerminalPane(Pane):
    """Shows the active terminal and sends it the keys. Terminals belong to the desk; here are only their views."""

    help_key = "terminal"

    class ArrowEchoed(Message):
        """An arrow key went to a program that does not read single keys: it is only echoed, as ^[[A."""

        def __init__(self, pane: TerminalPane) -> None:
            super().__init__()
            self.pane = pane

        @property
        def control(self) -> TerminalPane:
            return self.pane

    def __init__(self, look: Look) -> None:
        super().__init__(look, id="terminals")
        self.views: list[TerminalView] = []
        self.active = 0
        self.key_back = "F3"
        """The key that brings the keyboard here, as of the last frame."""
        self.held = HeldKeys()
        self._early_keys: list[events.Key] = []
        self.known: weakref.WeakSet[Terminal] = weakref.WeakSet()
        """All terminals that were ever shown here."""
        self._flood_until = 0.0
        self._behind_until = 0.0
        """Until then the terminal that is shown counts as one whose output comes faster than it can be read."""
        self._drawn = 0.0
        self._reported_size: tuple[int, int] | None = None
        self._shown_title: list[tuple[str, Style]] = []
        self._shown_hint = ""
        self._drag: tuple[int, int] | None = None

    # -- the list of terminals -----------------------------------------------------------------------------------------

    @property
    def view(self) -> TerminalView | None:
        """The view of the terminal that is shown."""
        return self.views[self.active] if self.views else None

    def add(self, terminal: Terminal) -> TerminalView:
        """Show another terminal and make it the active one."""
        view = TerminalView(terminal)
        self.views.append(view)
        self.known.add(terminal)
        self.activate(len(self.views) - 1)
        return view

    def activate(self, index: int) -> None:
        """Show the terminal with this index."""
        self.active = index % len(self.views)
        view = self.views[self.active]
        view.stale()
        self._tell_size()
        self.touch()
        self.look.wake()

    def forget(self, view: TerminalView) -> None:
        """Remove a terminal that has ended."""
        index = self.views.index(view)
        self.views.remove(view)
        if self.views:
            self.activate(max(0, self.active - 1) if index < self.active else min(self.active, len(self.views) - 1))
        self.touch()

    def terminal_size(self) -> tuple[int, int]:
        """Columns and rows a terminal has here; a usable one before the first layout."""
        if not self.extent.width:
            return 80, 24
        return max(2, self.inner_width), max(1, self.inner_height)

    def _tell_size(self) -> None:
        # Every terminal has the size of the pane, so that none has to be redrawn when its tab is chosen.
        columns, rows = self.terminal_size()
        for view in self.views:
            if (view.columns, view.lines) != (columns, rows):
                view.terminal.resize(columns, rows)
                view.stale()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._tell_size()

    # -- frame ---------------------------------------------------------------------------------------------------------

    def title(self) -> list[Piece]:
        colours = self.look.colours
        pieces = []
        labels = self._labels()
        first, end = self._tabs_that_fit(labels)
        for index, label in enumerate(labels[first:end], first):
            if index == self.active:
                style = colours.title_focus if self.has_focus else colours.strong
            else:
                style = colours.title
            pieces.append(Piece(f" {label} ", style, partial(self._choose, index)))
        return pieces

    def _labels(self) -> list[str]:
        """The labels of the tabs: as much of the names as fits side by side, at least the numbers."""
        glyphs = self.look.glyphs
        names = [f"{index + 1} {tab_name(view.terminal.title)}".rstrip() for index, view in enumerate(self.views)]
        news = [index != self.active and view.terminal.has_news for index, view in enumerate(self.views)]
        room = self.inner_width - 2 * len(names) - 2 * sum(news)
        width = TAB_WIDTH
        while width > 2 and sum(min(width, cell_len(name)) for name in names) > room:
            width -= 1
        if width < SHORTEST_NAME:
            names = [str(index + 1) for index in range(len(names))]
            width = SHORTEST_NAME
        return [
            clip(name, width, glyphs.ellipsis) + f" {glyphs.news}" * new for name, new in zip(names, news, strict=True)
        ]

    def _tabs_that_fit(self, labels: list[str]) -> tuple[int, int]:
        """The first tab that is shown and the one after the last: the active one and as many beside it as fit."""
        room = self.inner_width - cell_len(labels[self.active]) - 2 if labels else 0
        first, end = self.active, self.active + 1
        while True:
            before = cell_len(labels[first - 1]) + 2 if first > 0 else 0
            after = cell_len(labels[end]) + 2 if end < len(labels) else 0
            if before and before <= room and (not after or self.active - first <= end - self.active):
                first, room = first - 1, room - before
            elif after and after <= room:
                end, room = end + 1, room - after
            elif before and before <= room:
                first, room = first - 1, room - before
            else:
                return first, end

    def _choose(self, index: int) -> None:
        self.activate(index)
        self.focus(scroll_visible=False)

    def title_right(self) -> list[Piece]:
        return self.parent.tabs_beside(self) if isinstance(self.parent, PaneHost) else []

    def status(self) -> list[Piece]:
        view = self.view
        if view is not None and view.scroll:
            return [
                Piece(
                    f" {self.look.texts('terminal.scrolled', count=view.scroll)} ",
                    self.look.colours.hint,
                    self._to_bottom,
                )
            ]
        return []

    @property
    def background(self) -> Style:
        return self.look.colours.terminal

    def _to_bottom(self) -> None:
        view = self.view
        if view is not None and view.scroll:
            view.scroll = 0
            view.stale()
            self.touch()
            self.look.wake()

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if self.extent.width and self._reported_size != self.terminal_size():
            self._reported_size = self.terminal_size()
            self._tell_size()
        view = self.view
        more = False
        if view is not None and now < self._behind_until and now - self._drawn < NEXT_PICTURE:
            more = True
        elif view is not None:
            self._drawn = now
            spans = view.changes()
            if spans:
                self.touch_spans(spans)
            if view.passed > 2 * view.lines:
                self._behind_until = now + FLOOD_SECONDS
            more = view.has_more
        hint = self._hint()
        if hint != self._shown_hint:
            self._shown_hint = hint
            self.touch_lines([self.inner_height - 1])
        title = [(piece.text, piece.style) for piece in self.title()]
        if title != self._shown_title:
            self._shown_title = title
            self.touch_frame()
        return more

    def read_flood(self) -> float | None:
        """Let the screens follow a flood of output between two frames; the seconds until the next turn, None without a flood.

        Terminals that are not shown are read, too, once their programs wait for it.
        """
        flood = None
        for view in self.views:
            if view.is_crowded or (view is self.view and view.has_more):
                view.terminal.update()
                self._flood_until = time.monotonic() + FLOOD_SECONDS
                if view.has_more:
                    flood = NEXT_SLICE
                    if view is self.view:
                        self._behind_until = self._flood_until
        if flood is None and time.monotonic() < self._flood_until:
            flood = NEXT_LOOK
        return flood

    def _hint(self) -> str:
        """The hint shown in the last line: what to do when keys do not do what the user expects."""
        view = self.view
        if view is not None and view.terminal.is_stubborn:
            return self.look.texts("terminal.stubborn")
        if view is not None and not self.has_focus and view.reading_keys:
            return self.look.texts("terminal.hint", key=self.key_back)
        return ""

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        view = self.view
        if view is None:
            return []
        hint = self._hint() if y == self.inner_height - 1 else ""
        if hint:
            return [Segment(fit(f" {hint} ", width, self.look.glyphs.ellipsis), self.look.colours.hint)]
        return view.segments(y, self.look.colours, focused=self.has_focus)

    def place_cursor(self) -> None:
        """Put the real cursor where the drawn one is: input methods open their window there."""
        view = self.view
        if view is not None and self.has_focus and view.cursor is not None:
            x, y = view.cursor
            self.app.cursor_position = Offset(x + 1, y + 1) + self.content_region.offset

    # -- keys ----------------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        event.stop()
        event.prevent_default()
        view = self.view
        if self.held.take(event, view):
            return
        if view is None:
            self._early_keys.append(event)
            return
        if event.key in ARROWS and view.only_echoes:
            self.post_message(self.ArrowEchoed(self))
        # Shift+PageUp is a terminal's own key, which many keep for themselves; alone it means nothing to a shell or a cooked
        # program, so it looks back there, too.
        if event.key in ("shift+pageup", "shift+pagedown") or (
            event.key in ("pageup", "pagedown") and not view.reading_keys
        ):
            self._scroll(self.inner_height - 1 if event.key.endswith("pageup") else 1 - self.inner_height)
            return
        if event.key == "shift+insert":
            self.paste(self.app.clipboard)
            return
        self.type_key(view, event)

    def take_early_keys(self) -> None:
        """Type the text that arrived before there was a terminal."""
        early, self._early_keys = self._early_keys, []
        for event in early:
            self.on_key(event)

    def type_key(self, view: TerminalView, event: events.Key) -> None:
        """Send a key to a terminal, whichever is shown."""
        text = encode(event.key, event.character, application_cursor=view.terminal.screen.application_cursor_keys)
        if text:
            if view is self.view:
                self._to_bottom()
            view.terminal.send(text)

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self.paste(event.text)

    def paste(self, text: str) -> None:
        """Type text that came from the clipboard."""
        view = self.view
        if view is not None and text:
            self._to_bottom()
            view.terminal.paste(text)

    def key_hints(self) -> list[tuple[str, str]]:
        return []

    # -- mouse ---------------------------------------------------------------------------------------------------------

    def _scroll(self, lines: int) -> None:
        view = self.view
        if view is not None and view.scroll_by(lines):
            self.touch()
            self.look.wake()  # the view reads its lines at the frame

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._scroll(WHEEL_LINES)

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._scroll(-WHEEL_LINES)

    def _cell(self, event: events.MouseEvent) -> tuple[int, int]:
        """Line (counted from the beginning of the scrollback) and column under the mouse."""
        view = self.views[self.active]
        line = max(0, min(self.inner_height - 1, event.y - 1))
        column = max(0, min(view.columns, event.x - 1))
        return view.history - view.scroll + line, column

    def on_mouse_down(self, event: events.MouseDown) -> None:
        view = self.view
        if view is None or self.hit(event.x, event.y) is not None:
            return
        if event.button == 2:
            self.paste(self.app.clipboard)
        elif event.button == 1:
            self._drag = self._cell(event)
            if view.selection is not None:
                view.selection = None
                self.touch()
            self.capture_mouse()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        view = self.view
        if self._drag is None or view is None:
            return
        here = self._cell(event)
        if (self._drag, here) != view.selection:
            view.selection = (self._drag, here)
            self.touch()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        self.release_mouse()
        self._drag = None
        self.copy_selection()

    def copy_selection(self) -> bool:
        """Put the selected text on the clipboard; False if there is none."""
        view = self.view
        text = view.selected_text() if view is not None else ""
        if text:
            self.app.copy_to_clipboard(text)
        return bool(text)
