"""A mistake of our own: a key or a click that fails is lost and told, everything else ends in order; never with a traceback."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = [pytest.mark.person, pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")]

BREAK = """
def breaks(*arguments, **named):
    raise RuntimeError("planted")
"""
A_KEY = f"""{BREAK}
from day6_tui.features.guidance import Guidance
Guidance.open_palette = breaks
from day6_tui.terminals.pane import TerminalPane
TerminalPane.on_mouse_scroll_up = breaks
"""
EVERYTHING = f"""{BREAK}
from day6_tui.features.guidance import Guidance
Guidance.open_palette = lambda self: self._desktop.app.call_later(breaks)
"""
A_CHOICE = f"""{BREAK}
from day6_tui.terminals.shown import Terminals
Terminals.use_idle = breaks
"""
READER = f"""{BREAK}
from day6_tui.textual_private.driver import TerminalDriver
original = TerminalDriver._read
def _read(self):
    data = original(self)
    if data == b"\\x1b[18~":
        breaks()
    return data
TerminalDriver._read = _read
"""


def desktop(place: Place, plant: str, scene: str | None = "empty") -> Terminal:
    """The desktop with a mistake planted in it."""
    return place.desktop(*(("--scene", scene) if scene else ()), plant=plant)


def given_back(desk: Terminal) -> None:
    for mode in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?2004l", b"\x1b[?1003l"):
        assert mode in desk.output
    assert b"Traceback" not in desk.output


@pytest.mark.parametrize("data", [b"\x1b[18~", b"\x1b[<64;10;18M"], ids=["a key", "the wheel"])
def test_a_key_or_a_click_that_fails_is_told_and_everything_goes_on(place: Place, data: bytes) -> None:
    with desktop(place, A_KEY) as desk:
        desk.wait("$")
        desk.line("echo $((6*7))")
        desk.wait_lines("42")
        desk.send_bytes(data)
        desk.wait("RuntimeError: planted")
        desk.press("Esc")
        desk.wait_gone("RuntimeError")
        desk.line("echo $((6*9))")
        desk.wait_lines("54")
        desk.press("Ctrl-Q")
        assert desk.wait_end() == 0
        given_back(desk)


def test_what_is_typed_at_the_welcome_choices_and_fails_is_told_and_everything_goes_on(place: Place) -> None:
    with desktop(place, A_CHOICE, scene=None) as desk:
        desk.wait("Drive the turtle")
        desk.wait("$")
        desk.send("l")
        desk.wait("RuntimeError: planted")
        desk.press("Esc", "F2")
        desk.wait_gone("RuntimeError")
        desk.line("echo $((6*9))")
        desk.wait_lines("54")
        desk.press("Ctrl-Q")
        assert desk.wait_end() == 0
        given_back(desk)


@pytest.mark.parametrize("plant", [EVERYTHING, READER], ids=["the application", "the reader of keys"])
def test_what_cannot_go_on_ends_with_one_line_and_status_1_and_the_text_is_kept(place: Place, plant: str) -> None:
    place.home_file("talker.py", "print(1)\n")
    with desktop(place, plant) as desk:
        desk.wait("$")
        desk.line("nano talker.py")
        desk.wait("print(1)")
        desk.send("# unsaved ")
        desk.wait("# unsaved print(1)")
        desk.press("F7")
        assert desk.wait_end() == 1
        given_back(desk)
        after = bytes(desk.output).rpartition(b"\x1b[?1049l")[2].decode()
        assert after.count("day6-tui: RuntimeError: planted") == 1
    until(lambda: not place.processes(), told=place.processes)
    assert (place.home / "talker.py").read_text() == "print(1)\n"
    with place.desktop("--scene", "empty") as desk:
        desk.wait("$")
        desk.line("nano talker.py")
        desk.wait("# unsaved print(1)")


FORKS = "for i in $(seq 1010); do sleep 100 & done"


def test_with_as_many_programs_as_there_may_be_no_terminal_opens_and_the_desktop_says_so(place: Place) -> None:
    with place.desktop("--scene", "empty", columns=120) as desk:
        desk.wait("$")
        desk.line(FORKS)
        desk.wait("bash: fork: Resource temporarily unavailable")
        desk.press("F2")
        desk.wait("too many programs are running")
        desk.quit()
        assert desk.wait_end() == 0
        given_back(desk)
