"""Pipes, files, keys."""

from __future__ import annotations

import io
import os
from collections.abc import Coroutine
from pathlib import Path
from typing import Any

import pytest

from day6_core.session.clock import WorldClock
from day6_core.session.keys import split_keys
from day6_core.session.scheduler import Scheduler
from day6_core.session.streams import PIPE_HIGH, PIPE_LIMIT, Captured, FileInput, FileOutput, Pipe, TextInput
from day6_core.session.task import Task


def run(*coroutines: Coroutine[Any, Any, Any]) -> list[Task]:
    scheduler = Scheduler(WorldClock(wall=None))
    tasks = [scheduler.spawn(each) for each in coroutines]
    scheduler.advance()
    return tasks


def test_a_pipe_delivers_whole_lines_however_they_were_written() -> None:
    pipe = Pipe()
    lines: list[str] = []

    async def reader() -> None:
        while line := await pipe.reader.read_line():
            lines.append(line)

    async def writer() -> None:
        for piece in ("he", "llo\nwo", "rld\n\nlast"):
            pipe.writer.write(piece)
            await pipe.writer.drain()
        pipe.writer.close()

    run(reader(), writer())
    assert lines == ["hello\n", "world\n", "\n", "last"]


def test_writing_into_a_pipe_nobody_reads_any_more_breaks_it() -> None:
    pipe = Pipe()
    pipe.reader.close()
    with pytest.raises(BrokenPipeError):
        pipe.writer.write("x")


def test_a_writer_that_drains_waits_for_its_reader() -> None:
    pipe = Pipe()
    written: list[int] = []

    async def writer() -> None:
        for number in range(100):
            pipe.writer.write("x" * (PIPE_HIGH // 4))
            await pipe.writer.drain()
            written.append(number)

    async def reader() -> None:
        await pipe.reader.read_key()
        pipe.reader.close()

    (task,) = run(writer())
    assert len(written) == 3
    assert not task.finished
    task.scheduler.spawn(reader())
    task.scheduler.advance()
    assert isinstance(task.exception, BrokenPipeError)


def test_a_pipe_holds_a_bounded_amount_and_counts_what_did_not_fit() -> None:
    pipe = Pipe()
    block = "x" * (1024 * 1024)
    for _ in range(10):
        pipe.writer.write(block)
    assert pipe._size == PIPE_LIMIT
    assert pipe.dropped == 6 * len(block)


def test_what_is_written_to_a_file_can_be_read_line_by_line(tmp_path: Path) -> None:
    path = tmp_path / "a"
    for text, append in (("一\n", False), ("two", True)):
        output = FileOutput(path, append=append)
        output.write(text)
        output.close()
    lines: list[str] = []

    async def reader() -> None:
        stream = FileInput(path)
        while line := await stream.read_line():
            lines.append(line)
        stream.close()

    run(reader())
    assert lines == ["一\n", "two"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes")
def test_a_named_pipe_may_get_the_descriptor_0(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """That of standard input, where a program was started without one: once the pipe was then opened again, and waited."""
    path = tmp_path / "pipe"
    os.mkfifo(path)
    opened: list[object] = []
    monkeypatch.setattr(os, "open", lambda *_: 0)
    monkeypatch.setattr(io, "FileIO", lambda file, mode: opened.append((file, mode)))
    FileOutput(path)
    assert opened == [(0, "w")]


def test_a_here_document_is_read_by_lines_and_by_keys() -> None:
    stream = TextInput("ab\nc")
    results: list[str] = []

    async def reader() -> None:
        results.append(await stream.read_key())
        results.append(await stream.read_line())
        results.append(await stream.read_all())
        results.append(await stream.read_line())

    run(reader())
    assert results == ["a", "b\n", "c", ""]


def test_a_capture_keeps_what_was_written() -> None:
    output = Captured()
    output.write("a")
    output.write("b")
    assert output.text == "ab"


@pytest.mark.parametrize(
    ("text", "keys"),
    [
        ("ab", ["a", "b"]),
        ("\x1b[A\x1b[B", ["\x1b[A", "\x1b[B"]),
        ("\x1bOA", ["\x1bOA"]),
        ("\x1b[1;5D", ["\x1b[1;5D"]),
        ("\x1b[200~x", ["\x1b[200~", "x"]),
        ("\x1bb", ["\x1bb"]),
        ("\x1b", ["\x1b"]),
        ("你\r", ["你", "\r"]),
        ("", []),
    ],
)
def test_what_a_terminal_sends_is_split_into_keys(text: str, keys: list[str]) -> None:
    assert split_keys(text) == keys


def test_what_a_process_has_not_read_comes_next_also_before_the_rest_of_a_line() -> None:
    pipe, text = Pipe(), TextInput("a\nb\n")
    got: list[str] = []

    async def reader() -> None:
        for stream in (pipe.reader, text):
            line = await stream.read_line()
            stream.push_back(line)
            got.append(await stream.read_line())
            got.append(await stream.read_key())
            stream.push_back(got[-1])
            got.append(await stream.read_all())

    pipe.writer.write("one\ntw")
    (first,) = run(reader())
    pipe.reader.push_back("not read\n")  # while its last line waits for its end
    assert not first.done.is_set()
    pipe.writer.write("o\n")
    pipe.writer.close()
    first.scheduler.advance()
    assert got == ["one\n", "t", "not read\ntwo\n", "a\n", "b", "b\n"]


def test_a_process_goes_on_reading_a_file_where_reading_stopped(tmp_path: Path) -> None:
    path = tmp_path / "f"
    path.write_text("é1\nzwei\ndrei\n", encoding="utf-8", newline="")
    file = FileInput(path)
    (line,) = run(file.read_line())
    number = file.fileno()
    assert number is not None and line.result == "é1\n"
    assert os.read(number, 5) == b"zwei\n"
    (line,) = run(file.read_line())
    file.close()
    assert line.result == "drei\n"
