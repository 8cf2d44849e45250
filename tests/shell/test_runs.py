"""What a terminal remembers of the lines that were run in it."""

from __future__ import annotations

from typing import Any

from day6_core.shell.runs import LONGEST_OLD_OUTPUT, LONGEST_OUTPUT, Runs


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
