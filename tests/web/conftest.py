"""What the tests of the server share: one that runs for all of them that do not end it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

pytest.importorskip("termios", reason="this system has no pseudo-terminals, and the server no keepers")
pytest.importorskip("aiohttp", reason="needs the extra: pip install 'day6-tui[serve]'")
pytest.importorskip("segno", reason="needs the extra: pip install 'day6-tui[serve]'")

from serving import WORD, Serving
from short_folder import make_short_folder

LIST = "\ufeffname,group\r\nanna,1\r\n李雷,1\r\n,2\r\nANNA,2\r\nbert,2\r\n"


@pytest.fixture(scope="session")
def class_server() -> Iterator[Serving]:
    folder = make_short_folder("d6w-")
    table = folder / "pupils.csv"
    table.write_text(LIST, encoding="utf-8", newline="")
    with Serving(folder, "--class", str(table), "--word", WORD, "--isolation", "none", "--most", "3") as serving:
        yield serving
    assert serving.cells() == []
