"""Gives every test of this folder a `world`: where day6-tui runs in virtual time, and from which nothing may be left."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

# Tests are imported by path (--import-mode=importlib), their helpers by name.
from tests.support.waiting import until
from tests.virtual.world import World


@pytest.fixture
def world(tmp_path: Path) -> Iterator[World]:
    made = World(tmp_path)
    yield made
    try:
        until(lambda: not made.left(), told=made.left)
    finally:
        made.close()
