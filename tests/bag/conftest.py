"""Gives the tests of this folder a stepped machine that runs `ros2`, and nodes that talk."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.ros2.bag_commands import counted_bag
from tests.ros2.ros2_machine import Machine


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    yield Machine(tmp_path)


@pytest.fixture
def counted(machine: Machine) -> Machine:
    """A bag in which /count is published ten times a second for two seconds, and nobody who publishes any more."""
    return counted_bag(machine)
