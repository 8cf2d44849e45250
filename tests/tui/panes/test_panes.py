"""Panes on the desktop: split, moved, stacked, dragged, closed; by keys and with the mouse."""

from __future__ import annotations

import pytest
from textual import events

from tests.tui.fakes import FakeSimulation
from tests.tui.screens import opened, screen_lines, screen_text, step


def places(app) -> dict[int, tuple[int, int, int, int]]:
    return {pane.slot: tuple(pane.region) for pane in app.desktop.shown()}


async def drag(pilot, x: int, y: int) -> None:
    """Move the mouse with its button down."""
    await pilot._post_mouse_events([events.MouseMove], offset=(x, y), button=1)
    pilot.app.frames.step()
    await pilot.pause()


async def test_alt_and_the_arrows_go_to_the_pane_on_that_side_and_numbers_to_any(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash", "alt+minus")
        await step(app, pilot)
        assert len(places(app)) == 3
        seen = []
        for key in ("alt+up", "alt+left", "alt+left", "alt+right", "alt+3", "alt+2", "alt+9"):
            await pilot.press(key)
            seen.append(app.desktop.focused_pane.slot)
        assert seen == [2, 1, 1, 2, 3, 2, 2]
        await pilot.press("x")
        assert desk.terminals[1].sent == "x" and desk.terminals[0].sent == desk.terminals[2].sent == ""


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_splitting_puts_the_new_terminal_on_that_side(desk, size) -> None:
    async with opened(desk, *size, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash")
        await step(app, pilot)
        one, two = app.desktop.slots[1].region, app.desktop.slots[2].region
        assert two.x == one.right and two.y == one.y
        await pilot.press("alt+minus")
        await step(app, pilot)
        two, three = app.desktop.slots[2].region, app.desktop.slots[3].region
        assert three.y == two.bottom and three.x == two.x
        assert app.desktop.focused_pane.slot == 3


async def test_a_pane_changes_places_with_its_neighbour(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash")
        await step(app, pilot)
        before = places(app)
        app.actions["move.left"]()
        await step(app, pilot)
        assert places(app) == {1: before[2], 2: before[1]} and app.desktop.focused_pane.slot == 2


async def test_a_pane_becomes_a_tab_and_gets_a_place_again(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash")
        app.actions["stack"]()
        await step(app, pilot)
        assert set(places(app)) == {2} and " 1 ~  2 ~ " in screen_lines(app)[1]
        app.actions["stack"]()
        await step(app, pilot)
        assert set(places(app)) == {1, 2}


async def test_borders_move_by_keys(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash")
        await step(app, pilot)
        width = app.desktop.slots[2].size.width
        await pilot.press("alt+shift+left")
        await step(app, pilot)
        assert app.desktop.slots[2].size.width > width
        for _ in range(60):
            await pilot.press("alt+shift+right")
        await step(app, pilot)
        assert 10 <= app.desktop.slots[2].size.width < width
        await pilot.press("alt+shift+up")  # there is no such border
        await step(app, pilot)


async def test_a_border_is_dragged_with_the_mouse_and_the_terminal_learns_its_size(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash", "alt+minus")
        await step(app, pilot)
        edge = app.desktop.slots[1].region.right
        await pilot.mouse_down(offset=(edge - 1, 20))
        await pilot.hover(offset=(edge + 15, 20))
        await pilot.mouse_up(offset=(edge + 15, 20))
        await step(app, pilot)
        assert app.desktop.slots[1].region.right == edge + 15
        assert desk.terminals[0].screen.columns == edge + 13
        lower = app.desktop.slots[3].region.y
        await pilot.mouse_down(offset=(100, lower - 1))
        await pilot.hover(offset=(100, lower - 6))
        await pilot.mouse_up(offset=(100, lower - 6))
        await step(app, pilot)
        assert app.desktop.slots[3].region.y == lower - 5
        assert app.mouse_captured is None


async def test_a_title_is_dragged_onto_another_pane(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash")
        await step(app, pilot)
        target = app.desktop.slots[1].region
        await pilot.mouse_down(offset=(app.desktop.slots[2].region.x + 20, 1))
        await drag(pilot, target.x + 20, target.bottom - 3)
        assert "drop it below ~" in screen_text(app)
        await pilot.mouse_up(offset=(target.x + 20, target.bottom - 3))
        await step(app, pilot)
        assert app.desktop.slots[2].region.y == app.desktop.slots[1].region.bottom
        await pilot.mouse_down(offset=(app.desktop.slots[2].region.x + 20, app.desktop.slots[2].region.y))
        await drag(pilot, 60, 12)
        await pilot.mouse_up(offset=(60, 12))
        await step(app, pilot)
        assert set(places(app)) == {2} and app.desktop.split_tree.stack_of(2).keys == [1, 2]


async def test_a_double_click_on_a_title_enlarges_and_puts_back(desk) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        before = places(app)
        at = (before[2][0] + 20, 1)
        await pilot.click(offset=at, times=2)
        await step(app, pilot)
        assert places(app) == {2: (0, 1, 80, 22)}
        await pilot.click(offset=(40, 1), times=2)
        await step(app, pilot)
        assert places(app) == before


async def test_the_cross_is_there_however_long_the_titles(desk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        for number in range(12):
            await pilot.press("f2")
            desk.terminals[-1].title = f"ros2 topic echo /a/very/long/name/of/a/topic/number{number}"
        for size in ((80, 24), (60, 20), (40, 12), (24, 6), (120, 40)):
            await pilot.resize_terminal(*size)
            await step(app, pilot)
            for pane in app.desktop.shown():
                line = screen_lines(app)[pane.region.y]
                assert line[pane.region.x : pane.region.right].rstrip("┓╮").endswith(" × "), line


async def test_closing_a_busy_terminal_asks_and_ends_it(desk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2")
        desk.terminals[1].busy, desk.terminals[1].title = True, "ros2 run turtlesim turtlesim_node"
        app.actions["close"]()
        await step(app, pilot)
        assert "turtlesim_node is still running" in screen_text(app)
        await pilot.press("escape")
        await step(app, pilot)
        assert not desk.terminals[1].closed and len(app.terminals.panes) == 2
        app.actions["close"]()
        await step(app, pilot)
        await pilot.press("y")
        await step(app, pilot)
        assert desk.terminals[1].closed and len(app.terminals.panes) == 1
        app.actions["close"]()  # idle: without a question
        await step(app, pilot)
        assert desk.terminals[0].closed and len(app.terminals.panes) == 1


async def test_the_keyboard_goes_on_when_its_pane_goes(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2")
        app.desktop.focus_pane(app.desktop.panes[window.number])
        window.close()
        await step(app, pilot)
        assert app.desktop.focused_pane.slot == 3
        await pilot.press("x")
        assert desk.terminals[1].sent == "x"


async def test_the_tab_behind_the_one_that_closes_gets_the_keyboard_if_it_was_used_last(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("alt+backslash", "alt+minus")
        app.desktop.split_tree.move(3, 1, "tab")
        for slot in (2, 1, 3):
            app.switching.go_to(slot)
        app.actions["close"]()
        await step(app, pilot)
        assert app.desktop.focused_pane.slot == 1 and set(places(app)) == {1, 2}
        await pilot.press("x")
        assert desk.terminals[0].sent == "x"


@pytest.mark.long
@pytest.mark.parametrize("size", [(20, 5), (40, 10), (80, 24), (120, 40), (400, 120)])
async def test_thirty_terminals_and_a_storm_of_sizes(desk, size) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, *size, lang="en", scene="empty") as (app, pilot):
        for _ in range(29):
            await pilot.press("f2")
        for other in ((20, 5), (400, 120), (33, 7), size):
            await pilot.resize_terminal(*other)
            for _ in range(20):  # thirty panes that hear of it take their time
                await step(app, pilot)
                if len(screen_lines(app)) == other[1]:
                    break
            assert len(screen_lines(app)) == other[1]
            assert app.desktop.is_shown(app.desktop.focused_pane)
        assert len(app.terminals.panes) == 30
        await pilot.press("x")
        assert desk.terminals[-1].sent == "x"


async def test_the_mouse_on_a_pane_that_closes_meanwhile(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        await pilot.mouse_down(offset=(pane.region.x + 20, 1))
        window.close()
        await step(app, pilot)
        await pilot.hover(offset=(20, 20))
        await pilot.mouse_up(offset=(20, 20))
        await step(app, pilot)
        assert set(places(app)) >= {1} and app.desktop.focused_pane.slot == 1


async def test_a_terminal_in_the_front_of_a_stack_shows_news_of_the_others(desk) -> None:
    async with opened(desk, 40, 12, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2")
        await step(app, pilot)
        assert set(places(app)) == {2}
        desk.terminals[0].write("news\n")
        await step(app, pilot)
        assert "●" in screen_lines(app)[1]
