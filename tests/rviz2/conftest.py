"""One stepped machine with RViz on it for every test."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

for folder in ("tui", "rviz2"):
    path = str(Path(__file__).parents[1] / folder)
    if path not in sys.path:
        sys.path.insert(0, path)

from rviz_machine import RVizMachine  # noqa: E402


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch) -> Iterator[RVizMachine]:
    monkeypatch.setattr(time, "thread_time", lambda: 0.0)  # RViz looks the less often the longer a look takes
    machine = RVizMachine()
    yield machine
    machine.end()
