"""What the tests of this folder share, imported by name: one server, and one browser, for a run."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from short_folder import make_short_folder

if str(Path(__file__).parent) not in sys.path:
    sys.path.insert(0, str(Path(__file__).parent))

if TYPE_CHECKING:
    from background import Background
    from chromium import Chromium, Page
    from page_server import PageServer
    from serving import Serving

LIST = "\ufeffname,group\r\nanna,1\r\n李雷,1\r\n,2\r\nANNA,2\r\nbert,2\r\n"


@pytest.fixture(scope="session")
def class_server() -> Iterator[Serving]:
    """A server for all tests that do not end it."""
    from serving import WORD, Serving

    folder = make_short_folder("d6w-")
    table = folder / "pupils.csv"
    table.write_text(LIST, encoding="utf-8", newline="")
    with Serving(folder, "--class", str(table), "--word", WORD, "--isolation", "none", "--most", "3") as serving:
        yield serving
    assert serving.cells() == []


@pytest.fixture(scope="session")
def background() -> Iterator[Background]:
    from background import Background

    made = Background()
    yield made
    made.close()


@pytest.fixture(scope="session")
def chromium(background: Background) -> Iterator[Chromium]:
    """The browser of the run; tests that need it are skipped where there is none."""
    pytest.importorskip("aiohttp", reason="aiohttp is not installed (the extra serve)")
    from chromium import Chromium, program

    if (executable := program()) is None:
        pytest.skip("no Chromium on this machine")
    made = Chromium(executable, background)
    yield made
    made.close()


@pytest.fixture
def page(chromium: Chromium) -> Iterator[Page]:
    """A new tab."""
    made = chromium.page()
    yield made
    made.close()


@pytest.fixture
def server(background: Background) -> Iterator[PageServer]:
    """A server that does what the test says."""
    pytest.importorskip("aiohttp", reason="aiohttp is not installed (the extra serve)")
    from page_server import PageServer

    made = PageServer(background)
    yield made
    made.close()
