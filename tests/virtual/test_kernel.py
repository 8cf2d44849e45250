"""The threads of one process: who runs, what wakes whom, and what time it is then."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable

import pytest

if sys.platform != "linux":
    pytest.skip("virtual time is there on Linux only", allow_module_level=True)

from day6_core.virtual.follow import locks
from day6_core.virtual.kernel import LONGEST_READING_NS, READ_NS, Kernel, Watch
from day6_core.virtual.watchdog import what_lasts

SECOND = 1_000_000_000


class Alone:
    """A world of one process: it goes on at the first time for which it waits. `outside` says what comes before that."""

    def __init__(self) -> None:
        self.outside: list[Callable[[Kernel], None]] = []
        self.wanted = 0

    def idle(self, kernel: Kernel) -> int:
        if self.outside:
            self.outside.pop(0)(kernel)
            return kernel.now
        deadline = kernel.deadline
        assert deadline is not None, "it would wait for ever"
        return deadline

    def want(self) -> None:
        self.wanted += 1


@pytest.fixture
def kernel(monkeypatch: pytest.MonkeyPatch) -> Kernel:
    made = Kernel()
    made.world = Alone()
    monkeypatch.setattr(locks, "_kernel", made, raising=False)
    return made


def start(kernel: Kernel, function: Callable[[], object]) -> threading.Thread:
    """Start a thread that follows the kernel."""
    turn = kernel.begin()

    def run() -> None:
        kernel.enter(turn)
        function()
        kernel.end()

    thread = threading.Thread(target=run)
    thread.start()
    return thread


def test_a_wait_takes_its_time_and_nothing_else(kernel: Kernel) -> None:
    assert kernel.wait(3 * SECOND) is False
    assert kernel.now == 3 * SECOND
    assert kernel.wait(0) is False
    assert kernel.now == 3 * SECOND


def test_reading_the_clock_takes_a_little_and_then_lets_others_go_on(kernel: Kernel) -> None:
    assert [kernel.clock(), kernel.clock()] == [READ_NS, 2 * READ_NS]
    seen: list[int] = []
    thread = start(kernel, lambda: seen.append(kernel.now))
    while not seen:
        kernel.clock()
    assert seen == [LONGEST_READING_NS]
    thread.join()


def test_threads_run_one_after_the_other_in_the_order_of_their_times(kernel: Kernel) -> None:
    said: list[tuple[str, int]] = []

    def sleeper(name: str, *seconds: int) -> Callable[[], None]:
        def run() -> None:
            for each in seconds:
                kernel.wait(each * SECOND)
                said.append((name, kernel.now // SECOND))

        return run

    threads = [start(kernel, sleeper("a", 2, 2)), start(kernel, sleeper("b", 1, 2)), start(kernel, sleeper("c", 3, 3))]
    kernel.wait(10 * SECOND)
    assert said == [("b", 1), ("a", 2), ("c", 3), ("b", 3), ("a", 4), ("c", 6)]
    for thread in threads:
        thread.join()


def test_a_lock_is_handed_on_and_a_time_limit_ends_the_waiting(kernel: Kernel) -> None:
    lock = locks.Lock()
    lock.acquire()
    said: list[str] = []

    def impatient() -> None:
        said.append(f"impatient {lock.acquire(timeout=1)} {kernel.now / SECOND}")

    def patient() -> None:
        with lock:
            said.append(f"patient {kernel.now / SECOND}")

    threads = [start(kernel, impatient), start(kernel, patient)]
    kernel.wait(2 * SECOND)
    assert said == ["impatient False 1.0"]
    lock.release()
    kernel.wait(0)
    assert said[1:] == ["patient 2.0"]
    for thread in threads:
        thread.join()


@pytest.mark.parametrize("timeout", [-2, 1e12])
def test_a_lock_refuses_what_pythons_refuses(kernel: Kernel, timeout: float) -> None:
    real = threading.Lock()
    with pytest.raises((ValueError, OverflowError)) as of_python:
        real.acquire(timeout=timeout)
    with pytest.raises(of_python.type, match=str(of_python.value)):
        locks.Lock().acquire(timeout=timeout)
    with pytest.raises(RuntimeError, match="release unlocked lock"):
        locks.Lock().release()
    with pytest.raises(RuntimeError, match="cannot release un-acquired lock"):
        locks.RLock().release()


def test_a_condition_works_with_these_locks(kernel: Kernel, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(threading, "_allocate_lock", locks.Lock)
    condition = threading.Condition(locks.RLock())  # type: ignore[arg-type]
    taken: list[int] = []

    def consumer() -> None:
        with condition, condition:
            while not condition.wait(5):
                continue
            taken.append(kernel.now // SECOND)

    thread = start(kernel, consumer)
    kernel.wait(7 * SECOND)
    with condition:
        condition.notify()
    kernel.wait(0)
    assert taken == [7]
    thread.join()


def test_what_is_watched_is_looked_at_before_time_goes_on(kernel: Kernel) -> None:
    there: list[int] = []
    thread = start(kernel, lambda: (kernel.wait(SECOND), there.append(1)))
    assert kernel.wait(9 * SECOND, Watch(lambda: there, ())) is True
    assert kernel.now == SECOND
    thread.join()


def test_what_looking_raises_is_raised_where_it_was_asked_for(kernel: Kernel) -> None:
    def look() -> bool:
        raise OSError("closed")

    said: list[str] = []

    def asks() -> None:
        try:
            kernel.wait(None, Watch(look, ()))
        except OSError as error:
            said.append(str(error))

    thread = start(kernel, asks)
    kernel.wait(SECOND)
    assert (said, kernel.now) == (["closed"], SECOND)
    thread.join()


def test_a_handler_of_a_signal_waits_for_the_main_threads_turn_and_may_end_its_wait(kernel: Kernel) -> None:
    said: list[str] = []

    def handler(number: int, frame: object) -> None:
        said.append(f"{number} at {kernel.now // SECOND}")
        if number == 2:
            raise KeyboardInterrupt

    kernel.handlers = {1: handler, 2: handler}

    def other() -> None:
        kernel.wait(SECOND)
        kernel.arrived(1, None)
        said.append("not yet")
        kernel.wait(SECOND)
        kernel.arrived(2, None)

    thread = start(kernel, other)
    with pytest.raises(KeyboardInterrupt):
        kernel.wait(9 * SECOND)
    assert said == ["not yet", "1 at 1", "2 at 2"]
    thread.join()
    kernel.arrived(1, None)
    assert said[3:] == ["1 at 2"]  # at once: the main thread runs


def test_a_signal_from_outside_ends_the_idling(kernel: Kernel) -> None:
    world = kernel.world
    assert isinstance(world, Alone)
    kernel.handlers = {1: lambda number, frame: said.append(number)}
    said: list[int] = []
    world.outside.append(lambda kernel: kernel.arrived(1, None))
    assert kernel.wait(SECOND) is False
    assert (said, world.wanted) == ([1], 1)
    assert kernel.now == SECOND


@pytest.mark.parametrize(
    ("looks", "said"),
    [
        ([(0.0, 0.0), (0.5, 0.5), (1.0, 1.0), (1.5, 1.5), (2.0, 2.0)], "busy"),
        ([(0.0, 0.0), *((each / 20, each / 2) for each in range(1, 20))], ""),  # beside many others
        ([(0.0, 0.0), *((each / 20, each / 2) for each in range(1, 37))], "busy"),
        ([(0.0, 0.0), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5)], ""),
        ([(0.0, 0.0), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5), (0.5, 0.5)], "real"),
    ],
)
def test_what_lasts_is_told_by_what_was_wanted_of_the_cores(looks: list[tuple[float, float]], said: str) -> None:
    assert what_lasts(looks) == said
