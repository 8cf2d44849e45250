"""The playhead: a time in the bags that stands, or runs with the world's time at a speed, backwards too."""

from __future__ import annotations

from collections.abc import Callable

MOST_SPEED = 1024.0
LEAST_SPEED = 1 / 1024
"""rqt_bag/bag_timeline.py: the fastest and the slowest speed of both directions."""


class Playhead:
    """`steady_ns` is the world's clock."""

    def __init__(self, steady_ns: Callable[[], int]) -> None:
        self._steady_ns = steady_ns
        self._at = 0
        self._since = 0
        self.speed = 0.0
        """Seconds of the bag in a second; 0 while it stands."""

    def now(self) -> int:
        """Where it is, in nanoseconds since 1970."""
        return self._at + round((self._steady_ns() - self._since) * self.speed) if self.speed else self._at

    def jump(self, at_ns: int) -> None:
        """Go on from another time."""
        self._at, self._since = at_ns, self._steady_ns()

    def set_speed(self, speed: float) -> None:
        """Go on at another speed, within the limits of rqt_bag."""
        self.jump(self.now())
        size = min(MOST_SPEED, max(LEAST_SPEED, abs(speed))) if speed else 0.0
        self.speed = size if speed > 0 else -size

    def steady_at(self, at_ns: int) -> int:
        """When it will be there, in steady time; it must not stand."""
        return self._since + round((at_ns - self._at) / self.speed)

    def has_reached(self, at_ns: int) -> bool:
        """Whether `steady_at` is now or over; rounded, `now` may differ by what a nanosecond is at its speed."""
        return self.steady_at(at_ns) <= self._steady_ns()


def faster(speed: float) -> float:
    """The speed after 'Fast Forward' (bag_timeline.navigate_fastforward)."""
    return 2.0 if speed == 0.0 else speed * 2.0 if speed > 0.0 else speed * 0.5


def slower(speed: float) -> float:
    """The speed after 'Slower / Rewind' (bag_timeline.navigate_rewind)."""
    return -1.0 if speed == 0.0 else speed * 2.0 if speed < 0.0 else speed * 0.5


def speed_text(speed: float) -> str:
    """A speed as rqt_bag writes it: '>> 2x', '>', '> 1/2x', '<', '' while it stands (bag_widget._update_status_bar)."""
    if speed == 0.0:
        return ""
    sign, size = (">", speed) if speed > 0 else ("<", -speed)
    return sign if size == 1.0 else f"{sign * 2} {size:.0f}x" if size > 1.0 else f"{sign} 1/{1 / size:.0f}x"
