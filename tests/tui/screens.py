"""Opens the desktop on a fake machine and reads its screen as text. No test here waits: frames are stepped."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from types import SimpleNamespace
from typing import Any

from fakes import FakeDesk

from day6_tui.tui.app import Day6App, make_look

UTF8 = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}


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
