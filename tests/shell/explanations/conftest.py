"""The terminal in which cards are read."""

from __future__ import annotations

from typing import Any

import pytest


@pytest.fixture
def tall(machine: Any, seat_at: Any) -> Any:
    """A terminal that shows a whole card."""
    return seat_at(machine.desk, 160, 50)
