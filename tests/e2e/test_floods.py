"""A program that prints without end: Ctrl-C, what is typed after it and the desktop's own keys work, at a real terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

GENEROUS = 120.0
"""Seconds; what is measured here are keys that never arrive."""

FLOODS = {
    "lines": "while True: print('flood of', 'lines')",
    "one line": "import sys\nwhile True: sys.stdout.write('flood' * 2000)",
    "binary": "import os, sys\nprint('flood')\nwhile True: sys.stdout.buffer.write(os.urandom(5000).replace(b'\\x1b', b''))",
}


def flooded(place: Place, kind: str) -> Terminal:
    """A desktop with a program in front that prints without end."""
    place.home_file("flood.py", FLOODS[kind] + "\n")
    screen = place.desktop("--scene", "empty")
    screen.wait("student@day6:~$", limit=GENEROUS)
    screen.line("python3 flood.py")
    screen.wait({"lines": "of lines", "one line": "floodflood", "binary": "\ufffd"}[kind], limit=GENEROUS)
    return screen


@pytest.mark.parametrize("kind", FLOODS)
def test_what_is_typed_right_after_ctrl_c_at_a_flood_reaches_the_shell(place: Place, kind: str) -> None:
    with flooded(place, kind) as screen:
        screen.press("Ctrl-C")
        screen.line("clear; echo I am h''ere")
        # Not the whole line: bytes of no text may stand behind it, where two tables of widths differ.
        screen.wait(lambda seen: "┃I am here" in seen, limit=GENEROUS)


def test_ctrl_c_and_a_command_typed_before_the_program_has_begun_are_not_lost(place: Place) -> None:
    place.home_file("flood.py", FLOODS["lines"] + "\n")
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$", limit=GENEROUS)
        for number in range(3):
            screen.send("python3 flood.py\r")
            screen.press("Ctrl-C")
            screen.line(f"clear; echo I am h''ere {number}")
            seen = screen.wait_lines(f"I am here {number}", limit=GENEROUS)
            assert "launch_process" not in seen


def test_the_keys_of_the_desktop_answer_during_a_flood(place: Place) -> None:
    with flooded(place, "lines") as screen:
        screen.press("F1")
        screen.wait(lambda seen: "F2" in seen and "Ctrl" in seen, limit=GENEROUS)
        screen.press("Esc")
        screen.quit()
        assert screen.wait_end(GENEROUS) == 0
