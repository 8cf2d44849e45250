"""The world clock."""

from __future__ import annotations

import pytest

from day6_core.session.clock import NANOSECONDS, WorldClock


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
    clock = WorldClock(wall=wall)
    clock.release(None)
    wall.go(1.5)
    assert clock.steady_ns() == 1.5 * NANOSECONDS


def test_what_measures_reads_the_real_clocks_whatever_the_world_does() -> None:
    wall, system = Wall(), Wall()
    clock = WorldClock(wall=wall, system=system)
    clock.hold(16_000_000)
    clock.pause()
    clock.set_speed(0.1)
    wall.go(3)
    system.go(7)
    assert (clock.wall_ns(), clock.now_ns()) == (3 * NANOSECONDS + 1_000, 7 * NANOSECONDS + 1_000)


def test_beside_a_stepped_clock_nothing_is_real() -> None:
    clock = WorldClock(wall=None, epoch_ns=1_700_000_000 * NANOSECONDS)
    clock.release(None)
    clock.step(2.5)
    assert clock.steady_ns() == clock.wall_ns() == 2.5 * NANOSECONDS
    assert clock.now_ns() == 1_700_000_002.5 * NANOSECONDS


def test_a_held_clock_reads_exactly_the_deadline_whatever_the_wall_says() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall)
    clock.hold(16_000_000)
    wall.go(3)
    assert clock.steady_ns() == 16_000_000


def test_a_free_clock_never_passes_a_timer_that_has_not_run() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall)
    clock.release(16_000_000)
    wall.go(3)
    assert clock.steady_ns() == 16_000_000


def test_what_a_slow_computer_cannot_make_up_for_is_counted() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall)
    wall.go(1)
    clock.fall_behind(round(0.4 * NANOSECONDS))
    wall.go(1)
    clock.fall_behind(round(1.3 * NANOSECONDS))
    assert clock.target_ns() == 1.3 * NANOSECONDS
    assert clock.lost_ns == 0.7 * NANOSECONDS


def test_a_pause_loses_nothing() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall)
    clock.pause()
    wall.go(5)
    clock.set_speed(0.1)
    clock.resume()
    assert clock.lost_ns == 0


def test_the_clock_never_goes_back() -> None:
    clock = WorldClock(wall=None)
    clock.hold(50)
    clock.hold(20)
    assert clock.steady_ns() == 50


def test_a_paused_world_stands_still_and_goes_on_where_it_stood() -> None:
    wall = Wall()
    clock = WorldClock(wall=wall)
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
    clock = WorldClock(wall=wall)
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
