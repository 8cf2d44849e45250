"""The desktop in virtual time, as a person meets it: speeds and pause that hold for all programs, keys that are heard at once."""

from __future__ import annotations

import re
import signal
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until
from tests.virtual.test_worlds import TALKER

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal
    from tests.virtual.world import World

pytestmark = pytest.mark.person

PROMPT = "student@day6:~$"
FAST = "full speed"
EPOCH_NS = 1_767_225_600_000_000_000
SECOND = 1_000_000_000
_STAMP = re.compile(r"\[(\d+\.\d{9})\] \[\w+\]")


def begin(world: World, *options: str, **size: int) -> Terminal:
    world.home_file("talker.py", TALKER)
    return world.desktop("--virtual-time", *(options or ("--scene", "empty")), **size)


@contextmanager
def at_prompt(world: World, *options: str, **size: int) -> Iterator[Terminal]:
    """A desktop whose terminal waits for a line, and which ends well when it is left at last."""
    with begin(world, *options, **size) as screen:
        screen.wait(PROMPT)
        yield screen
        screen.quit()
        assert screen.wait_end() == 0


def choose(screen: Terminal, action: str) -> None:
    """By the list of all commands."""
    screen.press("F7")
    screen.send(action)
    screen.wait(lambda seen: seen.count(action) > 1)
    screen.press("Enter")


def stamps(seen: str) -> list[int]:
    """Of all lines of logs on the screen, ns since the world began."""
    return [int(each.replace(".", "")) - EPOCH_NS for each in _STAMP.findall(seen)]


def reaches(moment: int) -> Callable[[str], bool]:
    """Whether a line of a log on the screen is of after this moment of the world; a list of commands may hide all of them."""
    return lambda seen: any(each > moment for each in stamps(seen))


def test_ten_minutes_of_a_talker_pass_at_once_while_keys_are_heard(world: World) -> None:
    with at_prompt(world) as screen:
        screen.line("python3 talker.py")
        screen.wait("Hello 0")
        choose(screen, "As fast as")
        screen.wait(FAST, reaches(600 * SECOND))
        screen.press("F2")
        screen.line("echo $((6 * 7))")
        screen.wait_lines("42")
        screen.press("F9")
        screen.wait("paused")


def test_ten_times_as_fast_holds_for_a_program_of_the_users(world: World) -> None:
    with at_prompt(world) as screen:
        screen.line("python3 talker.py")
        screen.wait("Hello 0")
        for speed in ("2×", "5×", "10×"):
            choose(screen, "Faster time")
            screen.wait(f"{speed}  F1")
        began, first = time.monotonic(), max(stamps(screen.wait(reaches(0))))
        screen.wait(reaches(first + 40 * SECOND))
        assert time.monotonic() - began < 40


def test_a_pause_stops_all_programs_and_nothing_that_a_person_sees(world: World) -> None:
    with at_prompt(world) as screen:
        screen.line("python3 talker.py")
        screen.wait("Hello 1")
        screen.press("F9")
        before = stamps(screen.wait("paused"))
        screen.press("F7")
        screen.wait("type to search")
        screen.press("Esc")
        screen.wait_gone("type to search")
        screen.press("F2")
        screen.line("ros2 node list")
        screen.wait_lines("/talker")
        screen.line("date +%s.%N%N; date +%s.%N%N")
        seen = screen.wait(lambda seen: len(re.findall(r"17672256\d\d\.\d{18}", seen)) == 2)
        assert stamps(seen)[-1] == before[-1]
        assert len({each[:14] for each in re.findall(r"17672256\d\d\.\d{18}", seen)}) == 1
        choose(screen, "One time step")
        screen.press("F9")
        screen.wait(reaches(before[-1]))


def test_a_busy_program_is_told_of_and_holds_up_no_key(world: World) -> None:
    world.home_file("busy.py", "print('be' + 'gins', flush=True)\nwhile True: pass\n")
    with at_prompt(world) as screen:
        choose(screen, "As fast as")
        screen.wait(FAST)
        screen.line("python3 busy.py")
        screen.wait("begins", "busy for 2 s")
        screen.press("F2")
        screen.line("echo $((6 * 7))")
        screen.wait_lines("42")
        screen.press("Alt-1", "Ctrl-C")
        screen.wait("KeyboardInterrupt")


def test_what_time_stands_still_for_is_said_in_the_line_of_notices(world: World) -> None:
    world.home_file("waits.py", "import subprocess\nsubprocess.run(['sleep', '1000'])\n")
    with at_prompt(world) as screen:
        screen.line("python3 waits.py")
        seen = screen.wait("time stands still while sleep 1000")
        assert "time stands still while sleep 1000" in seen.splitlines()[-1]
        screen.press("Ctrl-C")
        screen.wait("KeyboardInterrupt")


@pytest.mark.parametrize("how", ["hang up", "interrupt", "kill"])
def test_an_end_at_full_speed_leaves_nothing(world: World, how: str) -> None:
    with begin(world) as screen:
        screen.wait(PROMPT)
        screen.line("python3 talker.py")
        choose(screen, "As fast as")
        screen.wait(FAST, "Hello")
        if how == "hang up":
            screen.hang_up()
        else:
            screen.kill(signal.SIGINT if how == "interrupt" else signal.SIGKILL)
            assert screen.wait_end() == (130 if how == "interrupt" else -signal.SIGKILL)
        until(lambda: not world.processes())
    if how == "kill":
        world.fast("true")  # clears up what is left of worlds whose first process is gone


def test_the_size_may_change_while_it_is_paused(world: World) -> None:
    with at_prompt(world) as screen:
        screen.press("F9")
        screen.wait("paused")
        screen.resize(100, 30)
        screen.wait(lambda seen: seen.splitlines()[-1].endswith("Quit") and seen.count("\n") == 29)


@pytest.mark.parametrize("option", ["--listen", "--connect"])
def test_other_machines_have_another_time(world: World, option: str) -> None:
    done = world.run("--virtual-time", option, "tcp/127.0.0.1:7447")
    assert done.returncode == 2
    assert f"--virtual-time: not allowed with argument {option}" in done.stderr


def test_a_desktop_without_it_says_how_to_get_it(world: World) -> None:
    with world.desktop("--scene", "empty") as screen:
        screen.wait(PROMPT)
        for speed in ("2×", "5×", "10×"):
            choose(screen, "Faster time")
            screen.wait(f"{speed}  F1")
        choose(screen, "Faster time")
        screen.wait("day6-tui --virtual-time")
        screen.quit()
        assert screen.wait_end() == 0
