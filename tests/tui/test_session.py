"""Layouts that are saved and loaded, and the desktop that comes back as it was left, on the real machine."""

from __future__ import annotations

import errno
import json
import os
import threading
from pathlib import Path
from typing import Any

import pytest

from day6_tui.app import Day6App
from day6_tui.panes.layouts import build, describe
from day6_tui.panes.splits import Tree
from day6_tui.settings import Settings
from tests.tui.screens import screen_text
from tests.tui.test_real_desk import opened, until

pytestmark = pytest.mark.process


def session_file(home: Path) -> Path:
    return home / ".config" / "day6-tui" / "session.json"


def trees() -> list[Tree]:
    flat, nested, one = Tree(), Tree(), Tree()
    for key, side in ((1, "right"), (2, "right"), (3, "tab")):
        flat.add(key, key - 1 or None, side)
    for key, side in ((1, "right"), (2, "below"), (3, "right"), (4, "below")):
        nested.add(key, key - 1 or None, side)
    one.add(1)
    return [flat, nested, one]


@pytest.mark.parametrize("tree", trees())
def test_a_layout_is_the_same_after_json(tree: Tree) -> None:
    written = json.loads(json.dumps(describe(tree, str)))
    again = build(written, int)
    assert describe(again, str) == describe(tree, str)


@pytest.mark.parametrize("missing", [1, 2, 3, 4])
def test_what_is_missing_is_closed_up(missing: int) -> None:
    tree = trees()[1]
    again = build(describe(tree, str), lambda role: int(role) if role != str(missing) else None)
    assert sorted(again.keys) == [key for key in (1, 2, 3, 4) if key != missing]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "null",
        "[]",
        "{}",
        '{"version": 99}',
        '{"version": 1}',
        "\x00\xff",
        '{"version": 1, "layout": ' + '{"across": true, "parts": [' * 5000,
        '{"version": 1, "time": 1.0, "layout": {"stack": 3}, "terminals": []}',
        '{"version": 1, "time": 1.0, "layout": null, "terminals": [{"folder": 1, "text": "", "commands": []}]}',
        '{"version": 1, "time": 1.0, "layout": {"across": true, "parts": [], "shares": [NaN]}, "terminals": "x"}',
        '{"version": 1, "time": 1.0, "layout": {"stack": []}, "terminals": [], "views": {"rviz2 1": 7}}',
    ],
)
async def test_a_session_that_cannot_be_understood_is_told_and_stays(tmp_path, text) -> None:
    file = session_file(tmp_path)
    file.parent.mkdir(parents=True)
    file.write_text(text, encoding="latin-1")
    before = file.read_bytes()
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        assert "session.json" in screen_text(app)
        app.session.save()
    assert file.read_bytes() == before


async def test_two_files_that_cannot_be_understood_are_both_told(tmp_path, monkeypatch) -> None:
    for file in (session_file(tmp_path), Settings().path):
        file.parent.mkdir(parents=True)
        file.write_text("[]")
    notified: list[str] = []
    monkeypatch.setattr(Day6App, "notify", lambda self, message, **more: notified.append(message))
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        assert "session.json" in screen_text(app) and "settings.json" in "".join(notified)


async def test_the_desktop_comes_back_as_it_was_left(tmp_path) -> None:
    (tmp_path / "work").mkdir()
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        first = app.terminals.panes[0]
        first.view.terminal.run_line("cd work; echo '\x16\x1b[31mred\x16\x1b[0m'; echo $((6 * 7)) is the answer")
        await until(app, pilot, lambda: "42 is the answer" in screen_text(app))
        await pilot.press("alt+minus")
        app.terminals.panes[1].view.terminal.run_line("ros2 run turtlesim turtlesim_node")
        await until(app, pilot, lambda: app.desktop.panes)
        app.desktop.focus_pane(first)
        layout = app.arranging.described()
        app.exit()
    saved = json.loads(session_file(tmp_path).read_text())
    assert saved["terminals"][1]["commands"] == ["ros2 run turtlesim turtlesim_node"]
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "Start them again?" in screen_text(app))
        assert len(app.terminals.panes) == 2 and app.desktop.focused_pane is app.terminals.panes[0]
        assert "turtlesim_node" in screen_text(app)
        await pilot.press("y")
        await until(app, pilot, lambda: app.desktop.panes)
        await until(app, pilot, lambda: app.arranging.described() == layout)
        await until(app, pilot, lambda: "student@day6:~/work$" in screen_text(app))
        assert "42 is the answer" in screen_text(app) and "[from 20" in screen_text(app)


