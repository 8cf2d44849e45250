"""One stepped machine with RViz on it for every test."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

for folder in ("tui", "rviz2"):
    path = str(Path(__file__).parents[1] / folder)
    if path not in sys.path:
        sys.path.insert(0, path)

from rviz_machine import RVizMachine  # noqa: E402


@pytest.fixture
def machine() -> Iterator[RVizMachine]:
    machine = RVizMachine()
    yield machine
    machine.end()
