"""A machine whose time the test moves on, with a world on it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_tui.urdf import shipped_model

sys.path.insert(0, str(Path(__file__).parents[1] / "stepped"))

from stepped_machine import Running, SteppedMachine


class Machine(SteppedMachine):
    def open_world(self, *parameters: str, robot: str | Path | None = None, screen: bool = True) -> Running:
        """Start the world with parameters like 'world:=walls' and wait until the robot was read."""
        robot = shipped_model("day6_bot_gazebo") if robot is None else robot
        given = [word for item in (f"robot_file:={robot}", *parameters) for word in ("-p", item)]
        running = self.start("day6_world", "world", "--ros-args", *given, screen=screen)
        if screen and self.display.windows:
            self.until(lambda: self.model.snapshot().robot is not None or self.refused)
        return running

    @property
    def model(self) -> Any:
        return self.display.windows[-1].model

    @property
    def refused(self) -> bool:
        return any(line.level == "error" for line in self.model.snapshot().status)

    @property
    def said(self) -> list[str]:
        return [line.text for line in self.model.snapshot().status]

    def until(self, condition: Any) -> None:
        """Wait in real time for what a thread does; the world's time moves on a little meanwhile."""
        import time

        end = time.monotonic() + 20.0
        while not condition():
            assert time.monotonic() < end, "it did not happen"
            time.sleep(0.002)
            self.advance(0.02)


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()
