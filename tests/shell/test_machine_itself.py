"""The simulated machine: its variables, process numbers, clock, domains, how many programs fit, and how they are ended."""

from __future__ import annotations

import ntpath
import os
import subprocess
import sys
from pathlib import Path, PureWindowsPath
from typing import Any

import pytest

from day6_core.graph.domain import DomainError
from day6_core.link import engine
from day6_core.session.clock import WorldClock
from day6_core.session.streams import Captured, InputStream
from day6_core.shell import desk as desk_module
from day6_core.shell import login_variables
from day6_core.shell.desk import Desk, domain_of
from day6_core.shell.language.redirection import Streams


def started(desk: Desk, main: Any, **more: Any) -> Any:
    streams = Streams(InputStream(), Captured(), Captured())
    return desk.start_program(["prog"], main, streams, env=desk.environment(), cwd=desk.home, **more)


async def for_ever(session: Any) -> int:
    while True:
        await session.sleep(1000)


def test_a_login_has_a_students_variables_and_what_ros_and_the_language_need(
    machine: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = {"LANG": "zh_CN.UTF-8", "TZ": "Asia/Shanghai", "ROS_LOCALHOST_ONLY": "1", "RCUTILS_COLORIZED_OUTPUT": "0",
            "DAY6_SOMETHING": "x", "LC_ALL": "C", "TMPDIR": "/t"}  # fmt: skip
    for name, value in kept.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("SECRET_TOKEN", "no")
    env = machine.desk.environment()
    assert {name: env[name] for name in kept} == kept and "SECRET_TOKEN" not in env
    assert (env["USER"], env["LOGNAME"], env["SHELL"], env["TERM"]) == (
        "student",
        "student",
        "/bin/bash",
        "xterm-256color",
    )
    assert env["HOME"] == str(machine.desk.home) and env["ROS_DOMAIN_ID"] == "0"
    monkeypatch.delenv("LANG")
    assert machine.desk.environment()["LANG"] == "C.UTF-8"


def test_programs_of_a_desktop_without_zenoh_do_without_it_too(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DAY6_LINK")
    assert "DAY6_LINK" not in machine.desk.environment()
    monkeypatch.setattr(engine, "_missing", {"zenoh"})
    assert machine.desk.environment()["DAY6_LINK"] == "local"
    monkeypatch.setenv("DAY6_LINK", "off")
    assert machine.desk.environment()["DAY6_LINK"] == "off"


def test_on_windows_every_name_of_the_home_is_the_simulated_one(monkeypatch: pytest.MonkeyPatch) -> None:
    home = PureWindowsPath(r"C:\Users\anna\AppData\Local\day6-tui\home")
    for name in ("APPDATA", "LOCALAPPDATA", "USERPROFILE", "HOMEDRIVE", "HOMEPATH"):
        monkeypatch.setenv(name, r"C:\Users\anna")
    variables = login_variables.passed_on(os.environ) | login_variables.of_user("student", home, "nt")
    assert [name for name, value in variables.items() if value == r"C:\Users\anna"] == []
    for name in list(os.environ):
        monkeypatch.delenv(name)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert ntpath.expanduser("~") == ntpath.expanduser("~student") == str(home)
    monkeypatch.delenv("USERPROFILE")
    assert ntpath.expanduser("~") == str(home)
    assert variables["APPDATA"] == str(home / "AppData" / "Roaming")
    assert variables["LOCALAPPDATA"] == str(home / "AppData" / "Local")


def test_a_shell_begins_at_home_or_where_it_is_told(machine: Any, tmp_path: Path) -> None:
    desk = machine.desk
    assert desk.shell().cwd == desk.home and desk.shell().variables["PWD"] == str(desk.home)
    shell = desk.shell(cwd=tmp_path, env={"A": "1"}, interactive=True)
    assert (shell.cwd, shell.environment, shell.interactive) == (tmp_path, {"A": "1", "PWD": str(tmp_path)}, True)


def test_process_numbers_begin_at_1001_and_only_grow(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "home", domain_id=0, join_link=False, clock=WorldClock(wall=None))
    assert [desk.new_pid(), desk.new_pid()] == [1001, 1002]
    program = started(desk, for_ever)
    assert program.pid == 1003 and desk.programs == {1003: program}
    assert started(desk, for_ever, pid=77).pid == 77 and desk.new_pid() == 1004
    desk.close()
    assert desk.programs == {}


def test_the_home_folder_has_a_workspace(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "new" / "home", domain_id=5, join_link=False)
    assert (tmp_path / "new" / "home" / "ros2_ws" / "src").is_dir()
    assert desk.home == (tmp_path / "new" / "home").resolve() and desk.environment()["ROS_DOMAIN_ID"] == "5"
    desk.close()
    desk.close()


def test_every_domain_has_one_graph_with_the_worlds_time(machine: Any) -> None:
    desk = machine.desk
    assert desk.graph_of(0) is desk.graph and desk.graph_of(3) is desk.graph_of(3) is not desk.graph
    assert set(desk.graphs) == {0, 3}
    assert desk.graph_of(3).now_ns() == desk.clock.now_ns()


@pytest.mark.parametrize(("text", "domain"), [("", 0), ("0", 0), ("42", 42)])
def test_the_domain_is_that_of_the_variables(text: str, domain: int) -> None:
    assert domain_of({"ROS_DOMAIN_ID": text}) == domain_of({"ROS_DOMAIN_ID": text or "0"}) == domain
    assert domain_of({}) == 0


def test_a_domain_that_rcl_refuses_is_an_error_for_programs_and_nought_for_the_desk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(DomainError):
        domain_of({"ROS_DOMAIN_ID": "many"})
    monkeypatch.setenv("ROS_DOMAIN_ID", "many")
    desk = Desk(tmp_path / "home", join_link=False)
    assert desk.domain_id == 0 and desk.environment()["ROS_DOMAIN_ID"] == "many"
    desk.close()
    monkeypatch.setenv("ROS_DOMAIN_ID", "7")
    desk = Desk(tmp_path / "home", join_link=False)
    assert desk.domain_id == 7
    desk.close()


def test_only_so_many_programs_run_at_a_time(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(desk_module, "MOST_PROGRAMS", 2)
    first, _ = started(machine.desk, for_ever), started(machine.desk, for_ever)
    with pytest.raises(BlockingIOError, match="Resource temporarily unavailable"):
        started(machine.desk, for_ever)
    first.kill()
    machine.go()
    assert started(machine.desk, for_ever).status is None


def test_the_paused_world_stands_still_until_it_is_stepped(tmp_path: Path) -> None:
    seconds = [0.0]
    desk = Desk(tmp_path / "home", domain_id=0, join_link=False, clock=WorldClock(wall=lambda: int(seconds[0] * 1e9)))
    begun = desk.clock.target_ns()

    def passed() -> float:
        desk.scheduler.advance()
        return round((desk.clock.target_ns() - begun) / 1e9, 6)

    seconds[0] = 1.0
    assert passed() == 1.0
    desk.pause()
    seconds[0] = 5.0
    assert passed() == 1.0
    desk.step()
    assert passed() == 1.016
    desk.step(2.0)
    assert passed() == 3.016
    desk.resume()
    desk.set_speed(2.0)
    seconds[0] = 6.0
    assert passed() == 5.016
    desk.close()


def test_programs_are_ended_by_ctrl_c_then_term_then_kill(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(desk_module, "GRACE", 0.02)
    heard: list[str] = []

    def listening(*deaf: str) -> Any:
        async def main(session: Any) -> int:
            session.on_interrupt = lambda: "int" in deaf
            await session.sleep(1000)
            return 0

        return main

    polite, stubborn = started(machine.desk, listening()), started(machine.desk, listening("int"))
    machine.go()
    machine.desk.end_programs([polite, stubborn])
    assert (polite.status, stubborn.status) == (130, 143) and heard == []


def test_who_is_in_a_hurry_kills_at_once(machine: Any) -> None:
    program = started(machine.desk, for_ever)
    machine.go()
    machine.desk.hurry()
    machine.desk.end_programs([program])
    assert program.status == 137


def test_a_stopped_program_is_woken_to_be_ended(machine: Any) -> None:
    program = started(machine.desk, for_ever)
    machine.go()
    program.stop()
    machine.desk.end_programs([program])
    assert program.status == 130


def test_closing_the_desk_ends_terminals_and_programs(machine: Any) -> None:
    terminal = machine.desk.open_terminal(30, 5)
    program = started(machine.desk, for_ever)
    machine.go()
    assert machine.desk.terminals == [terminal] and (terminal.columns, terminal.rows) == (30, 5)
    machine.desk.close()
    assert terminal.closed and program.status is not None
    assert machine.desk.terminals == [] and machine.desk.programs == {}


def test_without_a_display_there_is_none(tmp_path: Path) -> None:
    desk = Desk(tmp_path / "home", domain_id=0, join_link=False, display=False)
    assert desk.display is None
    desk.close()
    assert os.path.isdir(desk.home)


@pytest.mark.process
def test_programs_and_the_screen_never_load_rclpy_at_the_same_time(tmp_path: Path) -> None:
    """Its modules import each other: two threads that begin at different ones can get a module that isn't finished."""
    code = (
        "import sys; from pathlib import Path; from day6_core.shell.desk import Desk\n"
        "desk = Desk(Path(sys.argv[1]), domain_id=0, join_link=False); before = 'rclpy' in sys.modules\n"
        "desk.scheduler.start = lambda: print(before, 'rclpy' in sys.modules, 'rclpy.qos' in sys.modules)\n"
        "desk.start(link=False)"
    )
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    assert done.stdout == "False True True\n"
