"""What opens over the panes: menus, prompts, questions, messages and the manual are modal screens in one frame.

The desktop behind a modal screen goes on: programs run, and what they draw is seen around it.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Vertical
from textual.content import Content
from textual.scrollbar import ScrollBar
from textual.widget import Widget

from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.screen.poor_terminals import renderer_for
from day6_tui.textual_private.hooks import TypedAheadScreen
from day6_tui.textual_private.survival import Surviving


class Modal(Surviving, TypedAheadScreen):
    """A framed box with a title, and the keys below. Esc and a click outside close it."""

    messages_are_typed = True
    CSS_PATH = str(Path(__file__).with_suffix(".tcss"))  # absolute: Textual looks beside the module of each subclass
    AUTO_FOCUS = ""
    ALLOW_SELECT = True
    waits = False
    """Whether it has to be answered before the keys of the desktop do anything: they would do it unseen, behind it."""
    BINDINGS = [
        Binding("escape", "close", show=False),
        Binding("ctrl+c", "copy_or_close", show=False),
    ]

    def __init__(self, look: Look, title: str, keys: str = "") -> None:
        super().__init__(classes=f"-{look.glyphs.name}")
        self.look = look
        self._heading = title
        self._keys = keys
        self.about: Widget | None = None
        """The pane that it asks or searches something about."""

    def inside(self) -> ComposeResult:
        """The widgets in the frame."""
        yield from ()

    @property
    def keyboard(self) -> Widget | None:
        """The widget that gets the keys at first."""
        return None

    def compose(self) -> ComposeResult:
        with Vertical(id="frame") as frame:
            frame.border_title = plain(self._heading)
            frame.border_subtitle = plain(self._keys) if self._keys else None
            yield from self.inside()

    def on_mount(self) -> None:
        ScrollBar.renderer = renderer_for(self.look)
        self.set_focus(self.keyboard, scroll_visible=False)
        self.take_early_keys()

    def on_click(self, event: events.Click) -> None:
        """Close at a click beside the frame."""
        if self.get_widget_at(*event.screen_offset)[0] is self:
            self.close()

    def action_close(self) -> None:
        """Esc."""
        self.close()

    def action_copy_or_close(self) -> None:
        """Ctrl-C copies what is selected, as everywhere; without a selection it is Esc."""
        if self.get_selected_text():
            self.action_copy_text()
            self.clear_selection()
        else:
            self.close()

    def accept(self) -> None:
        """Enter in a line to type in."""

    def delete(self) -> None:
        """Del at the end of a line to type in."""

    def close(self) -> None:
        """Go away, if that has not happened already: quick keys may ask twice."""
        if self.is_active:
            self.dismiss()
            self.look.wake()


def plain(text: str) -> Content:
    """Text that is no markup, with its control characters written out."""
    return Content(one_line(text))


def lines_of(text: str) -> Iterator[Content]:
    """The lines of a longer text, each without markup, control characters written out."""
    return map(plain, text.replace("\t", "    ").split("\n"))
