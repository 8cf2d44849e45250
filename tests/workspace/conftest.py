"""Gives tests a workshop: a home folder with an empty workspace, and terminals that run command lines in it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

# Tests are imported by path (--import-mode=importlib), their helpers by name.
from tests.workspace.workshop import Workshop


@pytest.fixture
def workshop(tmp_path: Path) -> Iterator[Workshop]:
    place = Workshop(tmp_path / "home")
    yield place
    place.close()
