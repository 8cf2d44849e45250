"""The time in a bag during playback: it runs at a rate, pauses, jumps (rosbag2_cpp/time_controller_clock.cpp)."""

from __future__ import annotations

from collections.abc import Callable


class BagClock:
    """A clock with the recording's time in nanoseconds since 1970; `steady_ns` is the clock that paces it."""

    def __init__(self, start_ns: int, steady_ns: Callable[[], int], *, paused: bool = False) -> None:
        self._steady_ns = steady_ns
        self._at = start_ns
        self._since = steady_ns()
        self.rate = 1.0
        self.paused = paused

    def now(self) -> int:
        """Return the current time in the recording, in nanoseconds since 1970."""
        if self.paused:
            return self._at
        return self._at + round((self._steady_ns() - self._since) * self.rate)

    def steady_at(self, bag_ns: int) -> int:
        """Return the steady time at which the recording's time will be `bag_ns`, if the rate does not change."""
        return self._since + round((bag_ns - self._at) / self.rate)

    def jump(self, bag_ns: int) -> None:
        """Continue from this time of the recording."""
        self._at = bag_ns
        self._since = self._steady_ns()

    def pause(self) -> None:
        """Stop the time."""
        self.jump(self.now())
        self.paused = True

    def resume(self) -> None:
        """Let the time run again."""
        self.jump(self.now())
        self.paused = False

    def set_rate(self, rate: float) -> bool:
        """Change the rate; returns False and changes nothing unless it is above 0."""
        if not rate > 0:
            return False
        self.jump(self.now())
        self.rate = rate
        return True
