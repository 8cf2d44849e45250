"""Clocks: reading the time, sleeping, and callbacks for time jumps."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from types import TracebackType
from typing import TYPE_CHECKING

from rclpy._day6.incidental import also
from rclpy._day6.time_base import MACHINE_TIME, AutoResetEvent, TimeBase
from rclpy._rclpy_pybind11 import ClockChange as ClockChange
from rclpy._rclpy_pybind11 import Destroyable
from rclpy.clock_type import ClockType as ClockType
from rclpy.constants import S_TO_NS
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.time import Time

if TYPE_CHECKING:
    from rclpy._day6.typing_names import TimeJumpDictionary
    from rclpy.context import Context
    from rclpy.timer import Timer

__getattr__ = also(__name__, "TimeJumpDictionary Context get_default_context")


class JumpThreshold:
    """The jumps that trigger a callback: forward by at least `min_forward`, backward by `min_backward` (negative).

    Raises:
        ValueError: if a duration has the wrong sign, or if none is given and clock changes do not trigger either.
    """

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError("min_forward must be a positive non-zero duration")
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError("min_backward must be a negative non-zero duration")
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError("At least one jump threshold must be enabled")
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change

    def _exceeded_by(self, change: ClockChange, delta: int) -> bool:
        if change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self.on_clock_change
        if self.min_forward is not None and delta > 0 and delta >= self.min_forward.nanoseconds:
            return True
        return self.min_backward is not None and delta < 0 and delta <= self.min_backward.nanoseconds


class TimeJump:
    """A jump of time: how the source changed and by how much."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError("clock_change must be an instance of rclpy.clock.ClockChange")
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        """How the source of the time changed."""
        return self._clock_change

    @property
    def delta(self) -> Duration:
        """How far the time jumped."""
        return self._delta