async def test_rviz_comes_back_with_what_it_showed_although_nobody_saved_it(tmp_path) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        app.terminals.panes[0].view.terminal.run_line("rviz2")
        await until(app, pilot, lambda: app.desktop.panes)
        rviz = next(iter(app.desktop.panes.values())).rviz
        rviz.request(
            lambda: (rviz.add_display("RobotModel"), rviz.fixed.set("base_link"), rviz.set_view("TopDownOrtho"))
        )
        await until(app, pilot, lambda: rviz.view.type == "TopDownOrtho")
        app.exit()
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "Start them again?" in screen_text(app))
        await pilot.press("y")
        await until(app, pilot, lambda: app.desktop.panes)
        again = next(iter(app.desktop.panes.values())).rviz
        await until(app, pilot, lambda: again.view.type == "TopDownOrtho")
        assert again.fixed_frame == "base_link" and again.modified
        assert [display.type for display in again.displays] == [display.type for display in rviz.displays]


async def test_saying_no_leaves_the_terminals_at_their_prompts(tmp_path) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        app.terminals.panes[0].view.terminal.run_line("sleep 1000")
        await until(app, pilot, lambda: app.terminals.panes[0].view.terminal.busy)
        app.exit()
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "sleep 1000" in screen_text(app) and "Start them again?" in screen_text(app))
        await pilot.press("escape")
        await until(app, pilot, lambda: app.terminals.panes[0].view.at_prompt)
        assert not app.terminals.panes[0].view.terminal.busy


async def test_a_session_that_a_full_disk_does_not_take_is_told_and_written_later(tmp_path, monkeypatch) -> None:
    def full(path: Path, data: bytes) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        with monkeypatch.context() as patched:
            patched.setattr("day6_tui.features.saved_desktop.write_private", full)
            app.session.save_meanwhile()
            assert app.session.save() == os.strerror(errno.ENOSPC)
            app.session.save_meanwhile()
            await until(app, pilot, lambda: f"be saved: {os.strerror(errno.ENOSPC)}" in screen_text(app))
            assert not session_file(tmp_path).exists()
        app.session.save_meanwhile()  # though nothing has changed
        await until(app, pilot, session_file(tmp_path).exists)
        assert app.session.save() == ""


async def test_what_a_slow_disk_takes_meanwhile_never_replaces_what_was_saved_at_the_end(tmp_path, monkeypatch) -> None:
    written: list[int] = []
    disk = threading.Event()

    def slow(path: Path, data: bytes) -> None:
        if threading.current_thread() is not threading.main_thread():
            disk.wait()
        written.append(len(json.loads(data)["terminals"]))

    monkeypatch.setattr("day6_tui.features.saved_desktop.write_private", slow)
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        app.session.save_meanwhile()
        await pilot.press("alt+minus")
        await until(app, pilot, lambda: screen_text(app).count("student@day6:~$") == 2)
        threading.Timer(0.3, disk.set).start()
        app.session.save()
        await until(app, pilot, lambda: len(written) == 2)
        assert written == [1, 2]


async def test_one_idle_terminal_is_no_session(tmp_path) -> None:
    for _ in range(2):
        async with opened(tmp_path) as (app, pilot):
            await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
            assert app.screen.focused is app.welcome
            app.exit()


async def _named(app: Any, pilot: Any, name: str) -> None:
    app.actions["layout.save"]()
    await pilot.pause()
    await pilot.press(*name, "enter")
    await pilot.pause()


async def test_a_layout_is_saved_under_a_name_and_comes_back(tmp_path) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        await pilot.press("alt+backslash", "alt+minus")
        layout = app.arranging.described()
        await _named(app, pilot, "mine")
        app.actions["layout.presenter"]()
        assert app.arranging.described() != layout
        app.actions["layout.load"]()
        await pilot.pause()
        await pilot.press(*"mine", "enter")
        await pilot.pause()
        assert app.arranging.described() == layout


async def test_a_foreign_file_of_layouts_is_told_and_never_overwritten(tmp_path) -> None:
    file = session_file(tmp_path).with_name("layouts.json")
    file.parent.mkdir(parents=True)
    file.write_text('{"version": 99, "layouts": {"precious": 1}}')
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        await _named(app, pilot, "mine")
        await until(app, pilot, lambda: "not a layout file" in screen_text(app))
        await pilot.press("escape")
        app.actions["layout.load"]()
        await until(app, pilot, lambda: "Layout: four terminals" in screen_text(app))
    assert "precious" in file.read_text()


