"""Gives the tests of this folder a `machine` that runs `ros2`, and a recorded bag."""

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
    """A machine with a bag in which /count was published ten times a second for two seconds, by nobody any more."""
    return counted_bag(machine)
