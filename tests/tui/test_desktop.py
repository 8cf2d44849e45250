"""The desktop as a whole: scenes, focus, windows that come and go, time, looks, and what happens when something breaks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len
from textual import events

from day6_core.lessons.actions import filled
from day6_core.lessons.player import Steering
from day6_core.lessons.scene import scenes
from day6_core.lessons.scene_player import ScenePlayer
from day6_tui.features.lessons import KEPT_SECONDS
from day6_tui.options import Options
from day6_tui.overlays.manual import Manual
from tests.support.waiting import Deadline
from tests.tui.fakes import FakeSimulation, turtle
from tests.tui.screens import opened, screen_lines, screen_text, step
from tests.tui.stepped_time import move_on


class _Stage:
    """Notes what a scene does; everything it waits for is there at once, unless `missing`."""

    def __init__(self, missing: bool = False) -> None:
        self.done: list[str] = []
        self.missing = missing

    def use_terminal(self, which: str) -> None:
        self.done.append(f"[{which}]")

    def send(self, text: str) -> None:
        self.done.append(text)

    def ready(self) -> bool:
        return not self.missing

    def holds(self, condition: object) -> bool:
        return not self.missing

    def is_heard(self, name: str) -> bool:
        return not self.missing

    def reading_keys(self) -> bool:
        return not self.missing

    def say(self, text: str) -> None:
        self.done.append(f"({text})")


def _player(scene: str, stage: _Stage, robot: str = "", *, visibly: bool = True) -> ScenePlayer:
    actions = filled(list(scenes()[scene].actions), {"robot": robot})
    return ScenePlayer(actions, stage, Steering(seen=visibly))


def _play(scene: str, stage: _Stage, robot: str = "", *, visibly: bool = True) -> float:
    player = _player(scene, stage, robot, visibly=visibly)
    now = 1000.0
    while not player.done:
        player.advance(now)
        now += 1 / 30
    return now - 1000.0


def test_the_turtle_scene_types_its_commands_letter_by_letter() -> None:
    stage = _Stage()
    seconds = _play("turtle", stage)
    commands = ("turtlesim turtlesim_node", "turtlesim turtle_teleop_key")
    run, teleop = (f"ros2 run {command}\r" for command in commands)
    assert "".join(stage.done) == f"[idle]{run}[new]ros2 topic echo /turtle1/cmd_vel\r[new]{teleop}"
    assert len(stage.done) > 90
    assert 3 < seconds < 8


def test_a_window_that_never_comes_ends_the_scene_there() -> None:
    stage = _Stage(missing=True)
    assert _play("turtle", stage, visibly=False) < 15
    assert "".join(stage.done) == "[idle]ros2 run turtlesim turtlesim_node\r"


def test_a_program_that_failed_ends_the_scene_sooner() -> None:
    stage = _Stage(missing=True)
    stage.ready = lambda: True  # type: ignore[method-assign]
    assert _play("turtle", stage, visibly=False) < 3


@pytest.mark.parametrize("robot", ["", " robot:='/my robot.urdf'"])
def test_the_car_scene_types_what_a_teacher_would_show(robot: str) -> None:
    stage = _Stage()
    _play("car", stage, robot, visibly=False)
    launch, spin = f"ros2 launch day6_bot car.launch.py{robot}\r", "ros2 run day6_bot wheel_spinner\r"
    assert stage.done == ["[idle]", launch, "[new]", spin]


def test_in_a_hurry_a_command_is_typed_at_once() -> None:
    stage = _Stage()
    assert _play("turtle", stage, visibly=False) < 1
    assert "ros2 run turtlesim turtlesim_node\r" in stage.done


async def test_choosing_the_turtle_types_into_three_terminals_and_leaves_the_keyboard_with_the_teleop(desk) -> None:
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await pilot.press("1")
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        for _ in range(5):
            await step(app, pilot)
        assert desk.terminals[0].sent == "ros2 run turtlesim turtlesim_node\r"
        assert desk.terminals[1].sent == "ros2 topic echo /turtle1/cmd_vel\r"
        assert desk.terminals[2].sent == "ros2 run turtlesim turtle_teleop_key\r"
        assert app.screen.focused is app.terminals.current
        assert app.terminals.current.view.terminal is desk.terminals[2]


async def test_what_is_typed_while_a_scene_plays_is_not_lost(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="turtle") as (app, pilot):
        assert app.scenes.player is not None
        await pilot.press("up", "a")
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        terminal = None
        for _ in range(8):
            await step(app, pilot)
            terminal = desk.terminals[-1]
            terminal.busy = len(desk.terminals) == 3 and terminal.sent.endswith("\r")
            move_on(0.03)
        assert app.scenes.player is None
        assert terminal.sent == "ros2 run turtlesim turtle_teleop_key\r\x1b[Aa"


async def test_escape_stops_a_scene(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="turtle") as (app, pilot):
        await pilot.press("escape")
        await step(app, pilot)
        assert app.scenes.player is None and "turtle_teleop_key" not in "".join(
            terminal.sent for terminal in desk.terminals
        )


async def test_the_guide_types_a_command_but_leaves_running_it_to_the_user(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        app.desktop.focus_pane(app.welcome)
        await pilot.press("enter")
        assert desk.terminals[0].sent == "ros2 run turtlesim turtlesim_node"
        assert app.screen.focused is app.terminals.current


async def test_a_command_typed_at_the_welcome_choices_goes_to_the_terminal_whole(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        assert app.screen.focused is app.welcome
        await pilot.press(*"ros2 node list", "enter")
        await step(app, pilot)
        assert desk.terminals[0].sent == "ros2 node list\r"
        assert app.screen.focused is app.terminals.current and app.scenes.player is None


async def test_quick_fingers_at_the_welcome_choices_lose_no_key(desk) -> None:
    """All keys are there before the first is looked at, as when a line is sent by a program."""
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        for char in "ls 2 1":
            app.welcome.post_message(events.Key("space" if char == " " else char, char))
        app.welcome.post_message(events.Key("enter", "\r"))
        await step(app, pilot)
        assert desk.terminals[0].sent == "ls 2 1\r" and app.scenes.player is None


async def test_what_is_pasted_at_the_welcome_choices_goes_to_the_terminal(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.welcome.post_message(events.Paste("ros2 topic list"))
        await step(app, pilot)
        assert desk.terminals[0].sent == "<ros2 topic list>" and app.screen.focused is app.terminals.current


async def test_typing_at_the_guide_takes_a_terminal_in_which_nothing_runs(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        desk.terminals[0].busy = True
        app.desktop.focus_pane(app.welcome)
        await pilot.press(*"2d")
        await step(app, pilot)
        assert desk.terminals[0].sent == "" and desk.terminals[1].sent == "2d"


async def test_what_lay_over_a_pane_goes_when_the_keyboard_goes_to_another(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await pilot.press("f4", "f2")
        await step(app, pilot)
        assert app.desktop.overlay is None and "Windows and terminals" not in screen_text(app)
        assert app.screen.focused is app.terminals.current


def test_the_world_scene_launches_the_world_and_ends_where_the_keyboard_drives() -> None:
    stage = _Stage()
    _play("world", stage, visibly=False)
    assert stage.done == [
        "[idle]",
        "ros2 launch day6_world world.launch.py world:=walls\r",
        "[new]",
        "ros2 run teleop_twist_keyboard teleop_twist_keyboard\r",
    ]


async def test_f3_goes_through_terminals_and_windows_as_they_stand(desk) -> None:
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        await step(app, pilot)
        await pilot.press("f2")
        seen = []
        for _ in range(4):
            await pilot.press("f3")
            seen.append(app.desktop.focused_pane.slot)
        assert seen == [2, 1, 3, 2]  # the window stands on the right of both terminals


@pytest.mark.parametrize("key", ["f3", "shift+f3"])
async def test_f3_goes_through_hidden_tabs_too(desk, key) -> None:
    for title in ("First", "Second", "Third"):
        desk.display.open("rviz-like", title, object())
    async with opened(desk, 60, 16, lang="en") as (app, pilot):
        await step(app, pilot)
        app.desktop.focus_pane(app.terminals.current)
        seen = []
        for _ in range(4):
            await pilot.press(key)
            pane = app.desktop.focused_pane
            assert app.desktop.is_shown(pane)
            seen.append(pane.slot)
        assert sorted(seen) == [1, 2, 3, 4] and seen[-1] == 1


async def test_on_a_small_screen_the_guide_gives_way_to_a_terminal_that_is_full(desk) -> None:
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        assert "No window is open" in screen_text(app)
        height = app.terminals.current.size.height
        desk.terminals[0].write("\r\n".join(map(str, range(30))))
        await step(app, pilot)
        await step(app, pilot)
        assert height < app.terminals.current.size.height == 22 and "No window is open" not in screen_text(app)
        await pilot.press("f3")
        await step(app, pilot)
        assert "No window is open" in screen_text(app)
        await pilot.press("f3")
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        await step(app, pilot)
        await step(app, pilot)
        assert len(app.desktop.shown()) == 2 and " 2 TurtleSim " in screen_text(app)


async def test_on_a_wide_screen_the_guide_stays(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        desk.terminals[0].write("\r\n".join(map(str, range(60))))
        await step(app, pilot)
        await step(app, pilot)
        assert "No window is open" in screen_text(app)


async def test_the_help_of_the_guide_is_about_the_guide(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await pilot.press("f1")
        await step(app, pilot)
        assert "with a number" in screen_text(app)
        await pilot.press("escape")
        app.welcome.show_guide()
        await pilot.press("f1")
        await step(app, pilot)
        assert "No window is open, so here are" in screen_text(app)


@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
async def test_the_focused_pane_has_the_heavy_frame_and_only_it(desk, size) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, *size, lang="en") as (app, pilot):
        for _ in range(3):
            await pilot.press("f3")
            await step(app, pilot)
            assert screen_text(app).count("┏") == 1


async def test_the_names_of_windows_that_cannot_be_seen_stand_on_the_frame(desk) -> None:
    for title in ("TurtleSim", "Second", "Third", "Fourth", "Fifth", "Sixth"):
        desk.display.open("turtlesim", title, FakeSimulation())
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await step(app, pilot)
        shown = {pane.slot for pane in app.desktop.shown()}
        assert len(shown) < 7
        text = screen_text(app)
        for slot in app.desktop.slots:
            assert f" {slot} " in text


async def test_f8_enlarges_and_puts_back(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        app.desktop.focus_pane(pane)
        small = pane.size
        await pilot.press("f8")
        await step(app, pilot)
        assert pane.size == (80, 22) and " +1 " in screen_lines(app)[1]
        await pilot.press("f3")
        await step(app, pilot)
        assert app.terminals.current.size == (80, 22)
        await pilot.press("f8")
        await step(app, pilot)
        assert pane.size == small


async def test_f4_lists_everything_and_del_closes(desk) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await step(app, pilot)
        await pilot.press("f4")
        await step(app, pilot)
        assert "TurtleSim" in screen_text(app) and "Windows and terminals" in screen_text(app)
        await pilot.press("delete", "escape")
        await step(app, pilot)
        assert desk.display.windows == []


async def test_the_palette_finds_a_command_by_either_language(desk) -> None:
    async with opened(desk, 80, 24, lang="zh") as (app, pilot):
        await pilot.press("f7")
        await pilot.press(*"light")
        await step(app, pilot)
        assert "配色：深色、浅色" in screen_text(app) and "新终端" not in screen_text(app)
        await pilot.press("enter")
        await step(app, pilot)
        assert "高对比度" in screen_text(app)
        await pilot.press(*"浅色", "enter")
        await step(app, pilot)
        assert app.look.colours.name == "light" and app.desktop.overlay is None


async def test_keys_find_a_pane_although_the_keyboard_is_with_a_menu_that_was_closed(desk) -> None:
    async with opened(desk, 80, 24) as (app, pilot):
        await pilot.press("f2")
        await pilot.press("f7")
        menu = app.desktop.overlay
        await pilot.press("escape")
        await step(app, pilot)
        for gone in (menu, None):
            app.screen.focused = gone
            await pilot.press(*"echo")
            await step(app, pilot)
            assert app.screen.focused is app.terminals.current
        assert "".join(app.terminals.current.view.terminal.sent) == "echoecho"


async def test_the_language_changes_at_once(desk) -> None:
    async with opened(desk, 80, 24, lang="zh") as (app, pilot):
        assert "退出" in screen_text(app)
        app.actions["language"]()
        await step(app, pilot)
        assert "Quit" in screen_text(app) and "退出" not in screen_text(app)


async def test_every_glyph_set_can_be_chosen_while_a_window_is_open(desk) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation(turtle("a"), turtle("b", 2.0)))
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        seen = set()
        for _ in range(4):
            app.actions["glyphs"]()
            await step(app, pilot)
            seen.add(screen_text(app))
        assert len(seen) == 4


async def test_f9_lets_the_world_stand_and_run(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await pilot.press("f9")
        await step(app, pilot)
        assert desk.clock.paused and "paused" in screen_lines(app)[0] and "Run" in screen_lines(app)[-1]
        app.actions["step"]()
        assert desk.steps == [0.016]
        await pilot.press("f9")
        await step(app, pilot)
        assert not desk.clock.paused and "paused" not in screen_lines(app)[0]


async def test_another_speed_is_shown_with_what_it_does_not_reach(desk) -> None:
    async with opened(desk, 120, 24, lang="en") as (app, pilot):
        app.actions["slower"]()
        await step(app, pilot)
        assert desk.clock.speed == 0.5
        assert "0.5×" in screen_lines(app)[0] and "your own programs keep normal speed" in screen_lines(app)[-1]


async def test_a_click_on_a_tab_shows_its_pane(desk) -> None:
    async with opened(desk, 40, 10, lang="en") as (app, pilot):
        await pilot.press("f2")
        await step(app, pilot)
        assert app.desktop.focused_pane.slot == 2
        await pilot.click(offset=(3, 1))
        assert app.desktop.focused_pane.slot == 1


async def test_a_click_on_the_key_bar_does_what_the_key_does(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await step(app, pilot)
        await pilot.click(app.bottom, offset=(4, 0))
        assert len(desk.terminals) == 2


async def test_a_window_that_cannot_be_drawn_says_why_and_nothing_else_stops(desk) -> None:
    class Broken:
        node_name = "/x"

        @property
        def scene(self) -> object:
            raise ValueError("no scene today")

    desk.display.open("turtlesim", "TurtleSim", Broken())
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await step(app, pilot)
        text = screen_text(app)
        assert "This window cannot be drawn: ValueError: no scene today" in text
        await pilot.press("f2", "x")
        assert desk.terminals[1].sent == "x"


async def test_an_unknown_kind_of_window_says_so(desk) -> None:
    desk.display.open("gazebo", "Gazebo", object())
    async with opened(desk, 120, 40, lang="zh") as (app, pilot):
        await step(app, pilot)
        assert "画不出来：LookupError: no window of the kind 'gazebo'" in screen_text(app)


async def test_a_home_that_cannot_be_used_is_told_in_plain_words(monkeypatch) -> None:
    from day6_tui.app import Day6App
    from tests.tui.screens import UTF8, make_look, running

    options = Options(fps=0, lang="en", home=Path("/proc/nothing/here"))
    app = Day6App(options, look=make_look(options, UTF8))
    async with running(app, 80, 24) as pilot:
        await pilot.pause()
        await pilot.pause()
    assert app.return_code == 1


async def test_when_nothing_changed_nothing_is_refreshed(desk) -> None:
    desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en") as (app, pilot):
        await step(app, pilot)
        await step(app, pilot)
        refreshed: list[object] = []
        for pane in app.screen.query("Pane"):
            pane.refresh = lambda *regions, pane=pane, **kw: refreshed.append(pane)  # type: ignore[method-assign]
        for _ in range(10):
            app.frames.step()
        assert refreshed == []


async def test_a_click_on_the_cross_closes_a_window_that_had_not_the_keyboard(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        pane = app.desktop.panes[window.number]
        app.desktop.focus_pane(app.terminals.current)
        await step(app, pilot)
        x, y = screen_lines(app)[1].rindex(" × ") + 1, 1
        assert pane.hit(x - pane.region.x, y - pane.region.y) is not None
        pane.touch()  # as the focus does, between pressing the button and letting it go
        assert pane.hit(x - pane.region.x, y - pane.region.y) is not None
        await pilot.click(offset=(x, y))
        await step(app, pilot)
        assert window.closed


async def test_quitting_leaves_no_frame_behind(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        await pilot.press("ctrl+q")
        await pilot.pause()
    assert app.frames._loop is None and app.return_code == 1, "the home of this desk takes no layout"


async def test_a_new_window_never_covers_the_pane_with_the_keyboard(desk) -> None:
    """Else no frame is bright and nobody sees where the keys go."""
    for size in ((80, 24), (40, 10), (20, 5)):
        desk = type(desk)()
        async with opened(desk, *size, lang="en", scene="empty") as (app, pilot):
            for title in ("First", "Second", "Third"):
                desk.display.open("turtlesim", title, FakeSimulation())
                await step(app, pilot)
                assert app.desktop.focused_pane.slot == 1 and app.desktop.is_shown(app.desktop.focused_pane)
            for slot in (2, 3):
                app.desktop.focus_pane(app.desktop.slots[slot])
                desk.display.open("turtlesim", "More", FakeSimulation())
                await step(app, pilot)
                assert app.desktop.focused_pane.slot == slot and app.desktop.is_shown(app.desktop.focused_pane)


async def test_who_goes_elsewhere_while_a_new_window_appears_stays_there(desk) -> None:
    for goes in (False, True):
        desk = type(desk)()
        async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
            await pilot.press("f2")
            await step(app, pilot)
            window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation(), chosen=True)
            app.desktop.show_windows(desk.display.windows)
            if goes:
                app.desktop.focus_pane(app.desktop.slots[1])
            await step(app, pilot)
            there = app.desktop.slots[1] if goes else app.desktop.panes[window.number]
            assert app.desktop.focused_pane is there and app.screen.focused is there.focus_target


async def test_of_two_new_windows_the_last_gets_the_keyboard(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        for title in ("First", "Second"):
            window = desk.display.open("turtlesim", title, FakeSimulation(), chosen=True)
        app.desktop.show_windows(desk.display.windows)
        await step(app, pilot)
        assert app.desktop.focused_pane is app.desktop.panes[window.number]


async def test_the_hint_of_a_teleop_terminal_names_a_key_that_leads_there(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2", "f2", "f2")
        desk.terminals[1].busy = True
        teleop = app.terminals.panes[1]
        for pane in app.terminals.panes:
            app.desktop.focus_pane(pane)
            await step(app, pilot)
            if pane is teleop:
                assert "click or" not in screen_text(app)
                continue
            key = screen_text(app).split("click or ")[1].split()[0]
            await pilot.press({"F3": "f3", "Shift+F3": "shift+f3", "Alt+2": "alt+2"}[key])
            assert app.desktop.focused_pane is teleop


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("program", ["Apple_Terminal", "iTerm.app", "xterm"])
async def test_where_option_types_signs_no_hint_names_a_key_with_alt(desk, lang: str, program: str) -> None:
    environ = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "TERM_PROGRAM": program}
    async with opened(desk, 120, 200, lang=lang, scene="empty", environ=environ) as (app, pilot):
        await pilot.press("f2", "f2", "f2")
        shown = []
        for key in ("f7", "escape", "f4", "escape", "f1"):
            await pilot.press(key)
            await step(app, pilot)
            shown.append(screen_text(app))
        manual = app.desktop.overlay
        assert isinstance(manual, Manual)
        shown += [f"{key} {what}" for key, what in manual._everywhere]
        keys = {app.switching.key_to(pane) for pane in app.terminals.panes}
        names = [name for name in ("Alt+\\", "Alt+-", "Alt+1", "Alt+←") if name in "\n".join(shown)]
        if program == "xterm":
            assert names == ["Alt+\\", "Alt+-", "Alt+1", "Alt+←"] and "Alt+2" in keys
            assert "Option" not in "\n".join(shown)
        else:
            assert names == [] and keys <= {"F3", "Shift+F3", "F4"}, keys
            assert "Option" in "\n".join(shown)


async def test_keys_that_come_all_at_once_go_where_they_are_meant(desk) -> None:
    """A slow machine hands over what was typed meanwhile in one piece."""
    for title in ("First", "Second"):
        desk.display.open("turtlesim", title, FakeSimulation())
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        for key in ("f3", "f3", "f3", "x", "f3", "y", "alt+1", "z", "f4", "S", "e", "c", "enter", "q"):
            app.post_message(events.Key(key, key if len(key) == 1 else None))
        await step(app, pilot)
        await step(app, pilot)
        assert desk.terminals[0].sent == "xz"
        assert app.screen.focused.window.title == "Second" and app.desktop.overlay is None


async def test_an_arrow_key_where_it_drives_nothing_names_the_terminal_of_the_teleop(desk) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await pilot.press("f2", "f2")
        told = "Arrow keys only drive in terminal 3: "
        await pilot.press("up")
        await step(app, pilot)
        assert told not in screen_text(app)  # at a prompt they are the history's
        desk.terminals[1].busy, desk.terminals[1].title = True, "ros2 run turtlesim turtle_teleop_key"
        desk.terminals[2].busy, desk.terminals[2].title = True, "ros2 topic echo /turtle1/cmd_vel"
        desk.terminals[2].discipline.front.is_raw = False
        await pilot.press("left")
        await step(app, pilot)
        assert told in screen_text(app) and desk.terminals[2].sent.endswith("\x1b[D")
        app.notices.show("")
        app.desktop.focus_pane(app.desktop.panes[window.number])
        await pilot.press("up")
        await step(app, pilot)
        assert told in screen_text(app)
        app.notices.show("")
        await pilot.press("alt+3", "up")
        await step(app, pilot)
        assert told not in screen_text(app)


@pytest.mark.parametrize(
    ("command", "keys"),
    [
        ("ros2 run teleop_twist_keyboard teleop_twist_keyboard", "The keys i j k l and ,"),
        ("ros2 run turtlebot3_teleop teleop_keyboard", "The keys w a d x and s"),
        ("ros2 run turtlesim turtle_teleop_key", "Arrow keys"),
        ("python3 my_teleop.py", "This program's keys"),
    ],
)
async def test_each_teleop_is_named_with_its_own_keys(desk, command: str, keys: str) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        desk.terminals[0].busy, desk.terminals[0].title = True, command
        await pilot.press("up")
        await step(app, pilot)
        assert (f"Arrow keys do nothing here. {keys} drive" in screen_text(app)) == keys.startswith("The keys")
        app.notices.show("")
        app.desktop.focus_pane(app.desktop.panes[window.number])
        await step(app, pilot)
        assert f"{keys} work only in here: click or" in screen_text(app)
        await pilot.press("up")
        await step(app, pilot)
        assert f"{keys} only drive in terminal 1: F3 goes there" in screen_text(app)


async def test_the_key_that_leads_back_is_told_whole_and_anew_when_it_is_another_one(desk, monkeypatch) -> None:
    window = desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        await step(app, pilot)
        desk.terminals[0].busy, desk.terminals[0].title = True, "ros2 run turtlesim turtle_teleop_key"
        app.desktop.focus_pane(app.desktop.panes[window.number])
        await step(app, pilot)
        assert "Arrow keys: click here or F3" in screen_text(app)
        monkeypatch.setattr(app.switching, "key_to", lambda pane: "Alt+3")
        pane = app.desktop.slots[1]
        deadline = Deadline()
        while pane.key_back != "Alt+3":
            assert not deadline.is_over()
            app.frames.step()
            await pilot.pause()
        # In the frame that brought it: there may be no other one.
        assert "Arrow keys: click here or Alt+3" in screen_text(app)
        (hint,) = pane.content_line(pane.inner_height - 1, 32)  # as wide as it is
        assert hint.text == " Arrow keys: click here or Alt+3"


async def test_a_window_without_a_place_is_announced_and_f4_shows_it(desk) -> None:
    async with opened(desk, 40, 10, lang="en", scene="empty") as (app, pilot):
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        await step(app, pilot)
        assert "TurtleSim is open: F4 shows it" in screen_lines(app)[-1]
        await pilot.press("f4", "enter")
        await step(app, pilot)
        assert screen_lines(app)[1].startswith("┏ 1 ~  2 TurtleSim ")
        assert app.screen.focused.window.title == "TurtleSim"
    desk = type(desk)()
    async with opened(desk, 80, 24, lang="en", scene="empty") as (app, pilot):
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        await step(app, pilot)
        assert "is open" not in screen_lines(app)[-1]


# -- presenting ----------------------------------------------------------------------------------------------------------


def _running() -> tuple[_Stage, ScenePlayer]:
    stage = _Stage()
    return stage, _player("turtle", stage)


def _run(player: ScenePlayer, begin: float, seconds: float) -> float:
    """Advance for so long; return when that was."""
    for frame in range(round(seconds * 30)):
        player.advance(begin + frame / 30)
    return begin + seconds


def test_a_scene_stops_in_the_middle_of_a_word_and_goes_on_there() -> None:
    stage, player = _running()
    now = _run(player, 1000.0, 0.5)
    player.steering.held = True
    typed = "".join(stage.done)
    assert typed.startswith("[idle]ros2 run turt") and not typed.endswith("\r")
    now = _run(player, now, 300.0)
    assert "".join(stage.done) == typed
    player.steering.held = False
    _run(player, now, 8.0)
    assert player.done and "".join(stage.done).count("\r") == 3


def test_a_pause_counts_for_no_wait() -> None:
    stage, player = _running()
    stage.holds = lambda condition: False  # type: ignore[method-assign]
    stage.ready = lambda: stage.done[-1] != "\r"  # type: ignore[method-assign]
    now = _run(player, 1000.0, 3.0)
    player.steering.held = True
    now = _run(player, now, 60.0)
    player.steering.held = False
    now = _run(player, now, 2.0)
    assert not player.done, "it still waits for the window"
    stage.holds = lambda condition: True  # type: ignore[method-assign]
    stage.ready = lambda: True  # type: ignore[method-assign]
    _run(player, now, 8.0)
    assert player.done and "".join(stage.done).count("\r") == 3


def test_one_step_is_one_command() -> None:
    stage, player = _running()
    now = 1000.0
    player.steering.step()
    now = _run(player, now, 2.0)
    assert player.steering.held and "".join(stage.done) == "[idle]"
    for commands in (1, 2):
        player.steering.step()
        now = _run(player, now, 6.0)
        assert player.steering.held and "".join(stage.done).count("\r") == commands
    player.steering.step()
    now = _run(player, now, 6.0)
    assert player.steering.held and "".join(stage.done).count("\r") == 3
    assert not player.done, "whoever takes single steps is not told that this one is the last"
    player.steering.step()
    _run(player, now, 0.1)
    assert player.done


@pytest.mark.parametrize(
    ("speed", "least", "most"), [(0.25, 14, 34), (0.5, 7, 17), (1.0, 3, 8), (2.0, 1.5, 5), (4.0, 0.7, 3)]
)
def test_the_speed_is_that_of_typing_and_of_looking(speed: float, least: float, most: float) -> None:
    _, player = _running()
    player.steering.speed = speed
    now = 1000.0
    while not player.done:
        player.advance(now)
        now += 1 / 60
    assert least < now - 1000.0 < most


def test_a_scene_may_be_any_list_of_steps_and_say_what_it_does() -> None:
    stage = _Stage()
    steps = ({"say": "先看看有哪些节点。"}, {"terminal": "idle"}, {"type": "ros2 node list"}, {"say": ""})
    player = ScenePlayer(steps, stage, Steering(seen=True))
    now = _run(player, 1000.0, 1.0)
    assert stage.done == ["(先看看有哪些节点。)"], "there is time to read it"
    _run(player, now, 6.0)
    assert player.done and "".join(stage.done) == "(先看看有哪些节点。)[idle]ros2 node list\r()"


@pytest.mark.parametrize("size", [(80, 24), (120, 40), (40, 12)])
@pytest.mark.parametrize("lang", ["zh", "en"])
async def test_the_key_bar_shows_the_speed_and_how_to_steer_a_scene(desk, size, lang) -> None:
    async with opened(desk, *size, lang=lang, scene="turtle") as (app, pilot):
        bar = screen_lines(app)[-1]
        assert "1×" in bar and cell_len(bar) <= size[0]
        if size[0] >= 80:
            assert "F9" in bar and "PgDn" in bar and "Esc" in bar
        for key, shown in (
            ("plus", "2×"),
            ("plus", "4×"),
            ("plus", "4×"),
            *[("minus", "2×")],
            ("minus", "1×"),
            ("minus", "½×"),
        ):
            await pilot.press(key)
            await step(app, pilot)
            assert shown in screen_lines(app)[-1]
        assert app.scenes.player is not None and not app.scenes.steering.held


async def test_a_paused_scene_leaves_the_terminal_to_whoever_types(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="turtle") as (app, pilot):
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        await pilot.press("space")
        await step(app, pilot)
        assert "paused" in screen_lines(app)[-1] and not desk.clock.paused
        before = desk.terminals[0].sent
        await pilot.press("l", "s", "space", "enter")
        await step(app, pilot)
        assert desk.terminals[0].sent == before + "ls \r" and app.scenes.player is not None
        await pilot.press("f9")
        await step(app, pilot)
        assert "typing for you" in screen_lines(app)[-1] and not desk.clock.paused
        await pilot.press("escape")
        await step(app, pilot)
        assert app.scenes.player is None
        await pilot.press("f9")
        assert desk.clock.paused, "without a scene it is the world that stands"


async def test_after_the_last_step_f9_goes_on_and_only_then_stops_the_world(desk) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        app.scenes.play([{"terminal": "idle"}, {"type": "ros2 node list"}])
        for typed in ("", "ros2 node list\r"):
            await pilot.press("pagedown")
            await step(app, pilot)
            assert app.scenes.steering.held
            assert desk.terminals[0].sent == typed and "resume" in screen_lines(app)[-1]
        await pilot.press("f9")
        await step(app, pilot)
        assert app.scenes.player is None and not desk.clock.paused
        await pilot.press("f9")
        assert desk.clock.paused


async def test_a_click_on_the_key_bar_steers_a_scene(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="turtle") as (app, pilot):
        for text, expected in ((" + ", 2.0), (" - ", 1.0)):
            await pilot.click(offset=(screen_lines(app)[-1].index(text) + 1, 39))
            await step(app, pilot)
            assert app.scenes.player is not None and app.scenes.steering.speed == expected
        await pilot.click(offset=(screen_lines(app)[-1].index("pause"), 39))
        await step(app, pilot)
        assert app.scenes.steering.held
        await pilot.click(offset=(screen_lines(app)[-1].index("stop"), 39))
        await step(app, pilot)
        assert app.scenes.player is None


async def test_who_speaks_has_a_big_terminal_and_f8_shows_the_picture(desk) -> None:
    async with opened(desk, 120, 40, lang="en", scene="empty") as (app, pilot):
        app.actions["layout.speaker"]()
        desk.display.open("turtlesim", "TurtleSim", FakeSimulation())
        for _ in range(3):
            await step(app, pilot)
        terminal, (picture,) = app.terminals.current, app.desktop.panes.values()
        assert terminal.region.x < picture.region.x and terminal.region.width > picture.region.width
        await pilot.press("f8")
        await step(app, pilot)
        assert picture.region.width == 120 and not app.desktop.is_shown(terminal)
        await pilot.press("f8")
        await step(app, pilot)
        assert app.desktop.focused_pane is terminal and terminal.region.width < 120
        app.terminals.open()
        for _ in range(3):
            await step(app, pilot)
        assert len(app.desktop.plan_now().places) == 2, (
            "another terminal lies behind the first one, or the other way round"
        )
        app.actions["layout.lesson"]()
        await step(app, pilot)
        app.terminals.open()
        for _ in range(3):
            await step(app, pilot)
        assert len(app.desktop.plan_now().places) > 2, "another layout ends it"


@pytest.mark.parametrize("size", [(60, 50), (52, 20), (80, 24)])
@pytest.mark.parametrize("lang", ["zh", "en"])
async def test_the_key_bar_has_the_lessons_also_on_a_phone(desk, size, lang) -> None:
    async with opened(desk, *size, lang=lang) as (app, pilot):
        for _ in range(2):
            await step(app, pilot)
            assert "F5" in screen_lines(app)[-1]
            app.desktop.focus_pane(app.terminals.current)


@pytest.mark.parametrize("early", [False, True], ids=["slow lessons", "slow desk"])
async def test_f5_shows_at_once_that_the_lessons_come_and_enter_waits_for_them(desk, monkeypatch, early: bool) -> None:
    async with opened(desk, 80, 24, lang="zh") as (app, pilot):
        started: list[tuple[str, Any]] = []
        monkeypatch.setattr(app.machine, "start", lambda name, main: started.append((name, main)))
        if early:
            monkeypatch.setattr(app.machine, "desk", None)
        await pilot.press("f5")
        await step(app, pilot)
        assert app.look.texts("lesson.coming") in screen_lines(app)[-1]
        await pilot.press("enter", "enter")
        await step(app, pilot)
        assert app.scenes.player is None and desk.terminals[0].sent == "", "neither the choice nor the terminal had it"
        if early:
            monkeypatch.undo()
            monkeypatch.setattr(app.machine, "start", lambda name, main: started.append((name, main)))
            app.lessons.look_back()
            await step(app, pilot)
        assert [name for name, _ in started] == ["lesson"]
        move_on(KEPT_SECONDS)
        await pilot.press("f5")
        await step(app, pilot)
        assert app.look.texts("lesson.coming") in screen_lines(app)[-1] and len(started) == 1, (
            "it is still being opened"
        )
        app.desktop.focus_pane(app.terminals.current)
        await pilot.press("enter")
        await step(app, pilot)
        assert desk.terminals[0].sent == "\r", "what does not come keeps no key for ever"

        async def fails(session: object) -> int:
            return 1

        monkeypatch.setattr("day6_core.lessons.program.lessons_of", lambda *given: fails)
        await started[0][1](None)
        await step(app, pilot)
        assert app.look.texts("lesson.coming") not in screen_lines(app)[-1]
        await pilot.press("f5")
        assert len(started) == 1, "first it is said that they come"
        await step(app, pilot)
        assert len(started) == 2


async def test_a_lesson_that_was_named_leaves_enter_to_the_terminal(desk, monkeypatch) -> None:
    async with opened(desk, 80, 24, lang="en") as (app, pilot):
        monkeypatch.setattr(app.machine, "start", lambda name, main: None)
        app.lessons.open("day2")
        app.desktop.focus_pane(app.terminals.current)
        await pilot.press("l", "s", "enter")
        await step(app, pilot)
        assert app.look.texts("lesson.coming") in screen_lines(app)[-1] and desk.terminals[0].sent == "ls\r"
