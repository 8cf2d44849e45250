"""The actions on the simulated world's time: pause, single steps, faster, slower."""

from __future__ import annotations

from day6_tui.actions import Handlers
from day6_tui.parts import Feature, Parts


class WorldTime(Feature):
    """Changes the machine's clock and shows the result."""

    def __init__(self, parts: Parts) -> None:
        super().__init__(parts)

    def actions(self) -> Handlers:
        return {
            "pause": self.pause,
            "step": self.step,
            "faster": lambda: self.change_speed(1),
            "slower": lambda: self.change_speed(-1),
            "normal": lambda: self.change_speed(0),
        }

    def pause(self) -> None:
        """Pause or resume the world."""
        self._machine.toggle_pause()
        self._look.wake()

    def step(self) -> None:
        """Move the paused world on by one tick of the turtle."""
        if self._machine.desk is not None and self._machine.paused:
            from day6_core.ros.programs.turtlesim.model import TICK

            self._machine.desk.step(TICK)

    def change_speed(self, step: int) -> None:
        """Go to the next speed up or down (0: to normal)."""
        speed = self._machine.change_speed(step)
        note = "" if speed == 1.0 else f" {self._look.glyphs.dot} {self._look.texts('bar.external')}"
        self._notices.show(f"{speed:g}x{note}")
