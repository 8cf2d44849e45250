"""Golden screens as plain text, and async tests without a plugin. No test here waits: frames are stepped."""

from __future__ import annotations

import asyncio
import inspect
import os
import sys
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))
os.environ.pop("NO_COLOR", None)

from fakes import FakeDesk

from day6_tui.tui.app import Day6App, make_look

GOLDEN = Path(__file__).parent / "golden"
UTF8 = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-golden", action="store_true", help="write the golden screens anew instead of comparing")


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: Any) -> bool | None:
    if not inspect.iscoroutinefunction(pyfuncitem.obj):
        return None
    arguments = {name: pyfuncitem.funcargs[name] for name in pyfuncitem._fixtureinfo.argnames}
    asyncio.run(pyfuncitem.obj(**arguments))
    return True


@pytest.fixture
def desk() -> FakeDesk:
    return FakeDesk()


def screen_lines(app: Day6App) -> list[str]:
    """What the screen shows, as text."""
    strips = app.screen._compositor.render_strips()
    return ["".join(segment.text for segment in strip).rstrip() for strip in strips]


def screen_text(app: Day6App) -> str:
    return "\n".join(screen_lines(app))


@asynccontextmanager
async def opened(
    desk: FakeDesk, width: int = 80, height: int = 24, *, environ: dict[str, str] | None = None, **options: Any
) -> AsyncIterator[tuple[Day6App, Any]]:
    """The desktop on a fake machine, with no frame but those that `step` draws."""
    given = SimpleNamespace(fps=0, **options)
    app = Day6App(given, desk=desk, look=make_look(given, environ or UTF8))
    async with app.run_test(size=(width, height)) as pilot:
        await step(app, pilot)
        yield app, pilot


async def step(app: Day6App, pilot: Any) -> None:
    """Draw one frame and let the layout settle, twice: new panes learn their size in between."""
    for _ in range(2):
        app.frames.step()
        await pilot.pause()


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """Compare a screen with tests/tui/golden/<name>.txt."""

    def compare(name: str, text: str) -> None:
        file = GOLDEN / f"{name}.txt"
        if request.config.getoption("--update-golden"):
            file.write_text(text + "\n", encoding="utf-8")
            return
        assert file.exists(), f"no golden screen {file.name}: run with --update-golden and look at it"
        assert text + "\n" == file.read_text(encoding="utf-8")

    return compare
