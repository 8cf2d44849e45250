"""How much may be under way to a terminal: measured by its answers, in virtual time."""

from __future__ import annotations

from collections import deque

import pytest

from day6_tui.screen.line import FIRST_AHEAD, LEAST_AHEAD, LOST_SECONDS, MOST_ASKED, STOPPED_SECONDS, Line, may_ask


class FakeTerminal:
    """Reads `rate` bytes a second, `delay` seconds after they were written, and answers over the same way back."""

    def __init__(self, rate: float, delay: float = 0.0, *, answers: bool = True) -> None:
        self.now = 100.0
        self.rate, self.delay, self.answers = rate, delay, answers
        self.line = Line(lambda: self.now)
        self.line.begin(may_ask=True)
        self.asked = 0
        self.ours: list[bool] = []
        self._busy_until = 0.0
        self._due: deque[float] = deque()
        self.written = 0

    @property
    def waiting(self) -> float:
        """Bytes that have been written and not read."""
        return max(0.0, self._busy_until - self.now) * self.rate

    def ask(self) -> None:
        """The question, written as the driver does."""
        self.asked += 1
        self.line.asked()
        if self.answers:
            self._due.append(max(self._busy_until, self.now) + self.delay)

    def write(self, count: int, *, asks: bool = False) -> None:
        """Write so much, and what the line wants to ask."""
        self.written += count
        self._busy_until = max(self._busy_until, self.now) + count / self.rate
        if self.line.wrote(count, asks=asks):
            self.ask()
        elif asks and self.answers:
            self._due.append(self._busy_until + self.delay)

    def wait(self, seconds: float) -> None:
        """Let time pass; answers come when they are due."""
        end = self.now + seconds
        while self._due and self._due[0] <= end:
            self.now = self._due.popleft()
            self.ours.append(self.line.answered())
        self.now = end

    def stream(self, seconds: float, frame: int = 3000) -> float:
        """Write whatever is allowed at 30 frames a second; the most that ever waited, but for the first second."""
        most, began = 0.0, self.now
        while self.now < began + seconds:
            room = self.line.room()
            if room is None or room > 0:
                self.write(frame if room is None else min(frame, room))
            elif not self.line.waits:
                self.ask()
            if self.now > began + 1:
                most = max(most, self.waiting)
            self.wait(1 / 30)
        return most


def started(rate: float, delay: float = 0.0, *, answers: bool = True) -> FakeTerminal:
    terminal = FakeTerminal(rate, delay, answers=answers)
    terminal.write(120)
    terminal.ask()
    terminal.wait(0.3)
    return terminal


@pytest.mark.parametrize("rate", [1_000, 4_000, 50_000])
@pytest.mark.parametrize("delay", [0.0, 0.1])
def test_of_what_is_written_to_a_slow_line_little_is_under_way(rate: float, delay: float) -> None:
    terminal = started(rate, delay)
    terminal.stream(FIRST_AHEAD / rate + 3)
    most = terminal.stream(8.0)
    assert most <= max(LEAST_AHEAD, rate * (0.1 + delay) * 2) + 1


@pytest.mark.parametrize("rate", [4_000, 50_000])
@pytest.mark.parametrize("delay", [0.0, 0.1])
def test_a_slow_line_is_used(rate: float, delay: float) -> None:
    terminal = started(rate, delay)
    terminal.stream(2.0)
    before = terminal.written
    terminal.stream(8.0)
    assert terminal.written - before > 0.5 * 8.0 * rate


@pytest.mark.parametrize("delay", [0.0, 0.02, 0.3])
def test_on_a_fast_line_nothing_is_held_back_however_long_it_is(delay: float) -> None:
    terminal = started(20e6, delay)
    terminal.stream(5.0, frame=6000)
    assert terminal.line.room() is None


def test_a_fast_terminal_is_asked_seldom() -> None:
    terminal = started(20e6, 0.001)
    terminal.stream(10.0, frame=400)
    assert terminal.written > 100_000
    assert terminal.asked <= terminal.written / MOST_ASKED + 2


def test_the_first_picture_is_never_held_back_where_nothing_is_known() -> None:
    terminal = FakeTerminal(4_000)
    terminal.write(300)
    assert terminal.line.room() is None, "whether it answers is not known"
    terminal = started(4_000)
    assert terminal.line.room() == FIRST_AHEAD


def test_a_terminal_that_never_answers_is_never_waited_for() -> None:
    terminal = started(4_000, answers=False)
    for _ in range(100):
        terminal.write(3000)
        assert terminal.line.room() is None
        terminal.wait(0.1)
    terminal.wait(LOST_SECONDS + 1)
    assert not terminal.line.waits


def test_a_terminal_that_stops_to_answer_is_waited_for_a_while() -> None:
    terminal = started(50_000)
    terminal.stream(2.0)
    terminal.answers = False
    terminal.stream(2.0)
    assert terminal.line.room() is not None
    terminal.wait(LOST_SECONDS)
    assert terminal.line.room() is not None, "a slow line may need so long"
    terminal.wait(STOPPED_SECONDS)
    assert terminal.line.room() is None
    terminal.answers = True
    terminal.stream(4.0)
    assert terminal.line.room() is not None, "it answers again, and is as slow as before"


def test_a_fast_line_that_becomes_slow_is_found_out_before_the_answer_has_come() -> None:
    terminal = started(20e6)
    terminal.stream(2.0, frame=6000)
    assert terminal.line.room() is None
    terminal.rate = 4_000
    terminal.write(12_000)
    terminal.wait(1.0)
    assert (terminal.line.room() or 0) < 0


def test_a_slow_line_that_becomes_fast_is_found_out() -> None:
    terminal = started(4_000)
    terminal.stream(3.0)
    terminal.rate = 20e6
    terminal.stream(20.0)
    assert terminal.line.room() is None


def test_answers_go_to_whoever_asked() -> None:
    terminal = started(20e6)
    assert terminal.line.answered(), "nobody waits for it"
    terminal.ours.clear()
    terminal.write(100, asks=True)
    terminal.write(9000)
    terminal.write(100, asks=True)
    terminal.wait(1.0)
    assert terminal.ours == [False, True, False]


def test_another_terminal_is_another_line() -> None:
    terminal = started(4_000)
    terminal.stream(2.0)
    terminal.line.begin(may_ask=False)
    assert terminal.line.room() is None and not terminal.line.waits
    assert not terminal.line.wrote(100_000)


def test_a_terminal_that_knows_nothing_is_not_asked() -> None:
    assert may_ask({"TERM": "xterm-256color"}) and may_ask({"TERM": "linux"})
    assert not may_ask({"TERM": "dumb"}) and not may_ask({})
