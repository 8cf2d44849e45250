"""The Displays panel of the RViz window: the tree, the buttons below it, and what keys and clicks do there."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from rich.segment import Segment
from textual.strip import Strip

from day6_tui.core.ros.programs.rviz2.model.display import Display
from day6_tui.core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_tui.tui.windows.rviz import dialogs, panel
from day6_tui.tui.windows.rviz.buttons import Buttons
from day6_tui.tui.windows.rviz.tree import Tree

if TYPE_CHECKING:
    from day6_tui.tui.windows.rviz2 import RVizPane

LOWEST_WITH_BUTTONS = 4
"""Rows that the panel must have to spare one for the buttons."""

_END = 1_000_000


class DisplaysPanel:
    """Draws itself row by row. What is chosen, and whether the tree or a button has the keyboard, is kept here."""

    def __init__(self, pane: RVizPane) -> None:
        rviz = pane.rviz
        self._pane = pane
        self.tree = Tree(rviz)
        self.buttons = Buttons(
            lambda: self.tree.display,
            lambda: dialogs.add(pane),
            duplicate=lambda display: pane.request(partial(rviz.duplicate_display, display)),
            remove=lambda display: pane.request(partial(rviz.remove_display, display)),
            rename=lambda display: dialogs.rename(pane, display),
        )
        self._height = 1
        self._shown: dict[int, tuple[object, ...]] = {}
        """What the rows that are shown look like."""

    @property
    def _button_row(self) -> int:
        """The row of the buttons, -1 if there is none."""
        return self._height - 1 if self._height >= LOWEST_WITH_BUTTONS else -1

    def fit(self, height: int) -> None:
        """Learn how many rows there are."""
        self._height = height
        self.tree.fit(height - 1 if self._button_row >= 0 else height)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def changed(self, *, active: bool) -> list[int]:
        """Follow the program; return the rows that look other than at the last call. `active`: the panel has the keyboard."""
        self.tree.follow()
        states = {row: self._state(row, active) for row in range(self._height)}
        changed = [row for row, state in states.items() if self._shown.get(row) != state]
        self._shown = states
        return changed

    def _state(self, row: int, active: bool) -> tuple[object, ...]:
        """What a row looks like depends on this."""
        if row == self._button_row:
            return (self.tree.display is None, self.buttons.chosen, active)
        line = self.tree.line(row)
        if line is None:
            return ()
        prop = line.prop
        level = prop.statuses.level if isinstance(prop, Display) else 0
        chosen = prop is self.tree.prop
        on_tree = active and self.buttons.chosen is None
        return (prop, line.depth, prop.name, prop.value, prop.expanded, line.can_open, level, chosen, on_tree)

    def segments(self, row: int, width: int, *, active: bool) -> list[Segment]:
        """One row in exactly `width` cells."""
        if not self.tree.lines:
            self.tree.refresh()
        look = self._pane.look
        if row == self._button_row:
            strip = Strip(self.buttons.segments(width, look, active=active))
            return list(strip.adjust_cell_length(width, self._pane.background))
        line = self.tree.line(row)
        if line is None:
            return [Segment(" " * width, self._pane.background)]
        on_tree = active and self.buttons.chosen is None
        return panel.segments_of(line, width, look, line.prop is self.tree.prop, on_tree)

    # -- keys and clicks -----------------------------------------------------------------------------------------------

    def click(self, x: int, row: int, width: int, *, double: bool) -> None:
        """The mouse was clicked in a row of the panel, which is `width` cells wide."""
        if row == self._button_row:
            self.buttons.press_at(x, width)
            return
        self.buttons.chosen = None
        line = self.tree.line(row)
        if line is None:
            return
        self.tree.chosen = self.tree.top + row
        zone = panel.zones(line, width)
        if line.can_open and zone.opener <= x <= zone.opener + 1:
            self._pane.open_branch(line.prop, not line.prop.expanded)
        elif zone.box is not None and zone.box <= x < zone.box + 3:
            self._pane.toggle(line.prop)
        elif x >= zone.value or double:
            self._pane.edit()

    def key(self, key: str) -> bool:
        """A key was pressed while the panel has the keyboard; False if it means nothing here."""
        if self.buttons.chosen is not None:
            return self._button_key(key)
        if key == "down" and self._button_row >= 0 and self.tree.chosen >= len(self.tree.lines) - 1:
            self.buttons.chosen = 0
            return True
        page = max(1, self._height - 2)
        steps = {"up": -1, "down": 1, "pageup": -page, "pagedown": page, "home": -_END, "end": _END}
        if key in steps:
            self.tree.move(steps[key])
            self._pane.status_bar.hurry()
            return True
        prop = self.tree.prop
        action = self._actions(prop).get(key) if prop is not None else None
        if action is not None:
            action()
        return action is not None

    def _button_key(self, key: str) -> bool:
        if key in ("left", "right"):
            self.buttons.move(1 if key == "right" else -1)
        elif key in ("up", "escape"):
            self.buttons.chosen = None
        elif key in ("enter", "space"):
            self.buttons.press()
        else:
            return key == "down"
        return True

    def _actions(self, prop: Property) -> dict[str, Callable[[], object]]:
        """Key -> what it does to the chosen line, and to the display it belongs to."""
        pane = self._pane
        actions: dict[str, Callable[[], object]] = {
            "right": partial(pane.open_branch, prop, True),
            "left": partial(self._close_or_up, prop),
            "enter": pane.edit,
            "space": partial(pane.toggle, prop) if prop.kind == BOOL else lambda: None,
        }
        actions |= {button.key: button.press for button in self.buttons.all() if button.press is not None}
        if (display := self.tree.display) is not None:
            actions["delete"] = actions["ctrl+x"]
            for step, key in ((-1, "shift+up"), (1, "shift+down")):
                actions[key] = partial(pane.request, partial(pane.rviz.move_display, display, step))
        return actions

    def _close_or_up(self, prop: Property) -> None:
        if prop.expanded and prop.children:
            self._pane.open_branch(prop, False)
        elif prop.parent is not None and prop.parent.parent is not None:
            self._pane.choose(prop.parent)
