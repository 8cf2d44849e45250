"""A terminal that goes away does not keep the desktop."""

from __future__ import annotations

import errno
import io
import os
import select
import threading
import time

import pytest
from textual.drivers._writer_thread import MAX_QUEUED_WRITES, WriterThread

from day6_tui.textual_private import output

tty = pytest.importorskip("tty", reason="needs Unix's terminals")


class _HungUp(io.StringIO):
    """A terminal that is closed after the first text."""

    def write(self, text: str) -> int:
        if self.tell():
            raise OSError(errno.EIO, "Input/output error")
        return super().write(text)


def test_nobody_waits_for_a_terminal_that_is_gone() -> None:
    output.install()
    file = _HungUp()
    writer = WriterThread(file)
    writer.start()

    def talk() -> None:
        for number in range(3 * MAX_QUEUED_WRITES):
            writer.write(f"frame {number}")
        writer.stop()

    talking = threading.Thread(target=talk, daemon=True)
    talking.start()
    talking.join(10)
    assert not talking.is_alive()
    assert file.getvalue() == "frame 0"


def test_what_is_written_arrives_whole_and_in_order() -> None:
    output.install()
    file = io.StringIO()
    writer = WriterThread(file)
    writer.start()
    for number in range(100):
        writer.write(f"{number} ")
    writer.stop()
    assert file.getvalue().split() == [str(number) for number in range(100)]


def test_a_character_that_the_terminal_has_not_costs_this_character_alone() -> None:
    output.install()
    data = io.BytesIO()
    file = io.TextIOWrapper(data, encoding="latin-1", write_through=True)
    writer = WriterThread(file)
    writer.start()
    for text in ("one ", "\udcff小 ", "two"):
        writer.write(text)
    writer.stop()
    assert data.getvalue() == b"one ?? two"


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="needs a terminal as a pipe")
def test_a_slow_terminal_gets_everything_that_gives_it_back(monkeypatch: pytest.MonkeyPatch) -> None:
    output.install()
    monkeypatch.setattr(output, "_leaving", threading.Event())
    monkeypatch.setattr(output, "_last_words", [])
    monkeypatch.setattr(output, "LAST_SECONDS", 0.3)
    ours, theirs = os.pipe()
    with open(theirs, "w", encoding="utf-8") as file:
        writer = WriterThread(file)
        writer.start()

        def leave() -> None:
            for _ in range(3 * MAX_QUEUED_WRITES):
                if writer._queue.full():
                    output.let_go()
                writer.write("picture " * 1000)
            for number in range(2 * MAX_QUEUED_WRITES):
                writer.write(f"<mode {number} off>")
            writer.stop()

        leaving = threading.Thread(target=leave, daemon=True)
        leaving.start()
        while not output._leaving.is_set():
            time.sleep(0.01)
        got = b""
        while leaving.is_alive() or writer.is_alive():
            got += os.read(ours, 1500)  # slower than it is written, and longer than it is waited for without a word
            time.sleep(0.002)
    while more := os.read(ours, 65536):
        got += more
    os.close(ours)
    for number in range(2 * MAX_QUEUED_WRITES):
        assert f"<mode {number} off>".encode() in got


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")
def test_a_whole_frame_is_written_at_once_where_it_is_made() -> None:
    output.install()
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    with open(theirs, "w", encoding="utf-8", closefd=False) as file:
        writer = WriterThread(file)  # not even started: the thread is not needed
        for text in ("\x1b[?2026h", "\x1b[3;4Hturtle", "\x1b[1;1H"):
            writer.write(text)
        assert not select.select([ours], [], [], 0)[0]
        writer.write("\x1b[?2026l")
        assert os.read(ours, 1000) == b"\x1b[?2026h\x1b[3;4Hturtle\x1b[1;1H\x1b[?2026l"
        writer.write("bell")
        assert os.read(ours, 1000) == b"bell"
        writer.start()
        writer.stop()
    os.close(ours)
    os.close(theirs)


@pytest.mark.process
@pytest.mark.skipif(os.name != "posix", reason="needs pseudo-terminals")
def test_what_a_full_terminal_does_not_take_follows_in_order() -> None:
    output.install()
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    got = bytearray()
    with open(theirs, "w", encoding="utf-8", closefd=False) as file:
        writer = WriterThread(file)
        writer.start()
        frames = [f"<{number}:{'海' * 4000}>" for number in range(20)]
        for frame in frames:
            writer.write(frame)
        while len(got) < len("".join(frames).encode()):
            got += os.read(ours, 65536)
        writer.write("after")
        assert select.select([ours], [], [], 5)[0]
        got += os.read(ours, 100)
        writer.stop()
    os.close(ours)
    os.close(theirs)
    assert got.decode() == "".join(frames) + "after"
