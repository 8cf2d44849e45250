"""The table of jobs: numbers, marks, what fg, bg, kill, wait, disown, ps and pkill find, and their messages."""

from __future__ import annotations

from typing import Any

import pytest

PROMPT = "student@day6:~$"


def said(seat: Any, line: str, seconds: float = 0.0) -> list[str]:
    """What a line prints on a cleared screen, without prompts."""
    seat.line("clear")
    screen = seat.line(line, seconds).splitlines()
    return [row for row in screen[1:] if row != PROMPT]


@pytest.fixture
def three(seat: Any) -> Any:
    """Somebody with three jobs: `sleep 30` (1), a stopped `sleep 20` (2) and `sleep 40` (3)."""
    seat.line("sleep 30 &")
    seat.line("sleep 20")
    seat.type("\x1a")
    seat.line("sleep 40 &")
    return seat


def test_the_last_job_is_marked_plus_and_the_one_before_minus(three: Any) -> None:
    assert said(three, "jobs") == [
        "[1]   Running                 sleep 30 &",
        "[2]-  Stopped                 sleep 20",
        "[3]+  Running                 sleep 40 &",
    ]


def test_jobs_p_and_l_show_process_numbers(three: Any) -> None:
    pids = said(three, "jobs -p")
    assert len(pids) == 3 and pids == sorted(pids)
    assert said(three, "jobs -l") == [
        f"[1]  {pids[0]:>5} Running                 sleep 30 &",
        f"[2]- {pids[1]:>5} Stopped                 sleep 20",
        f"[3]+ {pids[2]:>5} Running                 sleep 40 &",
    ]


@pytest.mark.parametrize(
    ("spec", "job"),
    [
        ("%1", "sleep 30"),
        ("%2", "sleep 20"),
        ("%%", "sleep 40"),
        ("%+", "sleep 40"),
        ("%-", "sleep 20"),
        ("%sl", "sleep 40"),
        ("%?30", "sleep 30"),
        ("2", "sleep 20"),
        ("", "sleep 40"),
    ],
)
def test_fg_finds_the_job_that_a_specification_means(three: Any, spec: str, job: str) -> None:
    assert said(three, f"fg {spec}") == [job]
    assert three.terminal.busy
    assert three.type("\x03").splitlines()[-2:] == ["^C", PROMPT]
    assert job not in "\n".join(said(three, "jobs"))


def test_a_job_brought_to_the_front_and_stopped_again_becomes_the_current_one(three: Any) -> None:
    three.line("fg %1")
    assert three.type("\x1a").splitlines()[-2] == "[1]+  Stopped                 sleep 30"
    assert [row[:4] for row in said(three, "jobs")] == ["[1]+", "[2] ", "[3]-"]


def test_bg_lets_a_stopped_job_go_on_and_says_so(three: Any) -> None:
    assert said(three, "bg %2") == ["[2]- sleep 20 &"]
    assert said(three, "jobs")[1] == "[2]-  Running                 sleep 20 &"
    assert said(three, "bg %1") == ["bash: bg: job 1 already in background"]
    assert said(three, "bg %7; echo $?") == ["bash: bg: %7: no such job", "1"]


def test_disown_takes_a_job_out_of_the_table_and_it_runs_on(three: Any) -> None:
    assert said(three, "disown %1; jobs") == [
        "[2]-  Stopped                 sleep 20",
        "[3]+  Running                 sleep 40 &",
    ]
    assert any("sleep 30" in row for row in said(three, "ps"))
    assert said(three, "disown; jobs") == ["[2]+  Stopped                 sleep 20"]
    assert said(three, "disown %9; echo $?") == ["bash: disown: %9: no such job", "1"]


def test_a_new_job_gets_the_number_behind_the_highest(three: Any) -> None:
    three.line("kill %3")
    assert said(three, "sleep 5 & jobs")[0].startswith("[3] ")
    three.line("kill %1")
    assert said(three, "sleep 6 &")[0].startswith("[4] ")


def test_ends_are_reported_in_bashs_words_before_the_next_prompt(seat: Any) -> None:
    for signal, words in (("KILL", "Killed"), ("HUP", "Hangup"), ("TERM", "Terminated"), ("INT", "Interrupt")):
        seat.line("sleep 50 &")
        rows = said(seat, f"kill -{signal} %1")
        assert rows == [f"[1]+  {words:<24}sleep 50"]


def test_a_status_is_reported_as_exit(seat: Any) -> None:
    seat.line("(sleep 1; exit 3) & sleep 1 &")
    seat.settle(2)
    rows = seat.line("").splitlines()
    assert "[1]-  Exit 3                  (sleep 1; exit 3)" in rows
    assert "[2]+  Done                    sleep 1" in rows


def test_a_stopped_job_that_is_ended_wakes_up_for_it(three: Any) -> None:
    assert said(three, "kill %2") == ["[2]-  Terminated              sleep 20"]


