"""A machine whose time the test moves on, and a keyboard."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.support.stepped_keyboard import Keyboard
from tests.support.stepped_machine import SteppedMachine


@pytest.fixture
def machine() -> Iterator[SteppedMachine]:
    machine = SteppedMachine()
    yield machine
    machine.end()


@pytest.fixture
def keyboard() -> Keyboard:
    return Keyboard()
