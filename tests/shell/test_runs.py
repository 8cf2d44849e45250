"""What a terminal remembers of the lines that were run in it."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.session.plain import plain
from day6_core.shell.runs import LONGEST_OLD_OUTPUT, LONGEST_OUTPUT, MOST_COMMANDS, Runs


def test_a_line_is_kept_with_its_status_folder_and_output(seat: Any) -> None:
    seat.line("cd ros2_ws")
    seat.line("ls nothing")
    first, second = seat.terminal.runs.all
    assert (first.source, first.status, first.output) == ("cd ros2_ws", 0, "")
    assert (second.source, second.status, second.cwd.name) == ("ls nothing", 2, "ros2_ws")
    assert second.output == "ls: cannot access 'nothing': No such file or directory\r\n"
    assert first.ended_ns is not None
    assert first.ended_ns <= second.began_ns


def test_what_still_runs_has_no_status_yet(seat: Any) -> None:
    seat.line("echo begun; sleep 100")
    run = seat.terminal.runs.running
    assert run is seat.terminal.runs.all[-1]
    assert (run.status, run.ended_ns, run.output) == (None, None, "begun\r\n")
    seat.type("\x03")
    assert (run.status, seat.terminal.runs.running) == (130, None)


def test_bashrc_is_no_line_of_the_user(seat: Any) -> None:
    assert seat.terminal.runs.all == []


def test_the_end_of_a_long_output_is_kept_and_less_of_it_later(seat: Any) -> None:
    runs = Runs()
    run = runs.begin("yes", seat.terminal.shell.cwd, 1)
    for number in range(20_000):
        run.keep(f"{number:09}\n")
    assert LONGEST_OUTPUT - 10 <= len(run.output) <= LONGEST_OUTPUT
    assert run.output.endswith("000019999\n")
    runs.end(0, 2)
    runs.begin("true", seat.terminal.shell.cwd, 3)
    assert len(run.output) == LONGEST_OLD_OUTPUT
    assert run.output.endswith("000019999\n")


HELLO = ("echo", "hello")
COMMANDS = {
    "ls": [(("ls",), 0, "ros2_ws\n", "")],
    "cd ros2_ws && /bin/ls; cd": [(("cd", "ros2_ws"), 0, "", ""), (("/bin/ls",), 0, "src\n", ""), (("cd",), 0, "", "")],
    "false && pwd # ls": [(("false",), 1, "", "")],
    "echo hello | cat": [(HELLO, 0, "", "hello\n"), (("cat",), 0, "hello\n", "")],
    "echo hello > file; cat < file": [(HELLO, 0, "", "hello\n"), (("cat",), 0, "hello\n", "")],
    "x=1 | true": [(("true",), 0, "", "")],
    "echo hello > /dev/null": [(HELLO, 0, "", "")],
    "echo hello >&2 | cat": [(HELLO, 0, "hello\n", ""), (("cat",), 0, "", "")],
    "echo $(echo hello)": [(HELLO, 0, "", "hello\n"), (HELLO, 0, "hello\n", "")],
    "x=hello; for i in 1 2; do echo $x; done": [(HELLO, 0, "hello\n", "")] * 2,
    "f() { echo hello; }; f": [(("f",), 0, "", ""), (HELLO, 0, "hello\n", "")],
    "time env B=2 echo hello": [(("env", "B=2", *HELLO), 0, "hello\n", ""), (HELLO, 0, "hello\n", "")],
    "timeout 5 echo hello": [(("timeout", "5", *HELLO), 0, "hello\n", ""), (HELLO, 0, "hello\n", "")],
    "echo hello | xargs echo": [(HELLO, 0, "", "hello\n"), (("xargs", "echo"), 0, "hello\n", ""), (HELLO, 0, "hello\n", "")],
    "bash -c 'echo hello | cat'": [
        (("bash", "-c", "echo hello | cat"), 0, "hello\n", ""), (HELLO, 0, "", "hello\n"), (("cat",), 0, "hello\n", ""),
    ],
    "(echo hello; false) || { nothing; }": [
        (HELLO, 0, "hello\n", ""), (("false",), 1, "", ""), (("nothing",), 127, "bash: nothing: command not found\n", ""),
    ],
    "if [ -d ros2_ws ]; then eval echo hello; fi": [
        (("[", "-d", "ros2_ws", "]"), 0, "", ""), (("eval", *HELLO), 0, "", ""), (HELLO, 0, "hello\n", ""),
    ],
}  # fmt: skip


def test_each_simple_command_of_a_line_is_kept_with_what_it_printed_itself(seat: Any) -> None:
    for line, commands in COMMANDS.items():
        seat.line(line, 0.5)
        seat.wait_prompt()
        ran = seat.terminal.runs.all[-1].commands
        found = [(tuple(each.argv), each.status, plain(each.screen), plain(each.elsewhere)) for each in ran]
        assert found == commands, line
        assert all(each.began_ns <= each.ended_ns for each in ran), line


def test_a_command_knows_its_words_before_expansion_and_whether_it_was_a_function(seat: Any) -> None:
    seat.line("ls() { echo $HOME; }; ls; command ls | cat; echo '$HOME'")
    found = [(each.source, each.is_function) for each in seat.terminal.runs.all[-1].commands]
    assert found[:3] == [("ls", True), ("echo $HOME", False), ("command ls", False)]
    assert sorted(found[3:]) == [("cat", False), ("command ls", False), ("echo '$HOME'", False)]


def test_what_runs_in_the_background_is_known_until_it_ends_and_after_a_later_line(seat: Any) -> None:
    seat.line("(sleep 2; echo late) &")
    seat.line("echo soon")
    behind, now = seat.terminal.runs.all
    assert [(each.argv[0], each.status) for each in behind.commands] == [("sleep", None)]
    seat.settle(3.0)
    assert [(each.argv[0], each.status, each.screen) for each in behind.commands][1:] == [("echo", 0, "late\n")]
    assert [each.screen for each in now.commands] == ["soon\n"]


def test_of_very_many_commands_the_first_and_the_last_are_kept(seat: Any) -> None:
    seat.line("for ((i = 0; i < 500; i++)); do echo $i; done", 1.0)
    ran = seat.terminal.runs.all[-1].commands
    assert [each.argv[1] for each in ran] == [str(n) for n in (*range(MOST_COMMANDS), *range(500 - MOST_COMMANDS, 500))]


def test_prompt_and_bashrc_run_commands_of_no_line(seat: Any) -> None:
    seat.line("PS1='$(whoami)> '")
    seat.line("true")
    assert [[each.argv[0] for each in run.commands] for run in seat.terminal.runs.all] == [[], ["true"]]


def test_what_was_run_in_a_closed_terminal_is_known(seat: Any) -> None:
    seat.line("pwd")
    seat.terminal.close()
    assert [each.argv for runs in seat.desk.closed_runs for run in runs.all for each in run.commands] == [["pwd"]]


@pytest.mark.process
def test_what_a_process_prints_to_the_terminal_or_a_pipe_is_its_commands(seat: Any) -> None:
    seat.line("python3 -c 'print(1+1)'; python3 -c 'print(2+2)' | cat")
    seat.wait_prompt()
    ran = seat.terminal.runs.all[-1].commands
    found = sorted((each.argv[0], plain(each.screen).replace("\r", ""), each.elsewhere) for each in ran)
    assert found == [("cat", "4\n", ""), ("python3", "", "4\n"), ("python3", "2\n", "")]
