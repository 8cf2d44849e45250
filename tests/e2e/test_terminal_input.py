"""Bytes that no well-behaved terminal sends: the desktop stays, tells what is wrong, and gives the terminal back in the end."""

from __future__ import annotations

import os
import signal
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = [pytest.mark.person, pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")]

NONSENSE = {
    "a byte that is never UTF-8": b"\xff\xfe\xc0\x80",
    "Alt+a with 8-bit meta": b"\xe1",
    "a lone continuation byte": b"\x80\x80\x80",
    "a surrogate and what lies beyond Unicode": b"\xed\xa0\x80\xf4\x90\x80\x80",
    "a control sequence without an end": b"\x1b[" + b"1;" * 5000,
    "a key report that is no character": b"\x1b[1114112u\x1b[99999999999u\x1b[55296;1;57343u\x1b[;;u",
    "a mouse at nonsense places": b"\x1b[<0;99999999999999999999;1M\x1b[<0;-5;-9m\x1b[<999999999;3;3M\x1b[M\x01\x01\x01",
    "windows without and beyond any size": b"\x1b[48;0;0;0;0t\x1b[<0;3;3M\x1b[48;99999999;99999999;1;1t",
    "answers nobody asked for": b"\x1b[?9999;9$y\x1b[99999999;99999999R\x1b]52;c;AAAA\x07\x1bP1$r0m\x1b\\",
    "a paste of escape sequences": b"\x1b[200~: '" + b"\x1b[31m\x1b]0;x\x07\x1b[6n" * 2000 + b"'\x1b[201~",
    "NUL and other controls": bytes(set(range(1, 32)) - {3, 4, 9, 17, 20, 26, 27}) + b"\x00",
}


def survives(desk: Terminal) -> None:
    """The shell still answers."""
    desk.press("Esc")
    desk.press("Ctrl-C")
    desk.line("echo $((6*7))")
    desk.wait_lines("42")


def leave(desk: Terminal) -> None:
    """It ends well, and the terminal is as it was."""
    desk.quit()
    assert desk.wait_end() == 0
    assert b"Traceback" not in desk.output
    for mode in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?2004l", b"\x1b[?1003l"):
        assert desk.output.rindex(mode) > desk.output.rfind(mode[:-1] + (b"l" if mode.endswith(b"h") else b"h"))


def test_whatever_a_terminal_sends_the_desktop_stays(place: Place) -> None:
    with place.desktop("--scene", "empty") as desk:
        desk.wait("$")
        before = desk.attributes()
        for name, data in NONSENSE.items():
            desk.send_bytes(data)
            desk.look(0.3)
            assert desk.status is None, name
            desk.press("Ctrl-C")
        survives(desk)
        leave(desk)
        assert before[3] != desk.attributes()[3]  # echo and line editing are the terminal's again


@pytest.mark.parametrize(
    ("data", "hint"),
    [("echo 中文".encode("gbk"), "GBK"), ("echo né".encode("latin-1") + b"x", "UTF-8")],
    ids=["GBK", "Latin-1"],
)
def test_another_code_is_told_once_and_typing_goes_on(place: Place, data: bytes, hint: str) -> None:
    with place.desktop("--scene", "empty", columns=120) as desk:
        desk.wait("$")
        desk.send_bytes(data)
        desk.wait("echo", "\ufffd", "UTF-8", hint)
        desk.press("Enter")
        survives(desk)
        leave(desk)


def test_a_character_that_comes_in_two_halves_is_one(place: Place) -> None:
    with place.desktop("--scene", "empty") as desk:
        desk.wait("$")
        text = "echo 中文".encode()
        for byte in text:
            desk.send_bytes(bytes([byte]))
            desk.look(0.02)
        desk.press("Enter")
        desk.wait_lines("中文")
        assert "\ufffd" not in desk.look()


def test_a_terminal_that_hangs_up_without_a_word_ends_the_desktop_and_its_programs(place: Place) -> None:
    place.home_file("stay.py", "import time\nprint('here', flush=True)\ntime.sleep(600)\n")
    with place.desktop("--scene", "empty", columns=60) as desk:
        desk.wait("$")
        desk.line("python3 stay.py")
        desk.wait_lines("here")
        desk.hang_up()
        until(lambda: desk._reap() or desk.status is not None)
        until(lambda: not place.processes())
        assert desk.status in (0, 129, -signal.SIGHUP)


def test_the_window_of_a_program_survives_bad_bytes_too(place: Place) -> None:
    with place.terminal("ros2", "run", "turtlesim", "turtlesim_node", columns=100) as window:
        window.wait("F1")
        for data in NONSENSE.values():
            window.send_bytes(data.replace(b"q", b""))
            window.look(0.05)
        window.send_bytes("中文".encode("gbk"))
        window.wait("GBK")
        assert window.status is None
        window.press("q")
        assert window.wait_end() == 0
        assert b"Traceback" not in window.output


def test_a_program_whose_windows_terminal_hangs_up_ends(place: Place) -> None:
    with place.terminal("ros2", "run", "turtlesim", "turtlesim_node", columns=100) as window:
        window.wait("F1")
        window.hang_up()
        until(lambda: window._reap() or window.status is not None)
        until(lambda: not place.processes())


def test_ctrl_z_on_the_way_out_does_not_keep_a_desktop_that_no_shell_would_continue(place: Place) -> None:
    place.home_file(
        "stay.py", "import signal, time\nsignal.signal(2, signal.SIG_IGN)\nprint('here')\ntime.sleep(600)\n"
    )
    with place.desktop("--scene", "empty") as desk:
        desk.wait("$")
        desk.line("python3 stay.py")
        desk.wait_lines("here")
        desk.quit()
        until(lambda: desk.look(0.05) and b"\x1b[?1049l" in desk.output)
        desk.send("\x1a\x1a")
        assert desk.wait_end() == 0
        until(lambda: not place.processes(), told=place.processes)  # the guard looks once more when the desktop is gone
