"""Pictures on a stepped desktop whose text and pictures a small terminal of real pixels (`pixel_terminal`) shows."""

from __future__ import annotations

import asyncio
import re
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import Any

import numpy as np
import pytest
from textual.app import App
from textual.widgets._toast import Toast

from day6_tui.app import Day6App
from day6_tui.classes.modals import Frozen
from day6_tui.panes.canvas import square
from day6_tui.pixels.ask import IS_READY, ITERM, KITTY, SIXEL, Ability, Answered
from day6_tui.pixels.pictures import LOST_SECONDS, SLOW_SECONDS, Pictures
from day6_tui.textual_private.keyboard import KeyboardParser
from day6_tui.windows.turtlesim.turtlesim import TurtleSimPane
from tests.pixels.pixel_terminal import CELL, PixelTerminal
from tests.tui.fakes import FakeDesk, FakeSimulation, turtle
from tests.tui.screens import opened, screen_text, step

pytestmark = pytest.mark.long

GROUND = (69, 86, 255)
KINDS = [KITTY, SIXEL, ITERM]


class Stage:
    """A desktop with one TurtleSim, and what its terminal shows."""

    def __init__(self, app: Day6App, pilot: Any, model: FakeSimulation, kind: str) -> None:
        self.app, self.pilot, self.model = app, pilot, model
        self.terminal = PixelTerminal(kind, *app.size)
        self.now = 100.0
        self.deaf = False
        """Whether the terminal answers later."""
        self.written: list[str] = []
        app.look.pictures = self.pictures = Pictures(
            app.look,
            {},
            self._write,
            changed=app._pictures_changed,
            given_up=app._too_slow,
            clock=lambda: self.now,
        )
        self.pictures.wanted = True
        self.pictures.use(Ability(kind, CELL))

    def _write(self, text: str) -> None:
        self.written.append(text)
        answers = self.terminal.feed(text)
        if not self.deaf:
            self.answer(answers)

    def answer(self, text: str = "\x1b[0n") -> None:
        """The terminal says that it is ready."""
        for message in KeyboardParser().feed(text) if text else ():
            assert isinstance(message, Answered)
            self.pictures.hear(message.text)
            self.app.call_later(self.pictures.take, message.text)

    async def frame(self, *turtles: Any) -> None:
        """One frame, after which 0.1 s have passed."""
        if turtles:
            self.model.show(*turtles)
        self.pane._drawn_at = -100.0
        await step(self.app, self.pilot)
        self.now += 0.1

    @property
    def pane(self) -> TurtleSimPane:
        return next(iter(self.app.query(TurtleSimPane)))

    def world(self) -> tuple[int, int, int, int]:
        """Column, row, columns and rows of the world on the screen."""
        x, y, columns, rows = self.pane._world_place()
        return self.pane.region.x + 1 + x, self.pane.region.y + 1 + y, columns, rows

    def ground(self) -> np.ndarray:
        """The cells that show the world's ground."""
        return self.terminal.has(GROUND)


@asynccontextmanager
async def staged(
    kind: str, monkeypatch: pytest.MonkeyPatch, width: int = 100, height: int = 30
) -> AsyncIterator[Stage]:
    """A desktop whose window is TurtleSim; what Textual draws is fed to the terminal of the test."""
    desk, model, stages = FakeDesk(), FakeSimulation(), []

    def display(app: App[Any], screen: Any, update: Any) -> None:
        if stages and update is not None and hasattr(update, "render_segments"):
            stages[0].terminal.feed(update.render_segments(app.console))

    monkeypatch.setattr(App, "_display", display)
    desk.display.open("turtlesim", "TurtleSim", model)
    async with opened(desk, width, height, scene="empty", toasts=True) as (app, pilot):
        stages.append(Stage(app, pilot, model, kind))
        app.screen.refresh()
        for _ in range(3):
            await stages[0].frame()
        yield stages[0]


def play(kind: str, monkeypatch: pytest.MonkeyPatch, scenes: Callable[[Stage], Awaitable[None]], **size: int) -> None:
    async def run() -> None:
        async with staged(kind, monkeypatch, **size) as stage:
            await scenes(stage)

    asyncio.run(run())


