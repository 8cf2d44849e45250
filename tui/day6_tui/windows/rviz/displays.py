"""The Displays panel of the RViz window: the tree, the buttons below it, and the line for a value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual import events
from textual.app import ComposeResult
from textual.containers import Vertical

from day6_core.ros.programs.rviz2.model.properties import Property
from day6_tui.appearance.look import Look
from day6_tui.overlays.prompt import Taken
from day6_tui.windows.rviz import panel
from day6_tui.windows.rviz.buttons import PanelButtons
from day6_tui.windows.rviz.tree import PropertyTree

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_tui.windows.rviz.value_line import ValueLine

LOWEST_WITH_BUTTONS = 4
"""Rows that the panel must have to spare one for the buttons."""

NARROWEST_LINE = 16
"""Cells of the line for a value, also where its column is narrower."""


class DisplaysPanel(Vertical):
    """Its keys and messages are handled by the window, whose view most of them are about too."""

    DEFAULT_CSS = """
    DisplaysPanel { layers: tree value; background: $background; overflow: hidden; }
    """

    def __init__(self, rviz: RViz, look: Look) -> None:
        super().__init__()
        self._look = look
        self.properties = PropertyTree(rviz, look)
        self.buttons = PanelButtons()
        self.value_line: ValueLine | None = None
        """Where a value is typed at present."""
        self._seen_line = False
        """Whether it was in sight already."""

    def compose(self) -> ComposeResult:
        yield self.properties
        yield self.buttons

    def on_resize(self, event: events.Resize) -> None:
        self.buttons.display = event.size.height >= LOWEST_WITH_BUTTONS
        self._look.wake()

    def on_click(self, event: events.Click) -> None:
        """Beside the buttons: not for the window, which counts cells from its own corner."""
        event.stop()

    def pull(self, *, active: bool) -> None:
        """Follow the program. `active`: the panel has the keyboard."""
        self.properties.follow(active=active and self.buttons.chosen is None)
        self.follow_choice()
        self._place_line()

    def follow_choice(self) -> None:
        """Let the buttons be pressed that are about what is chosen."""
        has_display, button = self.properties.chosen_display is not None, self.buttons.chosen
        if not has_display and button is not None and button.id != "add":
            self.screen.set_focus(self.properties, scroll_visible=False)
        self.buttons.follow(has_display=has_display)

    def choose_button(self, steps: int = 0) -> None:
        """Give the keyboard to the first button, or to one that lies farther right or left than the chosen one."""
        self.follow_choice()
        self.buttons.choose(steps)

    # -- typing a value ------------------------------------------------------------------------------------------------

    def type_value(self, prop: Property, taken: Taken) -> None:
        """Let a value be typed in its place; `taken` gets it, and returns what is wrong with it."""
        from day6_tui.windows.rviz.value_line import ValueLine

        self.close_line()
        self.value_line = line = ValueLine(self._look, prop, taken, self.close_line)
        self._seen_line = False
        self._place_line()
        self.mount(line)
        self.screen.set_focus(line, scroll_visible=False)

    def close_line(self) -> None:
        """Take the line for a value away."""
        if (line := self.value_line) is None:
            return
        self.value_line, line.over = None, True
        if self.screen.focused is line:
            self.screen.set_focus(self.properties, scroll_visible=False)
        line.remove()
        self._look.wake()

    def _place_line(self) -> None:
        """Keep the line on that of its property; close it with the value typed so far when that goes out of sight."""
        if (line := self.value_line) is None:
            return
        tree = self.properties
        node = tree.node_of(line.prop)
        y = node.line - int(tree.scroll_offset.y) if node is not None else -1
        if node is None or node.data is None:
            self.close_line()
            return
        if self._seen_line and not 0 <= y < tree.size.height:
            self.screen.set_focus(tree, scroll_visible=False)
            return
        width = tree.size.width
        x = max(0, min(panel.value_column(node.data, width), width - NARROWEST_LINE))
        self._seen_line = 0 <= y < tree.size.height
        line.styles.offset = (x, max(0, y))
        line.styles.width = width - x
