"""The clocks of the modules time and datetime, and `sleep`."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import time
from collections.abc import Callable
from typing import Any

from day6_core.virtual.follow.builtin import is_number, put
from day6_core.virtual.follow.imports import when_imported
from day6_core.virtual.kernel import READ_NS, Kernel

EPOCH_NS = 1_767_225_600_000_000_000
"""When every world begins: 2026-01-01, 00:00 UTC."""


_SLACK_NS = 50_000
"""What a sleep of nothing takes, so that others go on beside a program of such sleeps: by so much Linux lets sleeps be late."""
_TOO_LONG = 9.2e9
"""Seconds: for a sleep of Python's own."""


def install(kernel: Kernel) -> None:
    """Have the clocks follow a kernel."""
    clock, real_sleep = kernel.clock, time.sleep

    def sleep(*seconds: Any, **nothing: Any) -> None:
        length: Any = seconds[0] if len(seconds) == 1 and not nothing else None
        if is_number(length) and 0 <= length < _TOO_LONG:
            kernel.wait(int(length * 1e9) or _SLACK_NS)
        else:
            real_sleep(*seconds, **nothing)  # says what is wrong with it

    def time_ns() -> int:  # thousands of times a second: as `Kernel.clock`, without calling it
        now = kernel.now = kernel.now + READ_NS
        return EPOCH_NS + (now if now < kernel.yield_at else clock())

    def seconds_since_1970() -> float:
        return (EPOCH_NS + clock()) / 1e9

    def monotonic() -> float:
        return clock() / 1e9

    def monotonic_ns() -> int:
        now = kernel.now = kernel.now + READ_NS
        return now if now < kernel.yield_at else clock()

    for function, names in (
        (sleep, ("sleep",)),
        (time_ns, ("time_ns",)),
        (seconds_since_1970, ("time",)),
        (monotonic, ("monotonic", "perf_counter", "process_time", "thread_time")),
        (monotonic_ns, ("monotonic_ns", "perf_counter_ns", "process_time_ns", "thread_time_ns")),
    ):
        for name in names:
            put(time, **{name: function})
    _follow_clock_gettime(clock)
    _follow_default_times(seconds_since_1970)
    when_imported("datetime", _follow_datetime)
    when_imported("threading", _follow_threading)


def _follow_threading(module: Any) -> None:
    module._time = time.monotonic


def _follow_clock_gettime(clock: Callable[[], int]) -> None:
    real_ns = time.clock_gettime_ns
    dates = {time.CLOCK_REALTIME}
    steady = {time.CLOCK_MONOTONIC, *(getattr(time, name, -1) for name in ("CLOCK_MONOTONIC_RAW", "CLOCK_BOOTTIME"))}

    def clock_gettime_ns(clk_id: int, /) -> int:
        if clk_id in dates:
            return EPOCH_NS + clock()
        return clock() if clk_id in steady else real_ns(clk_id)

    def clock_gettime(clk_id: int, /) -> float:
        return clock_gettime_ns(clk_id) / 1e9

    put(time, clock_gettime_ns=clock_gettime_ns, clock_gettime=clock_gettime)


def _follow_default_times(now: Callable[[], float]) -> None:
    """What takes the time of now if it is given none."""

    def with_now(original: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *seconds: original(now()) if seconds in ((), (None,)) else original(*seconds)

    localtime, asctime, strftime = time.localtime, time.asctime, time.strftime
    put(time, localtime=with_now(localtime), gmtime=with_now(time.gmtime), ctime=with_now(time.ctime))
    put(
        time,
        asctime=lambda *t: asctime(*t or (localtime(now()),)),
        strftime=lambda *given: strftime(*given, localtime(now())) if len(given) == 1 else strftime(*given),
    )


def _follow_datetime(module: Any) -> None:
    real_datetime, real_date = module.datetime, module.date

    class _AlsoReal(type):
        """What C makes is a datetime, too."""

        def __instancecheck__(cls, instance: object) -> bool:
            return isinstance(instance, cls.__mro__[1])

        def __subclasscheck__(cls, subclass: type) -> bool:
            return issubclass(subclass, cls.__mro__[1])

    class datetime(real_datetime, metaclass=_AlsoReal):  # type: ignore[misc,valid-type]
        @classmethod
        def now(cls, tz: Any = None) -> Any:
            return cls.fromtimestamp(time.time(), tz)

        @classmethod
        def utcnow(cls) -> Any:
            return cls.fromtimestamp(time.time(), module.timezone.utc).replace(tzinfo=None)

        @classmethod
        def today(cls) -> Any:
            return cls.fromtimestamp(time.time())

    class date(real_date, metaclass=_AlsoReal):  # type: ignore[misc,valid-type]
        @classmethod
        def today(cls) -> Any:
            return cls.fromtimestamp(time.time())

    pairs: tuple[tuple[Any, Any], ...] = (datetime, real_datetime), (date, real_date)
    for made, real in pairs:
        made.__module__, made.__qualname__ = "datetime", real.__name__
        made.__repr__ = _representing(real)
        setattr(module, real.__name__, made)
    for name in ("min", "max"):
        day = getattr(real_date, name)
        date_and_time = getattr(real_datetime, name)
        setattr(date, name, date(day.year, day.month, day.day))
        setattr(datetime, name, datetime.combine(date_and_time.date(), date_and_time.time()))


def _representing(real: Any) -> Callable[[Any], str]:
    def represented(self: Any) -> str:
        text: str = real.__repr__(self)
        return text if text.startswith("datetime.") else f"datetime.{text}"

    return represented
