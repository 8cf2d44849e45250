"""Overlays over the desktop: an overlay takes the focus, and returns it when it closes."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterable

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.containers import Container

from day6_tui.tui.arrangement import Place
from day6_tui.tui.cells import fit, wrap
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Pane, Piece


class Overlay(Pane):
    """Base of menu, help and messages. `place` returns where it is; Esc and a click outside dismiss it."""

    DEFAULT_CSS = "Overlay { layer: above; }"
    wanted_width = 64

    @property
    def background(self) -> Style:
        return self.look.colours.overlay

    def wanted_height(self, width: int) -> int:
        """Lines of the inside it would like to have at this inner width."""
        return 10

    def place(self, area: Place) -> Place:
        """The rectangle it takes inside `area`."""
        columns = min(self.wanted_width, area.width)
        rows = min(self.wanted_height(columns - 2) + 2, area.height)
        return Place(area.x + (area.width - columns) // 2, area.y + max(0, (area.height - rows) // 3), columns, rows)

    def _border(self) -> tuple:  # type: ignore[type-arg]
        return self.look.glyphs.strong_border, self.look.colours.overlay_frame

    def dismiss(self) -> None:
        """Go away."""
        if isinstance(self.parent, PaneHost):
            self.parent.close_overlay()

    def on_key(self, event: events.Key) -> None:
        event.stop()
        event.prevent_default()
        if event.key in ("escape", "ctrl+c"):
            self.dismiss()
        else:
            self.handle_overlay_key(event)

    def handle_overlay_key(self, event: events.Key) -> None:
        """Keys but Esc."""


class PaneHost(Container):
    """The container of the windows' panes: the desktop, or the screen of a single program. It has at most one overlay."""

    overlay: Overlay | None = None

    @property
    @abstractmethod
    def focused_pane(self) -> Pane | None:
        """The pane that has the focus, or had it before an overlay."""

    @abstractmethod
    def give_keyboard(self, pane: Pane) -> None:
        """Focus a pane or overlay."""

    def tabs_beside(self, pane: Pane) -> list[Piece]:
        """What else can be reached from the upper edge of `pane`."""
        return []

    def open_overlay(self, overlay: Overlay) -> None:
        """Open an overlay over the panes, replacing any other, and focus it."""
        self.close_overlay()
        self.overlay = overlay
        self.mount(overlay)
        self.give_keyboard(overlay)

    def close_overlay(self) -> None:
        """Close the overlay; the pane that had the focus gets it back."""
        if self.drop_overlay() and (pane := self.focused_pane) is not None:
            self.give_keyboard(pane)

    def drop_overlay(self) -> bool:
        """Close the overlay and leave the focus to the caller; return False if there is none."""
        overlay, self.overlay = self.overlay, None
        if overlay is not None:
            overlay.remove()
        return overlay is not None


class TextOverlay(Overlay):
    """A text to read, wrapped and scrolled. Text before a tab is a key, set apart from its explanation."""

    def __init__(self, look: Look, title: str, keys: str) -> None:
        super().__init__(look)
        self._title = title
        self._keys = keys
        self._top = 0
        self._wrapped: tuple[int, str, list[tuple[str, str]]] | None = None

    def paragraphs(self) -> list[tuple[str, str]]:
        """What is to be read: (role of the style, text)."""
        return []

    def lines(self, width: int) -> list[tuple[str, str]]:
        """The paragraphs in lines of at most `width` cells."""
        language = self.look.texts.language
        if self._wrapped is None or self._wrapped[:2] != (width, language):
            found = [(role, line) for role, text in self.paragraphs() for line in _lines_of(text, width)]
            self._wrapped = (width, language, found)
        return self._wrapped[2]

    def wanted_height(self, width: int) -> int:
        return len(self.lines(width - 2))

    def title(self) -> list[Piece]:
        return [Piece(f" {self.look.texts(self._title)} ", self.look.colours.title_focus)]

    def status(self) -> list[Piece]:
        return [Piece(f" {self.look.texts(self._keys)} ", self.look.colours.overlay_muted)]

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        lines = self.lines(width - 2)
        if self._top + y >= len(lines):
            return []
        role, text = lines[self._top + y]
        return [Segment(" ", self.background), Segment(text, getattr(self.look.colours, role))]

    def _scroll(self, lines: int) -> None:
        last = max(0, len(self.lines(self.inner_width - 2)) - self.inner_height)
        top = max(0, min(last, self._top + lines))
        if top != self._top:
            self._top = top
            self.touch()

    def handle_overlay_key(self, event: events.Key) -> None:
        page = self.inner_height - 1
        step = {"down": 1, "up": -1, "pagedown": page, "pageup": -page, "space": page, "home": -9999, "end": 9999}.get(
            event.key
        )
        if step is not None:
            self._scroll(step)
        elif event.key in ("enter", "q", "f1"):
            self.dismiss()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        event.stop()
        self._scroll(3)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        event.stop()
        self._scroll(-3)


def page_of(text: str) -> list[tuple[str, str]]:
    """A help text as paragraphs; its lines with a tab are keys with what they do."""
    return [("overlay_key" if "\t" in line else "overlay", line) for line in text.split("\n")]


KEY_WIDTH = 12
"""Cells for the keys in a list of them."""


def _lines_of(text: str, width: int) -> list[str]:
    key, tab, rest = text.partition("\t")
    if not tab:
        return wrap(text, width)
    lines = wrap(rest, width - KEY_WIDTH)
    heads = [fit(key, KEY_WIDTH - 1) + " "] + [" " * KEY_WIDTH] * (len(lines) - 1)
    return [head + line for head, line in zip(heads, lines, strict=True)]


class MessageOverlay(TextOverlay):
    """Shows an error: in plain words, and in the catalogue's or the real tool's own."""

    def __init__(self, look: Look, text: str) -> None:
        super().__init__(look, "error.title", "error.continue")
        self._text = text

    def paragraphs(self) -> list[tuple[str, str]]:
        return [("overlay", self._text)]
