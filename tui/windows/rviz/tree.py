"""The tree of the Displays panel as lines: which exist, which is chosen, which are visible."""

from __future__ import annotations

from day6_tui.core.ros.programs.rviz2.model.display import Display
from day6_tui.core.ros.programs.rviz2.model.manager import RViz
from day6_tui.core.ros.programs.rviz2.model.properties import Property
from day6_tui.tui.windows.rviz import panel


class Tree:
    """Follows the properties of an `RViz`; selection and scroll position are view state, and so are kept here."""

    def __init__(self, rviz: RViz) -> None:
        self._rviz = rviz
        self._seen = -1
        self._height = 1
        self.lines: list[panel.Line] = []
        self.chosen = 0
        """The index of the line that keys act on."""
        self.top = 0
        """The index of the first visible line."""

    @property
    def prop(self) -> Property | None:
        """The chosen property."""
        return self.lines[self.chosen].prop if self.chosen < len(self.lines) else None

    @property
    def display(self) -> Display | None:
        """The display that the chosen line belongs to."""
        each = self.prop
        while each is not None and not isinstance(each, Display):
            each = each.parent
        return each

    def line(self, row: int) -> panel.Line | None:
        """The line in a row of the panel."""
        index = self.top + row
        return self.lines[index] if index < len(self.lines) else None

    def follow(self) -> None:
        """Walk the tree again if the program changed it."""
        if self._rviz.tree_version != self._seen:
            self._seen = self._rviz.tree_version
            self.refresh()

    def refresh(self) -> None:
        """Walk the tree again; the chosen property stays chosen where it still is."""
        before = self.prop
        self.lines = panel.lines_of(self._rviz)
        for index, line in enumerate(self.lines):
            if line.prop is before:
                self.chosen = index
                break
        self.keep_in_sight()

    def fit(self, height: int) -> None:
        """Learn how many rows there are."""
        self._height = max(1, height)
        self.keep_in_sight()

    def keep_in_sight(self) -> None:
        """Scroll so far that the chosen line is shown."""
        self.chosen = max(0, min(self.chosen, len(self.lines) - 1))
        if self.chosen < self.top:
            self.top = self.chosen
        elif self.chosen >= self.top + self._height:
            self.top = self.chosen - self._height + 1
        self.top = max(0, min(self.top, len(self.lines) - self._height))

    def move(self, steps: int) -> None:
        """Choose a line farther down, or up."""
        self.chosen += steps
        self.keep_in_sight()

    def scroll(self, rows: int) -> None:
        """Scroll down or up; the chosen line moves along at the edge."""
        self.top = max(0, min(len(self.lines) - self._height, self.top + rows))
        self.chosen = max(self.top, min(self.chosen, self.top + self._height - 1))

    def choose(self, prop: Property) -> None:
        """Open the tree down to a property and choose it."""
        above = prop.parent
        while above is not None:
            above.expanded = True
            above = above.parent
        self.refresh()
        for index, line in enumerate(self.lines):
            if line.prop is prop:
                self.chosen = index
        self.keep_in_sight()
