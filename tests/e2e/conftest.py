"""Gives every test of this folder a `place` of its own; nothing that was started there outlives it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

# Tests are imported by path (--import-mode=importlib), their helpers by name.
from tests.e2e.place import Place


@pytest.fixture
def place(tmp_path: Path) -> Iterator[Place]:
    made = Place(tmp_path)
    yield made
    made.close()
