"""What a shell remembers and looks up: history and what `!` recalls, commands and their places, the prompt's clock, limits."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any

import pytest

from day6_core.shell import commands
from day6_core.shell.line import history as history_module
from day6_core.shell.line.history import History, in_one_line
from day6_core.shell.line.recall import NoSuchLine, recalled
from day6_core.shell.process import memory

PROMPT = "student@day6:~$"
LINES = ["ros2 node list", "cd src/one", "ls -l a b", "cd src/two"]


def filled(tmp_path: Path) -> History:
    history = History(tmp_path / "h")
    for line in LINES:
        history.add(line)
    return history


@pytest.mark.parametrize(
    ("text", "before", "index"),
    [("cd", 4, 3), ("cd", 3, 1), ("cd", 1, None), ("ros2", 4, 0), ("ros2", 0, None), ("cd", 99, 3), ("none", 4, None),
     ("two", 4, 3), ("l", 4, 2)],
)  # fmt: skip
def test_a_search_finds_the_last_line_before_a_place(tmp_path: Path, text: str, before: int, index: int | None) -> None:
    assert filled(tmp_path).search(text, before) == index


def test_lines_that_repeat_or_begin_with_a_blank_are_not_kept(tmp_path: Path) -> None:
    history = filled(tmp_path)
    for line in ("cd src/two", " secret", "ls", "cd src/two"):
        history.add(line)
    assert history.lines == [*LINES, "ls", "cd src/two"]
    assert (tmp_path / "h").read_text().splitlines() == history.lines


def test_only_the_last_lines_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history_module, "KEPT", 3)
    history = filled(tmp_path)
    assert history.lines == LINES[1:]
    history.add("more")
    assert history.lines == [*LINES[2:], "more"]
    assert History(tmp_path / "h").lines == [*LINES[2:], "more"]


@pytest.mark.parametrize(
    ("typed", "result"),
    [
        ("!!", "cd src/two"),
        ("sudo !!", "sudo cd src/two"),
        ("!1", "ros2 node list"),
        ("!4", "cd src/two"),
        ("!-1", "cd src/two"),
        ("!-2", "ls -l a b"),
        ("!cd", "cd src/two"),
        ("!ls", "ls -l a b"),
        ("!?one?", "cd src/one"),
        ("!?one", "cd src/one"),
        ("echo !$", "echo src/two"),
        ("echo !^", "echo src/two"),
        ("echo !*", "echo src/two"),
        ("^two^three", "cd src/three"),
        ("^two^", "cd src/"),
        ("^two^x^", "cd src/x"),
        ("echo '!!'", "echo '!!'"),
        ('echo "!!"', 'echo "cd src/two"'),
        ("echo \\!!", "echo \\!!"),
        ("! true", "! true"),
        ("a != b", "a != b"),
        ("echo hi!", "echo hi!"),
        ("!ls;!1", "ls -l a b;ros2 node list"),
        ("echo it's !!", "echo it's !!"),
        ('echo "it\'s" !!', 'echo "it\'s" cd src/two'),
    ],
)
def test_an_earlier_line_is_recalled(typed: str, result: str) -> None:
    assert recalled(typed, LINES) == result


def test_words_of_the_last_line_are_recalled_by_their_place() -> None:
    assert recalled("x !^ !$ !*", ["a b c d"]) == "x b d b c d"
    assert recalled("x !^", ["alone"]) == "x "


@pytest.mark.parametrize("typed", ["!nothing", "!9", "!-9", "!?none?", "!0x"])
def test_what_nothing_fits_is_told(typed: str) -> None:
    with pytest.raises(NoSuchLine, match="event not found"):
        recalled(typed, LINES)
    with pytest.raises(NoSuchLine, match=":s\\^no\\^x: substitution failed"):
        recalled("^no^x", LINES)
    with pytest.raises(NoSuchLine, match="!!: event not found"):
        recalled("!!", [])


@pytest.mark.parametrize(
    ("source", "line"),
    [
        ("echo a", "echo a"),
        ("a\nb", "a; b"),
        ("a\n\n\nb", "a; b"),
        ("if a\nthen b\nelse c\nfi", "if a; then b; else c; fi"),
        ("if a; then\nb\nelif c; then\nd\nfi", "if a; then b; elif c; then d; fi"),
        ("for i in 1 2\ndo\na\ndone", "for i in 1 2; do a; done"),
        ("for i\nin 1\ndo a; done", "for i in 1; do a; done"),
        ("for i in\ndo a; done", "for i in do a; done"),
        ("while a\ndo b\ndone", "while a; do b; done"),
        ("until a\ndo b\ndone", "until a; do b; done"),
        ("case a in\na) b\n;;\nesac", "case a in a) b; ;; esac"),
        ("case a\nin a) b;; esac", "case a in a) b;; esac"),
        ("f()\n{\na\n}", "f() { a; }"),
        ("(a\nb)", "(a; b)"),
        ("(\na\n)\nb", "( a; ); b"),
        ("{\na\n}\nb", "{ a; }; b"),
        ("a |\nb &&\nc ||\nd", "a | b && c || d"),
        ("a &\nb", "a & b"),
        ("a;\nb", "a; b"),
        ("a \\\nb", "a b"),
        ("echo 'x\ny'\nz", "echo 'x\ny'; z"),
        ("a # note\nb", "a # note\nb"),
        ("cat <<E\nx\nE", "cat <<E\nx\nE"),
        ("echo do\necho then", "echo do; echo then"),
        ("! \na", "! \na"),
        ("echo 'open\n", "echo 'open\n"),
    ],
)
def test_a_command_of_several_lines_becomes_one(source: str, line: str) -> None:
    assert in_one_line(source).replace("  ", " ") in (line, line.replace("! \n", "! "))


def test_history_shows_numbers_clears_and_counts(seat: Any) -> None:
    for line in ("echo a", "echo b", "clear"):
        seat.line(line)
    assert seat.line("history 2").splitlines()[1:] == ["    3  clear", "    4  history 2", PROMPT]
    seat.line("clear")
    assert seat.line("history").splitlines()[1:3] == ["    1  echo a", "    2  echo b"]
    assert seat.line("history x").splitlines()[-2] == "bash: history: x: numeric argument required"
    seat.line("history -c; clear")
    assert seat.line("history").splitlines()[1] == "    1  history"


@pytest.mark.parametrize("keys", ["\x04", "exit\r", "logout\r"])
def test_the_end_of_a_shell_is_written(seat: Any, keys: str) -> None:
    screen = seat.type(keys)
    assert screen.splitlines()[-1] == ("exit" if keys == "exit\r" else screen.splitlines()[-1])
    assert seat.terminal.closed
    if keys == "\x04":
        assert screen == f"{PROMPT} exit"


@pytest.mark.parametrize(
    ("escape", "form"),
    [("\\t", "%H:%M:%S"), ("\\T", "%I:%M:%S"), ("\\@", "%I:%M %p"), ("\\A", "%H:%M"), ("\\d", "%a %b %d"),
     ("\\D{%Y}", "%Y"), ("\\D{}", "%X")],
)  # fmt: skip
def test_the_prompt_tells_the_time(seat: Any, escape: str, form: str) -> None:
    before = time.strftime(form)
    seat.line(f"PS1='<{escape}> '; clear")
    shown = seat.look()[1:].rpartition(">")[0]
    assert before <= shown <= time.strftime(form) or len(shown) == len(before)


def test_the_prompt_counts_lines_and_jobs_and_keeps_folders_as_they_are(seat: Any) -> None:
    seat.line("mkdir '$x'; cd '$x'; PS1='\\!.\\#.\\j \\W$? $(echo sub) > '")
    seat.line("false")
    assert seat.look().splitlines()[-1] == "3.3.0 $x1 sub >"
    seat.line("cd /")
    assert seat.look().splitlines()[-1] == "4.4.0 /0 sub >"
    seat.line("cd; PS1='\\W \\w > '")
    assert seat.look().splitlines()[-1] == "~ ~ >"
    seat.line("PS1='${broken> '")
    assert seat.look().splitlines()[-1] == "${broken>"


@pytest.mark.parametrize(
    ("name", "place"),
    [("ls", "/usr/bin/ls"), ("echo", "/usr/bin/echo"), ("cd", ""), ("export", ""), ("[", "/usr/bin/["), ("jobs", ""),
     ("stty", "/usr/bin/stty"), ("nothing", ""), ("python3", "/usr/bin/python3"), ("kill", "/usr/bin/kill"), (":", "")],
)  # fmt: skip
def test_a_command_has_a_place_unless_it_is_part_of_the_shell(name: str, place: str) -> None:
    assert commands.place_of(name) == place


@pytest.mark.parametrize("name", ["ros2", "rviz2", "rqt", "rqt_graph", "check_urdf", "urdf_to_graphviz", "xacro"])
def test_what_is_ros_lies_in_opt_ros(name: str) -> None:
    assert commands.place_of(name).startswith("/opt/ros/") and commands.place_of(name).endswith(f"/bin/{name}")


def test_every_command_is_where_the_table_says() -> None:
    for name in commands.command_names():
        assert commands.builtin(name) is not None
    assert commands.builtin("nothing") is None


def test_arguments_are_too_long_where_linux_says_so() -> None:
    one = 128 * 1024
    assert not commands.too_long(["ls", "x" * (one - 1)], {})
    assert commands.too_long(["ls", "x" * one], {})
    assert not commands.too_long(["echo", "x" * one], {}) and not commands.too_long([], {})
    assert commands.too_long(["ls", "é" * (one // 2)], {})
    many = ["ls", *["x" * 1015] * 2000]  # 1015 + 1 + 8 bytes each
    assert not commands.too_long(many, {})
    assert commands.too_long([*many, *["x" * 1015] * 60], {})
    assert commands.too_long(["ls"], {"A": "x" * one})


CAT = "#!/usr/bin/env -S cat -s\n"


@pytest.mark.parametrize(
    ("first", "line", "status", "out", "err"),
    [
        ("#!/usr/bin/env bash\n", "./f a", 0, "f ./f a\n", ""),
        ("", "./f a", 0, "f ./f a\n", ""),
        ("#!/bin/sh\n", "~/f a", 0, "f HOME/f a\n", ""),
        pytest.param(CAT, "./f", 0, f"{CAT}echo f $0 $1\n", "", marks=pytest.mark.process),
        ("", "chmod -x f; ./f", 126, "", "bash: ./f: Permission denied\n"),
        ("", "./g", 127, "", "bash: ./g: No such file or directory\n"),
        ("", "./ros2_ws", 126, "", "bash: ./ros2_ws: Is a directory\n"),
        ("", "/bin/echo x", 0, "x\n", ""),
        ("", "/usr/bin/nothing", 127, "", "bash: /usr/bin/nothing: No such file or directory\n"),
    ],
)  # fmt: skip
def test_a_file_runs_by_its_first_line(machine: Any, first: str, line: str, status: int, out: str, err: str) -> None:
    if os.name == "nt":
        pytest.skip("files have no right to be run there")
    file = machine.desk.home / "f"
    file.write_text(f"{first}echo f $0 $1\n")
    file.chmod(0o755)
    home = str(machine.desk.home)
    result = machine.run(line)
    assert (result.status, result.out.replace(home, "HOME"), result.err.replace(home, "HOME")) == (status, out, err)


@pytest.mark.parametrize(
    ("wish", "machine_has", "limit"),
    [("512", 2**40, 512 * 2**20), ("0", 2**40, 0), ("", 2**40, int(2**40 * 0.6)), ("", 2**30, 2**30), ("", 0, 0),
     (" 7 ", 0, 7 * 2**20), ("many", 2**40, int(2**40 * 0.6))],
)  # fmt: skip
def test_the_memory_of_a_process(monkeypatch: pytest.MonkeyPatch, wish: str, machine_has: int, limit: int) -> None:
    monkeypatch.setenv(memory.VARIABLE, wish)
    monkeypatch.setattr(memory, "total_memory", lambda: machine_has)
    assert memory.memory_limit() == limit


def test_a_variable_may_hold_16_mib_and_no_more(machine: Any) -> None:
    machine.shell.variables["x"] = "a" * 2**24
    assert machine.run("y=$x; echo ${#y}").out == "16777216\n"
    done = machine.run("y=${x}b; echo no")
    assert done == (2, "", "bash: xrealloc: cannot allocate 16777217 bytes\n")
