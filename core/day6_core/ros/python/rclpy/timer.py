"""Timers and rates."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Coroutine
from types import FunctionType, MethodType, TracebackType
from typing import TYPE_CHECKING, Any

from rclpy._day6.callables import is_coroutine_function, lacks_self
from rclpy._day6.entity import NOTHING, TIMER, Entity
from rclpy._day6.incidental import also
from rclpy._day6.time_base import wait_interruptibly
from rclpy._day6.withdrawn import withdraw
from rclpy._rclpy_pybind11 import DESTROYED, Destroyable, InvalidHandle, RCLError, TimerCancelledError
from rclpy.clock import Clock, ROSClock
from rclpy.clock_type import ClockType
from rclpy.exceptions import ROSInterruptException
from rclpy.time import Time
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy._day6.timer_heap import TimerHeap
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context

__getattr__ = also(__name__, "CallbackGroup Context")


_INVALID_CONTEXT = (
    "failed to create timer: the given context is not valid, either rcl_init() was not called or "
    "rcl_shutdown() was called., at /project/src/rcl/guard_condition.c:65"
)
_NO_CALLBACK = "cannot access local variable 'arg_name' where it is not associated with a value"


class TimerInfo:
    """When a timer's call was due and when it was made; passed to callbacks with an argument annotated `TimerInfo`."""

    def __init__(
        self,
        *,
        expected_call_time: int = 0,
        actual_call_time: int = 0,
        clock_type: ClockType = ClockType.SYSTEM_TIME,
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if expected_call_time < 0 or actual_call_time < 0:
            raise ValueError("call time values must not be negative")
        self._expected_call_time = Time(nanoseconds=expected_call_time, clock_type=clock_type)
        self._actual_call_time = Time(nanoseconds=actual_call_time, clock_type=clock_type)

    @property
    def expected_call_time(self) -> Time:
        """When the call was due."""
        return self._expected_call_time

    @property
    def actual_call_time(self) -> Time:
        """When the call was made."""
        return self._actual_call_time


TimerCallbackType = Callable[[], None] | Callable[[TimerInfo], None] | Callable[[], Coroutine[object, None, None]]


class Timer(Entity):
    """Calls a function every `timer_period_ns` nanoseconds; made by `Node.create_timer`.

    It uses the steady clock, except that a ROS clock on simulated time drives its timers itself. The first call comes after
    one period; calls missed because the executor was busy are skipped (rcl/timer.c).
    """

    _kind = TIMER
    _missed = 0
    """Calls that were skipped; of a timer without a period, those that came late."""

    def __init__(
        self,
        callback: TimerCallbackType | None,
        callback_group: CallbackGroup | None,
        timer_period_ns: int,
        clock: Clock,
        *,
        context: Context | None = None,
        autostart: bool = True,
    ) -> None:
        self._context = get_default_context() if context is None else context
        self._clock = clock
        if self._context.handle is None:
            raise RuntimeError("Context must be initialized before create a _rclpy.Timer.")
        if not self._context._valid:
            raise RCLError(_INVALID_CONTEXT)
        if timer_period_ns < 0:
            raise RCLError("failed to create timer: timer period must be non-negative, at /project/src/rcl/timer.c:144")
        self._handle = _TimerHandle._of(self)
        self._steady_ns = self._context._time.steady_ns
        self._period = int(timer_period_ns)
        self._heap: TimerHeap | None = None
        self._heap_deadline = 0
        self._canceled = not autostart
        self._last = self._base_now()
        self._next = self._last + self._period
        self._credit = 0
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False
        if isinstance(clock, ROSClock):
            clock._timers.add(self)

    # -- time ----------------------------------------------------------------------------------------------------------

    def _is_simulated(self) -> bool:
        return isinstance(self._clock, ROSClock) and self._clock._active

    def _base_now(self) -> int:
        """Nanoseconds by the timer's clock."""
        return self._clock._now_ns() if self._clock._is_simulated() else self._steady_ns()

    def _due(self) -> bool:
        return not self._canceled and not self._handle._destroyed and self._next <= self._base_now()

    _pending = _due

    def _schedule(self) -> None:
        """Let the executor process the timer when it is due."""
        scope = self._scope
        if scope is None or self._canceled or self._handle._destroyed:
            return
        if self._clock._is_simulated():
            if self._next <= self._clock._now_ns():
                self._notify()
        elif scope.executor is not None:
            scope.executor._add_timer(self)

    def _before_switch(self) -> None:
        self._credit = self._next - self._base_now()

    def _after_jump(self, switched: bool) -> None:
        now = self._base_now()
        if switched:
            if now == 0:
                return
            # The rest of the period stays the same by the other clock.
            self._next = now + self._credit
            self._last = self._next - self._period
        elif now < self._last:
            self._last, self._next = now, now + self._period
        self._schedule()

    # -- running -------------------------------------------------------------------------------------------------------

    def _process(self) -> Any:
        self._queued = False
        now = self._base_now()
        due = self._next
        if self._canceled or due > now or self._handle._destroyed:
            self._schedule()
            return NOTHING
        self._advance(now)
        self._schedule()
        callback = self._callback
        if callback is None:
            # The error of real rclpy for a program with `create_timer(1.0, self.tick())`.
            raise UnboundLocalError(_NO_CALLBACK)
        if self._plain:
            callback()
            return None
        result = self._call_slowly(callback, due, now)
        return result if is_coroutine_function(callback) else None

    def _advance(self, now: int) -> None:
        """Record a call; the next one is due at the first whole period after now."""
        due = self._next
        self._last = now
        self._next = due + self._period
        if self._next <= now:
            missed = 1 if self._period == 0 else 1 + (now - self._next) // self._period
            self._next = now if self._period == 0 else self._next + missed * self._period
            self._missed += missed

    def _info(self, due: int, now: int) -> TimerInfo:
        """Return the TimerInfo of a call that was due at `due` and is made at `now` (ns by the timer's clock)."""
        clock_now = self._clock._now_ns()
        return TimerInfo(
            expected_call_time=max(0, clock_now - (now - due)),
            actual_call_time=clock_now,
            clock_type=self._clock.clock_type,
        )

    def _call_slowly(self, callback: Callable[..., Any], due: int, now: int) -> Any:
        """Call a callback that takes a TimerInfo, or is anything other than a function or method without arguments."""
        import inspect

        for parameter in inspect.signature(callback).parameters.values():
            if parameter.annotation == TimerInfo:
                return callback(**{parameter.name: self._info(due, now)})
        return callback()

    @property
    def callback(self) -> TimerCallbackType | None:
        """The function that is called. With None spinning raises UnboundLocalError, as in rclpy 9."""
        return self._callback

    @callback.setter
    def callback(self, value: TimerCallbackType | None) -> None:
        self._callback: Callable[..., Any] | None = value
        plain = value.__func__ if isinstance(value, MethodType) else value
        self._plain = (
            isinstance(plain, FunctionType)
            and not is_coroutine_function(plain)
            and TimerInfo not in plain.__annotations__.values()
            and not lacks_self(value)
        )

    # -- for programs --------------------------------------------------------------------------------------------------

    def _check(self) -> None:
        if self._handle._destroyed:
            raise InvalidHandle(DESTROYED)

    @property
    def handle(self) -> _TimerHandle:
        """The handle."""
        return self._handle

    def destroy(self) -> None:
        """Make the timer unusable; prefer `Node.destroy_timer`."""
        self._handle.destroy_when_not_in_use()

    @property
    def clock(self) -> Clock:
        """The clock the timer runs by."""
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        """The period in nanoseconds; a new one applies from the next call on."""
        self._check()
        return self._period

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._check()
        self._period = int(value)

    def is_ready(self) -> bool:
        """Return whether a call is due."""
        self._check()
        return self._due()

    def is_canceled(self) -> bool:
        """Return whether the timer was cancelled."""
        self._check()
        return self._canceled

    def cancel(self) -> None:
        """Stop calling until `reset`."""
        self._check()
        self._canceled = True

    def reset(self) -> None:
        """Restart: the next call comes one period from now."""
        self._check()
        self._canceled = False
        self._last = self._base_now()
        self._next = self._last + self._period
        self._schedule()
        if self._handle._on_reset is not None:
            self._handle._on_reset(1)

    def time_since_last_call(self) -> int:
        """Return nanoseconds since the last call (since creation before the first one)."""
        self._check()
        return self._base_now() - self._last

    def time_until_next_call(self) -> int | None:
        """Return nanoseconds until the next call, negative if it is overdue; None for a cancelled timer."""
        self._check()
        return None if self._canceled else self._next - self._base_now()

    def __enter__(self) -> Timer:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy()


class _TimerHandle(Destroyable):
    """The handle of a timer. A program can make one with the handles of a clock and a context, and call it itself."""

    _timer: weakref.ReferenceType[Timer]
    _on_reset: Callable[[int], object] | None = None

    def __init__(self, clock: Any, context: Any, period_nsec: int, autostart: bool) -> None:
        timer = Timer(None, None, period_nsec, clock._clock(), context=context._context(), autostart=autostart)
        self.__dict__.update(timer._handle.__dict__)
        timer._handle = self
        self._keep = timer

    @classmethod
    def _of(cls, timer: Timer) -> _TimerHandle:
        handle = cls.__new__(cls)
        Destroyable.__init__(handle)
        handle._timer = weakref.ref(timer)
        return handle

    def _entity(self) -> Timer:
        timer: Timer | None = self._timer()
        if self._destroyed or timer is None:
            raise InvalidHandle(DESTROYED)
        return timer

    def call_timer(self) -> None:
        """Record a call of the timer.

        Raises:
            RCLError: for a cancelled one.
        """
        self.call_timer_with_info()

    def call_timer_with_info(self) -> TimerInfo:
        """Record a call of the timer; returns when it was due and when it was made.

        Raises:
            RCLError: for a cancelled one.
        """
        timer = self._entity()
        if timer._canceled:
            raise TimerCancelledError("Timer has been canceled: timer is canceled, at /project/src/rcl/timer.c:277")
        now, due = timer._base_now(), timer._next
        timer._advance(now)
        return timer._info(due, now)

    def is_timer_ready(self) -> bool:
        """Return whether a call is due."""
        return self._entity()._due()

    def is_timer_canceled(self) -> bool:
        """Return whether the timer was cancelled."""
        return self._entity()._canceled

    def cancel_timer(self) -> None:
        """Stop calling until `reset_timer`."""
        self._entity().cancel()

    def reset_timer(self) -> None:
        """Restart the period."""
        self._entity().reset()

    def set_on_reset_callback(self, callback: Callable[[int], object]) -> None:
        """Call `callback(1)` at each reset."""
        self._entity()
        self._on_reset = callback

    def clear_on_reset_callback(self) -> None:
        """Stop calling it."""
        self._on_reset = None

    def get_timer_period(self) -> int:
        """Return the period in nanoseconds."""
        return self._entity()._period

    def change_timer_period(self, period_nsec: int) -> None:
        """Set the period in nanoseconds."""
        self._entity()._period = period_nsec

    def time_since_last_call(self) -> int:
        """Return nanoseconds since the last call."""
        return self._entity().time_since_last_call()

    def time_until_next_call(self) -> int | None:
        """Return nanoseconds until the next call, None for a cancelled timer."""
        return self._entity().time_until_next_call()


class Rate:
    """Sleeps until the next tick of a timer; made by `Node.create_rate`. The node must be spun in another thread."""

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._timer = timer
        self._is_shutdown = False
        self._is_destroyed = False
        self._event = threading.Event()
        self._lock = threading.Lock()
        self._num_sleepers = 0
        timer.callback = self._event.set
        context.on_shutdown(self._on_shutdown)

    def _on_shutdown(self) -> None:
        self._is_shutdown = True
        self.destroy()

    def destroy(self) -> None:
        """Make the rate unusable and end its sleeps; prefer `Node.destroy_rate`."""
        self._is_destroyed = True
        self._event.set()

    def sleep(self) -> None:
        """Block until the timer's next tick.

        Raises:
            ROSInterruptException: at shutdown.
            RuntimeError: for a destroyed rate.
            InvalidHandle: for a destroyed timer.
        """
        if self._is_shutdown:
            raise ROSInterruptException
        if self._is_destroyed:
            raise RuntimeError("Rate cannot sleep because it has been destroyed")
        if not self._timer.handle:
            self.destroy()
            raise InvalidHandle("Rate cannot sleep because the timer has been destroyed")
        with self._lock:
            self._num_sleepers += 1
        try:
            wait_interruptibly(self._event, None)
        finally:
            with self._lock:
                self._num_sleepers -= 1
                if self._num_sleepers == 0:
                    self._event.clear()
            if self._is_shutdown:
                self.destroy()
                raise ROSInterruptException


withdraw(__name__)
