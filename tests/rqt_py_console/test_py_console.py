"""The Python console of rqt: the interpreter behind it, its blocks, errors, questions and ends; keys and what is pasted."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from textual import events

from day6_core.ros.programs.rqt_py_common.command_lines import MOST_LINES, Kind
from day6_core.ros.programs.rqt_py_console.interpreter import AWAITS, ERROR, PLAIN
from day6_core.ros.programs.rqt_py_console.model import NO_DESKTOP, PyConsole
from day6_core.session.program import Program
from day6_core.shell.process.process import running_processes
from tests.support.desk_window import DeskWindow
from tests.support.rqt_machine import RqtMachine
from tests.support.short_folder import make_short_folder
from tests.tui.screens import ToolWindow, use_window


class Machine(DeskWindow):
    """A desk on which rqt_py_console runs."""

    model: PyConsole

    def __init__(self, home: Path, *, linked: bool = False) -> None:
        super().__init__(home, "ros2 run rqt_py_console rqt_py_console", linked=linked)
        self.wait(lambda: self.model.prompt == ">>> ")

    def run(self, *lines: str) -> list[tuple[str, str]]:
        """Type lines, and return what is new when Python waits for the next one, without the lines themselves."""
        before = len(self.model.lines)
        for line in lines:
            assert self.model.run(line)
            self.wait(lambda: self.model.prompt is not None or self.model.status is not None)
        new = [(kind.value, text) for kind, text in self.model.lines[before:]]
        return [each for each in new if each[0] != "command"]


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    found = Machine(tmp_path)
    yield found
    found.close()


@pytest.mark.process
def test_lines_run_one_after_the_other_in_one_interpreter(machine: Machine) -> None:
    assert machine.model.lines[0][1].startswith(f"Python {sys.version.split()[0]}")
    assert machine.run("x = 6", "x * 7", "print('a', end='')") == [("output", "42")]
    assert machine.model.prompt == "a>>> ", "as in a terminal"
    assert machine.run("__name__, __import__('os').getcwd()") == [("output", str(("__main__", str(machine.desk.home))))]


@pytest.mark.process
def test_a_block_is_awaited_to_its_empty_line(machine: Machine) -> None:
    assert machine.run("for i in range(2):") == [] and machine.model.prompt == "... "
    assert machine.run("    print(i)", "") == [("output", "0"), ("output", "1")]
    assert [text for kind, text in machine.model.lines if kind is Kind.COMMAND] == [
        ">>> for i in range(2):",
        "...     print(i)",
        "... ",
    ]


@pytest.mark.process
def test_errors_are_pythons_own_and_stand_where_they_happened(machine: Machine) -> None:
    assert machine.run("print(1); 1/0") == [
        ("output", "1"),
        ("error", "Traceback (most recent call last):"),
        ("error", '  File "<input>", line 1, in <module>'),
        ("error", "ZeroDivisionError: division by zero"),
    ]
    assert machine.run("1 +")[-1] == ("error", "SyntaxError: invalid syntax")
    assert machine.run("import os; _ = os.system('echo below >&2; echo too')") == [
        ("output", "below"),
        ("output", "too"),
    ]


@pytest.mark.process
def test_input_asks_in_the_window(machine: Machine) -> None:
    machine.run("name = input('Who? ')")
    assert machine.model.prompt == "Who? "
    assert machine.run("小明", "name") == [("output", "'小明'")]


@pytest.mark.process
def test_output_is_seen_while_the_line_still_runs_and_ctrl_c_ends_it(machine: Machine) -> None:
    machine.model.run("import time")
    machine.model.run("while True: print('again'); time.sleep(0.01)")
    machine.model.run("")
    machine.model.run("print('never')")
    machine.wait(lambda: (Kind.OUTPUT, "again") in machine.model.lines)
    assert machine.model.prompt is None
    machine.model.interrupt()
    machine.wait(lambda: machine.model.prompt == ">>> ")
    assert (Kind.ERROR, "KeyboardInterrupt") in machine.model.lines
    assert machine.run("time.__name__") == [("output", "'time'")], "it is still the same interpreter"
    assert (Kind.OUTPUT, "never") not in machine.model.lines


@pytest.mark.process
def test_ctrl_c_at_the_prompt_gives_up_a_block(machine: Machine) -> None:
    machine.run("if True:")
    machine.model.interrupt()
    machine.wait(lambda: machine.model.prompt == ">>> ")
    assert machine.model.lines[-1] == (Kind.ERROR, "KeyboardInterrupt")


@pytest.mark.process
@pytest.mark.parametrize(("line", "status"), [("exit()", 0), ("raise SystemExit(3)", 3), (None, 0)])
def test_it_ends_by_exit_or_ctrl_d_and_another_one_begins(machine: Machine, line: str | None, status: int) -> None:
    machine.run("x = 1")
    if line is None:
        machine.model.end_input()
    else:
        machine.model.run(line)
    machine.wait(lambda: machine.model.status is not None)
    assert machine.model.status == status and machine.model.prompt is None and not machine.model.run("x")
    machine.model.begin()
    machine.wait(lambda: machine.model.prompt == ">>> ")
    assert machine.model.status is None
    assert machine.run("x")[-1] == ("error", "NameError: name 'x' is not defined")


@pytest.mark.process
def test_an_interpreter_that_is_killed_is_told_with_its_status(machine: Machine) -> None:
    machine.model.run("import os; os.kill(os.getpid(), 9)")
    machine.wait(lambda: machine.model.status is not None)
    assert machine.model.status == 137


@pytest.mark.process
def test_closing_the_window_ends_python_in_whatever_it_does(machine: Machine) -> None:
    machine.model.run("while True: pass")
    machine.model.run("")
    machine.wait(lambda: machine.model.prompt is None and len(running_processes(machine.desk.scheduler)) == 1)
    machine.display.windows[0].close_by_user()
    machine.wait(lambda: machine.program.status is not None and not running_processes(machine.desk.scheduler))


@pytest.mark.process
def test_a_node_made_here_is_seen_in_the_terminals(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DAY6_LINK")
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(make_short_folder()))
    machine = Machine(tmp_path, linked=True)
    try:
        machine.run("import rclpy", "_ = rclpy.init()", "node = rclpy.create_node('mine')")
        machine.wait(lambda: "mine" in [node.name for node in machine.desk.graph.nodes])
    finally:
        machine.close()


def test_where_there_is_no_desktop_it_is_said(tmp_path: Path) -> None:
    machine = RqtMachine("rqt_py_console", tmp_path)
    machine.open()
    assert machine.model.lines == [(Kind.REMARK, NO_DESKTOP)]
    assert machine.model.prompt is None and machine.model.status is None and not machine.model.run("1")
    machine.model.begin()
    machine.advance(0.5)
    assert len(machine.model.lines) == 1
    machine.end()


@pytest.mark.parametrize(("lang", "told"), [("en", "run python3 in your terminal"), ("zh", "现在没有桌面")])
def test_why_there_is_no_python_is_said_in_the_users_language(lang: str, told: str) -> None:
    model = PyConsole()
    model.take(f"{NO_DESKTOP}\n", Kind.REMARK)

    async def act(window: ToolWindow) -> None:
        assert told in " ".join(line.strip("┃ ") for line in window.text.splitlines())

    use(model, act, lang=lang)


@pytest.mark.process
def test_too_many_programs_are_told(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*given: Any, **more: Any) -> Program:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    machine.run("1")
    monkeypatch.setattr(machine.desk, "start_program", refuse)
    machine.model.run("exit()")
    machine.wait(lambda: machine.model.status == 0)
    machine.model.begin()
    machine.wait(lambda: machine.model.status == 1)
    assert "Resource temporarily unavailable" in machine.model.lines[-1][1]


# -- the model ---------------------------------------------------------------------------------------------------------


def asking(prompt: str = ">>> ") -> tuple[PyConsole, list[str]]:
    """A model whose interpreter waits for a line, and what it is sent."""
    model, sent = PyConsole(), []
    model.began(sent.append, lambda: sent.append("^C"))
    model.take_stream(f"Python\n{prompt}{AWAITS}")
    return model, sent


def test_marks_count_wherever_the_stream_is_cut() -> None:
    text = f"a\n{ERROR}Trace\nback\n{PLAIN}b{AWAITS}"
    for cut in range(len(text)):
        model = PyConsole()
        model.began(print, print)
        model.take_stream(text[:cut])
        model.take_stream(text[cut:])
        assert [kind.value[0] + line for kind, line in model.lines] == ["oa", "eTrace", "eback"] and model.prompt == "b"


def test_lines_that_come_too_early_wait_and_ctrl_c_drops_them() -> None:
    model, sent = asking()
    for line in ("one", "two", "three"):
        model.run(line)
    assert sent == ["one\n"]
    model.take_stream(f">>> {AWAITS}")
    assert sent == ["one\n", "two\n"] and list(model.history) == ["one", "two", "three"]
    model.interrupt()
    model.take_stream(f">>> {AWAITS}")
    assert sent[2:] == ["^C"] and model.prompt == ">>> "


def test_what_other_threads_print_does_not_disturb_the_prompt() -> None:
    model, _ = asking()
    model.take_stream("late\nand unfinished")
    assert model.prompt == ">>> " and model.lines[-1] == (Kind.OUTPUT, "and unfinished")


def test_what_is_kept_is_bounded() -> None:
    model, _ = asking()
    for _ in range(5):
        model.take_stream("x\n" * 1_000 + AWAITS * 1_000 + ERROR)
    assert len(model.lines) == MOST_LINES


# -- the window --------------------------------------------------------------------------------------------------------


def use(model: PyConsole, act: Any, size: tuple[int, int] = (80, 24), **options: Any) -> None:
    use_window(("rqt_py_console", "PyConsole", model), act, size, ToolWindow, **options)


def test_keys_edit_the_line_and_recall_earlier_ones() -> None:
    model, sent = asking()

    async def act(window: ToolWindow) -> None:
        await window.press("b", "home", "a", "end", "c", "left", "backspace", "enter")
        assert sent == ["ac\n"] and ">>> ac" in window.text and "running" in window.text
        model.take_stream(f"out\n>>> {AWAITS}")
        await window.press("x", "up")
        assert "out" in window.text and window.text.count(">>> ac") == 2
        await window.press("down", "(", "ctrl+c")
        assert sent[-1] == "^C" and window.text.splitlines()[5].strip("┃ ") == ">>>"

    use(model, act)


def test_a_block_is_indented_by_itself_and_blanks_alone_end_it() -> None:
    model, sent = asking()

    async def act(window: ToolWindow) -> None:
        await window.press("i", "f", "space", "1", ":", "enter")
        model.take_stream(f"... {AWAITS}")
        await window.press("x", "enter")
        model.take_stream(f"... {AWAITS}")
        await window.press("tab", "backspace", "enter")
        assert sent == ["if 1:\n", "    x\n", "\n"]
        model.take_stream(f">>> {AWAITS}")
        await window.press("y", "enter")
        assert sent[-1] == "y\n"

    use(model, act)


def test_what_is_pasted_runs_line_by_line_as_it_is() -> None:
    model, sent = asking()

    async def act(window: ToolWindow) -> None:
        window.pane.post_message(events.Paste("if 1:\r\n\tx\n\ny"))
        await window.press("left")
        assert sent == ["if 1:\n"]
        for prompt in ("... ", "... ", ">>> "):
            model.take_stream(prompt + AWAITS)
        await window.press("end")
        assert sent == ["if 1:\n", "    x\n", "\n"] and ">>> y" in window.text

    use(model, act)


def test_the_end_is_told_and_enter_begins_anew() -> None:
    model, sent = asking()
    begun: list[bool] = []
    model.on_begin = lambda: begun.append(True)

    async def act(window: ToolWindow) -> None:
        await window.press("ctrl+d")
        assert sent == [""]
        model.ended(3)
        await window.press("x")
        assert "exited with status 3" in window.text and "Enter new Python" in window.text
        await window.press("enter")
        assert begun == [True]

    use(model, act)


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (10, 4), (120, 40)])
@pytest.mark.parametrize("options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}])
def test_it_is_drawn_at_every_size(size, options) -> None:
    model, _ = asking("名" * 300)
    model.take_stream(f"{ERROR}\x1b]0;T\x07\n" + "名" * 3_000 + "\n\n")

    async def act(window: ToolWindow) -> None:
        await window.press(*"print", "space", *["a"] * 30, "home")
        assert all(char.isprintable() for line in window.text.splitlines() for char in line)
        model.ended(1)
        await window.press("x")
        assert all(char.isprintable() for line in window.text.splitlines() for char in line)

    use(model, act, size, **options)
