"""The end of the desktop, whatever comes when: its status, the terminal as it was, nothing printed, nothing left."""

from __future__ import annotations

import contextlib
import os
import signal
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.e2e.place import DAY6
from tests.support.waiting import communicate, until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

termios = pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

STUBBORN = (
    "import signal, time\nfor n in (1, 2, 15): signal.signal(n, signal.SIG_IGN)\nprint('re' + 'ady')\ntime.sleep(999)\n"
)
LEFT = b"\x1b[?1049l"
"""How the desktop leaves the alternate screen."""


def expect_end(screen: Terminal, place: Place, status: int, before: list[object]) -> None:
    assert screen.wait_end() == status
    expect_given_back(screen, before)
    until(lambda: place.processes() == {})


def expect_given_back(screen: Terminal, before: list[object]) -> None:
    output = bytes(screen.output)
    for on, off in (
        (b"\x1b[?1049h", LEFT),
        (b"\x1b[?25l", b"\x1b[?25h"),
        (b"\x1b[?1000h", b"\x1b[?1000l"),
        (b"\x1b[?1003h", b"\x1b[?1003l"),
        (b"\x1b[?2004h", b"\x1b[?2004l"),
        (b"\x1b[?7l", b"\x1b[?7h"),
    ):
        assert output.rfind(on) < output.rfind(off), (on, off)
    assert b"Traceback" not in output
    assert screen.attributes() == before


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_ends_the_desktop_with_its_status_and_gives_the_terminal_back(place: Place, name: str) -> None:
    number = getattr(signal, name)
    with place.desktop("--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait("student@day6:~$")
        screen.kill(number)
        expect_end(screen, place, 128 + number, before)


PATIENT = """
from day6_core.shell import desk
from day6_tui.screen import departure
desk.GRACE = departure.LEAVE_SECONDS = 600.0
"""
"""Planted into a desktop, which then waits for its programs until it is told to hurry, however late that is."""


def test_ctrl_c_while_the_desktop_quits_ends_it_without_a_word(place: Place) -> None:
    place.home_file("stubborn.py", STUBBORN)
    with place.desktop("--scene", "empty", plant=PATIENT) as screen:
        before = screen.attributes()
        screen.wait("student@day6:~$")
        screen.line("python3 stubborn.py")
        screen.wait("ready")
        screen.quit()
        screen.wait(lambda _: LEFT in screen.output)  # from here on Ctrl-C is a signal again
        until(lambda: screen.look(0.02) is not None and screen.attributes() == before)
        screen.press("Ctrl-C")
        expect_end(screen, place, 130, before)
        assert b"Interrupt" not in screen.output


def test_ctrl_c_while_the_desktop_is_being_loaded_ends_it_without_a_word(place: Place) -> None:
    slow = place.work / "slow"
    slow.mkdir()
    (slow / "textual.py").write_text("import time\nprint('loading', flush=True)\ntime.sleep(99)\n", encoding="utf-8")
    with place.desktop(PYTHONPATH=str(slow)) as screen:
        screen.wait("loading")
        screen.press("Ctrl-C")
        assert screen.wait_end() == -signal.SIGINT
        assert screen.look().replace("^C", "").split() == ["loading"]


def test_a_terminal_that_takes_nothing_does_not_hold_the_desktop(place: Place) -> None:
    place.home_file("flood.py", "while True: print('x' * 70, flush=True)\n")
    with place.desktop("--scene", "empty", columns=120, rows=40) as screen:
        screen.wait("student@day6:~$")
        screen.line("python3 flood.py")

        def is_stuck() -> bool:
            """The thread that writes waits for room in the terminal."""
            for task in os.listdir(f"/proc/{screen.pid}/task"):
                with contextlib.suppress(FileNotFoundError):  # a thread that has just ended
                    name = Path(f"/proc/{screen.pid}/task/{task}/wchan").read_text(encoding="utf-8")
                    if name in ("n_tty_write", "wait_woken"):
                        return True
            return False

        if not os.access(f"/proc/{screen.pid}/wchan", os.R_OK):
            pytest.skip("this system does not tell what a thread waits for")
        until(is_stuck)
        screen.kill(signal.SIGTERM)

        def ended() -> bool:
            screen._reap()
            return screen.status is not None

        until(ended)
        assert screen.status == 143
        until(lambda: place.processes() == {})


def test_a_stray_sigcont_does_not_cost_the_terminal_its_settings(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait("student@day6:~$")
        taken = screen.output.count(b"\x1b[?1049h")
        screen.kill(signal.SIGCONT)
        screen.wait(lambda _: screen.output.count(b"\x1b[?1049h") > taken)
        screen.line("echo still he''re")
        screen.wait("still here")
        screen.press("Ctrl-Q")
        expect_end(screen, place, 0, before)


def test_the_desktop_ends_with_its_terminal_where_nobody_hears_sighup(place: Place) -> None:
    from tests.e2e.terminal import Terminal

    words = ["/bin/sh", "-c", "trap '' HUP; exec \"$@\"", "sh", *DAY6, "--scene", "empty", "--lang", "en"]
    words += ["--home", str(place.home)]
    screen = Terminal(words, 80, 24, cwd=place.work, env=place.environment())
    screen.wait("student@day6:~$")
    os.close(screen._fd)
    until(lambda: os.waitpid(screen.pid, os.WNOHANG)[0] == screen.pid)
    until(lambda: place.processes() == {})


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP"])
def test_a_sub_shell_that_is_told_to_go_leaves_nothing(place: Place, name: str) -> None:
    temporary = place.work / "t"
    temporary.mkdir()
    with place.terminal("shell", SHELL="/bin/sh", TMPDIR=str(temporary)) as screen:
        screen.wait("exit ends it")
        until(lambda: len(place.processes()) > 1 or not os.path.isdir("/proc/self"))
        screen.kill(getattr(signal, name))
        assert screen.wait_end() > 128
        assert b"Traceback" not in screen.output
    assert list(temporary.iterdir()) == []
    until(lambda: place.processes() == {})


@pytest.mark.parametrize(("name", "status"), [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)])
def test_a_script_that_a_signal_ends_has_the_status_of_the_signal(place: Place, name: str, status: int) -> None:
    process = place.start("exec", "--home", str(place.home), "-c", "echo begun; while true; do :; done")
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    process.send_signal(getattr(signal, name))
    said, error = communicate(process)
    assert (process.returncode, said, error) == (status, "", "")


DEAF = """\
import os
import time

def wait():
    while True:
        try:
            open(os.path.join(os.path.dirname(__file__), "deaf"), "w").close()
            time.sleep(99)
        except BaseException:
            pass
"""
"""Makes the file `deaf` beside itself, already deaf: on the terminal the word could come in the middle of what is being drawn."""


def test_a_command_that_does_not_listen_ends_by_force_when_its_user_insists(place: Place) -> None:
    folder = place.work / "deaf"
    folder.mkdir()
    (folder / "zenoh.py").write_text(DEAF + "wait()\n", encoding="utf-8")
    with place.terminal("ros2", "topic", "list", PYTHONPATH=str(folder)) as screen:
        before = screen.attributes()
        until((folder / "deaf").exists)
        screen.press("Ctrl-C")
        screen.wait("^C")
        screen.kill(signal.SIGTERM)  # another one, which the system does not make one with the first
        assert screen.wait_end() == 130
        assert "Traceback" not in screen.look()
        assert screen.attributes() == before


def test_a_window_that_does_not_listen_ends_by_force_and_gives_the_terminal_back(place: Place) -> None:
    folder = place.work / "deaf"
    folder.mkdir()
    stick = (
        "from day6_core.session.local import Foreground\n"
        "Foreground.over = property(lambda self: False if self.program.status is None else wait())\n"
    )
    (folder / "sitecustomize.py").write_text(DEAF + stick, encoding="utf-8")
    with place.terminal("ros2", "run", "turtlesim", "turtlesim_node", PYTHONPATH=str(folder)) as screen:
        before = screen.attributes()
        screen.wait("x 5.54")
        screen.kill(signal.SIGTERM)
        screen.wait(lambda _: (folder / "deaf").exists())
        screen.kill(signal.SIGTERM)
        assert screen.wait_end() == 128 + signal.SIGTERM
        expect_given_back(screen, before)