def test_stop_and_continue_are_signals_too(seat: Any) -> None:
    seat.line("sleep 30 &")
    assert said(seat, "kill -STOP %1") == ["", "[1]+  Stopped                 sleep 30"]
    assert said(seat, "jobs") == ["[1]+  Stopped                 sleep 30"]
    assert said(seat, "jobs -l")[0].split(None, 2)[2] == "Stopped (signal)        sleep 30"
    seat.line("kill -CONT %1")
    assert said(seat, "jobs") == ["[1]+  Running                 sleep 30 &"]


def test_leaving_with_stopped_jobs_is_warned_about_once(three: Any) -> None:
    three.line("clear")
    assert three.type("\x04").splitlines()[-3:-1] == [f"{PROMPT} exit", "There are stopped jobs."]
    assert not three.terminal.closed
    three.type("\x04")
    assert three.terminal.closed
    assert three.desk.programs == {}


def test_the_warning_comes_again_after_another_command(three: Any) -> None:
    three.type("\x04")
    three.line("echo no")
    three.type("\x04")
    assert not three.terminal.closed


def test_ps_lists_the_shell_and_what_runs(machine: Any) -> None:
    rows = machine.run("sleep 9 & ps").out.splitlines()
    assert rows[0] == "    PID TTY          TIME CMD"
    pids = [int(row.split()[0]) for row in rows[1:]]
    assert pids == sorted(pids)
    assert [row.split(None, 3)[3] for row in rows[1:]].count("sleep 9") == 1
    assert all(row[7:30] == " pts/0    00:00:00 " + row[26:30] for row in rows[1:])


@pytest.mark.parametrize(
    ("line", "out", "err"),
    [
        ("sleep 50 & pkill sleep; echo $?; wait $!; echo $?", "0\n143\n", ""),
        ("sleep 50 & pkill slee; echo $?; wait $!; echo $?", "0\n143\n", ""),
        ("sleep 50 & pkill -9 sleep; wait $!; echo $?", "137\n", ""),
        ("sleep 50 & pkill -INT -f 'sleep 50'; wait $!; echo $?", "130\n", ""),
        ("sleep 50 & killall sleep; echo $?; wait $!; echo $?", "0\n143\n", ""),
        ("sleep 50 & killall slee; echo $?; kill $!", "1\n", "slee: no process found\n"),
        ("sleep 50 & sleep 60 & killall sleep; wait; echo $?", "0\n", ""),
        ("pkill; echo $?", "2\n", "pkill: no matching criteria specified\n"),
        ("pkill -NOPE x; echo $?", "2\n", "pkill: no matching criteria specified\n"),
        ("pkill nothing; echo $?", "1\n", ""),
    ],
)
def test_pkill_and_killall_find_programs_by_their_command(machine: Any, line: str, out: str, err: str) -> None:
    result = machine.run(line)
    assert (result.out, result.err) == (out, err)


def test_kill_l_lists_the_signals(machine: Any) -> None:
    out = machine.run("kill -l").out
    assert out == machine.run("kill -L").out
    assert "1) SIGHUP 2) SIGINT" in out and "9) SIGKILL" in out and "15) SIGTERM" in out


@pytest.mark.parametrize(
    ("line", "out"),
    [
        ("timeout 2 sleep 5; echo $?", "124\n"),
        ("timeout 2 sleep 1; echo $?", "0\n"),
        ("timeout -s INT 1 sleep 5; echo $?", "124\n"),
        ("timeout -s KILL 1 sleep 5; echo $?", "124\n"),
        ("timeout --preserve-status 1 sleep 5; echo $?", "143\n"),
        ("timeout -v -s 9 1 sleep 5; echo $?", "137\n"),
        ("timeout 0.05m sleep 2; echo $?", "0\n"),
        ("timeout 0.05m sleep 4; echo $?", "124\n"),
        ("timeout 0 sleep 6; echo $?", "0\n"),
        ("timeout 1 sh -c 'sleep 5; exit 3'; echo $?", "124\n"),
    ],
)
def test_timeout_ends_a_command_when_its_time_is_up(machine: Any, line: str, out: str) -> None:
    assert machine.run(line, seconds=7.0).out == out


@pytest.mark.parametrize(
    ("words", "seconds"), [("1.5", 1.5), ("0.1m", 6.0), ("2s", 2.0), ("0.001h", 3.6), ("1 2", 3.0), ("0.0001d", 8.64)]
)
def test_sleep_lasts_as_long_as_its_words_say(machine: Any, words: str, seconds: float) -> None:
    program = machine.start(f"sleep {words}")
    machine.go(seconds - 0.01)
    assert program.status is None
    machine.go(0.02)
    assert program.status == 0


def test_sleep_infinity_goes_on(machine: Any) -> None:
    program = machine.start("sleep infinity")
    machine.go(86400.0)
    assert program.status is None


def test_date_is_the_world_clocks(machine: Any) -> None:
    out = machine.run(
        "date -u +%Y-%m-%dT%H:%M:%S; date +%s; date +%N; date -u; sleep 61.5; date +%s.%N", seconds=70
    ).out
    assert out.splitlines() == [
        "2023-11-14T22:13:20",
        "1700000000",
        "000000000",
        "Tue Nov 14 10:13:20 PM UTC 2023",
        "1700000061.500000000",
    ]
