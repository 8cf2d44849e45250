"""Cooperative tasks at exact times of the world."""

from __future__ import annotations

import gc
import threading
import time
import warnings
from types import SimpleNamespace

import pytest

from day6_core.session.clock import NANOSECONDS, WorldClock
from day6_core.session.scheduler import MAX_LAG_NS, Scheduler
from day6_core.session.task import Signal, TaskCancelled, let_others_run, sleep_until, wait_for
from tests.support.waiting import until

MS = 1_000_000


@pytest.fixture
def scheduler() -> Scheduler:
    return Scheduler(WorldClock(wall=None, epoch_ns=0))


def test_a_sleeper_wakes_at_exactly_its_time(scheduler: Scheduler) -> None:
    seen: list[int] = []

    async def sleeper() -> None:
        await sleep_until(16 * MS)
        seen.append(scheduler.clock.steady_ns())

    scheduler.spawn(sleeper())
    scheduler.advance(0.0159)
    assert seen == []
    scheduler.advance(1)
    assert seen == [16 * MS]


def test_two_timers_run_in_the_order_of_their_deadlines_whatever_was_asked_first(scheduler: Scheduler) -> None:
    order: list[str] = []

    async def at(name: str, deadline: int) -> None:
        await sleep_until(deadline)
        order.append(f"{name}@{scheduler.clock.steady_ns() // MS}")

    scheduler.spawn(at("late", 30 * MS))
    scheduler.spawn(at("early", 10 * MS))
    scheduler.spawn(at("early too", 10 * MS))
    scheduler.advance(0.1)
    assert order == ["early@10", "early too@10", "late@30"]


def test_everything_woken_by_a_deadline_runs_before_time_moves_on(scheduler: Scheduler) -> None:
    signal = Signal()
    seen: list[int] = []

    async def publisher() -> None:
        await sleep_until(10 * MS)
        signal.set()

    async def subscriber() -> None:
        await wait_for(signal)
        await let_others_run()
        seen.append(scheduler.clock.steady_ns())

    scheduler.spawn(subscriber())
    scheduler.spawn(publisher())
    scheduler.advance(5)
    assert seen == [10 * MS]


def test_waiting_ends_with_the_signal_or_with_the_time(scheduler: Scheduler) -> None:
    signal = Signal()
    results: list[bool] = []

    async def waiter() -> None:
        results.append(await wait_for(signal, 10 * MS))
        results.append(await wait_for(signal, 20 * MS))

    scheduler.spawn(waiter())
    scheduler.advance(0.012)
    assert results == [False]
    signal.set()
    scheduler.advance()
    assert results == [False, True]


def test_a_signal_ended_wait_leaves_no_deadline_behind(scheduler: Scheduler) -> None:
    signal = Signal()

    async def waiter() -> None:
        for _ in range(1000):
            signal.clear()
            await wait_for(signal, 3600 * NANOSECONDS)

    scheduler.spawn(waiter())
    scheduler.advance()
    for _ in range(1000):
        signal.set()
        scheduler.advance()
    assert len(scheduler._deadlines) < 100
    assert not signal._waiters


def test_a_thrown_exception_arrives_where_the_task_waits(scheduler: Scheduler) -> None:
    caught: list[str] = []

    async def program() -> None:
        try:
            await wait_for(Signal())
        except KeyboardInterrupt:
            caught.append("interrupted")
            raise

    task = scheduler.spawn(program())
    scheduler.advance()
    task.throw(KeyboardInterrupt())
    scheduler.advance()
    assert caught == ["interrupted"]
    assert isinstance(task.exception, KeyboardInterrupt)


def test_an_interrupt_during_a_step_arrives_at_the_next_wait(scheduler: Scheduler) -> None:
    async def program() -> None:
        task.throw(KeyboardInterrupt())
        await sleep_until(NANOSECONDS)

    task = scheduler.spawn(program())
    scheduler.advance()
    assert isinstance(task.exception, KeyboardInterrupt)


def test_a_cancelled_task_runs_its_finally_blocks(scheduler: Scheduler) -> None:
    ended: list[str] = []

    async def program() -> None:
        try:
            await wait_for(Signal())
        except Exception:
            ended.append("an except Exception caught it")
        finally:
            ended.append("finally")

    task = scheduler.spawn(program())
    scheduler.advance()
    task.cancel()
    scheduler.advance()
    assert ended == ["finally"]
    assert isinstance(task.exception, TaskCancelled)


