"""Drawing only what changed, at the end of the frame, against Textual's own way."""

from __future__ import annotations

import asyncio
import random

import pyte
from rich.console import Console
from rich.text import Text
from textual._compositor import Compositor
from textual.app import App, ComposeResult
from textual.geometry import Region
from textual.screen import Screen
from textual.widgets import Static

from day6_tui.textual_private.dirty_spans import pieces_of_chops
from day6_tui.textual_private.frame_screen import FrameScreen, SpansCompositor
from tests.tui.settled import install

install()

WIDTH, HEIGHT = 48, 16
NOTHING = pyte.Screen(1, 1).default_char


def _words(seed: int) -> Text:
    picker = random.Random(seed)
    lines = ["".join(picker.choice("abc d▀") for _ in range(WIDTH)) for _ in range(HEIGHT)]
    return Text("\n".join(lines), style=picker.choice(["red", "on blue", "bold"]), no_wrap=True, overflow="crop")


class _Desk(App[None]):
    """Widgets side by side, and two that lie over them."""

    CSS = """
    Screen { layers: below above top; }
    #left, #right { width: 1fr; height: 1fr; layer: below; }
    #left { dock: left; width: 21; }
    #card { layer: above; width: 20; height: 7; offset: 11 3; }
    #toast { layer: top; width: 9; height: 3; offset: 25 5; }
    """

    def compose(self) -> ComposeResult:
        for number, name in enumerate(("left", "right", "card", "toast")):
            yield Static(_words(number), id=name)

    def get_default_screen(self) -> Screen[None]:
        return FrameScreen(id="_default")


def _shown(data: str) -> list[list[object]]:
    screen = pyte.Screen(WIDTH, HEIGHT)
    pyte.Stream(screen).feed("\x1b[2J" + data)
    return [[screen.buffer[y][x] for x in range(WIDTH)] for y in range(HEIGHT)]


def test_what_is_drawn_is_what_textual_draws() -> None:
    # Without wide characters: Textual also cuts those in two below which, unseen, another widget begins.
    console = Console(force_terminal=True, color_system="truecolor", width=WIDTH, legacy_windows=False)
    picker = random.Random(7)

    async def compare() -> None:
        app = _Desk()
        async with app.run_test(size=(WIDTH, HEIGHT)):
            compositor = app.screen._compositor
            assert isinstance(compositor, SpansCompositor)
            whole = _shown(compositor.render_full_update().render_segments(console))
            for _ in range(60):
                regions = set()
                for _ in range(picker.randint(1, 4)):
                    x, y = picker.randint(-2, WIDTH - 1), picker.randint(-1, HEIGHT - 1)
                    region = Region(x, y, picker.randint(1, 14), picker.randint(1, 3))
                    regions.add(region.intersection(app.screen.region))
                compositor._dirty_regions = set(regions)
                ours = compositor.render_partial_update()
                compositor._dirty_regions = set(regions)
                theirs = Compositor.render_partial_update(compositor)
                if theirs is None or not theirs.spans:
                    continue
                assert ours is not None
                pieces = pieces_of_chops(theirs)
                expected = _shown("".join(f"\x1b[{y + 1};{x + 1}H{strip.render(console)}" for x, y, strip in pieces))
                drawn = _shown(ours.render_segments(console))
                for y, line in enumerate(drawn):
                    for x, cell in enumerate(line):
                        assert cell == whole[y][x] or cell == expected[y][x] == NOTHING

    asyncio.run(compare())


def test_what_is_marked_in_a_frame_is_drawn_once_at_its_end() -> None:
    async def draw() -> None:
        app = _Desk()
        async with app.run_test(size=(WIDTH, HEIGHT)) as pilot:
            await pilot.pause()
            screen = app.screen
            assert isinstance(screen, FrameScreen)
            drawn: list[object] = []
            render = screen._compositor.render_partial_update
            screen._compositor.render_partial_update = lambda: drawn.append(render()) or drawn[-1]  # type: ignore
            left = app.query_one("#left")
            assert not screen.mark(left, [Region(0, 0, 3, 1)]), "outside a frame Textual draws"
            screen.begin_frame()
            assert screen.mark(left, [Region(0, 0, 3, 1)]) and screen.mark(left, [Region(5, 2, 3, 1)])
            assert drawn == []
            screen.end_frame()
            (update,) = drawn
            assert sorted(update.spans) == [(0, 0, 3), (2, 5, 8)]  # type: ignore[attr-defined]
            await pilot.pause()
            assert len(drawn) == 1
            screen.begin_frame()
            screen.end_frame()
            assert len(drawn) == 1

    asyncio.run(draw())
