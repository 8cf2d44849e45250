"""Opens the desktop on a fake machine and reads its screen as text. No test here waits: frames are stepped."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable
from contextlib import asynccontextmanager
from typing import Any, TypeVar

from rich.cells import cell_len
from textual.app import App

from day6_tui.app import Day6App, make_look
from day6_tui.options import Options
from tests.support.waiting import Deadline
from tests.tui import parsed_once, settled
from tests.tui.fakes import FakeDesk
from tests.tui.stepped_time import stepped_time

settled.install()
parsed_once.install()

UTF8 = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}


def screen_lines(app: Day6App) -> list[str]:
    """What the screen shows, as text."""
    strips = app.screen._compositor.render_strips()
    return ["".join(segment.text for segment in strip).rstrip() for strip in strips]


def is_drawn_in_ascii(text: str) -> bool:
    """Whether all that is drawn is ASCII. Chinese, at least the name of the other language, may be written in between."""
    return all(char.isascii() or cell_len(char) == 2 for char in text)


def screen_text(app: Day6App) -> str:
    return "\n".join(screen_lines(app))


@asynccontextmanager
async def running(app: App[Any], width: int, height: int, *, toasts: bool = False) -> AsyncIterator[Any]:
    """Run an application with no time but what settling takes; yields its pilot. Without `toasts` it shows none."""
    with stepped_time():
        async with app.run_test(size=(width, height), notifications=toasts) as pilot:
            yield pilot


@asynccontextmanager
async def opened(
    desk: FakeDesk,
    width: int = 80,
    height: int = 24,
    *,
    environ: dict[str, str] | None = None,
    toasts: bool = False,
    **options: Any,
) -> AsyncIterator[tuple[Day6App, Any]]:
    """The desktop on a fake machine, with no frame but those that `step` draws."""
    given = Options(fps=0, **options)
    app = Day6App(given, desk=desk, look=make_look(given, environ or UTF8))
    async with running(app, width, height, toasts=toasts) as pilot:
        await step(app, pilot)
        yield app, pilot


def look_at(
    window: tuple[str, str, Any], pane: str, keys: Iterable[str] = (), width: int = 80, height: int = 24, **options: Any
) -> str:
    """The screen with a program's window (kind, title, model), after keys that its pane (the name of its class) has got."""

    async def look() -> str:
        desk = FakeDesk()
        desk.display.open(*window)
        async with opened(desk, width, height, scene="empty", **options) as (app, pilot):
            await step(app, pilot)
            next(iter(app.query(pane))).focus()
            await step(app, pilot)
            for key in keys:
                await pilot.press(key)
                await step(app, pilot)
            return screen_text(app)

    return asyncio.run(look())


class ToolWindow:
    """A program's window that has the whole of a stepped desktop, and the keyboard."""

    def __init__(self, app: Day6App, pilot: Any, number: int) -> None:
        self.app, self.pilot = app, pilot
        self.pane: Any = app.desktop.panes[number]
        self.model: Any = self.pane.window.model

    @property
    def text(self) -> str:
        return screen_text(self.app)

    async def press(self, *keys: str) -> None:
        for key in keys:
            await self.pilot.press(key)
            await step(self.app, self.pilot)


Tool = TypeVar("Tool", bound=ToolWindow)


def use_window(
    window: tuple[str, str, Any],
    act: Callable[[Tool], Awaitable[None]],
    size: tuple[int, int],
    kind: type[Tool],
    **options: Any,
) -> None:
    """Open a program's window (kind, title, model) enlarged, so that it has the whole of `size`, and do something with it."""

    async def run() -> None:
        desk = FakeDesk()
        number = desk.display.open(*window).number
        async with opened(desk, *size, scene="empty", **{"lang": "en", **options}) as (app, pilot):
            await step(app, pilot)
            app.desktop.focus_pane(app.desktop.panes[number])
            await step(app, pilot)
            tool = kind(app, pilot, number)
            await tool.press("f8")
            await act(tool)

    asyncio.run(run())


async def step(app: Day6App, pilot: Any) -> None:
    """Draw one frame and let the layout settle, twice: new panes learn their size in between."""
    for _ in range(2):
        app.frames.step()
        await pilot.pause()


async def step_until(app: Day6App, pilot: Any, condition: Callable[[], object]) -> None:
    """Draw frames until `condition` holds: a flood of output is shown a few times a second."""
    deadline = Deadline()
    while not condition():
        assert not deadline.is_over(), screen_text(app)
        await step(app, pilot)
