"""What bash has and our shell does not is refused with a sentence, before anything of its line runs."""

from __future__ import annotations

import sys
from typing import Any

import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="a terminal there has no pty")

SENTENCE = "bash has this, the shell of day6-tui does not; nothing of this line was run"


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("echo before; coproc cat", "coproc"),
        ("echo before; x=$(coproc cat)", "coproc"),
        ("if true; then echo before; coproc x { :; }; fi", "coproc"),
        ("echo before; exec 3<> file", "<>"),
        ("echo before; trap 'echo x' DEBUG", "trap … DEBUG"),
        ("echo before; read -i text x", "read -i"),
        ("echo before; set -k", "set -k"),
        ("echo before; mapfile -C f a", "mapfile -C"),
        ("echo before; wait -n", "wait -n"),
        ('echo before; echo "${PS1@P}"', "${PS1@P}"),
        ("f() { echo before; local -I x; }", "local -I"),
        ("echo before; tee >(cat)", ">(cat)"),
    ],
)
def test_it_is_refused_before_anything_of_the_line_runs(machine: Any, line: str, what: str) -> None:
    result = machine.run(line)
    assert (result.status, result.out, result.err) == (2, "", f"bash: {what}: {SENTENCE}\n")


def test_the_sentence_is_chinese_for_a_chinese_reader(machine: Any) -> None:
    said = machine.run("export DAY6_LANG=zh\ncoproc cat").err
    assert said == "bash: coproc：bash 有这个功能，day6-tui 的 shell 没有；这一行什么都没有执行\n"


def test_lines_before_it_have_run_and_the_terminal_goes_on(seat: Any) -> None:
    seat.line("echo one; coproc x { :; }")
    assert SENTENCE.partition(";")[0] in seat.line("echo two").replace("\n", " ")
    assert "two" in seat.look().splitlines()[-2]


@pytest.mark.parametrize("option", ["lastpipe", "extdebug", "localvar_inherit", "compat50x"])
def test_a_setting_that_is_not_obeyed_cannot_be_turned_on(machine: Any, option: str) -> None:
    result = machine.run(f"shopt -s {option}; echo $?; shopt {option}")
    assert result.out.startswith("1\n") and "\ton" not in result.out and result.err


def test_ctrl_c_runs_the_trap_and_the_script_goes_on(seat: Any) -> None:
    seat.line("trap 'echo caught' INT; for i in 1 2; do sleep 100; echo after $i; done")
    shown = seat.type("\x03")
    assert "caught" in shown and "after 1" in shown and "after 2" not in shown
    assert "after 2" in seat.type("\x03")
    seat.line("trap - INT")
    assert "after 3" not in seat.look()


def test_a_process_substitution_runs_while_it_is_read(seat: Any) -> None:
    seat.line("while read -r x; do echo got $x; done < <(echo one; sleep 5; echo two)")
    assert "got one" in seat.look() and "got two" not in seat.look()
    assert "got two" in seat.type("", seconds=6.0)


def test_exec_with_a_command_ends_the_shell_with_its_status(machine: Any) -> None:
    result = machine.run(
        "(exec bash -c 'exit 5'; echo never); echo $?; bash -c 'trap \"echo bye\" EXIT; exec true'; echo $?"
    )
    assert (result.out, result.err) == ("5\n0\n", "")
    assert machine.run("exec nothere; echo never").status == 127


def test_what_a_script_defines_does_not_reach_another_bash(machine: Any) -> None:
    lines = "f() { echo f; }; a=1; export b=2; alias x='echo x'\nbash -c 'f; echo ${a-none} $b; x'"
    assert machine.run(lines).out == "none 2\n"
