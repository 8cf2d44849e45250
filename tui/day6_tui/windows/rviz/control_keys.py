"""Keys that grasp the controls of interactive markers, as the mouse does.

What is chosen and held is known here at once, so that every key finds what the ones before it did; the program follows.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from day6_core.ros.programs.rviz2.model.displays.control_drag import DRAGGABLE
from day6_core.ros.programs.rviz2.model.displays.control_keys import BOTH
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.tools.interact import Interact, Thing


class ControlKeys:
    """Each key returns False where it means nothing to a control, so that it is the view's."""

    def __init__(self, rviz: RViz) -> None:
        self._rviz = rviz
        self.at: Thing | None = None
        """The control that the keys are at."""
        self.holds = False
        """Whether they hold it, so that the arrows move it."""
        self.turning = False
        """Whether they turn it, if they could move it, too."""

    def forget(self) -> None:
        """Another tool is in use."""
        self.at, self.holds, self.turning = None, False, False

    def next(self, step: int) -> bool:
        """Go to the next control (1), or the one before (-1), with the tool for them; False if there is none."""
        tools = self._rviz.tools
        if (tool := tools.interact) is None or not (things := tool.things):
            self.forget()
            return False
        if tools.current is not tool:
            self._rviz.request(partial(tools.choose, tool))
        index = things.index(self.at) + step if self.at in things else min(0, step)
        self._go_to(things[index % len(things)])
        return True

    def _go_to(self, thing: Thing | None) -> None:
        self.forget()
        self.at = thing
        self._ask(lambda tool: tool.choose(thing))

    def enter(self) -> bool:
        """Take the control, or let it go; a button is clicked, a menu opens."""
        thing = self.at
        if thing is None:
            return False
        if not thing.there:
            self._go_to(None)
        elif self.holds:
            self.holds = False
            self._ask(Interact.let_go)
        elif thing.mode in DRAGGABLE:
            self.holds = True
            self._ask(lambda tool: tool.hold(thing))
        else:
            self._ask(lambda tool: tool.click(thing))
        return True

    def step(self, right: int, up: int, away: int, *, fine: bool) -> bool:
        """An arrow key, page up or page down; `fine` with Shift."""
        if self.holds:
            turning = self.turning
            self._ask(lambda tool: tool.step(right, up, away, fine=fine, turning=turning))
        return self.holds

    def space(self) -> bool:
        """Open the marker's menu; while a control is held that moves and turns, do the other from now on."""
        thing = self.at
        if thing is None:
            return False
        if self.holds:
            self.turning = thing.mode in BOTH and not self.turning
        elif thing.there:
            self._ask(lambda tool: tool.open_menu(thing))
        return True

    def leave(self) -> bool:
        """Let go, or else leave the control."""
        if self.at is None:
            return False
        if self.holds:
            self.holds = False
            self._ask(Interact.let_go)
        else:
            self._go_to(None)
        return True

    def _ask(self, action: Callable[[Interact], bool]) -> None:
        tools = self._rviz.tools
        if (tool := tools.interact) is not None:
            self._rviz.request(partial(tools.use, tool, lambda _: action(tool)))
