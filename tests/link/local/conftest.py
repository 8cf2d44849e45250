"""Sessions that meet in a folder of their own, by Unix sockets and by TCP."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.link.local.sessions import Sessions


@pytest.fixture(params=["tcp"] if sys.platform == "win32" else ["unix", "tcp"])
def sessions(request: pytest.FixtureRequest, short_folder: Path) -> Iterator[Sessions]:
    made = Sessions(short_folder / "0", tcp=request.param == "tcp")
    yield made
    made.close()
