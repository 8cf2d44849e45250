"""Commands are called in this process: with 80 columns, no network, a folder of its own, and nothing that they choose stays."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.ros import distribution


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    before, on_interrupt = dict(os.environ), signal.getsignal(signal.SIGINT)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.setenv("DAY6_LINK", "off")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(distribution, "_current", distribution.current())
    monkeypatch.setattr(sys, "path", [*sys.path])
    yield
    signal.signal(signal.SIGINT, on_interrupt)  # the command `ros2` ignores it at its end
    os.environ.clear()
    os.environ.update(before)
