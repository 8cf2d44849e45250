"""The pane of one terminal: shows its screen and scrollback, sends it the keys, selects and copies text."""

from __future__ import annotations

import time
from collections.abc import Iterable
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Offset

from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit
from day6_tui.panes.pane import Pane, PaneMessage, Piece
from day6_tui.panes.placement import TELEOP, TERMINAL, PaneNeeds
from day6_tui.panes.splits import PanePlace
from day6_tui.terminals.held_keys import HeldKeys
from day6_tui.terminals.keys import encode
from day6_tui.terminals.teleop_keys import is_driven_otherwise, keys_of
from day6_tui.terminals.view import TerminalView, tab_name

if TYPE_CHECKING:
    from day6_core.shell.terminal import Terminal

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


class TerminalPane(Pane):
    """Shows a terminal of the desk. Before it has got one, it keeps the keys for it."""

    help_key = "terminal"

    class Said(PaneMessage):
        """Base of this pane's messages."""

        pane: TerminalPane

    class ArrowEchoed(Said):
        """An arrow key went to a program that has no use for it: it is only echoed, as ^[[A, or drives with other keys."""

    class LineClicked(Said):
        """The mouse was pressed and released on one cell of a line."""

        def __init__(self, pane: TerminalPane, line: str) -> None:
            super().__init__(pane)
            self.line = line

    class NeedsOthers(Said):
        """What the pane needs has changed with what runs in it."""

    class CloseAsked(Said):
        """The user wants to close this terminal."""

    def __init__(self, look: Look, held: HeldKeys) -> None:
        super().__init__(look)
        self._view: TerminalView | None = None
        self.key_back = "F3"
        """The key that brings the keyboard here, as of the last frame."""
        self._held = held
        self._early_keys: list[events.Key] = []
        self._flood_until = 0.0
        self._behind_until = 0.0
        """Until then the output counts as coming faster than it can be read."""
        self._drawn = 0.0
        self._was_busy = False
        self._shown_hint = ""
        self._told_needs = self.needs
        self._drag: tuple[int, int] | None = None

    # -- the terminal --------------------------------------------------------------------------------------------------

    @property
    def has_terminal(self) -> bool:
        return self._view is not None

    @property
    def view(self) -> TerminalView:
        """The view of its terminal. Raises RuntimeError before it has one (`has_terminal`)."""
        if self._view is None:
            raise RuntimeError("this pane has no terminal yet")
        return self._view

    def show(self, terminal: Terminal) -> None:
        """Show this terminal."""
        self._view = TerminalView(terminal)
        terminal.on_crowded = self.look.work_soon
        self._tell_size(*self.terminal_size())
        self.touch()
        self.look.wake()

    def take_early_keys(self) -> None:
        """Type what was typed before there was a terminal."""
        early, self._early_keys = self._early_keys, []
        for event in early:
            self.on_key(event)

    def terminal_size(self) -> tuple[int, int]:
        """Columns and rows a terminal has here; a usable one before the first layout."""
        if not self.extent.width:
            return 80, 24
        return max(2, self.inner_width), max(1, self.inner_height)

    def take_size(self, place: PanePlace) -> None:
        """While the pane is behind another: the terminal gets the size it will have in front."""
        self._tell_size(max(2, place.width - 2), max(1, place.height - 2))

    def _tell_size(self, columns: int, rows: int) -> None:
        view = self._view
        if view is not None and (view.columns, view.lines) != (columns, rows):
            view.terminal.resize(columns, rows)
            view.stale()

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        self._tell_size(*self.terminal_size())

    # -- frame ---------------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        return tab_name(self._view.terminal.title) if self._view is not None else ""

    @property
    def has_news(self) -> bool:
        return self._view is not None and bool(self._view.terminal.has_news)

    @property
    def commands(self) -> set[int]:
        """The pids of the command that occupies it."""
        front = self._view.terminal.shell.front if self._view is not None else None
        return {program.pid for program in front.programs} if front is not None else set()

    @property
    def drives(self) -> bool:
        """Whether a teleop reads its keys."""
        return self._view is not None and self._view.reading_keys and "teleop" in self._view.terminal.title

    @property
    def needs(self) -> PaneNeeds:
        """What it needs to be useful, with its frame."""
        return TELEOP if self.drives else TERMINAL

    def close(self) -> None:
        self.post_message(self.CloseAsked(self))

    def status(self) -> list[Piece]:
        view = self._view
        if view is None or not view.scroll:
            return []
        text = self.look.texts("terminal.scrolled", count=view.scroll)
        return [Piece(f" {text} ", self.look.colours.hint, self._to_bottom)]

    @property
    def background(self) -> Style:
        return self.look.colours.terminal

    def _to_bottom(self) -> None:
        view = self._view
        if view is not None and view.scroll:
            view.scroll = 0
            view.stale()
            self.touch()
            self.look.wake()

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        view = self._view
        if view is None:
            return False
        if self.extent.width:
            self._tell_size(*self.terminal_size())
        more = True
        if (busy := view.terminal.busy) is not self._was_busy:
            self._was_busy, self._behind_until = busy, 0.0  # the end of a flood is shown at once
        if now >= self._behind_until or now - self._drawn >= NEXT_PICTURE:
            self._drawn = now
            self.redraw_lines(view.changes())
            if view.passed > 2 * view.lines:
                self._behind_until = now + FLOOD_SECONDS
            more = view.has_more
        if (needs := self.needs) is not self._told_needs:
            self._told_needs = needs
            self.post_message(self.NeedsOthers(self))
        hint = self._hint(self.inner_width - 2)
        if hint != self._shown_hint:
            self._shown_hint = hint
            self.touch_lines([self.inner_height - 1])
        return more

    @property
    def in_flood(self) -> bool:
        """Whether a program prints more than frames can show, or just did. What waits otherwise is read with the next frame."""
        view = self._view
        return view is not None and (view.is_flooded or time.monotonic() < self._flood_until)

    def read_flood(self, *, shown: bool) -> float | None:
        """Let the screen follow a flood of output between two frames; the seconds until the next turn, None when it is over.

        A terminal that is not shown is read, too, once its programs wait for it.
        """
        view = self._view
        assert view is not None
        if view.is_crowded or (shown and view.has_more):
            view.terminal.update()
            self._flood_until = time.monotonic() + FLOOD_SECONDS
            if view.has_more:
                if shown:
                    self._behind_until = self._flood_until
                return NEXT_SLICE
        return NEXT_LOOK if time.monotonic() < self._flood_until else None

    def _hint(self, room: int) -> str:
        """The hint shown in the last line: what to do when keys do not do what the user expects. `room` in cells."""
        view = self._view
        if view is not None and view.terminal.is_stubborn:
            return self.look.texts("terminal.stubborn")
        if view is not None and not self.has_focus and view.reading_keys:
            texts = self.look.texts
            values = {"keys": keys_of(view.terminal.title, texts), "key": self.key_back}
            hint = texts("terminal.hint", **values)
            return hint if cell_len(hint) <= room else texts("terminal.hint.short", **values)
        return ""

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        view = self._view
        if view is None:
            return []
        hint = self._hint(width - 2) if y == self.inner_height - 1 else ""
        if hint:
            return [Segment(fit(f" {hint}", width, self.look.glyphs.ellipsis), self.look.colours.hint)]
        return view.segments(y, self.look.colours, focused=self.has_focus)

    def place_cursor(self) -> None:
        """Put the real cursor where the drawn one is: input methods open their window there."""
        view = self._view
        if view is not None and self.has_focus and view.cursor is not None:
            x, y = view.cursor
            self.app.cursor_position = Offset(x + 1, y + 1) + self.content_region.offset

    # -- keys ----------------------------------------------------------------------------------------------------------

    def keeps_keyboard(self, event: events.Event) -> bool:
        return True

    def on_key(self, event: events.Key) -> None:
        event.stop()
        event.prevent_default()
        view = self._view
        if self._held.take(event, view):
            return
        if view is None:
            self._early_keys.append(event)
            return
        if event.key in ARROWS and (
            view.only_echoes or (view.reading_keys and is_driven_otherwise(view.terminal.title))
        ):
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
        self.type_key(event)

    def type_key(self, event: events.Key) -> None:
        """Send a key to the terminal."""
        view = self.view
        text = encode(event.key, event.character, application_cursor=view.terminal.screen.application_cursor_keys)
        if text:
            self._to_bottom()
            view.terminal.send(text)

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self.paste(event.text)

    def paste(self, text: str) -> None:
        """Type text that came from the clipboard."""
        if self._view is not None and text:
            self._to_bottom()
            self._view.terminal.paste(text)

    def forget_history(self) -> None:
        """Forget what has scrolled away."""
        if self._view is not None:
            self._view.forget_history()
            self.touch()

    # -- mouse ---------------------------------------------------------------------------------------------------------

    def _scroll(self, lines: int) -> None:
        view = self._view
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
        view = self.view
        line = max(0, min(self.inner_height - 1, event.y - 1))
        column = max(0, min(view.columns, event.x - 1))
        return view.history - view.scroll + line, column

    def on_mouse_down(self, event: events.MouseDown) -> None:
        view = self._view
        if view is None or not self.is_inside(event):
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
        view = self._view
        if self._drag is None or view is None:
            return
        here = self._cell(event)
        begun = self._drag if view.selection is None else view.selection[0]  # which follows its text
        if (begun, here) != view.selection:
            view.selection = (begun, here)
            self.touch()

    def on_mouse_up(self, event: events.MouseUp) -> None:
        view, begun = self._view, self._drag
        if begun is not None:
            self.release_mouse()
            self._drag = None
            clicked = not self.copy_selection() and self.is_inside(event) and self._cell(event) == begun
            if clicked and view is not None and (line := view.whole_line(begun[0]).strip()):
                self.post_message(self.LineClicked(self, line))

    def copy_selection(self) -> bool:
        """Put the selected text on the clipboard; False if there is none."""
        view = self._view
        text = view.selected_text() if view is not None else ""
        if text:
            self.app.copy_to_clipboard(text)
        return bool(text)
