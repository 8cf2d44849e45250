"""The frame timer: still when nothing changes, never faster than it may, slower when the terminal cannot follow."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import pytest

from day6_tui.app import Day6App
from day6_tui.options import Options
from day6_tui.screen.frames import Frames
from tests.support.waiting import Deadline
from tests.tui.fakes import FakeDesk, FakeSimulation, turtle
from tests.tui.screens import UTF8, make_look, running, screen_text, step


class _Loop:
    """An event loop whose time the test moves."""

    def __init__(self) -> None:
        self.now = 100.0
        self.calls: list[tuple[float, Callable[[], None]]] = []

    def call_later(self, delay: float, function: Callable[[], None], *, context: object = None) -> _Handle:
        call = (self.now + delay, function)
        self.calls.append(call)
        return _Handle(lambda: self.calls.remove(call))

    def call_soon_threadsafe(self, function: Callable[[], None], *, context: object = None) -> None:
        self.calls.append((self.now, function))

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self.calls:
            self.calls.sort(key=lambda call: call[0])
            if self.calls[0][0] > end:
                break
            due, function = self.calls.pop(0)
            self.now = max(self.now, due)
            function()
        self.now = end


class _Handle:
    def __init__(self, cancel: Callable[[], None]) -> None:
        self.cancel = cancel


def _frames(monkeypatch, draw: Callable[[], bool], fps: float = 30.0, **options: object) -> tuple[Frames, _Loop]:
    loop = _Loop()
    monkeypatch.setattr("day6_tui.screen.frames.time.monotonic", lambda: loop.now)
    monkeypatch.setattr(asyncio, "get_running_loop", lambda: loop)
    frames = Frames(draw, fps, **options)
    frames.attach()
    return frames, loop


def test_nothing_runs_while_nothing_changes(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: False)
    loop.run(10.0)
    assert frames.drawn == 0 and not loop.calls
    frames.wake()
    loop.run(10.0)
    assert frames.drawn == 1 and not loop.calls


def test_a_thousand_changes_a_second_are_thirty_frames(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: False)
    for _ in range(1000):
        frames.wake()
        loop.run(0.001)
    assert 28 <= frames.drawn <= 31


def test_what_moves_by_itself_gets_frames_without_being_woken(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: True)
    frames.wake()
    loop.run(1.0)
    assert 28 <= frames.drawn <= 31


def test_what_was_put_off_gets_one_frame_in_its_time(monkeypatch) -> None:
    at: list[float] = []

    def draw() -> bool:
        at.append(loop.now)
        if len(at) == 1:
            frames.wake_after(0.2)
        return False

    frames, loop = _frames(monkeypatch, draw)
    frames.wake()
    loop.run(5.0)
    assert len(at) == 2 and at[1] - at[0] == pytest.approx(0.2, abs=0.02)


def test_a_change_is_not_held_up_by_what_was_put_off(monkeypatch) -> None:
    at: list[float] = []

    def draw() -> bool:
        at.append(loop.now)
        frames.wake_after(2.0)
        return False

    frames, loop = _frames(monkeypatch, draw)
    frames.wake()
    loop.run(1.0)
    frames.wake()
    loop.run(0.05)
    assert len(at) == 2 and at[1] - at[0] == pytest.approx(1.0, abs=0.04)
    loop.run(1.9)
    assert len(at) == 2, "it is put off anew by every frame"
    loop.run(0.2)
    assert len(at) == 3


def test_where_nobody_looks_there_are_few_frames_until_somebody_comes(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: True)
    frames.rest(True)
    loop.run(10.0)
    assert 38 <= frames.drawn <= 42
    frames.rest(False)
    before = frames.drawn
    loop.run(1.0)
    assert 28 <= frames.drawn - before <= 32


def test_on_a_busy_machine_there_are_fewer_frames_but_eight(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: True)
    usual = loop.call_later
    # Somebody else has the processor whenever a frame is due.
    monkeypatch.setattr(loop, "call_later", lambda delay, *rest, **more: usual(delay + 0.2, *rest, **more))
    frames.wake()
    loop.run(3.0)
    assert frames.rate == pytest.approx(8.0)


def test_a_terminal_that_does_not_take_its_output_is_left_in_peace(monkeypatch) -> None:
    stuck = True
    frames, loop = _frames(monkeypatch, lambda: True, congested=lambda: stuck)
    frames.wake()
    loop.run(2.0)
    assert frames.drawn == 0
    assert frames.rate <= 5
    stuck = False
    loop.run(20.0)
    assert frames.rate == 30


def test_in_tests_only_step_draws(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: False, fps=0)
    frames.wake()
    loop.run(1.0)
    assert frames.drawn == 0
    frames.step()
    assert frames.drawn == 1


def test_an_error_in_a_frame_is_reported_and_the_next_frame_is_drawn(monkeypatch) -> None:
    errors: list[Exception] = []
    answers = iter([ValueError("broken")])

    def draw() -> bool:
        error = next(answers, None)
        if error is not None:
            raise error
        return False

    frames, loop = _frames(monkeypatch, draw, failed=errors.append)
    frames.wake()
    loop.run(1.0)
    frames.wake()
    loop.run(1.0)
    assert [str(error) for error in errors] == ["broken"]
    assert frames.drawn == 2


def test_work_goes_on_between_the_frames_until_it_is_done(monkeypatch) -> None:
    left = [0.001] * 20 + [None]
    drawn_at: list[int] = []
    frames, loop = _frames(monkeypatch, lambda: drawn_at.append(len(left)) or False, work=lambda: left.pop(0))
    loop.run(1.0)
    assert len(left) == 21  # nothing was woken
    frames.wake()
    loop.run(1.0)
    assert left == [] and frames.drawn == 1 and drawn_at == [21]


def test_work_that_somebody_waits_for_is_done_at_once_and_once(monkeypatch) -> None:
    done: list[float] = []
    frames, loop = _frames(monkeypatch, lambda: False, work=lambda: done.append(loop.now) or 0.5)
    for _ in range(3):
        frames.work_soon()
    loop.run(0.0)
    assert done == [100.0] and not frames.drawn
    loop.run(0.2)
    frames.work_soon()
    loop.run(0.4)
    assert done == [100.0, 100.2]  # instead of the turn that was planned
    loop.run(0.2)
    assert done == [100.0, 100.2, 100.7]
    frames.detach()
    frames.work_soon()
    loop.run(1.0)
    assert len(done) == 3


def test_work_that_fails_is_told_and_the_frames_go_on(monkeypatch) -> None:
    told: list[Exception] = []

    def work() -> float:
        raise ValueError("broken")

    frames, loop = _frames(monkeypatch, lambda: False, work=work, failed=told.append)
    for _ in range(2):
        frames.wake()
        loop.run(1.0)
    assert frames.drawn == 2 and len(told) == 2


def test_an_echo_is_drawn_before_the_frame_that_is_planned(monkeypatch) -> None:
    echoes: list[float] = []
    frames, loop = _frames(monkeypatch, lambda: True, echo=lambda: echoes.append(loop.now) or True)
    frames.wake()
    loop.run(1.0)
    frames.wake()
    loop.run(0.001)
    assert not echoes, "nobody has typed"
    frames.hurry()
    drawn, typed = frames.drawn, loop.now
    frames.wake()  # what was typed has been written
    loop.run(0.002)
    assert echoes == [typed] and frames.drawn == drawn
    frames.wake()
    loop.run(0.001)
    assert len(echoes) == 1, "it was there: what else changes waits for the frame"


def test_an_echo_that_does_not_come_is_not_looked_for_for_ever(monkeypatch) -> None:
    looks: list[float] = []
    frames, loop = _frames(monkeypatch, lambda: True, echo=lambda: looks.append(loop.now) or False)
    frames.wake()
    loop.run(0.1)
    frames.hurry()
    for _ in range(100):
        frames.wake()
        loop.run(0.02)
    assert looks and looks[-1] - looks[0] == pytest.approx(0.5, abs=0.05)


def test_a_frame_gives_way_to_a_key_but_only_once(monkeypatch) -> None:
    at: list[float] = []
    frames, loop = _frames(monkeypatch, lambda: at.append(loop.now) or True)
    frames.wake()
    loop.run(1.0)
    key = at[-1] + 1 / 30 - 0.001
    loop.run(key - loop.now)
    frames.typed()  # it is on its way through the application
    loop.run(0.1)
    first = next(time for time in at if time > key)
    assert first - key == pytest.approx(0.02, abs=0.002)
    before = frames.drawn
    for _ in range(200):  # held down
        frames.typed()
        loop.run(0.005)
    assert frames.drawn - before >= 15


def test_where_frames_are_few_a_key_brings_one_early_but_not_each_key(monkeypatch) -> None:
    frames, loop = _frames(monkeypatch, lambda: True)
    usual, busy = loop.call_later, True
    monkeypatch.setattr(loop, "call_later", lambda delay, *rest, **more: usual(delay + 0.2 * busy, *rest, **more))
    frames.wake()
    loop.run(3.0)
    assert frames.rate == pytest.approx(8.0)
    busy = False
    loop.run(0.5)
    before = frames.drawn
    while frames.drawn == before:
        loop.run(0.001)
    frames.hurry()
    loop.run(1 / 30 + 0.001)
    assert frames.drawn == before + 2, "the next one would come 125 ms after the last"
    for _ in range(30):
        frames.hurry()
        loop.run(1 / 30)
    assert frames.drawn - before < 20


@pytest.mark.parametrize(("takes", "between"), [(0.1, 0.2), (0.6, 0.725)])
def test_a_frame_that_takes_long_leaves_as_long_for_keys_but_not_for_ever(
    monkeypatch, takes: float, between: float
) -> None:
    began: list[float] = []

    def draw() -> bool:
        began.append(loop.now)
        loop.now += takes
        return True

    frames, loop = _frames(monkeypatch, draw)
    frames.wake()
    loop.run(6.0)
    assert began[-1] - began[-2] == pytest.approx(between)


async def test_what_is_typed_beside_a_driving_turtle_is_seen_before_the_next_frame() -> None:
    desk, simulation = FakeDesk(), FakeSimulation()
    desk.display.open("turtlesim", "TurtleSim", simulation)
    options = Options(fps=0.01, lang="en", scene="empty")  # the next frame would come after 100 seconds
    app = Day6App(options, desk=desk, look=make_look(options, UTF8))
    async with running(app, 120, 40) as pilot:
        await step(app, pilot)
        terminal = desk.terminals[0]
        app.desktop.focus_pane(app.terminals.panes[0])
        await step(app, pilot)
        app.frames.wake()
        await pilot.pause()
        for letter in "qz":
            simulation.show(turtle(x=7.0))
            app.frames.wake()
            await pilot.press(letter)
            drawn, deadline = app.frames.drawn, Deadline()
            terminal.write(letter)
            app.frames.wake()
            while f"student@day6:~$ {terminal.sent}" not in screen_text(app):
                assert not deadline.is_over(), screen_text(app)
                await pilot.pause()
            assert app.frames.drawn == drawn and "x 7.00" not in screen_text(app)
        await step(app, pilot)
        assert "x 7.00" in screen_text(app)


def test_a_frame_that_waits_for_the_terminal_comes_as_soon_as_it_takes_more(monkeypatch) -> None:
    stuck = True
    frames, loop = _frames(monkeypatch, lambda: False, congested=lambda: stuck)
    frames.wake()
    loop.run(2.0)
    assert frames.drawn == 0
    stuck = False
    frames.relieve()
    loop.run(0.001)
    assert frames.drawn == 1 and frames.rate == 30, "the terminal was slow, not the machine"
    frames.relieve()
    loop.run(1.0)
    assert frames.drawn == 1


def test_what_is_left_of_a_frame_comes_as_soon_as_the_terminal_takes_it(monkeypatch) -> None:
    left = [3]

    def draw() -> bool:
        if left[0]:
            left[0] -= 1
            frames.hold()
            frames.wake()
        return False

    frames, loop = _frames(monkeypatch, draw)
    frames.wake()
    loop.run(0.0)
    for drawn in (1, 2, 3, 4):
        assert frames.drawn == drawn
        frames.relieve()
        loop.run(0.0)
    assert frames.drawn == 4


def test_an_echo_is_drawn_while_frames_wait_but_not_where_nothing_could_be_sent(monkeypatch) -> None:
    echoes: list[float] = []
    blocked = True

    def echo() -> bool:
        echoes.append(loop.now)
        return True

    frames, loop = _frames(monkeypatch, lambda: False, congested=lambda: True, blocked=lambda: blocked, echo=echo)
    frames.wake()
    loop.run(0.1)
    for expected in (0, 1):
        frames.hurry()
        frames.wake()
        loop.run(0.01)
        assert len(echoes) == expected and frames.drawn == 0
        blocked = False