async def test_the_ready_layouts(tmp_path) -> None:
    async with opened(tmp_path, 120, 40, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        app.terminals.panes[0].view.terminal.run_line("ros2 run turtlesim turtlesim_node")
        await until(app, pilot, lambda: app.desktop.panes)
        app.actions["layout.four"]()
        await pilot.pause()
        assert len(app.terminals.panes) == 4 and len(app.desktop.shown()) == 5
        app.actions["layout.presenter"]()
        await pilot.pause()
        places = {pane.slot: pane.region for pane in app.desktop.shown()}
        picture = next(iter(app.desktop.panes.values()))
        assert len(places) == 2 and places[picture.slot].width > 80
        app.actions["layout.lesson"]()
        await pilot.pause()
        assert len(app.desktop.shown()) >= 4 and app.desktop.is_shown(picture)


SETUP = """from setuptools import setup
setup(
    name="day6_publisher", version="0.0.0", packages=["day6_publisher"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/day6_publisher"]),
        ("share/day6_publisher", ["package.xml"]),
        ("share/day6_publisher/launch", ["turtle.launch.py"]),
    ],
    entry_points={"console_scripts": ["wheel_spinner = day6_publisher.wheel_spinner:main"]},
)
"""
SPINNER = """import rclpy
def main():
    rclpy.init()
    print("The wheels turn", flush=True)
    rclpy.spin(rclpy.create_node("wheel_spinner"))
"""
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([Node(package="turtlesim", executable="turtlesim_node")])
"""
PACKAGE = """<package format="3"><name>day6_publisher</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.cc">a</maintainer><license>MIT</license><export><build_type>ament_python</build_type></export></package>
"""


def write_package(home: Path) -> None:
    """A pupil's package with a program and a launch file."""
    texts = {"setup.py": SETUP, "package.xml": PACKAGE, "turtle.launch.py": LAUNCH, "resource/day6_publisher": ""}
    texts["setup.cfg"] = (
        "[develop]\nscript_dir=$base/lib/day6_publisher\n[install]\ninstall_scripts=$base/lib/day6_publisher\n"
    )
    texts |= {"day6_publisher/__init__.py": "", "day6_publisher/wheel_spinner.py": SPINNER}
    for name, text in texts.items():
        path = home / "ros2_ws/src/day6_publisher" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


@pytest.mark.parametrize("in_bashrc", [False, True])
async def test_what_is_started_again_finds_the_pupils_own_workspace(tmp_path, in_bashrc) -> None:
    write_package(tmp_path)
    if in_bashrc:
        (tmp_path / ".bashrc").write_text("source ~/ros2_ws/install/setup.bash 2> /dev/null\n")
    runs = "ros2 run day6_publisher wheel_spinner"
    launches = "ros2 launch day6_publisher turtle.launch.py"
    async with opened(tmp_path, 80, 24, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        first = app.terminals.panes[0]
        first.view.terminal.run_line(f"cd ros2_ws; colcon build; source install/setup.bash; {launches}")
        await until(app, pilot, lambda: app.desktop.panes)
        await pilot.press("f2")
        await pilot.pause()
        app.terminals.panes[-1].view.terminal.run_line(f"source ~/ros2_ws/install/setup.bash; {runs}")
        await until(app, pilot, lambda: "The wheels turn" in screen_text(app))
        app.exit()
    async with opened(tmp_path, 80, 24) as (app, pilot):
        await until(app, pilot, lambda: "Start them again?" in screen_text(app))
        await pilot.press("y")
        await until(
            app, pilot, lambda: app.desktop.panes and "The wheels turn" in screen_text(app).split("[from 20")[-1]
        )
        typed = [[run.source.strip() for run in pane.view.terminal.runs.all] for pane in app.terminals.panes]
        sources = ["source install/setup.bash"], ["source ~/ros2_ws/install/setup.bash"]
        assert typed == [
            [*([] if in_bashrc else source), each] for source, each in zip(sources, (launches, runs), strict=True)
        ]


@pytest.mark.parametrize("and_so", ["", " &"])
async def test_what_does_not_start_again_is_seen(tmp_path, and_so: str) -> None:
    left = [
        {"folder": str(tmp_path), "text": "", "commands": commands}
        for commands in ([f"ros2 run nothing nowhere{and_so}"], ["sleep 1000"], [])
    ]
    layout = {"stack": ["terminal 1", "terminal 2", "terminal 3"], "front": "terminal 3"}
    file = session_file(tmp_path)
    file.parent.mkdir(parents=True)
    file.write_text(json.dumps({"version": 1, "time": 1.0, "layout": layout, "terminals": left, "focus": "terminal 3"}))
    async with opened(tmp_path, 80, 24) as (app, pilot):
        await until(app, pilot, lambda: "Start them again?" in screen_text(app))
        assert [pane.slot for pane in app.desktop.shown()] == [3]
        await pilot.press("y")
        await until(app, pilot, lambda: "Package 'nothing' not found" in screen_text(app))
        assert app.desktop.focused_pane is app.terminals.panes[0], "nothing covers the pane with the keyboard"


def typed(app: Day6App, line: str) -> None:
    app.terminals.panes[0].view.terminal.run_line(line)


async def test_a_line_that_sources_another_one_makes_the_desktop_start_again_as_it(
    tmp_path: Path,
) -> None:
    line = "source /opt/ros/lyrical/setup.bash && echo now"
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        typed(app, line)
        await until(app, pilot, lambda: app.distributions.next)
        assert app.distributions.next == "lyrical" and Settings().text("distro") == "lyrical"
    saved = json.loads((tmp_path / ".config" / "day6-tui" / "session.json").read_text(encoding="utf-8"))["terminals"]
    assert saved[0]["again"] == line and "it has to start again to be lyrical" in saved[0]["text"]
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, lambda: app.terminals.panes and app.terminals.panes[0].view.terminal.runs.count)
        assert app.terminals.panes[0].view.terminal.runs.all[0].source.strip() == line


async def test_while_something_runs_it_is_asked_whether_to_start_again_at_once(tmp_path: Path) -> None:
    async with opened(tmp_path, 200) as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        typed(app, "sleep 1000 &")
        typed(app, ". /opt/ros/humble/setup.bash; echo still $ROS_DISTRO")
        await until(app, pilot, lambda: "Start the desktop again now, as humble?" in screen_text(app))
        await until(app, pilot, lambda: "still jazzy" in screen_text(app))  # the line goes on below the question
        assert "It ends sleep" in screen_text(app)
        await pilot.press("escape")
        await until(app, pilot, lambda: app.desktop.overlay is None)
        assert not app.distributions.next
        typed(app, "(source /opt/ros/kilted/setup.bash)")
        await until(app, pilot, lambda: "/opt/ros/kilted/setup.bash: No such file or directory" in screen_text(app))
        assert not app.distributions.next and Settings().text("distro") == "humble"


async def test_what_bashrc_sources_does_not_make_the_desktop_start_again(tmp_path: Path) -> None:
    (tmp_path / ".bashrc").write_text("source /opt/ros/lyrical/setup.bash\n", encoding="utf-8")
    async with opened(tmp_path, 200) as (app, pilot):
        await until(app, pilot, lambda: "/opt/ros/lyrical/setup.bash: No such file or directory" in screen_text(app))
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        assert app.machine.desk is not None and app.machine.desk.wanted_distribution is None
        typed(app, "source .bashrc")
        await until(app, pilot, lambda: app.distributions.next == "lyrical")


async def test_a_window_that_cannot_say_what_it_shows_does_not_keep_the_desktop_open(tmp_path) -> None:
    def fail() -> str:
        raise RuntimeError("no view")

    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        app.terminals.panes[0].view.terminal.run_line("ros2 run turtlesim turtlesim_node")
        await until(app, pilot, lambda: app.desktop.panes)
        for pane in app.desktop.panes.values():
            pane.kept_view = fail
        app.exit()
    assert json.loads(session_file(tmp_path).read_text())["terminals"]


async def test_the_desktop_can_be_left_when_nothing_can_be_saved(tmp_path, monkeypatch) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        monkeypatch.setattr(app.arranging, "described", lambda: 1 / 0)
        app.exit()
    assert app.return_code == 1 and not session_file(tmp_path).exists()


async def test_what_alone_has_changed_on_the_desktop_is_saved_meanwhile(tmp_path) -> None:
    async with opened(tmp_path, scene="empty") as (app, pilot):
        await until(app, pilot, lambda: "student@day6:~$" in screen_text(app))
        await pilot.press("alt+minus")
        await until(app, pilot, lambda: screen_text(app).count("student@day6:~$") == 2)

        def saved() -> tuple[object, object]:
            app.session.save_meanwhile()
            found = json.loads(session_file(tmp_path).read_text()) if session_file(tmp_path).exists() else {}
            return found.get("layout"), found.get("focus")

        await until(app, pilot, lambda: saved() == (app.arranging.described(), "terminal 2"))
        app.desktop.focus_pane(app.terminals.panes[0])
        await until(app, pilot, lambda: saved() == (app.arranging.described(), "terminal 1"))
