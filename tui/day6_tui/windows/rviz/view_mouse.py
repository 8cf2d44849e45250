"""The mouse over the 3-D view: with the tool in use, or else turning the picture."""

from __future__ import annotations

from collections.abc import Callable

from textual import events
from textual.geometry import Region

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_tui.windows.rviz.dragging import Dragging
from day6_tui.windows.rviz.hand import Hand
from day6_tui.windows.rviz.view import View3D


class ViewMouse:
    """Hands on what the mouse does; `place` tells where the view is in the pane, whose events these are."""

    def __init__(self, rviz: RViz, view: View3D, hand: Hand, place: Callable[[], Region]) -> None:
        self._rviz = rviz
        self._hand = hand
        self._place = place
        self.dragging = Dragging(view)

    @property
    def held(self) -> bool:
        """Whether a button is held that went down over the view."""
        return self.dragging.held or self._hand.held

    def is_over(self, event: events.MouseEvent) -> bool:
        """Whether the mouse is over the view."""
        return self._place().contains(event.x, event.y)

    def _cell(self, event: events.MouseEvent) -> tuple[float, float]:
        """The place in the view, in cells: of a terminal that reports whole cells only, the middle of one."""
        x, y = (each + 0.5 if each == int(each) else each for each in (event.pointer_x, event.pointer_y))
        return x - self._place().x, y - self._place().y

    def press(self, event: events.MouseDown) -> bool:
        """A button goes down; False if it means nothing here."""
        return self.is_over(event) and (self._hand.begin(event, *self._cell(event)) or self.dragging.begin(event))

    def move(self, event: events.MouseMove) -> bool:
        """The mouse moves; False if that means nothing here."""
        if self.dragging.held:
            self.dragging.move(event, self._rviz.view)
        elif self._hand.held or (self.is_over(event) and self._hand.hovering is not None):
            self._hand.move(event, *self._cell(event))
        else:
            return False
        return True

    def release(self, event: events.MouseUp) -> bool:
        """A button goes up; False if none went down here."""
        if self._hand.held:
            self._hand.end(event, *self._cell(event))
        elif self.dragging.held:
            self.dragging.end()
        else:
            return False
        return True

    def wheel(self, event: events.MouseEvent, notches: int) -> None:
        """The wheel turns."""
        if self.is_over(event) and not self._hand.wheel(-notches):
            self._rviz.view.wheel(-notches, bool(event.shift))
