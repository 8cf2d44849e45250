"""Whole screens, compared with the text files in golden/."""

from __future__ import annotations

import pytest
from rich.cells import cell_len

from day6_core.lessons.scene import scenes
from day6_tui.actions import ACTIONS
from tests.tui.fakes import FakeDesk, FakeSimulation, turtle
from tests.tui.screens import opened, screen_lines, screen_text, step

ASCII = {"LANG": "C", "TERM": "xterm"}
CONSOLE = {"LANG": "C.UTF-8", "TERM": "linux"}


@pytest.mark.parametrize("language", ["zh", "en"])
@pytest.mark.parametrize("size", [(80, 24), (120, 40), (40, 10)])
async def test_the_welcome_choices_are_on_the_first_screen(desk, golden, language, size) -> None:
    async with opened(desk, *size, lang=language) as (app, _):
        golden(f"welcome-{language}-{size[0]}x{size[1]}", screen_text(app))


@pytest.mark.parametrize("language", ["zh", "en"])
@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_a_turtle_and_its_trail_on_the_desk(desk, golden, language, size) -> None:
    simulation = FakeSimulation(turtle(x=7.56, theta=0.0, v=2.0))
    simulation.trail.draw_line(249.5, 249.5, 340.2, 249.5, 0xB3B8FF, 3)
    desk.display.open("turtlesim", "TurtleSim", simulation)
    async with opened(desk, *size, lang=language) as (app, pilot):
        await step(app, pilot)
        golden(f"turtle-{language}-{size[0]}x{size[1]}", screen_text(app))


async def test_the_guide_follows_the_choice_of_an_empty_desk(desk, golden) -> None:
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await pilot.press(str(len(scenes()) + 1))  # the lessons stand before it
        await step(app, pilot)
        assert app.screen.focused is app.terminals.current
        golden("guide-en-120x40", screen_text(app))


@pytest.mark.parametrize("language", ["zh", "en"])
async def test_help_explains_the_focused_pane(desk, golden, language) -> None:
    async with opened(desk, 80, 24, lang=language) as (app, pilot):
        await pilot.press("f3")
        await pilot.press("f1")
        await step(app, pilot)
        golden(f"help-{language}-80x24", screen_text(app))


async def test_the_palette_lists_every_command(desk, golden) -> None:
    async with opened(desk, 80, 30, lang="zh") as (app, pilot):
        await pilot.press("f7")
        await step(app, pilot)
        golden("palette-zh-80x30", screen_text(app))


@pytest.mark.long
@pytest.mark.parametrize("width", [80, 100, 121, 150])
async def test_no_chinese_character_of_an_overlay_is_lost_at_the_edge_of_a_pane_below(desk, width) -> None:
    async with opened(desk, width, 40, lang="zh") as (app, pilot):
        await pilot.press("f1")
        await step(app, pilot)
        lines = [line.partition("┃")[2].rpartition("┃")[0] for line in screen_lines(app)]
        beside = 24 if width >= 100 else 0  # the list of the pages
        shown = "".join(cell_cut(line, beside) for line in lines).replace(" ", "")
        text = app.look.texts("help.welcome")
        assert text.replace(" ", "").replace("\n", "") in shown
        await pilot.press("escape", "f7")
        await step(app, pilot)
        shown = screen_text(app)
        offered = [app.look.texts(f"action.{action.id}") for action in ACTIONS if action.palette]
        assert all(name in shown for name in offered[:24])


def cell_cut(line: str, cells: int) -> str:
    """What is left of a line without its first cells."""
    while cells > 0 and line:
        cells -= cell_len(line[0])
        line = line[1:]
    return line


@pytest.mark.parametrize("environ", [ASCII, CONSOLE], ids=["no-utf8", "linux-console"])
async def test_a_poor_terminal_gets_characters_it_can_show(desk, golden, environ) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation(turtle(x=7.56, theta=1.57), turtle("turtle2", 2.0, 3.0)))
    async with opened(desk, 80, 24, environ=environ) as (app, pilot):
        await step(app, pilot)
        text = screen_text(app)
        golden("turtles-no-utf8-80x24" if environ is ASCII else "turtles-console-80x24", text)
        if environ is ASCII:
            assert text.isascii()
        else:
            assert not set(text) & set("▀▄╭╮╰╯▌▐"), "the fonts of the Linux console lack these"


@pytest.mark.parametrize("size", [(40, 10), (20, 5), (10, 3), (300, 100), (99, 13), (100, 14)])
async def test_every_size_of_terminal_shows_something_and_every_line_fits(desk, size) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, *size, lang="zh") as (app, pilot):
        await step(app, pilot)
        lines = screen_lines(app)
        assert len(lines) == size[1]
        assert any(line.strip() for line in lines)
        assert all(cell_len(line) <= size[0] for line in lines)


async def test_the_first_picture_after_a_resize_is_drawn_before_anybody_was_told(monkeypatch) -> None:
    """Textual renders a pane at its new size before the pane hears of it."""
    from day6_tui.panes.pane import Pane
    from day6_tui.windows.turtlesim.turtlesim import TurtleSimPane

    desk = FakeDesk()
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        for kind in (Pane, TurtleSimPane):
            monkeypatch.setattr(kind, "on_resize", lambda self, event: None)
        for size in ((80, 24), (200, 60), (100, 20)):
            await pilot.resize_terminal(*size)
            strips = pane.render_lines(pane.size.region)
            assert [strip.cell_length for strip in strips] == [pane.size.width] * pane.size.height


async def test_resizing_while_the_turtle_moves_keeps_the_picture_whole() -> None:
    desk, simulation = FakeDesk(), FakeSimulation()
    desk.display.open("turtlesim", "TurtleSim", simulation)
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        for number, size in enumerate([(80, 24), (40, 10), (200, 60), (120, 40)], 1):
            simulation.trail.draw_line(250, 250, 250 + 20 * number, 250, 0xFF0000, 3)
            simulation.show(turtle(x=5.54 + number))
            app.frames.step()
            await pilot.resize_terminal(*size)
            await step(app, pilot)
            assert len(screen_lines(app)) == size[1]
        assert "x 9.54" in screen_text(app)


async def test_without_utf8_arrows_are_words_and_nothing_is_a_question_mark(desk) -> None:
    async with opened(desk, 80, 24, environ=ASCII) as (app, pilot):
        assert "Choose with Up Down Enter or a number" in screen_text(app)
        await pilot.press("f4")
        await step(app, pilot)
        assert "Up Down choose" in screen_text(app)
        await pilot.press("escape", "f1")
        for _ in range(6):
            await step(app, pilot)
            assert "? " not in screen_text(app).replace("? Press", "")
            await pilot.press("pagedown")