class JumpHandle:
    """Registration of callbacks for jumps of a clock; `unregister` (or the end of `with`) removes it."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], None] | None,
        post_callback: Callable[[TimeJumpDictionary], None] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError("One of pre_callback or post_callback must be callable")
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError("pre_callback must be callable if given")
        if post_callback is not None and not callable(post_callback):
            raise ValueError("post_callback must be callable if given")
        self._clock: Clock | None = clock
        self._threshold = threshold
        self._pre_callback = pre_callback
        self._post_callback = post_callback
        clock._jump_handles.append(self)

    def unregister(self) -> None:
        """Remove the callbacks."""
        if self._clock is not None:
            if self in self._clock._jump_handles:
                self._clock._jump_handles.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None) -> None:
        self.unregister()


class _ClockHandle(Destroyable):
    """The handle of a clock."""

    def __init__(self, clock: Clock) -> None:
        super().__init__()
        self._clock = weakref.ref(clock)


class Clock:
    """A clock; `Clock(clock_type=ClockType.ROS_TIME)` makes a ROSClock.

    Raises:
        TypeError: for anything that isn't a ClockType.
    """

    _clock_type: ClockType
    _time: TimeBase = MACHINE_TIME
    _handle: Destroyable
    _jump_handles: list[JumpHandle]

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        """Make a clock of this type; a ROSClock for ROS_TIME, as rclpy/clock.py."""
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        self = super().__new__(ROSClock if clock_type is ClockType.ROS_TIME else cls)
        self._clock_type = clock_type
        self._handle = _ClockHandle(self)
        self._jump_handles = []
        if isinstance(self, ROSClock):
            self._active = False
            self._override = 0
            self._timers = weakref.WeakSet()
        return self

    if not TYPE_CHECKING:

        def __init__(self, **_kwargs: object) -> None:
            """Do nothing: `__new__` has done everything, as it may have chosen another class."""

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock."""
        return self._clock_type

    @property
    def handle(self) -> Destroyable:
        """The handle."""
        return self._handle

    def __repr__(self) -> str:
        return f"Clock(clock_type={self._clock_type.name})"

    def _now_ns(self) -> int:
        if self._clock_type is ClockType.STEADY_TIME:
            return self._time.steady_ns()
        return self._time.now_ns()

    def now(self) -> Time:
        """Return the time by this clock."""
        return Time(nanoseconds=self._now_ns(), clock_type=self._clock_type)

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], None] | None = None,
        post_callback: Callable[[TimeJump], None] | None = None,
    ) -> JumpHandle:
        """Call functions before and after jumps beyond `threshold`, until the returned handle is unregistered."""
        post = None
        if callable(post_callback):

            def post(jump: TimeJumpDictionary) -> None:
                post_callback(TimeJump(jump["clock_change"], Duration(nanoseconds=jump["delta"])))

        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Block until this clock reads `until`.

        Returns False if a shutdown of the context, or a switch to or from simulated time, ended the sleep.

        Raises:
            NotInitializedException: without a valid context.
            ValueError: for a time of another kind of clock.
        """
        from rclpy.utilities import get_default_context

        context = get_default_context() if context is None else context
        if not context.ok():
            raise NotInitializedException
        if until.clock_type is not self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        woken = AutoResetEvent()
        source_changed = False

        def on_jump(jump: TimeJump) -> None:
            nonlocal source_changed
            if jump.clock_change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
                source_changed = True
            woken.set()

        stop_watching = context._watch_end(woken.set)
        threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None, on_clock_change=True)
        with self.create_jump_callback(threshold, post_callback=on_jump):
            while context.ok() and not source_changed:
                left = until.nanoseconds - self._now_ns()
                if left <= 0:
                    break
                woken.wait(None if self._is_simulated() else left / S_TO_NS)
        stop_watching()
        return context.ok() and not source_changed and self._now_ns() >= until.nanoseconds

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Block for a duration by this clock; see `sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)

    def _is_simulated(self) -> bool:
        return False


class ROSClock(Clock):
    """The clock of a node: system time, or the time published on /clock when `use_sim_time` is set."""

    def __new__(cls) -> ROSClock:
        """Make a clock of type ROS_TIME."""
        self = Clock.__new__(Clock, clock_type=ClockType.ROS_TIME)
        assert isinstance(self, ROSClock)
        return self

    _active: bool
    _override: int
    _timers: weakref.WeakSet[Timer]

    def _is_simulated(self) -> bool:
        return self._active

    def _now_ns(self) -> int:
        return self._override if self._active else self._time.now_ns()

    @property
    def ros_time_is_active(self) -> bool:
        """Whether the clock shows simulated time."""
        return self._active

    def _jump(self, change: ClockChange, apply: Callable[[], None]) -> None:
        before = self._now_ns()
        timers = list(self._timers)
        switched = change is not ClockChange.ROS_TIME_NO_CHANGE
        if switched:
            for timer in timers:
                timer._before_switch()
        handles = list(self._jump_handles)
        pre = self._exceeding(handles, change, apply, before)
        for timer in timers:
            timer._after_jump(switched)
        for handle, jump in pre:
            if handle._post_callback is not None:
                handle._post_callback(jump)

    def _exceeding(
        self, handles: list[JumpHandle], change: ClockChange, apply: Callable[[], None], before: int
    ) -> list[tuple[JumpHandle, TimeJumpDictionary]]:
        """Call the pre-callbacks whose threshold the jump exceeds, make the jump, return the handles of those."""
        active, override = self._active, self._override
        apply()
        # A change of the time source isn't a jump by some duration (rcl/time.c).
        delta = self._now_ns() - before if change is ClockChange.ROS_TIME_NO_CHANGE else 0
        after_active, after_override = self._active, self._override
        concerned = [handle for handle in handles if handle._threshold._exceeded_by(change, delta)]
        if any(handle._pre_callback is not None for handle in concerned):
            self._active, self._override = active, override
            for handle in concerned:
                if handle._pre_callback is not None:
                    handle._pre_callback()
            self._active, self._override = after_active, after_override
        return [(handle, {"clock_change": change, "delta": delta}) for handle in concerned]

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._active:
            return

        def apply() -> None:
            self._active = enabled

        self._jump(ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED, apply)

    def set_ros_time_override(self, time: Time) -> None:
        """Set the simulated time.

        Raises:
            TypeError: for anything that isn't a Time.
        """
        if not isinstance(time, Time):
            raise TypeError(f"Time must be specified as rclpy.time.Time. Received type: {type(time)}")
        if not self._active:
            self._override = time.nanoseconds
            return

        def apply() -> None:
            self._override = time.nanoseconds

        self._jump(ClockChange.ROS_TIME_NO_CHANGE, apply)
