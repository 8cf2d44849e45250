"""The desktop on the real machine: what the first ten seconds of a lesson look like."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell.desk import Desk
from day6_tui.app import Day6App
from day6_tui.options import Options
from tests.support.waiting import Deadline
from tests.tui.screens import UTF8, make_look, screen_lines, screen_text, step

pytestmark = pytest.mark.process


@asynccontextmanager
async def opened(home: Path, width: int = 120, height: int = 40, **options: Any) -> AsyncIterator[tuple[Day6App, Any]]:
    """The desktop with its own machine, frames drawn by the test; the world runs ten times as fast as the wall."""
    desk = Desk(home, join_link=False)
    desk.set_speed(10.0)
    given = Options(fps=0, lang="en", **options)
    app = Day6App(given, desk=desk, look=make_look(given, UTF8))
    desk.start()
    try:
        async with app.run_test(size=(width, height)) as pilot:
            yield app, pilot
    finally:
        desk.close()


async def until(app: Day6App, pilot: Any, condition: Callable[[], object]) -> None:
    """Draw frames until `condition` holds."""
    deadline = Deadline()
    while not condition():
        assert not deadline.is_over(), screen_text(app)
        app.frames.step()
        await pilot.pause(0.02)


def _shows(app: Day6App, text: str) -> Callable[[], bool]:
    return lambda: text in screen_text(app)


def _type(app: Day6App, text: str) -> None:
    pane = app.terminals.current
    assert pane is not None
    pane.view.terminal.send(text)


async def test_the_turtle_drives_within_the_first_minute_of_a_lesson(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        await pilot.press("1")
        await until(app, pilot, _shows(app, "'q' to quit."))
        await until(app, pilot, lambda: app.scenes.player is None)
        assert "x 5.54  y 5.54  θ 0.00" in screen_text(app)
        assert "nodes 2" in screen_lines(app)[0]
        await pilot.press("up")
        await until(app, pilot, _shows(app, "x 7.56  y 5.54  θ 0.00  v 0.0"))
        await pilot.press("left")
        await until(app, pilot, _shows(app, "θ 2.02"))
        # Ctrl-C in the first terminal closes the window.
        app.switching.go_to(1)
        await pilot.press("ctrl+c")
        await until(app, pilot, lambda: app.machine.desk.display.windows == [])
        await until(app, pilot, lambda: "θ 2.02" not in screen_text(app))


async def test_the_arrow_keys_drive_only_in_the_teleop_terminal(tmp_path) -> None:
    async with opened(tmp_path, scene="turtle") as (app, pilot):
        await until(app, pilot, lambda: app.scenes.player is None and "'q' to quit." in screen_text(app))
        app.desktop.focus_pane(next(iter(app.desktop.panes.values())))
        await until(app, pilot, _shows(app, "Arrow keys work only in here"))
        await pilot.press("up")
        app.desktop.focus_pane(app.terminals.panes[-1])
        await pilot.press("left")
        await until(app, pilot, _shows(app, "θ 2.02"))
        assert "x 5.54" in screen_text(app)


async def test_lists_and_echo_tell_the_truth_about_the_turtle(tmp_path) -> None:
    async with opened(tmp_path, scene="turtle") as (app, pilot):
        await until(app, pilot, lambda: app.scenes.player is None and "'q' to quit." in screen_text(app))
        await pilot.press("f2", "f8")
        _type(app, "ros2 node list; ros2 topic list; ros2 topic echo --once /turtle1/pose\r")
        await until(app, pilot, _shows(app, "angular_velocity: 0.0"))
        text = screen_text(app)
        assert "/teleop_turtle" in text and "/turtle1/cmd_vel" in text and "x: 5.544444561004639" in text


async def test_closing_the_window_ends_its_program(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        _type(app, "ros2 run turtlesim turtlesim_node\r")
        await until(app, pilot, lambda: app.desktop.panes)
        app.desktop.focus_pane(next(iter(app.desktop.panes.values())))
        app.actions["close"]()
        await until(app, pilot, lambda: not app.terminals.panes[0].view.terminal.busy and app.desktop.panes == {})


async def test_the_topic_monitor_measures_what_turtlesim_publishes(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        _type(app, "ros2 run turtlesim turtlesim_node & ros2 run rqt_topic rqt_topic\r")
        await until(app, pilot, lambda: len(app.desktop.panes) == 2)
        pane = next(pane for pane in app.desktop.panes.values() if pane.window.kind == "topics")
        await until(app, pilot, lambda: any(topic.name == "/turtle1/pose" for topic in pane.model.topics))
        app.desktop.focus_pane(pane)
        for key in ("f8", "slash", *"pose", "enter"):
            await pilot.press(key)
        await until(app, pilot, _shows(app, "1/1 of "))
        await pilot.press("enter", "right")
        await until(app, pilot, lambda: re.search(r" x +float .* 5\.544444561004639 ", screen_text(app)))
        # 24 bytes, 62.5 times a second of the world, which are as many real ones as its speed says; a busy machine lets
        # the world fall behind, but not in each of the five seconds that are measured together.
        for speed, measured in ((1.0, r" 1\.[45]\d kB/s +6[0-4]\.\d+ "), (0.5, r" 7\d\d B/s +3[01]\.\d+ ")):
            app.machine.desk.set_speed(speed)
            await until(app, pilot, lambda measured=measured: re.search(measured, screen_text(app)))
        await pilot.press("enter")
        await until(app, pilot, _shows(app, "not monitored"))


async def test_the_car_stands_turns_and_stands_again(tmp_path) -> None:
    async with opened(tmp_path, scene="car") as (app, pilot):
        await until(app, pilot, lambda: app.scenes.player is None)
        await until(app, pilot, _shows(app, "rad/s"))
        app.machine.desk.set_speed(1.0)
        await until(app, pilot, lambda: re.search(r"\+(0\.9|1\.0)\d rad/s", screen_text(app)))
        await pilot.press("ctrl+c")
        await until(app, pilot, _shows(app, "nobody publishes /joint_states"))


async def test_pausing_lets_the_turtle_stand_in_mid_drive(tmp_path) -> None:
    async with opened(tmp_path, scene="turtle") as (app, pilot):
        await until(app, pilot, lambda: app.scenes.player is None and "'q' to quit." in screen_text(app))
        app.machine.desk.set_speed(0.5)
        await pilot.press("up")
        await until(app, pilot, lambda: "v 2.0" in screen_text(app))
        await pilot.press("f9")
        await until(app, pilot, _shows(app, "paused"))
        (turtle,) = app.machine.windows()[0].model.scene.turtles
        await until(app, pilot, _shows(app, f"x {turtle.x:.2f}"))  # numbers follow ten times a second
        here = [line for line in screen_lines(app) if "θ" in line]
        for _ in range(5):
            app.frames.step()
            await pilot.pause(0.02)
        assert [line for line in screen_lines(app) if "θ" in line] == here


@pytest.mark.parametrize(
    ("command", "answer"),
    [
        ("ros2 run turtlesim turtle_teleop", "No executable found"),
        ("ros2 run turtelsim turtlesim_node", "Package 'turtelsim' not found"),
        ("ros2 run robot_state_publisher robot_state_publisher nothing.urdf", "No such file or directory"),
        ("frobnicate", "frobnicate: command not found"),
    ],
)
async def test_a_mistake_is_answered_in_the_tools_words_and_the_prompt_comes_back(tmp_path, command, answer) -> None:
    async with opened(tmp_path, 80, 24) as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        _type(app, command + "\r")
        await until(app, pilot, _shows(app, answer))
        await until(app, pilot, lambda: app.terminals.panes[0].view.at_prompt)
        assert app.desktop.panes == {}


@pytest.mark.parametrize("command", ["rqt", "rqt_graph", "rqt --standalone rqt_topic", "ros2 run rqt_msg rqt_msg"])
async def test_a_window_of_rqt_has_the_keyboard_unless_one_goes_on_typing(tmp_path, command: str) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        terminal = app.terminals.current
        _type(app, f"{command} &\r")
        await until(app, pilot, lambda: len(app.desktop.panes) == 1 and app.desktop.panes[1].extent.width)
        for _ in range(5):
            await step(app, pilot)
        assert app.desktop.focused_pane is terminal
        _type(app, f"clear; {command}\r")
        await until(app, pilot, lambda: len(app.desktop.panes) == 2)
        window = app.desktop.panes[max(app.desktop.panes)]
        await until(app, pilot, lambda: app.desktop.focused_pane is window)
        assert app.desktop.is_shown(window)


TWO_WINDOWS = """from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package="turtlesim", executable="turtlesim_node"), Node(package="rviz2", executable="rviz2"),
    ])
