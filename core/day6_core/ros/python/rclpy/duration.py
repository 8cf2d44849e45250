"""Spans of time in whole nanoseconds."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import RMW_DURATION_INFINITE
from rclpy.constants import S_TO_NS

if TYPE_CHECKING:
    import builtin_interfaces.msg


__getattr__ = also(__name__)


class Duration:
    """A span of time, possibly negative, held as nanoseconds (64 bits).

    Raises:
        OverflowError: when the sum of `seconds` and `nanoseconds` does not fit.
    """

    __slots__ = ("__weakref__", "_nanoseconds")

    def __init__(self, *, seconds: int | float = 0, nanoseconds: int | float = 0) -> None:
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if not -(2**63) <= total < 2**63:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._nanoseconds = total

    @property
    def nanoseconds(self) -> int:
        """The whole span in nanoseconds."""
        return self._nanoseconds

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self._nanoseconds})"

    def __str__(self) -> str:
        return "Infinite" if self._nanoseconds == RMW_DURATION_INFINITE else f"{self._nanoseconds} nanoseconds"

    def __add__(self, other: Duration) -> Duration:
        if isinstance(other, Duration):
            return Duration(nanoseconds=self._nanoseconds + other._nanoseconds)
        return NotImplemented

    def __sub__(self, other: Duration) -> Duration:
        if isinstance(other, Duration):
            return Duration(nanoseconds=self._nanoseconds - other._nanoseconds)
        return NotImplemented

    def __mul__(self, other: float) -> Duration:
        if isinstance(other, int):
            return Duration(nanoseconds=self._nanoseconds * other)
        if isinstance(other, float):
            if other == math.inf:
                return Infinite
            if not math.isfinite(other):
                raise ValueError("Can't multiply duration with nan")
            return Duration(nanoseconds=int(self._nanoseconds * other))
        return NotImplemented

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds == other._nanoseconds
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __lt__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds < other._nanoseconds
        return NotImplemented

    def __le__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds <= other._nanoseconds
        return NotImplemented

    def __gt__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds > other._nanoseconds
        return NotImplemented

    def __ge__(self, other: Duration) -> bool:
        if isinstance(other, Duration):
            return self._nanoseconds >= other._nanoseconds
        return NotImplemented

    def to_msg(self) -> builtin_interfaces.msg.Duration:
        """Return the duration as a builtin_interfaces/Duration message."""
        import builtin_interfaces.msg

        seconds, nanoseconds = divmod(self._nanoseconds, S_TO_NS)
        return builtin_interfaces.msg.Duration(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: builtin_interfaces.msg.Duration) -> Duration:
        """Convert a builtin_interfaces/Duration message.

        Raises:
            TypeError: for anything else.
        """
        import builtin_interfaces.msg

        if not isinstance(msg, builtin_interfaces.msg.Duration):
            raise TypeError("Must pass a builtin_interfaces.msg.Duration object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def get_c_duration(self) -> Duration:
        """Return an object with the attribute `nanoseconds`, as rclpy's C++ half expects it."""
        return self


Infinite = Duration(nanoseconds=RMW_DURATION_INFINITE)
