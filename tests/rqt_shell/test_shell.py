"""The shell of rqt: lines run in a shell of their own, endless ones can be stopped, and without a desktop it is told."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from rich.cells import cell_len

from day6_core.ros.programs.rqt_py_common.command_lines import MOST_CHARACTERS, MOST_LINES, Kind
from day6_core.ros.programs.rqt_shell.model import NO_DESKTOP, RqtShell
from tests.support.desk_window import DeskWindow
from tests.support.rqt_machine import RqtMachine
from tests.tui.screens import ToolWindow, use_window


class Machine(DeskWindow):
    """A desk on which rqt_shell runs."""

    model: RqtShell

    def __init__(self, home: Path) -> None:
        super().__init__(home, "ros2 run rqt_shell rqt_shell")

    def run(self, line: str) -> None:
        assert self.model.run(line)
        self.wait(lambda: not self.model.running)

    @property
    def printed(self) -> list[tuple[str, str]]:
        return [(kind.value, text) for kind, text in self.model.lines]


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    found = Machine(tmp_path)
    yield found
    found.close()


def test_a_line_runs_and_its_output_is_shown_with_errors_apart(machine: Machine) -> None:
    machine.run("echo hello; ls nothere; printf 'no end'")
    assert machine.printed == [
        ("command", ">>> echo hello; ls nothere; printf 'no end'"),
        ("output", "hello"),
        ("error", "ls: cannot access 'nothere': No such file or directory"),
        ("output", "no end"),
    ]
    machine.run("ros2 node list")
    assert any(text.startswith("/rqt_gui_py_node_") for _, text in machine.printed)


def test_every_line_has_a_shell_of_its_own_and_nothing_to_read(machine: Machine) -> None:
    machine.run("mkdir below; cd below; x=1; cat; exit 3")
    machine.run("pwd; echo [$x]")
    assert [text for kind, text in machine.printed if kind == "output"] == [str(machine.desk.home), "[]"]


def test_an_endless_command_can_be_stopped_and_another_one_follows(machine: Machine) -> None:
    assert machine.model.run("while true; do echo again; sleep 0.1; done")
    machine.wait(lambda: ("output", "again") in machine.printed)
    assert not machine.model.run("echo too soon")
    machine.model.interrupt()
    machine.wait(lambda: not machine.model.running)
    machine.run("echo next")
    assert machine.printed[-1] == ("output", "next")


def test_a_line_that_is_no_command_is_told(machine: Machine) -> None:
    machine.run("nonsense")
    machine.run("if [")
    errors = [text for kind, text in machine.printed if kind == "error"]
    assert "nonsense: command not found" in errors[0] and len(errors) >= 2


def test_where_there_is_no_desktop_it_is_said(tmp_path: Path) -> None:
    machine = RqtMachine("rqt_shell", tmp_path)
    machine.open()
    machine.do("run", "echo hello")
    assert machine.model.lines[-1] == (Kind.REMARK, NO_DESKTOP) and not machine.model.running
    machine.end()


@pytest.mark.parametrize(("lang", "told"), [("en", "use your own terminal"), ("zh", "现在没有桌面")])
def test_why_no_command_can_be_run_is_said_in_the_users_language(lang: str, told: str) -> None:
    model = RqtShell()
    model.take(f"{NO_DESKTOP}\n", Kind.REMARK)

    async def act(window: ToolWindow) -> None:
        assert told in " ".join(line.strip("┃ ") for line in window.text.splitlines())

    use_window(("rqt_shell", "SimpleShell", model), act, (80, 24), ToolWindow, lang=lang)


def test_what_is_typed_can_be_changed_in_the_middle() -> None:
    model = RqtShell()

    async def act(window: ToolWindow) -> None:
        await window.press(*"ros2 tpic list", *["left"] * 8, "o", "home", "x", "backspace", "end", "!", "backspace")
        assert ">>> ros2 topic list" in window.text
        await window.press("home", "delete", "r", "ctrl+e", "ctrl+w", *"echo /a", "ctrl+a", "right", "ctrl+k")
        assert ">>> r " in window.text and "ros2" not in window.text
        await window.press(*"os2 node info /海龟/a", *["left"] * 3, "backspace", "车", "enter")
        assert model.running == "ros2 node info /车龟/a"

    use_window(("rqt_shell", "SimpleShell", model), act, (80, 24), ToolWindow)


def test_the_cursor_stays_in_sight_in_a_long_line() -> None:
    async def act(window: ToolWindow) -> None:
        await window.press(*["海"] * 60, "z")
        assert "海z" in window.text.splitlines()[2] and max(map(cell_len, window.text.splitlines())) <= 80
        await window.press("home", "a")
        assert ">>> a海" in window.text and max(map(cell_len, window.text.splitlines())) <= 80

    use_window(("rqt_shell", "SimpleShell", RqtShell()), act, (80, 24), ToolWindow)


def test_what_is_kept_is_bounded() -> None:
    model = RqtShell()
    for _ in range(10):
        model.take("x" * 5_000 + "\n" + "y\n" * 1_000, Kind.OUTPUT)
    assert len(model.lines) == MOST_LINES and max(len(text) for _, text in model.lines) == MOST_CHARACTERS


def test_keys_type_run_and_recall_and_the_newest_lines_are_seen() -> None:
    model = RqtShell()
    for number in range(100):
        model.take(f"line {number}\x1b[2J\n", Kind.OUTPUT)

    async def act(window: ToolWindow) -> None:
        assert "line 99^[[2J" in window.text and "line 9 " not in window.text
        await window.press("a", "b", "backspace", "c", "enter")
        assert model.running == "ac" and "running" in window.text
        model.ended()
        await window.press("x", "up")
        assert ">>> ac" in window.text.splitlines()[-3]
        await window.press("down", "pageup", "pageup")
        assert "line 99" not in window.text and "line 64" in window.text
        await window.press("z")
        assert ">>> z" in window.text

    use_window(("rqt_shell", "SimpleShell", model), act, (80, 24), ToolWindow)


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (10, 4), (120, 40)])
@pytest.mark.parametrize("options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}])
def test_it_is_drawn_at_every_size(size, options) -> None:
    model = RqtShell()
    model.take("\x1b]0;T\x07\n" + "名" * 3_000 + "\n\n", Kind.ERROR)

    async def act(window: ToolWindow) -> None:
        await window.press(*"ros2", "space", *["a"] * 30)
        assert all(char.isprintable() for line in window.text.splitlines() for char in line)

    use_window(("rqt_shell", "SimpleShell", model), act, size, ToolWindow, **options)
