"""The official tutorials' packages, without a mistake, give no alarm."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.inspector.lab import Lab
from tests.inspector.tutorials import TUTORIALS


@pytest.mark.process
@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda tutorial: tutorial.__name__)
def test_a_tutorial_gives_no_alarm(lab: Lab, tutorial: Callable[[Lab], object]) -> None:
    tutorial(lab)
    assert lab.stays_silent() == {}, "\n".join(lab.screen(number) for number in range(len(lab.terminals)))
