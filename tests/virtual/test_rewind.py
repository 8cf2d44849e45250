"""Back in time on the desktop: what was is there again, in a copy of the folder, and the person goes on from there."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.virtual.test_desktop import FAST, PROMPT, SECOND, at_prompt, begin, choose, reaches, stamps

if TYPE_CHECKING:
    from tests.e2e.terminal import Terminal
    from tests.virtual.world import World

pytestmark = pytest.mark.person

REPLAY = "replay in a copy"
_BACK = r"back at \d+:\d\d"
THERE = "in a copy of your folder that is gone at the end"


def go_back(screen: Terminal) -> str:
    before = re.findall(_BACK, screen.look())
    choose(screen, "Back 10 s")
    return screen.wait(REPLAY, THERE, lambda seen: before != re.findall(_BACK, seen) != [])


def test_a_talker_says_the_same_again_to_the_nanosecond(world: World) -> None:
    with begin(world) as screen:
        screen.wait(PROMPT)
        screen.line("python3 talker.py")
        first = stamps(screen.wait("Hello 1"))[0]
        choose(screen, "As fast as")
        screen.wait(FAST, reaches(first + 30 * SECOND))
        screen.press("F9")
        before = stamps(screen.wait("paused"))
        seen = go_back(screen)
        assert "paused" in seen
        assert 9 * SECOND < before[-1] - stamps(seen)[-1] < 12 * SECOND
        assert all((each - first) % (SECOND // 2) == 0 for each in stamps(seen))
        screen.press("Ctrl-C", "F9")
        screen.wait("talker ends")
        screen.line("echo new > made.txt; cat made.txt")
        screen.wait_lines("new")
        screen.quit()
        assert screen.wait_end() == 0
    assert not (world.home / "made.txt").exists()


def test_a_turtle_that_was_driven_is_where_it_was(world: World) -> None:
    with begin(world, "--scene", "turtle", columns=120, rows=40) as screen:
        screen.wait("Use arrow keys to move the turtle.", "x 5.54")
        screen.press("Up", "Left", "Up")
        screen.wait(lambda seen: "x 5.54" not in seen)
        screen.wait("linear_velocity  0.00  angular_velocity  0.00")
        screen.press("F2")
        screen.line("sleep 30; echo w'o'ken")
        choose(screen, "As fast as")
        screen.wait_lines("woken")
        screen.press("F9")
        before = screen.wait("paused") and screen.pane("TurtleSim")
        for _ in range(2):
            go_back(screen)
            screen.wait(lambda _: screen.pane("TurtleSim") == before)
        screen.quit()
        assert screen.wait_end() == 0


def test_a_folder_that_is_too_large_is_left_alone(world: World) -> None:
    for number in range(11):
        (world.home / f"folder{number}").mkdir(parents=True)
        for each in range(500):
            (world.home / f"folder{number}" / str(each)).touch()
    with at_prompt(world) as screen:
        choose(screen, "Back 10 s")
        screen.wait("there is no way back")


def test_a_replay_takes_another_size_and_can_be_stopped(world: World) -> None:
    world.home_file("long.py", "import time\nfor _ in range(10**9): time.sleep(0.001)\n")
    with at_prompt(world) as screen:
        screen.line("python3 long.py")
        choose(screen, "As fast as")
        screen.wait(FAST)
        screen.wait(lambda seen: screen.find("long.py", "") is not None)
        choose(screen, "Back 10 s")
        screen.wait(REPLAY)
        screen.resize(100, 30)
        screen.press("Esc")
        screen.wait(THERE, lambda seen: seen.count("\n") == 29)
