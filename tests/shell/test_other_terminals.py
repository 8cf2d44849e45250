"""xterm and gnome-terminal open further terminals of the desktop."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.shell import desk as desk_module
from tests.shell.conftest import show_all


def opened(machine: Any) -> list[Any]:
    return machine.desk.terminals


@pytest.mark.parametrize(
    "line",
    [
        "xterm -e 'echo $GREETING > out; pwd >> out'",
        "xterm -hold -T title -geometry 80x24 -e 'echo $GREETING > out; pwd >> out'",
        "gnome-terminal -- 'echo $GREETING > out; pwd >> out'",
        "gnome-terminal --tab -x 'echo $GREETING > out; pwd >> out'",
        "gnome-terminal -e 'echo $GREETING > out; pwd >> out'",
        "gnome-terminal --command='echo $GREETING > out; pwd >> out'",
        "gnome-terminal -e='echo $GREETING > out; pwd >> out'",
        "gnome-terminal --command 'echo $GREETING > out; pwd >> out'",
        "x-terminal-emulator -e 'echo $GREETING > out; pwd >> out'",
    ],
)
def test_a_command_runs_in_the_new_terminal_with_variables_and_folder(machine: Any, line: str) -> None:
    result = machine.run(f"mkdir work; cd work; export GREETING=hello; {line}; echo $?")
    machine.go(0.1)
    folder = machine.desk.home / "work"
    assert result.out == "0\n"
    assert (folder / "out").read_text().splitlines() == ["hello", str(folder)]


def test_several_words_are_a_command_and_its_arguments(machine: Any) -> None:
    machine.run("xterm -e touch 'a b' '$HOME'")
    assert sorted(path.name for path in machine.desk.home.iterdir()) == ["$HOME", "a b", "ros2_ws"]


def test_xterm_waits_for_its_terminal_and_gnome_terminal_does_not(machine: Any) -> None:
    waiting = machine.start("xterm -e sleep 5; echo after")
    machine.go(4)
    assert waiting.status is None and len(opened(machine)) == 1
    machine.go(2)
    assert waiting.status == 0 and machine.out.text == "after\n"
    assert machine.run("gnome-terminal -- sleep 5; echo at once").out == "at once\n"


def test_without_a_command_there_is_a_shell(machine: Any) -> None:
    machine.run("gnome-terminal")
    (terminal,) = opened(machine)
    machine.go()
    show_all(terminal)
    assert terminal.screen.text == "student@day6:~$"


def test_ctrl_c_for_xterm_closes_what_runs_in_it(machine: Any) -> None:
    program = machine.start("xterm -e sleep 500")
    (terminal,) = opened(machine)
    program.interrupt()
    machine.go(1)
    assert program.status == 130 and terminal.program.status is not None


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("xterm", "xterm: Xt error: Can't open display: \nxterm: DISPLAY is not set\n"),
        ("gnome-terminal", "# Failed to open display: \n"),
        ("gedit f", "gedit: there is no screen to edit on; the desktop of day6-tui has one\n"),
    ],
)
def test_without_a_display_a_window_is_refused(machine: Any, line: str, message: str) -> None:
    machine.desk.display = None
    assert machine.run(line) == (1, "", message)


def test_a_machine_full_of_programs_has_no_room_for_a_terminal(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(desk_module, "MOST_PROGRAMS", 2)
    message = "Resource temporarily unavailable\n"
    assert machine.run("gnome-terminal") == (1, "", f"gnome-terminal: fork: {message}")
    assert machine.run("xterm") == (1, "", f"xterm: fork: {message}")
