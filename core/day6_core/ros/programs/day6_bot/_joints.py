"""The joints in /joint_states: each one's position, and its speed measured from one message to the next."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

SECOND = 1_000_000_000
WINDOW_NS = SECOND // 5
"""Positions this far apart in time give a speed: ten messages at 50 Hz."""

SILENCE_NS = SECOND
"""A joint that no message has named for this long counts as standing still."""


@dataclass(frozen=True, slots=True)
class JointReading:
    """`position` (radians, metres if prismatic) as published, `speed` per second, `known` if the URDF has the joint."""

    name: str
    position: float
    speed: float
    known: bool


class Moment(NamedTuple):
    """When something happened (ns): by the real clock, which measures, and by the one of timers, which stands in a pause."""

    real_ns: int
    timer_ns: int


class _Track:
    """One joint: how far it has gone since the window began, whole turns not counted."""

    def __init__(self, position: float, now: Moment) -> None:
        self.position = position
        self.speed = 0.0
        self.heard_ns = now.timer_ns
        self._since_ns = now.real_ns
        self._gone = 0.0

    def hear(self, position: float, now: Moment, turns: bool) -> None:
        step = position - self.position
        # From just below 2 pi to just above 0 is a small step forward, for whatever turns.
        self._gone += math.remainder(step, 2 * math.pi) if turns else step
        self.position = position
        self.heard_ns = now.timer_ns
        span = now.real_ns - self._since_ns
        if span >= WINDOW_NS:
            self.speed = self._gone * SECOND / span
            self._since_ns, self._gone = now.real_ns, 0.0


class JointReadings:
    """All joints heard of, in the order they were first named, and how often messages come."""

    def __init__(self) -> None:
        self._tracks: dict[str, _Track] = {}
        self._arrivals: list[int] = []

    def hear(self, names: list[str], positions: list[float], now: Moment, turning: frozenset[str]) -> None:
        """Handle one message received `now`; `turning` names the joints whose positions are angles."""
        self._arrivals = [*self._arrivals[-99:], now.real_ns]
        for name, position in zip(names, positions, strict=False):
            track = self._tracks.get(name)
            if track is None:
                self._tracks[name] = _Track(position, now)
            else:
                track.hear(position, now, name in turning)

    def forget_silent(self, timer_ns: int) -> None:
        """Joints that fell silent have speed 0; after ten seconds of silence they are forgotten."""
        for name, track in list(self._tracks.items()):
            if timer_ns - track.heard_ns > 10 * SILENCE_NS:
                del self._tracks[name]
            elif timer_ns - track.heard_ns > SILENCE_NS:
                track.speed = 0.0

    def heard_lately(self, timer_ns: int) -> tuple[str, ...]:
        """Return the joints named in recent messages."""
        return tuple(name for name, track in self._tracks.items() if timer_ns - track.heard_ns <= SILENCE_NS)

    def rate(self, real_ns: int) -> float | None:
        """Return messages per second over the last two seconds (or two messages); None when they have stopped."""
        recent = [moment for moment in self._arrivals if real_ns - moment < 2 * SECOND]
        if not recent or real_ns - recent[-1] > SILENCE_NS + SECOND // 2:
            return None
        if len(recent) < 2:
            recent = self._arrivals[-2:]
        if len(recent) < 2:
            return None
        return (len(recent) - 1) * SECOND / max(recent[-1] - recent[0], 1)

    def readings(self, known: frozenset[str]) -> tuple[JointReading, ...]:
        return tuple(
            JointReading(name, track.position, track.speed, name in known) for name, track in self._tracks.items()
        )
