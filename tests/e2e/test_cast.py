"""A recording of the desktop at a real terminal: made by the option and by the palette, and played."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")


def test_the_screen_is_recorded_from_the_first_picture_to_the_last_and_played(place: Place) -> None:
    path = place.work / "lesson.cast"
    with place.desktop("--scene", "empty", "--record", str(path)) as terminal:
        terminal.wait("recording 0:0", "student@day6:~$")
        terminal.line("echo $((6*7)) done")
        terminal.wait("42 done")
        terminal.resize(100, 30)
        terminal.line("echo $((7*7)) wide")
        terminal.wait("49 wide")
        terminal.line("cat")
        terminal.wait("1 cat")
        terminal.press("Ctrl-Q")
        terminal.wait("Programs are still running")
        terminal.press("Ctrl-Q")
        assert terminal.wait_end() == 0
    lines = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
    assert (lines[0]["width"], lines[0]["height"]) == (80, 24)
    assert {line[1] for line in lines[1:]} == {"o", "r"}, "no input"
    assert [line[2] for line in lines[1:] if line[1] == "r"][-1] == "100x30"
    assert not any("\x1b[?1000" in line[2] or "\x1b[?1049" in line[2] for line in lines[1:])
    text = place.run("cast", str(path), "--at", str(lines[-1][0])).stdout
    assert "49 wide" in text and "recording" in text and "still running" not in text
    assert place.run("cast", str(path), "--svg", "last.svg").returncode == 0
    svg = (place.work / "last.svg").read_text(encoding="utf-8")
    assert ">49 wide<" in svg and "still running" not in svg, "what was asked at the end is left out"
    with place.terminal("cast", str(path), "--lang", "en", columns=110, rows=32) as terminal:
        terminal.wait("student@day6:~$", " 1× ")
        terminal.press("+", "+")
        terminal.wait(" 4× ", "42 done", "49 wide")
        terminal.send("----0")  # as one text
        terminal.wait(" ¼× ", lambda screen: "49 wide" not in screen)
        terminal.wait("49 wide")
        terminal.press("q")
        assert terminal.wait_end() == 0


def test_a_recording_by_the_palette_asks_before_it_overwrites_and_tells_where_it_is(place: Place) -> None:
    mine = place.home_file("mine.cast", "mine")
    with place.desktop("--scene", "empty") as terminal:
        terminal.wait("student@day6:~$")
        terminal.press("F7")
        terminal.wait("Commands")
        terminal.line("record the screen")
        terminal.wait("Record the screen to")
        terminal.send("\x15mine.cast\r")
        terminal.wait("mine.cast", "Enter")
        assert mine.read_text() == "mine"
        terminal.send("\r")
        terminal.wait("recording 0:0")
        terminal.press("F7")
        terminal.wait("Commands")
        terminal.line("record the screen")
        terminal.wait("recorded: ~/mine.cast")
        terminal.wait_gone("recording 0:")
        terminal.quit()
        terminal.wait_end()
    assert "Commands" in place.run("cast", str(mine), "--at", "99").stdout


def test_an_existing_file_or_no_folder_is_told_before_there_is_a_screen(place: Place) -> None:
    mine = place.file("mine.cast", "mine")
    for path in (mine, place.work / "no" / "folder.cast"):
        with place.desktop("--record", str(path)) as terminal:
            assert terminal.wait_end() == 2
            assert str(path.name) in terminal.look().replace("\n", "")
    assert mine.read_text() == "mine"
