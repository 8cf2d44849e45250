"""The clock of an AsyncNode, and its timers: both wait on the event loop, by ROS time."""

from __future__ import annotations

import asyncio
import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.clock import ClockChange, JumpThreshold
from rclpy.duration import Duration
from rclpy.exceptions import TimeSourceChangedError
from rclpy.timer import TimerInfo

if TYPE_CHECKING:
    from rclpy.clock import Clock, TimeJump

_ACTIVATION = (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED)


class AsyncClock:
    """A clock with `sleep`; everything else is that of the clock it is made of."""

    def __init__(self, clock: Clock) -> None:
        self._clock: Any = clock
        self._destroyed = False
        self._sleeps: set[asyncio.Future[None]] = set()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._clock, name)

    async def sleep(self, duration_sec: float) -> None:
        """Sleep for seconds of ROS time.

        Raises:
            TimeSourceChangedError: simulated time was switched on or off meanwhile.
            RuntimeError: after the node was destroyed. A sleep that this meets is cancelled.
        """
        if self._destroyed:
            raise RuntimeError("Cannot sleep on a destroyed clock")
        if duration_sec <= 0:
            await asyncio.sleep(0)
            return
        await self._until(self._clock.now().nanoseconds + int(duration_sec * 1e9), duration_sec, None)

    async def _until(self, target_ns: int, seconds: float, woken: asyncio.Event | None) -> None:
        """Wait until a ROS time, `seconds` away; `woken` ends it early."""
        loop = asyncio.get_running_loop()
        done: asyncio.Future[None] = loop.create_future()

        def finish(error: Exception | None = None) -> None:
            if not done.done():
                done.set_exception(error) if error is not None else done.set_result(None)

        def jumped(jump: TimeJump) -> None:  # on the thread that takes messages
            if jump.clock_change in _ACTIVATION:
                loop.call_soon_threadsafe(finish, TimeSourceChangedError())
            elif self._clock.now().nanoseconds >= target_ns:
                loop.call_soon_threadsafe(finish)

        threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None, on_clock_change=True)
        handle = self._clock.create_jump_callback(threshold, post_callback=jumped)
        timer = None if self._clock.ros_time_is_active else loop.call_later(seconds, finish)
        waker = None if woken is None else loop.create_task(woken.wait())
        if waker is not None:
            waker.add_done_callback(lambda _task: finish())
        self._sleeps.add(done)
        try:
            await done
        finally:
            self._sleeps.discard(done)
            handle.unregister()
            if timer is not None:
                timer.cancel()
            if waker is not None:
                waker.cancel()

    def _destroy(self) -> None:
        self._destroyed = True
        for sleep in list(self._sleeps):
            sleep.cancel()


class AsyncTimer:
    """Calls a function, or awaits a coroutine function, once a period; the next call waits for the end of the last."""

    def __init__(self, period_ns: int, clock: AsyncClock, callback: Callable[..., object], autostart: bool) -> None:
        self._period_ns = period_ns
        self._clock = clock
        self.callback = callback
        self._canceled = not autostart
        self._changed = asyncio.Event()
        self._next_ns = clock.now().nanoseconds + period_ns

    @property
    def timer_period_ns(self) -> int:
        """The period in nanoseconds; setting it starts a new one."""
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._period_ns = int(value)
        self.reset()

    @property
    def clock(self) -> AsyncClock:
        """The clock it runs by."""
        return self._clock

    def cancel(self) -> None:
        """Stop calling."""
        self._canceled = True
        self._changed.set()

    def is_canceled(self) -> bool:
        """Return whether it was cancelled, or never started."""
        return self._canceled

    def reset(self) -> None:
        """Start anew: the next call is a period from now."""
        self._canceled = False
        self._next_ns = self._clock.now().nanoseconds + self._period_ns
        self._changed.set()

    def time_until_next_call(self) -> int | None:
        """Return nanoseconds, None for a cancelled one."""
        return None if self._canceled else int(self._next_ns - self._clock.now().nanoseconds)

    def is_ready(self) -> bool:
        """Return whether a call is due."""
        return not self._canceled and self._clock.now().nanoseconds >= self._next_ns

    async def _run(self) -> None:
        while True:
            self._changed.clear()
            if self._canceled:
                await self._changed.wait()
                continue
            left = self._next_ns - self._clock.now().nanoseconds
            if left > 0:
                try:
                    await self._clock._until(self._next_ns, left / 1e9, self._changed)
                except TimeSourceChangedError:
                    self._next_ns = self._clock.now().nanoseconds + self._period_ns
                    continue
            else:
                await asyncio.sleep(0)
            if self._changed.is_set() or not self.is_ready():
                continue
            expected, now = self._next_ns, self._clock.now()
            behind = max(0, now.nanoseconds - expected) // self._period_ns if self._period_ns else 0
            self._next_ns = expected + (behind + 1) * self._period_ns
            await _called(self.callback, *([self._info(expected, now)] if _takes_info(self.callback) else []))

    def _info(self, expected_ns: int, now: Any) -> TimerInfo:
        return TimerInfo(
            expected_call_time=expected_ns, actual_call_time=now.nanoseconds, clock_type=self._clock.clock_type
        )


async def _called(callback: Callable[..., Any], *arguments: Any) -> Any:
    """Call a function, or await a coroutine function."""
    result = callback(*arguments)
    return await result if inspect.isawaitable(result) else result


def _takes_info(callback: Callable[..., Any]) -> bool:
    try:
        inspect.signature(callback).bind()
    except TypeError:
        return True
    return False
