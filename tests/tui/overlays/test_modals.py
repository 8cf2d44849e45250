"""Menus, questions, errors and the manual: keys that come early, focus, the mouse, and the desktop that goes on behind."""

from __future__ import annotations

import sys

import pytest
from textual import events

from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.message import ErrorModal, LogModal
from day6_tui.overlays.prompt import Prompt
from day6_tui.overlays.question import Answer, Question
from tests.tui.fakes import FakeDesk, FakeSimulation, turtle
from tests.tui.screens import opened, screen_lines, screen_text, step
from tests.tui.stepped_time import move_on

NAMED = {"enter": "\r", "escape": "\x1b"}


def burst(app, *keys: str) -> None:
    """Keys that are all there before the first is looked at."""
    for key in keys:
        app.post_message(events.Key(key, key if len(key) == 1 else NAMED.get(key)))


async def test_what_is_typed_right_after_the_palettes_key_is_searched(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        burst(app, "f7", *"drive the c", "enter")
        for _ in range(3):
            await step(app, pilot)
        assert app.scenes.player is not None and app.desktop.overlay is None


async def test_keys_of_one_burst_are_taken_in_their_order(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24) as (app, pilot):
        taken: list[str] = []
        app.desktop.open_overlay(Prompt(app.look, "Name", "", taken.append))
        burst(app, "a", "b", "backspace", "c", "home", "x", "end", "y", "enter")
        await step(app, pilot)
        await step(app, pilot)
        assert taken == ["xacy"]


async def test_a_pasted_text_goes_into_the_line_as_one(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24) as (app, pilot):
        taken: list[str] = []
        app.desktop.open_overlay(Prompt(app.look, "Name", "", taken.append))
        app.post_message(events.Paste("my\nfile.svg "))
        burst(app, "enter")
        await step(app, pilot)
        await step(app, pilot)
        assert taken == ["my file.svg"]


async def test_keys_typed_after_the_one_that_closes_go_to_the_pane_below(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        app.desktop.open_overlay(Prompt(app.look, "Name", "", lambda text: None))
        await step(app, pilot)
        burst(app, "a", "enter", "l", "s")
        for _ in range(3):
            await step(app, pilot)
        assert desk.terminals[0].sent == "ls"


@pytest.mark.parametrize("way", ["escape", "ctrl+c", "outside"])
async def test_the_pane_that_had_the_keyboard_gets_it_back(desk: FakeDesk, way: str) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        app.desktop.focus_pane(pane)
        await pilot.press("f7")
        await step(app, pilot)
        assert app.desktop.overlay is not None and not pane.has_focus
        await (pilot.click(offset=(1, 14)) if way == "outside" else pilot.press(way))
        await step(app, pilot)
        assert app.desktop.overlay is None and app.screen.focused is pane and pane.has_focus


async def test_a_click_chooses_and_one_in_the_frame_does_not_close(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        chosen: list[str] = []
        entries = [MenuEntry(name, "", lambda name=name: chosen.append(name)) for name in ("alpha", "omega")]  # type: ignore[misc]
        app.desktop.open_overlay(Menu(app.look, "menu.palette", entries))
        await step(app, pilot)
        row, line = next((row, line) for row, line in enumerate(screen_lines(app)) if "omega" in line)
        await pilot.click(offset=(line.index("omega"), row - 2))  # the line to type in
        await step(app, pilot)
        assert app.desktop.overlay is not None
        await pilot.click(offset=(line.index("omega"), row))
        await step(app, pilot)
        assert chosen == ["omega"] and app.desktop.overlay is None


async def test_the_turtle_moves_behind_the_palette(desk: FakeDesk) -> None:
    simulation = FakeSimulation(turtle(x=2.0))
    desk.display.open("turtlesim", "TurtleSim", simulation)
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        await pilot.press("f4")
        await step(app, pilot)
        before = screen_text(app)
        assert "x 2.00" in before
        simulation.show(turtle(x=9.0))
        await step(app, pilot)
        assert "x 9.00" in screen_text(app) and "Windows and terminals" in screen_text(app)
        desk_screen = app.desktop.screen
        assert not desk_screen._repaint_required and not desk_screen._compositor._dirty_regions, "drawn again for ever"


async def test_a_palette_opened_while_the_desk_is_still_starting_stays(desk: FakeDesk) -> None:
    from day6_tui.app import Day6App
    from day6_tui.options import Options
    from tests.tui.screens import UTF8, make_look, running

    options = Options(fps=0, lang="en")
    app = Day6App(options, desk=desk, look=make_look(options, UTF8))
    async with running(app, 80, 24) as pilot:
        app.actions["palette"]()
        for _ in range(50):
            await step(app, pilot)
            if desk.terminals:
                break
        await step(app, pilot)
        assert isinstance(app.desktop.overlay, Menu) and desk.terminals


async def test_the_palette_opened_while_a_scene_plays_stays_and_keeps_the_keyboard(desk: FakeDesk) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation(turtle()))  # what the scene waits for, seconds only
    async with opened(desk, 120, 40, lang="en", scene="turtle") as (app, pilot):
        await pilot.press("f7")
        await step(app, pilot)
        assert isinstance(app.desktop.overlay, Menu)
        for _ in range(1000):
            await step(app, pilot)
            desk.terminals[-1].busy = len(desk.terminals) == 3 and desk.terminals[-1].sent.endswith("\r")
            if desk.terminals[-1].busy:
                break
            move_on(0.03)
        assert len(desk.terminals) == 3, "the scene goes on"
        burst(app, *"zzz")
        await step(app, pilot)
        await step(app, pilot)
        assert isinstance(app.desktop.overlay, Menu)
        assert app.look.texts("menu.none") in screen_text(app)
        await pilot.press("escape")
        await step(app, pilot)
        assert app.screen.focused is app.desktop.focused_pane


async def test_the_palette_stays_when_the_pane_behind_it_goes_or_another_one_comes(desk: FakeDesk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation(turtle()))
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        app.desktop.go_to_pane(app.desktop.panes[window.number])
        await pilot.press("f7")
        await step(app, pilot)
        window.close()
        desk.open_terminal(80, 24)
        await step(app, pilot)
        await step(app, pilot)
        assert len(app.terminals.panes) == 2 and not app.desktop.panes
        assert isinstance(app.desktop.overlay, Menu)
        await pilot.press("escape")
        await step(app, pilot)
        assert app.screen.focused is app.terminals.current


async def test_a_question_about_a_terminal_that_ends_meanwhile_closes(desk: FakeDesk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2")
        await step(app, pilot)
        asked, pane = desk.terminals[-1], app.terminals.current
        app.terminals.find()
        await step(app, pilot)
        assert app.desktop.overlay is not None and app.desktop.overlay.about is pane
        asked.closed = True
        await step(app, pilot)
        assert app.desktop.overlay is None and app.screen.focused is app.terminals.current


@pytest.mark.parametrize(
    ("keys", "answer"),
    [(["enter"], "yes"), (["y"], "yes"), (["Y"], "yes"), (["right", "enter"], "no"), (["d"], "no"), (["escape"], ""),
     (["left", "enter"], ""), (["n"], "")],
)  # fmt: skip
async def test_each_answer_has_a_button_and_a_key(desk: FakeDesk, keys: list[str], answer: str) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        given: list[str] = []
        answers = [
            Answer("y", "Save", lambda: given.append("yes")),
            Answer("d", "Discard", lambda: given.append("no")),
        ]
        app.desktop.open_overlay(Question(app.look, "Title", "Save it?", answers))
        await step(app, pilot)
        assert "Y Save" in screen_text(app) and "Esc Back" in screen_text(app)
        await pilot.press(*keys)
        await step(app, pilot)
        assert "".join(given) == answer and app.desktop.overlay is None


async def test_an_error_is_shown_as_it_is_and_its_button_closes_it(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.open_overlay(ErrorModal(app.look, "[bold]no markup[/] \x1b[31m in here\nsecond line"))
        await step(app, pilot)
        seen = screen_text(app)
        assert "[bold]no markup[/]" in seen and "second line" in seen and "\x1b" not in seen
        await pilot.click("Button")
        await step(app, pilot)
        assert app.desktop.overlay is None


@pytest.mark.long
@pytest.mark.parametrize("width", [80, 120])
async def test_every_page_of_the_manual_is_reached_by_tab_and_by_searching(desk: FakeDesk, width: int) -> None:
    from day6_tui.overlays.manual import pages

    async with opened(desk, width, 30, lang="en") as (app, pilot):
        await pilot.press("f1")
        await step(app, pilot)
        seen = set()
        for _ in pages():
            app.screen.action_turn(1)
            await pilot.pause()
            seen.add(screen_lines(app)[1].partition("Help: ")[2].partition(" ━")[0])
            assert "`" not in screen_text(app), "commands are drawn as code"
        assert seen == {app.look.texts(f"manual.{page}") for page in pages()}
        burst(app, "tab", *"tread", "ctrl+u", *"Randomize")
        await step(app, pilot)
        assert "A slider for every movable joint" in screen_text(app) and "Help: Joint sliders" in screen_lines(app)[1]
        await pilot.press("enter")
        await step(app, pilot)
        assert "Help: Joint sliders" in screen_lines(app)[1] and "type to search" in screen_text(app)
        await pilot.press("enter")
        await step(app, pilot)
        assert app.desktop.overlay is None


def test_a_command_in_the_manual_is_code_also_where_it_goes_on_in_the_next_line() -> None:
    from day6_tui.overlays.manual import page_of

    assert page_of("Type `ros2 topic echo /a` here", 17) == "Type `ros2 topic`  \n`echo /a` here"


async def test_the_manual_begins_with_the_keys_of_the_focused_window(desk: FakeDesk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        pane.key_hints = lambda: [("w", "wags <its> *tail*")]
        app.desktop.focus_pane(pane)
        await pilot.press("f1")
        await step(app, pilot)
        assert screen_lines(app)[3].strip("┃ ") == "w           wags <its> *tail*"
        assert "11.09 metres" in screen_text(app)


@pytest.mark.parametrize("size", [(40, 10), (20, 6), (10, 3)])
async def test_whatever_is_open_a_small_terminal_survives_it(desk: FakeDesk, size: tuple[int, int]) -> None:
    async with opened(desk, *size, lang="zh") as (app, pilot):
        for key in ("f1", "f7", "f4"):
            await pilot.press(key)
            await step(app, pilot)
            assert app.desktop.overlay is not None and len(screen_lines(app)) == size[1]
            await pilot.resize_terminal(80, 24)
            await step(app, pilot)
            await pilot.resize_terminal(*size)


@pytest.mark.parametrize("environ", [{"LANG": "C", "TERM": "xterm"}, {"LANG": "C", "TERM": "xterm", "NO_COLOR": "1"}])
async def test_without_utf8_modals_and_their_scroll_bars_are_ascii(desk: FakeDesk, environ: dict[str, str]) -> None:
    async with opened(desk, 80, 24, environ=environ) as (app, pilot):
        for key, marks in (("f7", "#|"), ("f1", "#|"), ("f4", "")):
            await pilot.press(key)
            await step(app, pilot)
            assert screen_text(app).isascii() and all(mark in screen_text(app) for mark in marks)
        await pilot.press("escape")


# -- leaving -----------------------------------------------------------------------------------------------------------


async def test_leaving_names_what_still_runs_and_ends_it_when_told(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        left: list[object] = []
        app.exit = lambda *result, **more: left.append(more)  # type: ignore[method-assign]
        await pilot.press("f2")
        await step(app, pilot)
        for terminal, title in zip(
            desk.terminals, ("ros2 run turtlesim turtlesim_node", "python3 talker.py"), strict=True
        ):
            terminal.busy, terminal.title = True, title
        await pilot.press("ctrl+q")
        await step(app, pilot)
        assert "turtlesim_node, talker.py are running. End all and quit?" in screen_text(app)
        await pilot.press("escape")
        await step(app, pilot)
        assert left == [] and app.desktop.overlay is None
        await pilot.press("ctrl+q", "enter")
        await step(app, pilot)
        assert left == [{}]
        await pilot.press("ctrl+q", "ctrl+q")
        assert left == [{}, {}]


async def test_leaving_does_not_ask_while_only_shells_wait(desk: FakeDesk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await pilot.press("ctrl+q")
        await pilot.pause()
    assert app.return_code == 1, "it has left; the home of this desk takes no layout"


# -- themes ------------------------------------------------------------------------------------------------------------


async def test_the_chosen_theme_is_worn_by_panes_and_widgets_and_found_again(desk: FakeDesk) -> None:
    from day6_tui.app import Day6App

    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.actions["theme"]()
        await step(app, pilot)
        await pilot.press(*"high", "enter")
        await step(app, pilot)
        assert app.look.colours.name == app.theme == "contrast"
        assert sys.platform == "win32" or app.settings.path.stat().st_mode & 0o077 == 0
    again = Day6App()
    assert again.look.colours.name == again.theme == "contrast"


@pytest.mark.parametrize("text", [b"\xff\xfe", b"[1]", b'{"theme": 7}', b'{"theme": "pink"}', b"[" * 70_000, b"{"])
async def test_settings_that_cannot_be_understood_are_told_and_left_alone(
    desk: FakeDesk, text: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_tui.app import Day6App
    from day6_tui.settings import Settings

    path = Settings().path
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(text)
    app = Day6App()
    assert app.look.colours.name == "dark" and path.read_bytes() == text
    told: list[str] = []
    monkeypatch.setattr(Day6App, "notify", lambda self, message, **more: told.append(message))
    if not text.startswith(b'{"'):
        async with opened(desk, 120, 24, lang="en", scene="empty") as (app, pilot):
            await step(app, pilot)
            assert "cannot be read and was left unchanged" in screen_text(app) + "".join(told)
            assert path.read_bytes() == text


async def test_a_log_that_is_closed_at_once_ends_nothing_else(desk: FakeDesk) -> None:
    """Textual's Log measures in a worker; one that outlives its widget fails and takes the desktop with it."""
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.desktop.open_overlay(LogModal(app.look, "Log", ["well done"] * 3))
        await step(app, pilot)
        assert "well done" in screen_text(app)
        assert not list(app.workers)
        burst(app, "escape")
        await step(app, pilot)
        assert app.desktop.overlay is None and app.is_running


# -- the distribution --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lang", "told"), [("en", "Rolling from the next start"), ("zh", "下次打开 day6-tui 时就是 rolling")]
)
async def test_the_chosen_distribution_is_that_of_the_next_start(
    desk: FakeDesk, lang: str, told: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    from day6_core.ros import distribution
    from day6_tui.settings import Settings

    async with opened(desk, 80, 24, lang=lang, scene="empty") as (app, pilot):
        app.actions["distro"]()
        await step(app, pilot)
        assert "/opt/ros/humble" in screen_text(app)
        await pilot.press(*"roll", "enter")
        await step(app, pilot)
        assert told.lower() in screen_text(app).lower()
    assert (Settings().text("distro"), distribution.current()) == ("rolling", "jazzy")


async def test_a_distribution_named_at_the_start_is_remembered(desk: FakeDesk) -> None:
    from day6_tui.settings import Settings

    async with opened(desk, 80, 24, lang="en", scene="empty", distro="humble"):
        pass
    assert Settings().text("distro") == "humble"
