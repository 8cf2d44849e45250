"""The windows of programs, in rooms: the pane of a kind of window is in the module of that name, imported when one opens.

A new kind is a module here, and its texts (`help.<kind>` and `manual.<kind>` for its page of the help).
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Generic, cast

from rich.segment import Segment
from textual import events
from textual.geometry import Region
from textual.strip import Strip

from day6_core.session.display import Model, Window
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal
from day6_tui.panes.cells import wrap
from day6_tui.panes.host import PaneHost
from day6_tui.panes.pane import Pane, PaneMessage
from day6_tui.panes.placement import OTHER
from day6_tui.textual_private.survival import PersonMessage


class WindowPane(Pane, Generic[Model]):
    """Base of the panes that draw a program's window."""

    class Failed(PaneMessage):
        """The window could not be drawn."""

        pane: WindowPane[object]

        def __init__(self, pane: WindowPane[object], error: Exception) -> None:
            super().__init__(pane)
            self.error = error

    class KeyboardWanted(PaneMessage, PersonMessage):
        """Somebody types what this window gets, but the keyboard is elsewhere: what is typed has to be seen."""

    class CommandChosen(PaneMessage, PersonMessage):
        """A command of the window's is to be typed into a terminal."""

        def __init__(self, pane: Pane, command: str) -> None:
            super().__init__(pane)
            self.command = command

    needs = OTHER
    """What it needs to be useful, with its frame."""

    about = ""
    """What it is about, if it is to be seen beside other windows about it: no such window covers another one."""

    takes_focus = False
    """Whether it takes the focus when it opens: editors, and windows of rqt that were asked for by a command in the foreground.

    All others leave it in the terminal, however they were started: at RViz, the sliders or a picture one goes on typing, Ctrl-C
    among it. F8 at the terminal that such a window occupies enlarges the window (`Arranging.enlarge`).
    """

    covers_keyboard = False
    """Whether it may lie over the pane that has the keyboard, because it gets it: rather than over a lesson that one reads."""

    closes_on_quit = False
    """Whether ^Q closes this window, as it closes a file in an editor; otherwise it ends the desktop."""

    def __init__(self, window: Window[Model], look: Look) -> None:
        super().__init__(look)
        self.window = window
        self.model: Model = window.model
        self.help_key = window.kind
        if window.chosen:
            self.takes_focus = self.covers_keyboard = True
        self._failed = False

    def render_lines(self, crop: Region) -> list[Strip]:
        try:
            return super().render_lines(crop)
        except Exception as error:
            # A window that cannot be drawn must not take the desktop with it.
            if not self._failed:
                self._failed = True
                self.post_message(self.Failed(self, error))
            return [Strip.blank(crop.width, self.background)] * crop.height

    @property
    def label(self) -> str:
        """The window's name on frames and in lists: the program's, as on a real desktop."""
        return self.window.title

    def close(self) -> None:
        """Close the window at the user's request; one that would lose something asks first."""
        self.window.close_by_user()

    def loses_at_the_end(self) -> str:
        """Keep what can be kept; return what is lost if the desktop ends now, and why, or ''."""
        return ""

    def kept_view(self) -> str:
        """What the window shows and comes back with the desktop, '' if there is nothing to keep."""
        return ""

    def take_view(self, view: str) -> None:
        """Show again what `kept_view` told. Raises ValueError for what it did not."""

    # -- keys and mouse ------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        if self._press(event.key, event.character or ""):
            event.stop()
            event.prevent_default()
            self._redraw()

    def _press(self, key: str, character: str) -> bool:
        """Use a key; return whether it is one of the window's."""
        return False

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        self._wheel(event, 1)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        self._wheel(event, -1)

    def _wheel(self, event: events.MouseEvent, notches: int) -> None:
        """Use the mouse wheel, turned down (1) or up (-1)."""

    def _redraw(self) -> None:
        """Show what the user has changed."""
        self.look.wake()

    # -- asking --------------------------------------------------------------------------------------------------------

    def ask(self, title: str, value: str, taken: Callable[[str], str | None], *, note: str = "") -> None:
        """Ask for a line of text: `taken` gets it and returns what is wrong with it, or None."""
        from day6_tui.overlays.prompt import Prompt

        self.lay_over(Prompt(self.look, title, value, taken, note=note))

    def lay_over(self, modal: Modal) -> None:
        """Open a prompt or menu over the desktop."""
        if isinstance(self.parent, PaneHost):
            self.parent.open_overlay(modal, about=self)


class BrokenPane(WindowPane[object]):
    """Shows, in place of a window that cannot be drawn, the reason."""

    def __init__(self, window: Window[object], look: Look, error: Exception) -> None:
        super().__init__(window, look)
        self._error = error

    def content_line(self, y: int, width: int) -> list[Segment]:
        reason = f"{type(self._error).__name__}: {self._error}"
        lines = wrap(self.look.texts("error.window", reason=reason), width)
        return [Segment(lines[y], self.look.colours.warning)] if y < len(lines) else []


def pane_class(kind: str) -> type[WindowPane[object]]:
    """Return the class of a kind of window: the one of the module of that name that is written for a certain model.

    Raises:
        LookupError: there is no such window.
    """
    for file in Path(__file__).parent.glob(f"*/{kind}.py"):
        module = import_module(f"{__name__}.{file.parent.name}.{kind}")
        for each in vars(module).values():
            own = isinstance(each, type) and issubclass(each, WindowPane) and each.__module__ == module.__name__
            if own and not getattr(each, "__parameters__", ()):
                return cast("type[WindowPane[object]]", each)
    raise LookupError(f"no window of the kind {kind!r}")


def make_window(window: Window[object], look: Look) -> WindowPane[object]:
    """Return the pane for a window; if it cannot be made, one that shows the reason, and the program runs on."""
    try:
        return pane_class(window.kind)(window, look)
    except Exception as error:
        return BrokenPane(window, look, error)
