"""What the mouse and the keys do with the tool in use, where they do not move the view."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from textual import events

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.tools.interact import Interact
from day6_core.ros.programs.rviz2.model.tools.tool import CAMERA, SCREEN, Pointer, Tool
from day6_tui.render.picking import things_in
from day6_tui.windows.rviz.view import View3D

LEFT, RIGHT = 1, 3
COARSE, FINE = (4, 2), (1, 1)
"""Columns and rows that an arrow key moves the cursor; with Shift, the finer ones."""


class Hand:
    """Tells the tool what it is pointed to; `x` and `y` are cells of the view, with fractions."""

    def __init__(self, rviz: RViz, view: View3D) -> None:
        self._rviz = rviz
        self._view = view
        self._held: tuple[Tool, int, tuple[float, float]] | None = None
        """The tool, the button and where it went down."""
        self._over: tuple[int, int] | None = None
        """The cell that the mouse is over."""

    @property
    def held(self) -> bool:
        return self._held is not None

    @property
    def tool(self) -> Tool | None:
        """The one in use, if it takes the left button and the arrow keys."""
        tool = self._rviz.tools.current
        return tool if tool is not None and tool.arrows != CAMERA else None

    @property
    def hovering(self) -> Tool | None:
        """The one in use, if it wants to know what the mouse is over."""
        tool = self._rviz.tools.current
        return tool if tool is not None and (tool.needs_hit or (isinstance(tool, Interact) and tool.things)) else None

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def begin(self, event: events.MouseDown, x: float, y: float) -> bool:
        """A button goes down over the view; False if it is the view's."""
        tool = self.tool
        if event.meta:  # Alt: as with the original's Select
            return False
        if tool is None and self._grab(event, x, y):
            return True
        if tool is None or event.button not in ((LEFT, RIGHT) if tool.takes_right else (LEFT,)):
            return False
        self._held = (tool, event.button, (x, y))
        self._view.cursor = None
        if event.button == LEFT:
            self._tell(tool, tool.press, self._pointer(tool, event, x, y))
        return True

    def _grab(self, event: events.MouseDown, x: float, y: float) -> bool:
        """Take a thing that the tool wants, though otherwise the mouse is the view's."""
        tool = self._rviz.tools.current
        if tool is None or not tool.grabs or event.button not in (LEFT, RIGHT):
            return False
        pointer = self._view.pointer(x, y, search=True)
        if not tool.wants(pointer):
            return False
        self._held = (tool, event.button, (x, y))
        pointer = pointer._replace(shift=bool(event.shift), control=bool(event.ctrl))
        self._tell(tool, tool.press if event.button == LEFT else tool.menu, pointer)
        return True

    def move(self, event: events.MouseMove, x: float, y: float) -> None:
        """The mouse moved over the view, or with the button held."""
        if self._held is not None:
            held, button, _ = self._held
            if button == LEFT:
                self._tell(held, held.drag, self._pointer(held, event, x, y))
        elif (tool := self.hovering) is not None and (int(x), int(y)) != self._over:
            self._over = int(x), int(y)
            self._tell(tool, tool.hover, self._view.pointer(x, y, search=True))

    def end(self, event: events.MouseUp, x: float, y: float) -> None:
        """The button was released."""
        assert self._held is not None
        (tool, button, start), self._held = self._held, None
        if button == RIGHT:
            self._request(tool, lambda used: used.right())
            return
        pointer = self._pointer(tool, event, x, y, start)
        self._tell(tool, tool.release, pointer)

    def _pointer(
        self, tool: Tool, event: events.MouseEvent, x: float, y: float, start: tuple[float, float] | None = None
    ) -> Pointer:
        pointer = self._view.pointer(x, y, search=tool.needs_hit or (tool.grabs and start is not None))
        inside: tuple[tuple[object, object], ...] = ()
        if start is not None and tool.needs_hit and (int(x), int(y)) != (int(start[0]), int(start[1])):
            (left, right), (top, bottom) = sorted((int(start[0]), int(x))), sorted((int(start[1]), int(y)))
            inside = things_in(self._rviz.scene, self._view.screen, left, top, right + 1, bottom + 1)
        return pointer._replace(inside=inside, shift=bool(event.shift), control=bool(event.ctrl))

    # -- keys ----------------------------------------------------------------------------------------------------------

    def arrow(self, right: int, down: int, *, fine: bool) -> bool:
        """An arrow key; False if it turns the view."""
        tool, view = self.tool, self._view
        if tool is None:
            return False
        if tool.arrows != SCREEN:
            self._request(tool, lambda used: used.arrow_key(right, -down, fine=fine))
            return True
        columns, rows = FINE if fine else COARSE
        x, y = view.cursor or (view.columns // 2, view.rows // 2)
        if view.cursor is not None:
            x, y = x + right * columns, y + down * rows
        view.cursor = max(0, min(view.columns - 1, x)), max(0, min(view.rows - 1, y))
        self._tell(tool, tool.hover, self._at_cursor())
        return True

    def enter(self) -> bool:
        """Enter: a click where the keys are; False if the tool knows no such thing."""
        tool = self.tool
        if tool is None:
            return False
        if tool.arrows != SCREEN:
            self._request(tool, lambda used: used.enter_key())
        elif self._view.cursor is None:
            return self.arrow(0, 0, fine=False)
        else:
            pointer = self._at_cursor()
            self._tell(tool, tool.press, pointer)
            self._tell(tool, tool.release, pointer)
        return True

    def wheel(self, notches: float) -> bool:
        """The wheel; False if it is the view's."""
        if self._held is None or not self._held[0].grabs:
            return False
        self._request(self._held[0], lambda used: used.wheel(notches))
        return True

    def _at_cursor(self) -> Pointer:
        x, y = self._view.cursor or (0, 0)
        return self._view.pointer(x + 0.5, y + 0.5, search=True)

    # -- the program's thread --------------------------------------------------------------------------------------------

    def _tell(self, tool: Tool, act: Callable[[Pointer], bool], pointer: Pointer) -> None:
        self._request(tool, lambda _: act(pointer))

    def _request(self, tool: Tool, action: Callable[[Tool], bool]) -> None:
        self._rviz.request(partial(self._rviz.tools.use, tool, action))