@pytest.mark.parametrize("kind", KINDS)
def test_the_world_fills_its_cells_and_no_others(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        column, row, columns, rows = stage.world()
        assert (columns, rows) == square(stage.pane.inner_width, stage.pane.inner_height)
        ground = stage.ground()
        assert ground[row : row + rows, column : column + columns].mean() > 0.95  # a turtle hides a few
        ground[row : row + rows, column : column + columns] = False
        assert not ground.any()

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_a_turtle_is_where_it_was_told_to_be_and_no_longer_where_it_was(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def scenes(stage: Stage) -> None:
        column, row, columns, rows = stage.world()
        for x, y in ((1.5, 1.5), (9.0, 2.0), (5.5, 9.0)):
            await stage.frame(turtle(x=x, y=y))
            await stage.frame()
            shell = np.argwhere(stage.terminal.has((0x2E, 0x9E, 0x5B), near=10))
            middle = shell.mean(axis=0) + 0.5
            assert abs((middle[1] - column) / columns - x / 11.09) < 0.06, (x, y)
            assert abs((middle[0] - row) / rows - (1 - y / 11.09)) < 0.06, (x, y)

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_a_moving_turtle_costs_its_own_surroundings(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        await stage.frame(turtle(x=5.0))
        stage.written.clear()
        await stage.frame(turtle(x=5.1))
        assert 0 < sum(map(len, stage.written)) < 12_000

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_a_menu_covers_its_part_of_the_picture_around_which_the_turtle_goes_on(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def scenes(stage: Stage) -> None:
        before = stage.ground()
        await stage.pilot.press("f7")
        await stage.frame(turtle(x=5.2))
        await stage.frame(turtle(x=5.3))
        overlay = stage.app.desktop.overlay
        assert overlay is not None
        x, y, right, bottom = overlay.query_one("#frame").region.corners
        assert before[y:bottom, x:right].any() and not stage.ground()[y:bottom, x:right].any()
        beside = before.copy()
        beside[y:bottom, x:right] = False
        assert beside.sum() > 50 and (stage.ground() & beside).sum() >= beside.sum() - 8
        stage.written.clear()
        await stage.frame(turtle(x=9.0 if right < before.shape[1] else 2.0))
        assert any("\x1b_G" in text or "\x1bP" in text or "1337;File" in text for text in stage.written)
        await stage.pilot.press("escape")
        await stage.frame(turtle(x=5.4))
        await stage.frame()
        assert stage.ground().sum() >= before.sum() - 8

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("under", ["nothing", "a sheet"])
def test_a_notification_is_not_hidden_under_a_picture_that_moves(
    under: str, kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def scenes(stage: Stage) -> None:
        before = stage.ground()
        if under == "a sheet":
            stage.app.push_screen(Frozen(stage.app.look))
        stage.app.notify("line\n" * 9, timeout=600.0)
        for x in (5.2, 5.3, 5.4):
            await stage.frame(turtle(x=x))
        (toast,) = stage.app.screen.query(Toast)
        covered = np.zeros_like(before)
        for widget in (toast, *stage.app.screen.query("#frame")):
            x, y, right, bottom = widget.region.corners
            assert before[y:bottom, x:right].any()
            covered[y:bottom, x:right] = True
        assert not (stage.ground() & covered).any()
        beside = before & ~covered
        assert beside.sum() > 50 and (stage.ground() & beside).sum() >= beside.sum() - 8
        stage.app.clear_notifications()
        await stage.frame(turtle(x=5.5))
        await stage.frame()
        assert (stage.ground() & before).sum() > beside.sum()

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_what_opens_over_a_picture_leaves_none_of_it_blank_while_the_terminal_is_busy(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The text of the frame has wiped all of it, or in Kitty's protocol lies under it."""

    async def scenes(stage: Stage) -> None:
        stage.deaf = True
        await stage.frame(turtle(x=5.2))
        before = stage.ground()
        stage.app.push_screen(Frozen(stage.app.look))
        stage.app.screen_stack[0].refresh()
        await stage.frame()
        x, y, right, bottom = stage.app.screen.query_one("#frame").region.corners
        covered = np.zeros_like(before)
        covered[y:bottom, x:right] = True
        assert (before & covered).any() and not (stage.ground() & covered).any()
        assert ((before & ~covered) == (stage.ground() & ~covered)).all()
        stage.written.clear()
        for place in (3.0, 4.0, 5.0):
            await stage.frame(turtle(x=place))
        assert stage.written == []

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_names_that_move_over_a_picture_ask_a_busy_terminal_nothing_more(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else it would never be seen that it is busy, and get picture after picture."""

    async def scenes(stage: Stage) -> None:
        pair = turtle(name="otto", x=8.0, y=5.0)
        await stage.frame(turtle(name="anna", x=3.0, y=5.0), pair)
        stage.deaf = True
        pictures = stage.app.look.pixels
        await stage.frame(turtle(name="anna", x=3.5, y=5.0), pair)
        asked = pictures.asked
        for place in (4.0, 5.0, 6.0):
            await stage.frame(turtle(name="anna", x=place, y=5.0), pair)
        assert pictures.waiting and pictures.asked == asked

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_names_of_turtles_are_text(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        pair = turtle(name="anna", x=3.0, y=5.0), turtle(name="otto", x=8.0, y=5.0)
        await stage.frame(*pair)
        await stage.frame()
        for hole in stage.pane._picture.sheet.holes:  # type: ignore[union-attr]
            column, row, _, _ = stage.world()
            cells = stage.ground()[row + hole.y, column + hole.x : column + hole.right]
            assert hole.width == 4 and not cells.any()

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_a_closed_window_leaves_nothing_on_the_screen(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        for window in list(stage.app.machine.desk.display.windows):  # type: ignore[union-attr]
            window.close()
        await step(stage.app, stage.pilot)
        await step(stage.app, stage.pilot)
        assert not stage.ground().any() and not stage.terminal.images

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_another_set_of_characters_takes_the_picture_away(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        stage.app.actions["glyphs"]()
        assert stage.app.look.glyphs.name == "half"
        await stage.frame(turtle(x=5.2))
        await stage.frame()
        assert not stage.ground().any() and not stage.terminal.images
        for _ in range(4):
            stage.app.actions["glyphs"]()
        assert stage.app.look.glyphs.name == "pixels"
        await stage.frame()
        await stage.frame()
        assert stage.ground().any()

    play(kind, monkeypatch, scenes)


@pytest.mark.parametrize("kind", KINDS)
def test_the_picture_moves_with_its_pane(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        for size in ((80, 24), (100, 30), (64, 30)):
            stage.terminal.pixels = np.zeros((30 * CELL[1], 100 * CELL[0], 3), np.uint8)  # room for both
            await stage.pilot.resize_terminal(*size)
            stage.terminal.size = size
            stage.terminal.pixels = np.zeros((size[1] * CELL[1], size[0] * CELL[0], 3), np.uint8)
            stage.app.screen.refresh()
            for _ in range(3):
                await stage.frame()
            column, row, columns, rows = stage.world()
            ground = stage.ground()
            assert ground[row : row + rows, column : column + columns].mean() > 0.9
            assert ground.sum() <= columns * rows

    play(kind, monkeypatch, scenes)


def test_nothing_more_is_written_before_the_terminal_is_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        stage.deaf = True
        await stage.frame(turtle(x=2.0))
        stage.written.clear()
        for x in (3.0, 4.0, 5.0):
            await stage.frame(turtle(x=x))
        assert stage.written == []
        stage.answer()
        await stage.frame()
        assert len(stage.written) == 1
        shell = np.argwhere(stage.terminal.has((0x2E, 0x9E, 0x5B), near=10))
        column, _, columns, _ = stage.world()
        assert abs((shell.mean(axis=0)[1] + 0.5 - column) / columns - 5.0 / 11.09) < 0.06

    play(SIXEL, monkeypatch, scenes)


def test_where_cells_are_no_whole_pixels_a_picture_is_written_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pieces would leave a line of the background at each of their edges."""

    async def scenes(stage: Stage) -> None:
        stage.pictures.use(Ability(SIXEL, CELL, (CELL[0] + 0.425, CELL[1] + 0.25)))
        await stage.frame(turtle(x=4.0))
        stage.written.clear()
        await stage.frame(turtle(x=4.1))
        _, _, columns, rows = stage.world()
        sizes = re.findall(r"\x1bP0;1;0q\"1;1;(\d+);(\d+)", "".join(stage.written))
        assert sizes == [(str(int(columns * (CELL[0] + 0.425))), str(int(rows * (CELL[1] + 0.25))))]

    play(SIXEL, monkeypatch, scenes)


def test_a_slow_terminal_gets_coarser_pictures_and_at_last_characters(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        stage.deaf = True
        cells = []
        while stage.app.look.glyphs.name != "half" and len(cells) < 40:  # a busy machine leaves pictures out
            await stage.frame(turtle(x=2.0 + len(cells) % 12 / 2))
            stage.now += SLOW_SECONDS * 1.5
            stage.answer()
            await stage.frame()
            cells.append(stage.pictures.cell(40, 20))
        assert cells[0] == CELL and min(cells[:-1]) < CELL
        assert stage.app.look.glyphs.name == "half"
        assert "pictures are now drawn with characters" in screen_text(stage.app)

    play(SIXEL, monkeypatch, scenes)


def test_a_terminal_that_is_quick_again_gets_fine_pictures_again(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        pictures = stage.pictures
        stage.deaf = True
        for seconds, count in ((SLOW_SECONDS * 2, 3), (0.01, 150)):
            for _ in range(count):
                pictures._put("")
                stage.now += seconds
                pictures.hear(IS_READY)
                pictures.take(IS_READY)
            assert (pictures.cell(40, 20) == CELL) == (seconds < SLOW_SECONDS)

    play(KITTY, monkeypatch, scenes)


def test_an_answer_that_never_comes_does_not_stop_the_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        stage.deaf = True
        await stage.frame(turtle(x=2.0))
        stage.now += LOST_SECONDS + 1
        stage.written.clear()
        await stage.frame(turtle(x=3.0))
        assert stage.written
        stage.answer()
        stage.deaf = False
        for x in (4.0, 5.0):  # as quickly as before
            stage.written.clear()
            await stage.frame(turtle(x=x))
            assert stage.written

    play(KITTY, monkeypatch, scenes)


def test_letters_of_another_size_leave_no_old_image_and_no_choice_undone(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        stage.pictures.use(Ability(KITTY, (20, 40)))
        await stage.frame(turtle(x=4.0))
        await stage.frame()
        assert {number for number, _ in stage.terminal.placements} == set(stage.terminal.images)
        assert stage.ground().sum() <= stage.world()[2] * stage.world()[3]
        stage.app.actions["glyphs"]()
        stage.pictures.use(Ability(KITTY, CELL))
        await stage.frame()
        assert stage.app.look.glyphs.name == "half" and not stage.terminal.images

    play(KITTY, monkeypatch, scenes)


def test_letters_that_change_twice_before_the_terminal_answers_are_measured_as_they_are_last(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def scenes(stage: Stage) -> None:
        stage.deaf = True
        stage.pictures.ask((100, 30))
        stage.pictures.ask((90, 27))
        for height, width in ((20, 10), (21, 11)):
            for answer in (f"\x1b[6;{height};{width}t", "\x1b[?62;4c"):
                stage.pictures.take(answer)
        assert stage.pictures.ability == Ability(SIXEL, (11, 21))

    play(SIXEL, monkeypatch, scenes)


def test_leaving_removes_every_image(monkeypatch: pytest.MonkeyPatch) -> None:
    async def scenes(stage: Stage) -> None:
        assert stage.terminal.images
        stage.terminal.feed(stage.pictures.farewell())
        assert not stage.terminal.images and not stage.terminal.placements

    play(KITTY, monkeypatch, scenes)


def test_a_pane_that_goes_while_the_desktop_leaves_takes_no_image_out_of_the_farewell(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def scenes(stage: Stage) -> None:
        pane = stage.pane
        stage.app.exit()
        stage.pictures._write = lambda text: None  # as the application does from then on
        stage.pictures.drop(pane)
        stage.pictures.send()
        stage.terminal.feed(stage.pictures.farewell())
        assert not stage.terminal.images and not stage.terminal.placements

    play(KITTY, monkeypatch, scenes)
