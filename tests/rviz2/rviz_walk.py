"""Walks through the RViz window: keys and clicks at a stepped desktop, and what is on its screen."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from typing import TYPE_CHECKING, Any

from tests.support.waiting import Deadline

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine


class Walk:
    """Presses keys at the window and lets the machine answer."""

    def __init__(self, machine: RVizMachine, app: Any, pilot: Any) -> None:
        self.machine, self.app, self.pilot = machine, app, pilot

    @property
    def pane(self) -> Any:
        """The window that has the keys; the newest one while a dialog has them."""
        focused = self.app.desktop.focused_pane
        return focused if hasattr(focused, "rviz") else list(self.app.desktop.panes.values())[-1]

    async def press(self, *keys: str) -> None:
        for key in keys:
            await self.pilot.press(key)
        await self.settle()

    async def type(self, text: str) -> None:
        await self.press(*({" ": "space", "/": "slash", "_": "underscore", ".": "full_stop"}.get(c, c) for c in text))

    async def settle(self) -> None:
        from tests.tui.screens import step

        self.machine.settle()
        await step(self.app, self.pilot)

    async def until(self, condition: Callable[[], object]) -> None:
        """Settle until `condition` holds: the view is drawn only a few times a second."""
        deadline = Deadline()
        while not condition():
            assert not deadline.is_over(), self.screen()
            await self.settle()

    def screen(self) -> str:
        from tests.tui.screens import screen_text

        return screen_text(self.app)

    def line(self, name: str) -> str:
        return next(line for line in self.screen().splitlines() if name in line)


@asynccontextmanager
async def walking(
    machine: RVizMachine,
    width: int = 120,
    height: int = 40,
    *,
    args: tuple[str, ...] = (),
    lang: str = "en",
    **options: Any,
) -> AsyncIterator[Walk]:
    from tests.tui.fakes import FakeDesk
    from tests.tui.screens import opened

    machine.open(*args)
    desk = FakeDesk()
    desk.display = machine.display
    async with opened(desk, width, height, scene="empty", lang=lang, **options) as (app, pilot):
        walk = Walk(machine, app, pilot)
        await walk.press("f3", "f8")
        yield walk


def run(walk: Any) -> None:
    asyncio.run(walk)


def mouse(pane: Any, kind: type, x: int, y: int, button: int, shift: bool, ctrl: bool, alt: bool = False) -> Any:
    return kind(pane, x, y, 0, 0, button, shift, alt, ctrl, x, y)


async def drag(
    at: Walk,
    *places: tuple[int, int],
    button: int = 1,
    shift: bool = False,
    ctrl: bool = False,
    alt: bool = False,
) -> None:
    """Press at the first place (cells of the view), move through the others, let go at the last."""
    from textual import events

    pane = at.pane
    kinds = [events.MouseDown, *[events.MouseMove] * (len(places) - 1), events.MouseUp]
    for kind, (x, y) in zip(kinds, [*places, places[-1]], strict=True):
        left, top = pane.view_place.offset
        pane.post_message(mouse(pane, kind, left + x, top + y, button, shift, ctrl, alt))
        await at.settle()
    await at.settle()  # what the window asked for is done by the program now


async def hover(at: Walk, place: tuple[int, int]) -> None:
    """Move the mouse to a cell of the view, with no button down."""
    from textual import events

    pane = at.pane
    left, top = pane.view_place.offset
    pane.post_message(mouse(pane, events.MouseMove, left + place[0], top + place[1], 0, False, False))
    await at.settle()
    await at.settle()
