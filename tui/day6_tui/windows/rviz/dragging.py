"""Dragging in the 3-D view: which button is held, and how far it went since the last event."""

from __future__ import annotations

from textual import events

from day6_core.ros.programs.rviz2.model.views import NOMINAL_HEIGHT, View
from day6_tui.windows.rviz.view import View3D

_BUTTONS = {1: "left", 2: "middle", 3: "right"}


class Dragging:
    """Hands movements of the mouse to the view controller, in the pixels of its rules."""

    def __init__(self, view: View3D) -> None:
        self._view = view
        self._held: tuple[str, bool, bool] | None = None
        """The button, and whether Shift and Ctrl were held with it."""
        self._last = (0, 0)

    @property
    def held(self) -> bool:
        return self._held is not None

    def begin(self, event: events.MouseDown) -> bool:
        """A button goes down over the view; False if it is none that drags."""
        button = _BUTTONS.get(event.button)
        if button is None:
            return False
        self._held, self._last = (button, bool(event.shift), bool(event.ctrl)), (event.screen_x, event.screen_y)
        self._view.dragging = True
        return True

    def move(self, event: events.MouseMove, controller: View) -> None:
        """The mouse moved with the button held."""
        if self._held is None:
            return
        (button, shift, control), (x, y) = self._held, self._last
        self._last = (event.screen_x, event.screen_y)
        # The height of the picture is 600 pixels to RViz's rules; a cell is half as wide as high.
        step = NOMINAL_HEIGHT / max(1, self._view.rows)
        dx, dy = (event.screen_x - x) * step / 2, (event.screen_y - y) * step
        if control and button == "left":
            # The way the article pans the picture.
            button, shift = "middle", False
        elif control and button == "middle":
            button = "left"
        controller.drag(button, shift, dx, dy, self._view.aspect)

    def end(self) -> None:
        """The button was released."""
        self._held = None
        self._view.dragging = False
