"""What the tests of this folder share, imported by name: one server, and one browser, for a run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from tests.support.short_folder import make_short_folder
from tests.web.browser import background, chromium, scripted_tab  # noqa: F401

if TYPE_CHECKING:
    from tests.web.serving import Serving

LIST = "\ufeffname,group\r\nanna,1\r\n李雷,1\r\n,2\r\nANNA,2\r\nbert,2\r\n"


@pytest.fixture(scope="session")
def class_server() -> Iterator[Serving]:
    """A server for all tests that do not end it."""
    from tests.web.serving import WORD, Serving

    folder = make_short_folder("d6w-")
    table = folder / "pupils.csv"
    table.write_text(LIST, encoding="utf-8", newline="")
    with Serving(folder, "--class", str(table), "--word", WORD, "--isolation", "none", "--most", "3") as serving:
        yield serving
    assert serving.cells() == []
    assert not [line for line in serving.said if "Traceback" in line or "Error" in line]
