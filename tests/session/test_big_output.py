"""Output of megabytes through the streams between programs: nothing is lost, and twice as much takes twice as long."""

from __future__ import annotations

from time import process_time

import pytest

from day6_core.session import streams
from day6_core.session.clock import WorldClock
from day6_core.session.scheduler import Scheduler
from day6_core.session.streams import Captured, InputStream, Pipe


def read_lines(stream: InputStream) -> list[str]:
    """All lines of a stream that has come to its end."""
    scheduler = Scheduler(WorldClock(wall=None))

    async def read() -> list[str]:
        lines = []
        while line := await stream.read_line():
            lines.append(line)
        return lines

    task = scheduler.spawn(read())
    scheduler.advance()
    assert task.finished
    return task.result  # type: ignore[no-any-return]


def time_of(count: int) -> float:
    """The CPU seconds in which so many lines that wait in a pipe are read; the best of three."""
    best = 1e9
    for _ in range(3):
        pipe = Pipe()
        pipe.writer.write("seven..\n" * count)
        pipe.writer.close()
        began = process_time()
        assert len(read_lines(pipe.reader)) == count
        best = min(best, process_time() - began)
    return best


def test_ten_times_as_many_lines_in_a_pipe_take_ten_times_as_long() -> None:
    assert time_of(200_000) < max(40 * time_of(20_000), 0.2)  # the clock of Windows goes in steps


def test_one_write_of_many_megabytes_goes_through_a_pipe_whole() -> None:
    pipe = Pipe()
    pipe.writer.write("x" * (streams.PIPE_LIMIT * 2) + "\nlast\n")
    pipe.writer.close()
    assert pipe.dropped == 0
    assert [len(line) for line in read_lines(pipe.reader)] == [streams.PIPE_LIMIT * 2 + 1, 5]


def test_keys_and_lines_can_be_read_from_one_pipe_in_turn() -> None:
    pipe = Pipe()
    pipe.writer.write("ab\ncd")
    pipe.writer.write("\nef")
    pipe.writer.close()
    scheduler = Scheduler(WorldClock(wall=None))
    reader = pipe.reader

    async def read() -> list[str]:
        return [await reader.read_key(), await reader.read_line(), await reader.read_line(), await reader.read_key()]

    task = scheduler.spawn(read())
    scheduler.advance()
    assert task.result == ["a", "b\n", "cd\n", "e"]
    assert read_lines(reader) == ["f"]


def test_what_is_captured_is_kept_whole_and_a_program_without_end_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    captured = Captured()
    for _ in range(100):
        captured.write("x" * 100_000)
    assert len(captured.text) == 10_000_000 and not captured.is_cut
    monkeypatch.setattr(streams, "CAPTURE_LIMIT", 1000)
    captured = Captured()
    with pytest.raises(BrokenPipeError):
        for _ in range(100):
            captured.write("y" * 100)
    assert captured.is_cut and len(captured.text) == 1000
