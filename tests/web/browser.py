"""Fixtures of the tests that need a browser: one serves all tests of a run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.web.background import Background
    from tests.web.chromium import Chromium


@pytest.fixture(scope="session")
def background() -> Iterator[Background]:
    from tests.web.background import Background

    made = Background()
    yield made
    made.close()


@pytest.fixture(scope="session")
def chromium(background: Background) -> Iterator[Chromium]:
    """The browser of the run; tests that need it are skipped where there is none."""
    pytest.importorskip("aiohttp", reason="aiohttp is not installed (the extra serve)")
    from tests.web.chromium import Chromium, program

    if (executable := program()) is None:
        pytest.skip("no Chromium on this machine")
    made = Chromium(executable, background)
    yield made
    made.close()
