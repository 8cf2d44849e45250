"""The recorder: a cast that others can play, no input, no waiting for the disk, and nothing that is overwritten."""

from __future__ import annotations

import errno
import json
import os
import sys
import threading
from pathlib import Path

import pytest

from day6_tui.cast import recorder as module
from day6_tui.cast.file import read
from day6_tui.cast.film import Film
from day6_tui.cast.recorder import Recorder, picture_of


class _Clock:
    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def test_what_was_shown_when_is_in_the_file_and_sizes_with_it(tmp_path: Path) -> None:
    clock, size = _Clock(), [20, 3]
    recorder = Recorder(tmp_path / "a.cast", lambda: (size[0], size[1]), clock=clock)
    clock.now += 1.5
    recorder.write("\x1b[1;1H\x1b[1;38;2;255;0;0m海龟\x1b[0m")
    clock.now += 1
    size[:] = [30, 4]
    recorder.write("\x1b[2;1Hwide")
    recorder.stop()
    lines = [json.loads(line) for line in (tmp_path / "a.cast").read_text(encoding="utf-8").splitlines()]
    assert (lines[0]["version"], lines[0]["width"], lines[0]["height"]) == (2, 20, 3)
    assert lines[2] == [1.5, "o", "\x1b[1;1H\x1b[1;38;2;255;0;0m海龟\x1b[0m"]
    assert lines[3:] == [[2.5, "r", "30x4"], [2.5, "o", "\x1b[2;1Hwide"]]
    film = Film(read(tmp_path / "a.cast"))
    film.go_to(2.0)
    assert film.size == (20, 3) and film.rows()[0][0][0].startswith("海")
    film.go_to(9.0)
    assert film.size == (30, 4) and film.rows()[1][0][0] == "wide"


@pytest.mark.parametrize(
    ("sent", "kept"),
    [
        ("\x1b[?1049h\x1b[?1000hx", "x"),
        ("\x1b[?25l\x1b[2J\x1b[3;4H", "\x1b[?25l\x1b[2J\x1b[3;4H"),
        ("\x1b]0;title\x07a\x1b]52;c;aGk=\x1b\\b", "ab"),
        ("\x1b_Ga=T;AAAA\x1b\\c\x1bP0;1;0q#0~~\x1b\\d", "cd"),
        ("\x1b[c\x1b[6n\x1b[?2026$pe\x1b[>1u", "e"),
        ("\x07\x00bell\x9b31m", "bell31m"),
        ("open \x1b]0;never ends", "open 0;never ends"),
        ("海\r\n龟\t.", "海\r\n龟\t."),
    ],
)
def test_only_what_changes_the_picture_is_recorded(sent: str, kept: str) -> None:
    assert picture_of(sent) == kept


def test_an_existing_file_is_not_touched_unless_that_was_asked(tmp_path: Path) -> None:
    path = tmp_path / "mine.cast"
    path.write_text("mine")
    with pytest.raises(FileExistsError):
        Recorder(path, lambda: (80, 24))
    assert path.read_text() == "mine"
    Recorder(path, lambda: (80, 24), replace=True).stop()
    assert read(path).size == (80, 24)


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_a_recording_is_not_written_through_a_link(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(FileExistsError):
        Recorder(tmp_path / "link", lambda: (80, 24))
    assert not (tmp_path / "elsewhere").exists()


def test_a_full_disk_ends_the_recording_and_what_was_written_can_be_played(tmp_path: Path, monkeypatch) -> None:
    room, real, told = [400], os.write, threading.Event()

    def write(number: int, data: bytes) -> int:
        if room[0] <= 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        room[0] -= len(data)
        return real(number, data)

    monkeypatch.setattr(module.os, "write", write)
    recorder = Recorder(tmp_path / "a.cast", lambda: (80, 24), failed=told.set)
    for number in range(100):
        recorder.write(f"line {number}\r\n")
    assert told.wait(10)
    assert recorder.fault == os.strerror(errno.ENOSPC)
    recorder.write("more")
    recorder.stop()
    film = Film(read(tmp_path / "a.cast"))
    film.go_to(film.cast.seconds)
    assert film.rows()[0][0][0].startswith("line 0")


def test_the_screen_never_waits_for_the_disk(tmp_path: Path, monkeypatch) -> None:
    go_on, real = threading.Event(), os.write

    def write(number: int, data: bytes) -> int:
        go_on.wait(20)
        return real(number, data)

    monkeypatch.setattr(module.os, "write", write)
    monkeypatch.setattr(module, "MOST_WAITING", 100_000)
    recorder = Recorder(tmp_path / "a.cast", lambda: (80, 24))
    for _ in range(300):
        recorder.write("x" * 1000)
    go_on.set()
    recorder.stop()
    assert recorder.fault == "the disk is too slow"
    assert (tmp_path / "a.cast").stat().st_size < 110_000


def test_a_question_whether_to_end_is_recorded_only_if_the_recording_goes_on(tmp_path: Path) -> None:
    clock, asking = _Clock(), [False]
    recorder = Recorder(tmp_path / "a.cast", lambda: (20, 3), clock=clock, asks=lambda: asking[0])
    for asking[0], text in (
        (False, "before"),
        (True, "really?"),
        (True, " sure?"),
        (False, "no"),
        (True, "really end?"),
    ):
        clock.now += 1
        recorder.write(text)
    recorder.stop()
    events = [event for event in read(tmp_path / "a.cast").events if event.time]
    assert [(event.time, event.text) for event in events] == [(1, "before"), (2, "really?"), (3, " sure?"), (4, "no")]
