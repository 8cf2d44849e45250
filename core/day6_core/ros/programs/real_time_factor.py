"""How fast simulated time passes, measured against the wall: Gazebo's real-time factor."""

from __future__ import annotations

from collections import deque

PERIOD_NS = 250_000_000
SAMPLES = 4
"""So many periods are averaged: a second, calm enough to be read."""


class RealTimeFactor:
    """Simulated seconds per real second, lately."""

    def __init__(self) -> None:
        self._samples: deque[tuple[int, int]] = deque(maxlen=SAMPLES + 1)
        self.value: float | None = None
        """None before it is measured."""

    def note(self, simulated_ns: int, wall_ns: int) -> None:
        """Look at both clocks (ns); call it as often as you like."""
        samples = self._samples
        if samples and simulated_ns < samples[-1][0]:
            samples.clear()  # the simulation was reset
        if samples and wall_ns - samples[-1][1] < PERIOD_NS:
            return
        samples.append((simulated_ns, wall_ns))
        if len(samples) > 1:
            self.value = (simulated_ns - samples[0][0]) / (wall_ns - samples[0][1])

    def forget(self) -> None:
        """Begin anew, after a pause."""
        self._samples.clear()
        self.value = None
