"""One module per kind of window. A window's pane is made for a kind by name, and its module imported only then."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual.geometry import Region
from textual.strip import Strip

from day6_tui.core.session.display import Window
from day6_tui.tui.cells import wrap
from day6_tui.tui.look import Look
from day6_tui.tui.pane import Pane, Piece

if TYPE_CHECKING:
    from day6_tui.tui.overlay import Overlay

KINDS: dict[str, tuple[str, str]] = {
    "turtlesim": ("turtlesim", "TurtleSimPane"),
    "car": ("car", "CarPane"),
    "rqt_graph": ("rqt_graph", "RqtGraphPane"),
    "topics": ("topics", "TopicsPane"),
    "rqt": ("rqt", "RqtPane"),
    "rqt_console": ("rqt_console", "RqtConsolePane"),
    "rqt_plot": ("rqt_plot", "RqtPlotPane"),
    "joint_state_publisher": ("joint_state_publisher", "SlidersPane"),
    "world": ("world", "WorldPane"),
    "editor": ("editor", "EditorPane"),
    "inspector": ("inspector", "InspectorPane"),
    "rviz2": ("rviz2", "RVizPane"),
}
"""Kind of window -> module in this package and class in it."""


class WindowPane(Pane):
    """Base of the panes that draw a program's window: its number, its title with the others' names, its model."""

    takes_focus = False
    """Whether the keyboard goes to it when it opens, as to an editor; else it stays in the terminal."""

    def __init__(self, window: Window, look: Look) -> None:
        super().__init__(look)
        self.window = window
        self.model = window.model
        self.help_key = window.kind
        self._failed = False

    @property
    def number(self) -> int:
        return self.window.number

    def render_lines(self, crop: Region) -> list[Strip]:
        try:
            return super().render_lines(crop)
        except Exception as error:
            # A window that cannot be drawn must not take the desktop with it.
            if not self._failed:
                self._failed = True
                self.app.call_later(self.app.window_failed, self, error)  # type: ignore[attr-defined]
            return [Strip.blank(crop.width, self.background)] * crop.height

    @property
    def label(self) -> str:
        """The window's name on frames and in lists: that of the program, as on a real desktop."""
        return self.window.title

    def title(self) -> list[Piece]:
        colours = self.look.colours
        style = colours.title_focus if self.has_focus else colours.title
        return [Piece(f" {self.label} ", style)]

    def title_right(self) -> list[Piece]:
        from day6_tui.tui.desktop import Desktop

        desktop = self.parent
        others = desktop.other_tabs(self) if isinstance(desktop, Desktop) and desktop.active == self.number else []
        close = Piece(f" {self.look.glyphs.close} ", self.look.colours.title, self.close)
        return [*others, close]

    def close(self) -> None:
        """Close the window for the user; one that would lose something asks first."""
        self.window.close_by_user()

    def loses_at_the_end(self) -> str:
        """What is lost if the desktop ends now, and why; '' for nothing. Keeps what can be kept."""
        return ""

    def ask(self, title: str, value: str, taken: Callable[[str], str | None], *, note: str = "") -> None:
        """Ask for a line of text: `taken` gets it and returns what is wrong with it, or None."""
        from day6_tui.tui.prompt import Prompt

        self.lay_over(Prompt(self.look, title, value, taken, note=note))

    def lay_over(self, overlay: Overlay) -> None:
        """Lay a prompt or menu over the desktop."""
        open_overlay = getattr(self.parent, "open_overlay", None)
        if open_overlay is not None:
            open_overlay(overlay)


class BrokenPane(WindowPane):
    """What is shown for a window that cannot be drawn: the reason, in the place of the picture."""

    def __init__(self, window: Window, look: Look, error: Exception) -> None:
        super().__init__(window, look)
        self._error = error

    def content_line(self, y: int, width: int) -> list[Segment]:
        reason = f"{type(self._error).__name__}: {self._error}"
        lines = wrap(self.look.texts("error.window", reason=reason), width)
        return [Segment(lines[y], self.look.colours.warning)] if y < len(lines) else []


def make_window(window: Window, look: Look) -> WindowPane:
    """The pane for a window. A window whose pane cannot be made gets one that says why; the program runs on."""
    try:
        module, name = KINDS[window.kind]
        pane: WindowPane = getattr(import_module(f"{__name__}.{module}"), name)(window, look)
    except Exception as error:
        return BrokenPane(window, look, error)
    return pane
