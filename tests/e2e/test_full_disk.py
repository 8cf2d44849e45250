"""A disk on which nothing can be written any more, as a person meets it: `ulimit -f 0` does that to every user."""

from __future__ import annotations

import shutil
import sys
from typing import TYPE_CHECKING

import pytest

if sys.platform == "win32":
    pytest.skip("needs a pty", allow_module_level=True)

from tests.e2e.place import DAY6
from tests.e2e.terminal import Terminal

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

BASH = shutil.which("bash")


def without_room(place: Place) -> Terminal:
    """A desktop whose files may not grow."""
    assert BASH is not None
    line = 'ulimit -f 0; exec "$@"'
    command = [*DAY6, "--scene", "empty", "--lang", "en", "--home", str(place.home)]
    env = place.environment(XDG_DATA_HOME=str(place.work / "data"), TERM="xterm-256color")
    return Terminal([BASH, "-c", line, "day6", *command], 90, 24, cwd=place.work, env=env)


@pytest.mark.skipif(BASH is None, reason="needs bash")
def test_nano_and_the_desktop_lose_no_text_without_a_question(place: Place) -> None:
    with without_room(place) as screen:
        screen.wait("$")
        screen.line("echo hi > f.txt; echo status $?")
        screen.wait_lines("status 1")
        screen.wait("bash: echo: write error: ")
        screen.line("nano hello.txt")
        screen.wait("hello.txt", "^X close")
        screen.send("all my work")
        screen.wait("all my work", "no backup of the text")
        screen.send("\x13")
        screen.wait("not saved: File too large")
        screen.press("F2", "Ctrl-Q")
        screen.wait("You have unsaved work", "hello.txt")
        screen.press("Esc")
        screen.wait_gone("You have unsaved work")
        assert "all my work" in screen.look() and screen.status is None
        screen.press("Ctrl-Q")
        screen.wait("You have unsaved work")
        screen.send("y")
        assert screen.wait_end() == 1
        assert b"day6-tui: layout and terminals can't be saved: File too large" in screen.output
    assert not list(place.work.rglob(".day6-*")) and not list(place.home.rglob(".day6-*"))
