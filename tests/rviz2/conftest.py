"""One stepped machine with RViz on it for every test."""

from __future__ import annotations

import time
from collections.abc import Iterator

import pytest

from tests.rviz2.rviz_machine import RVizMachine


@pytest.fixture
def machine(monkeypatch: pytest.MonkeyPatch) -> Iterator[RVizMachine]:
    monkeypatch.setattr(time, "thread_time", lambda: 0.0)  # RViz looks the less often the longer a look takes
    machine = RVizMachine()
    yield machine
    machine.end()
