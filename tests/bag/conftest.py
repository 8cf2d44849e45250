"""Gives the tests of this folder a stepped machine that runs `ros2`, and nodes that talk."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "ros2"))
sys.path.insert(0, str(Path(__file__).parents[1] / "stepped"))

from bag_commands import counter, record
from ros2_machine import Machine


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    made = Machine(tmp_path)
    made.graph.now_ns = made.clock.now_ns
    yield made


@pytest.fixture
def counted(machine: Machine) -> Machine:
    """A bag in which /count is published ten times a second for two seconds, and nobody who publishes any more."""
    node = machine.node("counter", counter())
    record(machine, "--topics", "/count")
    node.destroy_timer(node.timer)
    return machine
