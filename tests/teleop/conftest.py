"""A machine whose time the test moves on, and a keyboard."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "stepped"))

from stepped_keyboard import Keyboard
from stepped_machine import SteppedMachine


@pytest.fixture
def machine() -> Iterator[SteppedMachine]:
    machine = SteppedMachine()
    yield machine
    machine.end()


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()
