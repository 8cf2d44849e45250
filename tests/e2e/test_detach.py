"""A desktop that outlives its terminal: what is left goes on, and comes back in any other terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from waiting import until

if TYPE_CHECKING:
    from place import Place
    from terminal import Terminal

termios = pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

LEFT = b"\x1b[?1049l"


def attach(place: Place, columns: int = 80, rows: int = 24, **env: str | None) -> Terminal:
    return place.terminal("attach", "--home", str(place.home), "--lang", "en", columns=columns, rows=rows, **env)


def test_what_is_left_by_the_palette_goes_on_and_comes_back_in_another_size(place: Place) -> None:
    with place.desktop("--detach", "--scene", "empty") as screen:
        before = screen.attributes()
        screen.wait("student@day6:~$")
        screen.line("echo one $((1 + 1)) three")
        screen.wait("one 2 three")
        screen.press("F7")
        screen.send("Detach")
        screen.wait("Detach")
        screen.press("Enter")
        assert screen.wait_end() == 0
        assert "[detached: day6-tui attach --home" in screen.look()
        assert screen.attributes() == before
    with attach(place, 120, 40) as screen:
        screen.wait("one 2 three", "student@day6:~$")
        screen.line("exit")
        screen.press("Ctrl-Q")
        screen.wait_end()
    until(lambda: place.processes() == {})
