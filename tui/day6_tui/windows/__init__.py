"""One module per kind of window. A pane is made by the name of its kind, and its module is imported only then."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Generic

from rich.segment import Segment
from textual.geometry import Region
from textual.strip import Strip

from day6_core.session.display import Model, Window
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal
from day6_tui.panes.cells import wrap
from day6_tui.panes.host import PaneHost
from day6_tui.panes.pane import Pane, PaneMessage
from day6_tui.screen.survival import PersonMessage

KINDS: dict[str, tuple[str, str]] = {
    "turtlesim": ("turtlesim", "TurtleSimPane"),
    "car": ("car", "CarPane"),
    "rqt_graph": ("rqt_graph", "RqtGraphPane"),
    "topics": ("topics", "TopicsPane"),
    "rqt": ("rqt", "RqtPane"),
    "rqt_console": ("rqt_console", "RqtConsolePane"),
    "rqt_plot": ("rqt_plot", "RqtPlotPane"),
    "rqt_bag": ("rqt_bag", "RqtBagPane"),
    "rqt_tf_tree": ("rqt_tf_tree", "RqtTfTreePane"),
    "service_caller": ("service_caller", "ServiceCallerPane"),
    "publisher": ("publisher", "PublisherPane"),
    "type_browser": ("type_browser", "TypeBrowserPane"),
    "action_browser": ("action_browser", "ActionBrowserPane"),
    "rqt_image_view": ("rqt_image_view", "ImageViewPane"),
    "showimage": ("showimage", "ShowImagePane"),
    "rqt_logger_level": ("rqt_logger_level", "LoggerLevelPane"),
    "rqt_reconfigure": ("rqt_reconfigure", "ReconfigurePane"),
    "joint_state_publisher": ("joint_state_publisher", "SlidersPane"),
    "rqt_shell": ("rqt_shell", "ShellPane"),
    "rqt_py_console": ("rqt_py_console", "PyConsolePane"),
    "rqt_robot_steering": ("rqt_robot_steering", "RobotSteeringPane"),
    "world": ("world", "WorldPane"),
    "editor": ("editor", "EditorPane"),
    "inspector": ("inspector", "InspectorPane"),
    "lesson": ("lesson", "LessonPane"),
    "rviz2": ("rviz2", "RVizPane"),
    "kitchen": ("kitchen", "KitchenPane"),
    "classroom": ("classroom", "ClassroomPane"),
}
"""Kind of window -> module in this package and class in it."""


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

    takes_focus = False
    """Whether it takes the focus when it opens, as an editor does; otherwise the focus stays in the terminal."""

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


def make_window(window: Window[object], look: Look) -> WindowPane[object]:
    """Return the pane for a window; if it cannot be made, one that shows the reason, and the program runs on."""
    try:
        module, name = KINDS[window.kind]
        pane: WindowPane[object] = getattr(import_module(f"{__name__}.{module}"), name)(window, look)
    except Exception as error:
        return BrokenPane(window, look, error)
    return pane
