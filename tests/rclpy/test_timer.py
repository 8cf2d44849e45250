"""Timers, rates and guard conditions: when they are due, what cancelling and resetting does, by which clock they run."""

from __future__ import annotations

from threading import Thread
from typing import Any

import pytest

from rclpy.clock import Clock, ROSClock
from rclpy.clock_type import ClockType
from rclpy.exceptions import InvalidHandle, ROSInterruptException
from rclpy.parameter import Parameter
from rclpy.time import Time
from rclpy.timer import TimerInfo

SECOND = 1_000_000_000


def test_a_timer_counts_from_its_last_call_to_its_next(world: Any) -> None:
    node = world.node("n")
    timer = node.create_timer(2.0, lambda: None)
    assert timer.timer_period_ns == 2 * SECOND
    assert (timer.time_since_last_call(), timer.time_until_next_call()) == (0, 2 * SECOND)
    world.time.elapsed += SECOND // 2
    assert (timer.time_since_last_call(), timer.time_until_next_call()) == (SECOND // 2, 3 * SECOND // 2)
    assert not timer.is_ready()
    world.time.elapsed += 3 * SECOND // 2
    assert timer.is_ready()
    world.time.elapsed += 5
    assert timer.time_until_next_call() == -5
    world.settle()
    assert not timer.is_ready()
    assert (timer.time_since_last_call(), timer.time_until_next_call()) == (0, 2 * SECOND - 5)


def test_a_cancelled_timer_waits_for_its_reset(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(world.time.elapsed))
    world.run(1.5)
    timer.cancel()
    assert timer.is_canceled()
    assert timer.time_until_next_call() is None
    world.run(2.0)
    assert not timer.is_ready()
    assert ticks == [SECOND]
    timer.reset()
    assert not timer.is_canceled()
    assert timer.time_until_next_call() == SECOND
    world.run(1.0)
    assert ticks == [SECOND, 4_500_000_000]


def test_a_reset_puts_the_next_call_off(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(world.time.elapsed))
    for _ in range(3):
        world.run(0.9)
        timer.reset()
    assert ticks == []
    world.run(1.0)
    assert ticks == [3_700_000_000]


def test_a_timer_that_does_not_start_by_itself_is_cancelled_at_first(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(1), autostart=False)
    assert timer.is_canceled()
    world.run(3.0)
    assert ticks == []
    timer.reset()
    world.run(1.0)
    assert ticks == [1]


def test_a_new_period_counts_from_the_next_call_on(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(world.time.elapsed))
    timer.timer_period_ns = 3 * SECOND
    assert timer.timer_period_ns == 3 * SECOND
    world.run(8.0)
    assert ticks == [SECOND, 4 * SECOND, 7 * SECOND]


@pytest.mark.parametrize(
    ("late", "next_call"), [(0, 1000), (1, 999), (999, 1), (1000, 1000), (1001, 999), (2500, 500), (3000, 1000)]
)
def test_the_next_call_is_at_a_whole_period_however_late_this_one_was(world: Any, late: int, next_call: int) -> None:
    node = world.node("n")
    timer = node.create_timer(1e-6, lambda: None)
    world.time.elapsed += 1000 + late
    world.executor.spin_once(timeout_sec=0)
    assert timer.time_until_next_call() == next_call
    assert timer.time_since_last_call() == 0


def test_a_timer_without_a_period_is_always_due(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(0.0, lambda: ticks.append(1))
    for _ in range(3):
        assert timer.is_ready()
        world.executor.spin_once(timeout_sec=0)
        world.time.elapsed += 7
    assert ticks == [1, 1, 1]


@pytest.mark.parametrize(
    ("period", "error", "message"),
    [
        (-1.0, RuntimeError, "timer period must be non-negative"),
        ("x", ValueError, "could not convert"),
        (None, TypeError, ""),
    ],
)
def test_a_period_is_a_number_of_seconds(world: Any, period: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message or None):
        world.node("n").create_timer(period, lambda: None)


def test_a_period_is_cut_off_to_nanoseconds(world: Any) -> None:
    assert world.node("n").create_timer(1.0000000019, lambda: None).timer_period_ns == 1_000_000_001


def test_a_callback_may_ask_when_it_was_due(world: Any) -> None:
    node = world.node("n")
    told: list[TimerInfo] = []

    def tick(info: Any) -> None:
        told.append(info)

    # The class itself, not its name: only that is looked for.
    tick.__annotations__["info"] = TimerInfo
    node.create_timer(1.0, tick)
    world.time.elapsed += 1_250_000_000
    world.settle()
    (info,) = told
    assert (info.actual_call_time - info.expected_call_time).nanoseconds == 250_000_000
    assert info.actual_call_time == node.get_clock().now()


def test_the_times_of_a_timer_are_checked() -> None:
    info = TimerInfo(expected_call_time=1, actual_call_time=2, clock_type=ClockType.STEADY_TIME)
    assert info.expected_call_time == Time(nanoseconds=1, clock_type=ClockType.STEADY_TIME)
    assert info.actual_call_time == Time(nanoseconds=2, clock_type=ClockType.STEADY_TIME)
    assert TimerInfo().actual_call_time == Time()
    with pytest.raises(TypeError, match="Clock type must be a ClockType enum"):
        TimerInfo(clock_type="STEADY")  # type: ignore[arg-type]
    for wrong in ({"expected_call_time": -1}, {"actual_call_time": -1}):
        with pytest.raises(ValueError, match="call time values must not be negative"):
            TimerInfo(**wrong)


def test_a_coroutine_may_be_a_timers_callback(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []

    async def tick() -> None:
        ticks.append(1)

    node.create_timer(1.0, tick)
    world.run(2.0)
    assert ticks == [1, 1]


def test_another_callback_takes_over(world: Any) -> None:
    node = world.node("n")
    ticks: list[str] = []
    timer = node.create_timer(1.0, lambda: ticks.append("first"))
    world.run(1.0)
    timer.callback = lambda: ticks.append("second")
    world.run(1.0)
    assert ticks == ["first", "second"]


def test_a_destroyed_timer_ticks_no_more_and_is_gone(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(1))
    assert list(node.timers) == [timer]
    assert node.destroy_timer(timer)
    assert list(node.timers) == []
    world.run(2.0)
    assert ticks == []
    for use in (
        timer.cancel,
        timer.reset,
        timer.is_ready,
        timer.is_canceled,
        timer.time_since_last_call,
        timer.time_until_next_call,
    ):
        with pytest.raises(InvalidHandle):
            use()
    assert not node.destroy_timer(timer)


def test_a_timer_is_destroyed_at_the_end_of_with(world: Any) -> None:
    node = world.node("n")
    with node.create_timer(1.0, lambda: None) as timer:
        assert not timer.is_canceled()
    with pytest.raises(InvalidHandle):
        timer.is_canceled()


def test_a_timer_runs_by_the_clock_it_was_given(world: Any) -> None:
    node = world.node("n")
    clock = Clock(clock_type=ClockType.STEADY_TIME)
    assert node.create_timer(1.0, lambda: None, clock=clock).clock is clock
    assert node.create_timer(1.0, lambda: None).clock is node.get_clock()


# simulated time


def simulated_node(world: Any, seconds: float) -> tuple[Any, Any]:
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
    clock = node.get_clock()
    clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
    return node, clock


def at(seconds: float) -> Time:
    return Time(seconds=seconds, clock_type=ClockType.ROS_TIME)


def test_simulated_time_drives_the_timers_of_its_clock(world: Any) -> None:
    node, clock = simulated_node(world, 10)
    ticks: list[float] = []
    timer = node.create_timer(1.0, lambda: ticks.append(clock.now().nanoseconds / SECOND))
    world.time.elapsed += 5 * SECOND
    world.settle()
    assert ticks == []
    for seconds in (10.5, 11.0, 11.5, 13.2):
        clock.set_ros_time_override(at(seconds))
        world.settle()
    assert ticks == [11.0, 13.2]
    assert timer.time_until_next_call() == 800_000_000


def test_time_that_goes_back_starts_the_period_anew(world: Any) -> None:
    node, clock = simulated_node(world, 10)
    ticks: list[int] = []
    timer = node.create_timer(1.0, lambda: ticks.append(1))
    clock.set_ros_time_override(at(9.8))
    assert timer.time_until_next_call() == SECOND
    clock.set_ros_time_override(at(10.7))
    world.settle()
    assert ticks == []
    clock.set_ros_time_override(at(10.8))
    world.settle()
    assert ticks == [1]


def test_what_was_left_of_a_period_is_left_by_the_other_clock(world: Any) -> None:
    node = world.node("n")
    clock = node.get_clock()
    clock.set_ros_time_override(at(100))
    timer = node.create_timer(1.0, lambda: None)
    world.time.elapsed += 300_000_000
    node.set_parameters([Parameter("use_sim_time", value=True)])
    assert timer.time_until_next_call() == 700_000_000
    clock.set_ros_time_override(at(100.2))
    assert timer.time_until_next_call() == 500_000_000
    world.time.elapsed += 5 * SECOND
    node.set_parameters([Parameter("use_sim_time", value=False)])
    assert timer.time_until_next_call() == 500_000_000


# rates


def test_a_rate_sleeps_until_its_timer_ticks(world: Any) -> None:
    node = world.node("n")
    rate = node.create_rate(4.0)
    (timer,) = node.timers
    assert timer.timer_period_ns == SECOND // 4
    slept: list[int] = []

    def sleep() -> None:
        for _ in range(3):
            rate.sleep()
            slept.append(world.time.elapsed)

    thread = Thread(target=sleep, daemon=True)
    thread.start()
    for _ in range(10_000):
        world.run(0.25)
        thread.join(0.001)
        if not thread.is_alive():
            break
    assert len(set(slept)) == 3, "each sleep waits for a tick of its own"
    assert node.destroy_rate(rate)
    assert list(node.timers) == []
    with pytest.raises(RuntimeError, match="Rate cannot sleep because it has been destroyed"):
        rate.sleep()


@pytest.mark.parametrize("frequency", [0, -1.0])
def test_a_rate_needs_a_frequency(world: Any, frequency: float) -> None:
    with pytest.raises(ValueError, match="frequency must be > 0"):
        world.node("n").create_rate(frequency)


def test_a_shutdown_wakes_who_sleeps(world: Any) -> None:
    rate = world.node("n").create_rate(1.0)
    outcome: list[BaseException] = []

    def sleep() -> None:
        try:
            rate.sleep()
        except ROSInterruptException as error:
            outcome.append(error)

    thread = Thread(target=sleep, daemon=True)
    thread.start()
    thread.join(0.02)
    world.context.shutdown()
    thread.join(5)
    assert [str(error) for error in outcome] == ["rclpy.shutdown() has been called"]
    with pytest.raises(ROSInterruptException):
        rate.sleep()


# guard conditions


def test_a_guard_condition_calls_back_once_for_what_was_triggered_before(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []
    guard = node.create_guard_condition(lambda: ran.append(1))
    world.settle()
    assert ran == []
    guard.trigger()
    guard.trigger()
    world.settle()
    assert ran == [1]
    guard.trigger()
    world.settle()
    assert ran == [1, 1]


def test_a_guard_condition_may_call_a_coroutine(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []

    async def callback() -> None:
        ran.append(1)

    node.create_guard_condition(callback).trigger()
    world.settle()
    assert ran == [1]


def test_a_destroyed_guard_condition_is_gone(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []
    guard = node.create_guard_condition(lambda: ran.append(1))
    assert list(node.guards) == [guard]
    assert node.destroy_guard_condition(guard)
    assert list(node.guards) == []
    with pytest.raises(InvalidHandle):
        guard.trigger()
    world.settle()
    assert ran == []
    assert not node.destroy_guard_condition(guard)


def test_nothing_can_be_made_in_a_context_that_is_not_there() -> None:
    from rclpy.context import Context
    from rclpy.guard_condition import GuardCondition
    from rclpy.timer import Timer

    context = Context()
    with pytest.raises(RuntimeError, match="Context must be initialized"):
        GuardCondition(None, None, context=context)
    with pytest.raises(RuntimeError, match="Context must be initialized"):
        Timer(lambda: None, None, 1, ROSClock(), context=context)  # type: ignore[arg-type]
    context.init([])
    context.shutdown()
    with pytest.raises(RuntimeError, match=r"the given context is not valid, either rcl_init\(\) was not called"):
        GuardCondition(None, None, context=context)
    with pytest.raises(RuntimeError, match=r"the given context is not valid, either rcl_init\(\) was not called"):
        Timer(lambda: None, None, 1, ROSClock(), context=context)  # type: ignore[arg-type]
