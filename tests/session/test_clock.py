"""The world clock."""

from __future__ import annotations

import pytest

from day6_tui.core.session.clock import NANOSECONDS, WorldClock


class Wall:
    """A pacing clock that the test moves."""

    def __init__(self) -> None:
        self.ns = 1_000

    def __call__(self) -> int:
        return self.ns

    def go(self, seconds: float) -> None:
        self.ns += round(seconds * NANOSECONDS)


def test_the_world_begins_at_zero_and_at_the_given_date() -> None:
    clock = WorldClock(wall=None, epoch_ns=1_700_000_000 * NANOSECONDS)
    assert clock.steady_ns() == 0
    assert clock.now_ns() == 1_700_000_000 * NANOSECONDS


def test_a_free_clock_follows_the_wall() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall, epoch_ns=0)
    clock.release(None)
    wall.go(1.5)
    assert clock.steady_ns() == clock.now_ns() == 1.5 * NANOSECONDS


def test_a_held_clock_reads_exactly_the_deadline_whatever_the_wall_says() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall, epoch_ns=0)
    clock.hold(16_000_000)
    wall.go(3)
    assert clock.steady_ns() == 16_000_000


def test_a_free_clock_never_passes_a_timer_that_has_not_run() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall, epoch_ns=0)
    clock.release(16_000_000)
    wall.go(3)
    assert clock.steady_ns() == 16_000_000


def test_the_clock_never_goes_back() -> None:
    clock = WorldClock(wall=None)
    clock.hold(50)
    clock.hold(20)
    assert clock.steady_ns() == 50


def test_a_paused_world_stands_still_and_goes_on_where_it_stood() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall, epoch_ns=0)
    clock.release(None)
    wall.go(1)
    clock.pause()
    wall.go(10)
    assert clock.steady_ns() == NANOSECONDS
    assert clock.wall_seconds_until(2 * NANOSECONDS) is None
    clock.resume()
    wall.go(0.5)
    assert clock.steady_ns() == 1.5 * NANOSECONDS


def test_at_half_speed_a_second_of_the_wall_is_half_a_second_of_the_world() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall, epoch_ns=0)
    clock.release(None)
    clock.set_speed(0.5)
    wall.go(2)
    assert clock.steady_ns() == NANOSECONDS
    assert clock.wall_seconds_until(2 * NANOSECONDS) == pytest.approx(2.0)


@pytest.mark.parametrize("factor", [0, 0.05, 11, -1])
def test_speeds_outside_a_tenth_to_ten_are_refused(factor: float) -> None:
    with pytest.raises(ValueError, match=r"between 0\.1 and 10\.0"):
        WorldClock(wall=None).set_speed(factor)


def test_a_change_of_pace_is_announced() -> None:
    clock = WorldClock()
    calls: list[str] = []
    clock.on_change = lambda: calls.append("changed")
    clock.pause()
    clock.step(0.1)
    clock.resume()
    clock.set_speed(2)
    assert calls == ["changed"] * 4
