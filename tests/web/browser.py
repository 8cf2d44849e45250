"""Fixtures of the tests that need a browser: one serves all tests of a run."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.web.background import Background
    from tests.web.chromium import Chromium, Page
    from tests.web.page_server import PageServer


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


@contextmanager
def scripted_page(chromium: Chromium, background: Background) -> Iterator[tuple[Page, PageServer]]:
    """A new tab, and a server of its page that does what the test says."""
    from tests.web.page_server import PageServer

    page, server = chromium.page(), PageServer(background)
    yield page, server
    page.close()
    server.close()


@pytest.fixture(scope="module")
def scripted_tab(chromium: Chromium, background: Background) -> Iterator[tuple[Page, PageServer]]:
    """Both for all tests of a file."""
    with scripted_page(chromium, background) as made:
        yield made
