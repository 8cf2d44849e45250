"""A machine whose time the test moves on, with a world on it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_urdf import shipped_model
from tests.support.stepped_machine import Running, SteppedMachine


class Machine(SteppedMachine):
    WHILE_WAITING = 0.02

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


@pytest.fixture
def machine() -> Iterator[Machine]:
    machine = Machine()
    yield machine
    machine.end()
