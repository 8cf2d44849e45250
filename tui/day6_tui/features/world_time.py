"""The actions on the simulated world's time: pause, single steps, faster, slower."""

from __future__ import annotations

import math

from day6_core.virtual import surroundings
from day6_tui.actions import Handlers
from day6_tui.bars.notices import HINT_SECONDS
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
            "fastest": self.go_fastest,
        }

    def go_fastest(self) -> None:
        """Let time pass as fast as all programs can."""
        self._machine.set_speed(math.inf)
        self._show_speed(math.inf)

    def pause(self) -> None:
        """Pause or resume the world."""
        self._machine.toggle_pause()
        self._look.wake()

    def step(self) -> None:
        """Move the paused world on by one tick of the turtle."""
        if self._machine.paused:
            from day6_core.ros.programs.turtlesim.model import TICK

            self._machine.step(TICK)

    def change_speed(self, step: int) -> None:
        """Go to the next speed up or down (0: to normal)."""
        before = self._machine.speed
        speed = self._machine.change_speed(step)
        if self._machine.is_virtual or not (step > 0 and speed == before and surroundings.is_there()):
            self._show_speed(speed)
        else:
            self._notices.show(self._look.texts("time.how"), HINT_SECONDS)

    def _show_speed(self, speed: float) -> None:
        texts = self._look.texts
        note = "" if speed == 1.0 or self._machine.is_virtual else f" {self._look.glyphs.dot} {texts('bar.external')}"
        self._notices.show(texts("time.fastest") if speed == math.inf else f"{speed:g}x{note}")
