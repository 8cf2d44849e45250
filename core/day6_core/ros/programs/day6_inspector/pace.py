"""How fast the world's time passes, of the speed that was chosen."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.clock import WorldClock

LOOKS = 21
"""As many looks at the clock tell whether it keeps up: ten seconds of them, so that the start of a program is no finding."""

LEAST_NS = 3_000_000_000
"""Less of the world's time tells nothing."""


class ClockPace:
    """Looks at a clock again and again."""

    def __init__(self, clock: WorldClock) -> None:
        self._clock = clock
        self._progress: deque[tuple[int, int]] = deque(maxlen=LOOKS)

    def now(self) -> float:
        """Return the chosen speed, less what this computer was too slow for lately."""
        self._progress.append((self._clock.steady_ns(), self._clock.lost_ns))
        (began, lost_before), (now, lost) = self._progress[0], self._progress[-1]
        due = now - began + lost - lost_before
        return self._clock.speed * ((now - began) / due if due >= LEAST_NS else 1.0)