"""


@pytest.mark.parametrize("command", ["ros2 launch two.launch.py", "ros2 run rviz2 rviz2", "rviz2"])
async def test_f8_at_a_terminal_that_a_window_occupies_enlarges_that_window(tmp_path, command) -> None:
    (tmp_path / "two.launch.py").write_text(TWO_WINDOWS)
    async with opened(tmp_path, 80, 24, scene="empty") as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        terminal = app.terminals.panes[0]
        terminal.view.terminal.run_line(command)
        kinds = {"turtlesim", "rviz2"} if "launch" in command else {"rviz2"}
        await until(app, pilot, lambda: {pane.window.kind for pane in app.desktop.panes.values()} == kinds)
        await until(app, pilot, lambda: len(app.desktop.shown()) == len(kinds) + 1)
        assert app.desktop.focused_pane is terminal, "what is typed goes where it went"
        assert {pane.window.is_launched for pane in app.desktop.panes.values()} == {"launch" in command}
        await pilot.press("f8")
        newest = list(app.desktop.panes.values())[-1]
        assert app.desktop.enlarged and app.desktop.shown() == [newest]
        await pilot.press("f8")
        assert not app.desktop.enlarged and app.desktop.focused_pane is terminal
        # A terminal that is free is enlarged itself.
        await pilot.press("f2")
        await pilot.pause()
        await pilot.press("f8")
        assert app.desktop.shown() == [app.terminals.panes[-1]]
