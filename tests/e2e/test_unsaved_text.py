"""Text that was typed and not saved, and then the terminal, the desktop or the machine goes away: it comes back."""

from __future__ import annotations

import json
import shutil
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if sys.platform == "win32":
    pytest.skip("needs a pty", allow_module_level=True)


from tests.e2e.place import DAY6
from tests.e2e.terminal import Terminal
from tests.support.disks import ROOT, SETPRIV, WITHOUT_RIGHTS
from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

BASH = shutil.which("bash")


def desktop(place: Place, *before: str) -> Terminal:
    command = [*before, *DAY6, "--scene", "empty", "--lang", "en", "--home", str(place.home)]
    env = place.environment(XDG_DATA_HOME=str(place.work / "data"), TERM="xterm-256color")
    return Terminal(command, 90, 24, cwd=place.work, env=env)


def copies(place: Place) -> list[Path]:
    return list((place.work / "data").rglob("*.json"))


def type_in_nano(screen: Terminal) -> None:
    screen.wait("$")
    screen.line("nano work.txt")
    screen.wait("work.txt", "^X close")
    screen.send("all my work")
    screen.wait("all my work")


def is_back(place: Place) -> None:
    """Whether the text is offered when the file is opened again, and can be saved."""
    with desktop(place) as screen:
        screen.wait("$")
        screen.line("nano work.txt")
        screen.wait("all my work")
        screen.send("\x13")
        until(lambda: (place.home / "work.txt").exists())
        assert (place.home / "work.txt").read_text().startswith("all my work")


@pytest.mark.parametrize("way", ["hang-up", "SIGHUP", "SIGTERM", "Ctrl-Q", "SIGKILL"])
def test_it_comes_back_whatever_ended_the_desktop(place: Place, way: str) -> None:
    with desktop(place) as screen:
        type_in_nano(screen)
        if way == "SIGKILL":  # of which nobody hears: what was typed a second ago is kept
            until(lambda: any("all my work" in path.read_text() for path in copies(place)))
        if way == "hang-up":
            screen.hang_up()
        elif way == "Ctrl-Q":
            screen.press("F2")  # in the editor it would close the file
            screen.quit()
        else:
            screen.kill(getattr(signal, way))
        until(lambda: screen._reap() or screen.status is not None)
    assert not (place.home / "work.txt").exists()
    is_back(place)


def test_who_is_killed_while_typing_without_a_pause_has_what_was_typed_before(place: Place) -> None:
    with desktop(place) as screen:
        screen.wait("$")
        screen.line("nano work.txt")
        screen.wait("work.txt", "^X close")
        words = 0

        def type_on() -> bool:
            nonlocal words
            screen.send(f"w{words}\r")
            words += 1
            screen.look(0.05)
            return any('"w0' in path.read_text() for path in copies(place))

        until(type_on, every=0)
        screen.kill(signal.SIGKILL)
        until(lambda: screen._reap() or screen.status is not None)
    (copy,) = copies(place)
    back = json.loads(copy.read_text())["text"]
    assert "".join(f"w{number}\n" for number in range(words)).startswith(back), "and nothing else"


@pytest.mark.skipif(ROOT and SETPRIV is None, reason="for root no folder is read-only, and setpriv is not there")
def test_where_no_copy_can_be_made_it_is_told_and_leaving_asks(place: Place) -> None:
    data = place.work / "data"
    with desktop(place) as screen:  # makes its folders
        type_in_nano(screen)
        until(lambda: copies(place) != [])
        screen.press("F2")
        screen.quit()
        screen.wait_end()
    folder = copies(place)[0].parent
    copies(place)[0].unlink()
    for each in (place.home, folder):
        each.chmod(0o500)
    try:
        with desktop(place, *([str(SETPRIV), *WITHOUT_RIGHTS] if ROOT else [])) as screen:
            type_in_nano(screen)
            screen.wait("no backup of the text: Permission denied")
            screen.send("\x13")
            screen.wait("not saved: Permission denied")
            screen.press("F2", "Ctrl-Q")
            screen.wait("You have unsaved work", "work.txt")
            screen.press("Esc")
            screen.wait_gone("You have unsaved work")
            screen.kill(signal.SIGTERM)
            assert screen.wait_end() != 0
            assert b"work.txt (Permission denied)" in screen.output
    finally:
        for each in (place.home, folder):
            each.chmod(0o700)
    assert data.is_dir()


def test_what_is_typed_at_the_terminal_of_an_editor_is_seen(place: Place) -> None:
    with desktop(place) as screen:
        screen.wait("$")
        screen.line("nano work.txt")
        screen.wait("┏ 2 nano")
        screen.press("F3")
        screen.wait("┏ 1 nano")
        screen.send("seen by everybody")
        screen.wait(
            "seen by everybody", "┏ 2 nano"
        )  # wherever the editor was: it might have been behind another window


def test_keys_that_come_at_once_are_taken_in_their_order(place: Place) -> None:
    place.home.mkdir(parents=True, exist_ok=True)
    (place.home / "work.txt").write_text("TODO: package description")
    with desktop(place) as screen:
        screen.wait("$")
        screen.line("nano work.txt")
        screen.wait("TODO: package description", "┏ 2 nano")
        screen.send(
            "\x05" + "\x7f" * 25 + "\x1b[D" + "My first" + "\x01" + "2 " + "\x1b[C" * 5 + "-" + "\x05" + "\x7f" + "!"
        )
        screen.wait("2 My fi-rs!")
