"""Gives the tests a lab: a whole machine with the inspector looking on."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.virtual.surroundings import is_virtual
from tests.inspector.lab import Lab


@pytest.fixture
def lab(short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Lab]:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "r"))
    if not is_virtual():  # there it is a part of that
        monkeypatch.setenv("DAY6_LINK", "on")
    made = Lab(short_folder / "home")
    yield made
    made.close()
