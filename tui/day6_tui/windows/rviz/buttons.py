"""The buttons below the tree of the Displays panel: RViz's names, its order, its keys."""

from __future__ import annotations

from typing import NamedTuple

from textual import events
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.content import Content
from textual.geometry import Size
from textual.widgets import Button

from day6_tui.textual_private.survival import Surviving


class Label(NamedTuple):
    """What a button is called, and its key as people read it."""

    name: str
    shown: str

    @property
    def key(self) -> str:
        return self.shown.lower().replace("^", "ctrl+")


ADD = Label("Add", "a")
"""Its key is said here, in the key bar and in the lessons; RViz's own, ^N, does the same."""

LABELS = (ADD, Label("Duplicate", "^D"), Label("Remove", "^X"), Label("Rename", "^R"))
"""From the left (displays_panel.cpp). All but the first are about the display that is chosen in the tree."""


def texts_in(width: int) -> list[str]:
    """What stands on the buttons of a row of `width` cells: the names, with air and with their keys if there is room."""
    for form in (" {name} {key} ", "{name} {key}", " {name} ", "{name}"):
        texts = [form.format(name=label.name, key=label.shown) for label in LABELS]
        if sum(map(len, texts)) + len(texts) - 1 <= width:
            break
    return texts


class PanelButton(Surviving, Button):
    """A click on it leaves the keyboard where it is: the tree is what one goes on with."""

    FOCUS_ON_CLICK = False

    def __init__(self, index: int) -> None:
        name = LABELS[index].name
        super().__init__(Content(name), id=name.lower(), compact=True)
        self.styles.line_pad = 0
        self._index = index
        self._text = name
        """What there is room for in the row."""

    def get_content_width(self, container: Size, viewport: Size) -> int:
        self._text = texts_in(container.width + self.styles.margin.width)[self._index]
        return len(self._text)

    def render(self) -> Content:
        return Content(self._text)

    def on_hide(self, event: events.Hide) -> None:
        if self.has_focus:
            event.prevent_default()  # as in the tree


class PanelButtons(Horizontal):
    """The row of buttons."""

    DEFAULT_CSS = """
    PanelButtons { height: 1; width: 100%; }
    PanelButtons > PanelButton#add, PanelButtons > PanelButton#duplicate,
    PanelButtons > PanelButton#remove, PanelButtons > PanelButton#rename {
        min-width: 0; height: 1; padding: 0; margin: 0 1 0 0; border: none;
        background: $key; color: $key-text; text-style: bold; text-align: left; tint: transparent 0%;
        background-tint: transparent 0%;
        &:disabled { background: $background; color: $muted; text-style: none; text-opacity: 100%; opacity: 100%; }
        &:focus { background: $primary; color: $on-primary; text-style: $button-focus-text-style; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self._all = [PanelButton(index) for index in range(len(LABELS))]
        self.follow(has_display=False)

    def compose(self) -> ComposeResult:
        yield from self._all

    @property
    def chosen(self) -> PanelButton | None:
        """The button that has the keyboard."""
        focused = self.screen.focused  # `has_focus` changes later, and keys are quick
        return focused if isinstance(focused, PanelButton) and focused in self._all else None

    def follow(self, *, has_display: bool) -> None:
        """Let only those be pressed that can do something: `has_display` says whether a display is chosen."""
        for button in self._all[1:]:
            button.disabled = not has_display

    def choose(self, steps: int = 0) -> None:
        """Give the keyboard to the first button, or to one that lies farther right or left than the chosen one."""
        able = [button for button in self._all if not button.disabled]
        chosen = self.chosen
        at = able.index(chosen) + steps if chosen in able else 0
        self.screen.set_focus(able[max(0, min(at, len(able) - 1))], scroll_visible=False)