def test_an_exception_ends_its_own_task_only(scheduler: Scheduler) -> None:
    ran: list[int] = []

    async def broken() -> None:
        raise RuntimeError("broken")

    async def healthy() -> None:
        await sleep_until(MS)
        ran.append(1)

    task = scheduler.spawn(broken())
    scheduler.spawn(healthy())
    scheduler.advance(0.01)
    assert str(task.exception) == "broken"
    assert ran == [1]


def test_a_held_task_keeps_its_wake_up_until_it_is_released(scheduler: Scheduler) -> None:
    seen: list[int] = []

    async def program() -> None:
        await sleep_until(10 * MS)
        seen.append(scheduler.clock.steady_ns() // MS)

    task = scheduler.spawn(program())
    scheduler.advance()
    task.hold()
    scheduler.advance(0.05)
    assert seen == []
    task.release()
    scheduler.advance()
    assert seen == [50]


def test_programs_that_keep_waking_each_other_do_not_stop_time() -> None:
    scheduler = Scheduler(WorldClock())
    woke: list[int] = []

    async def restless() -> None:
        while not woke:
            await let_others_run()

    async def sleeper() -> None:
        await sleep_until(scheduler.clock.steady_ns() + MS)
        woke.append(1)

    scheduler.spawn(restless())
    scheduler.spawn(sleeper())
    until(lambda: scheduler.run(lambda: bool(woke), 0.05), every=0.0)


def test_a_world_under_load_falls_behind_but_skips_no_tick() -> None:
    wall_ns = [0]
    clock = WorldClock(wall=lambda: wall_ns[0])
    scheduler = Scheduler(clock)
    ticks: list[int] = []

    async def slow_program() -> None:
        for number in range(1, 11):
            await sleep_until(number * 16 * MS)
            ticks.append(clock.steady_ns() // MS)
            wall_ns[0] += 500 * MS  # every tick takes far longer than it may

    task = scheduler.spawn(slow_program())
    wall_ns[0] += 16 * MS
    until(lambda: scheduler.run(lambda: task.finished, 0.05), every=0.0)
    assert ticks == [number * 16 for number in range(1, 11)]
    assert wall_ns[0] - clock.target_ns() == clock.lost_ns > 10 * MAX_LAG_NS


def test_a_stepped_world_runs_every_tick_of_the_step() -> None:
    clock = WorldClock()
    clock.pause()
    scheduler = Scheduler(clock)
    start = clock.steady_ns()
    ticks: list[int] = []

    async def program() -> None:
        for number in range(1, 1000):
            await sleep_until(start + number * 16 * MS)
            ticks.append(number)

    scheduler.spawn(program())
    scheduler.advance(0.16)
    assert ticks == list(range(1, 11))


def test_another_thread_wakes_a_scheduler_that_waits_without_a_deadline() -> None:
    scheduler = Scheduler(WorldClock())
    signal = Signal()
    woke = threading.Event()

    async def program() -> None:
        await wait_for(signal)
        woke.set()

    scheduler.start()
    scheduler.spawn(program())
    signal.set()
    until(woke.is_set)
    scheduler.stop()
    assert scheduler._thread is None


def test_an_idle_scheduler_uses_no_processor_time() -> None:
    scheduler = Scheduler(WorldClock())

    async def program() -> None:
        await wait_for(Signal())

    scheduler.spawn(program())
    scheduler.run(lambda: False, timeout=0.02)
    before = time.thread_time()
    scheduler.run(lambda: False, timeout=0.3)
    assert time.thread_time() - before < 0.005


def test_a_broken_call_from_outside_does_not_end_the_scheduler(scheduler: Scheduler) -> None:
    ran: list[int] = []
    scheduler.call_soon_threadsafe(lambda: [][1])  # type: ignore[arg-type, return-value]
    scheduler.call_soon_threadsafe(lambda: ran.append(1))
    scheduler.advance()
    assert ran == [1]


class Panic(BaseException):
    """What a library written in Rust raises when something in it has failed."""


def test_a_panic_in_a_call_from_outside_does_not_end_the_thread_of_all_programs() -> None:
    scheduler = Scheduler(WorldClock())
    ran: list[int] = []

    def panic() -> None:
        raise Panic

    scheduler.start()
    scheduler.call_soon_threadsafe(panic)
    scheduler.call_soon_threadsafe(lambda: ran.append(1))
    try:
        until(lambda: ran)
    finally:
        scheduler.close()


def test_activity_is_announced_after_work_only() -> None:
    scheduler = Scheduler(WorldClock())
    calls: list[int] = []
    scheduler.on_activity = lambda: calls.append(1)

    async def program() -> None:
        await let_others_run()

    task = scheduler.spawn(program())
    until(lambda: scheduler.run(lambda: task.finished and bool(calls), 0.05), every=0.0)
    assert len(calls) == 1
    scheduler.run(lambda: False, timeout=0.05)
    assert len(calls) == 1


def test_what_a_program_does_after_it_wrote_is_announced_too() -> None:
    """A terminal announces what is written to it at once; the window that the program opens next must be seen as well."""
    scheduler = Scheduler(WorldClock())
    opened: list[str] = []
    seen: list[list[str]] = []
    scheduler.on_activity = lambda: seen.append(list(opened))

    async def editor() -> None:
        scheduler.announce_activity()  # as Terminal.write does
        opened.append("window")
        await wait_for(Signal())

    scheduler.spawn(editor())
    until(lambda: scheduler.run(lambda: bool(seen) and seen[-1] == ["window"], 0.05), every=0.0)


@pytest.mark.long
def test_what_was_started_too_late_ends_without_a_word_of_python() -> None:
    scheduler = Scheduler(WorldClock(wall=None, epoch_ns=0))

    async def never() -> None:
        raise AssertionError("it had no turn")

    gc.collect()  # what other tests left
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        scheduler.start()
        scheduler.stop()
        scheduler.spawn(never())
        scheduler.close()
        del scheduler
        gc.collect()
    assert [str(each.message) for each in told] == []


@pytest.mark.parametrize("period", [0, 1, 1000])
def test_a_program_that_runs_without_end_does_not_stop_the_world(period: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """A timer of a nanosecond: its next deadline is always the first one, and no deadline may be passed."""
    wall = 0

    def passes() -> int:
        nonlocal wall
        wall += 10_000
        return wall

    monkeypatch.setattr(time, "monotonic", lambda: passes() / NANOSECONDS)
    scheduler = Scheduler(WorldClock(wall=passes))
    runs, ticks = 0, []

    async def restless() -> None:
        nonlocal runs
        while True:
            runs += 1
            await sleep_until(scheduler.clock.steady_ns() + period)

    async def other() -> None:
        for number in range(1, 11):
            await sleep_until(number * 16 * MS)
            ticks.append(scheduler.clock.steady_ns())

    scheduler.spawn(restless())
    scheduler.spawn(other())
    assert scheduler.run(lambda: len(ticks) == 10, 1.0)
    assert ticks == [number * 16 * MS for number in range(1, 11)]
    assert runs > 100


def test_a_world_that_is_late_leaves_time_for_keys_only_while_somebody_types(monkeypatch) -> None:
    now = 1000.0
    monkeypatch.setattr("day6_core.session.scheduler.time", SimpleNamespace(monotonic=lambda: now))
    scheduler = Scheduler(WorldClock(wall=lambda: round(now * 1e9)))
    paused: list[float] = []
    monkeypatch.setattr(scheduler, "_pause", paused.append)
    ticks = 0

    async def turtle() -> None:
        nonlocal now, ticks
        while True:
            await sleep_until(scheduler.clock.steady_ns() + 16 * MS)
            ticks += 1
            now += 0.03  # as much as two ticks: this machine is too slow

    def ticked(count: int) -> bool:
        nonlocal now
        now += 0.001
        return ticks >= count

    scheduler.spawn(turtle())
    scheduler.run(lambda: ticked(20))
    assert paused == []
    scheduler.give_way()
    scheduler.run(lambda: ticked(30))
    assert paused and paused == [pytest.approx(0.03)] * len(paused)
    count = len(paused)
    now += 2.0
    scheduler.run(lambda: ticked(40))
    assert len(paused) == count, "nobody has typed for a while"


def test_a_pause_for_keys_ends_with_the_key(scheduler: Scheduler) -> None:
    typed: list[str] = []
    scheduler.call_soon_threadsafe(lambda: typed.append("x"))
    scheduler._pause(3600.0)
    assert typed == ["x"]
