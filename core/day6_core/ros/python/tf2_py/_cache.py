"""The cache of one frame: its transforms to its parent over the last seconds, or one static transform.

Times are nanoseconds; 0 means the latest.
"""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

from tf2_py._exceptions import ExtrapolationException
from tf2_py._rotation import Quaternion, Vector, between, slerp

DEFAULT_CACHE_NS = 10_000_000_000
_SPARE = 256
"""The number of outdated entries that are kept before the lists are shortened."""


def seconds(time_ns: int) -> float:
    """Return seconds; whole seconds and the rest are converted separately, as in tf2."""
    whole = abs(time_ns) // 1_000_000_000
    rest = abs(time_ns) - whole * 1_000_000_000
    value = float(whole) + 1e-9 * rest
    return -value if time_ns < 0 else value


def shown(time_ns: int) -> str:
    """Return a time as tf2 prints it: seconds with six digits."""
    return f"{seconds(time_ns):.6f}"


class CachedTransform(NamedTuple):
    """A transform from a frame to its parent at a time."""

    stamp: int
    rotation: Quaternion
    translation: Vector
    parent: str


class TimeCache:
    """Transforms sorted by time; those more than `keep_ns` older than the latest are dropped."""

    is_static = False

    def __init__(self, keep_ns: int) -> None:
        self._keep = keep_ns
        self._stamps: list[int] = []
        self._entries: list[CachedTransform] = []
        self._start = 0
        """Index of the first entry that is still valid."""

    def __len__(self) -> int:
        return len(self._stamps) - self._start

    @property
    def latest_stamp(self) -> int:
        """The time of the latest transform, 0 if there is none."""
        return self._stamps[-1] if len(self) else 0

    @property
    def oldest_stamp(self) -> int:
        """The time of the oldest transform, 0 if there is none."""
        return self._stamps[self._start] if len(self) else 0

    @property
    def latest_parent(self) -> str | None:
        """The parent in the latest transform, None if there is none."""
        return self._entries[-1].parent if len(self) else None

    def insert(self, entry: CachedTransform) -> bool:
        """Store a transform; returns False if it is too old for this cache."""
        latest = self.latest_stamp
        self._drop_before(latest - self._keep)
        stamp = entry.stamp
        if stamp < latest - self._keep and len(self):
            return False
        position = bisect_right(self._stamps, stamp, self._start)
        before = position - 1
        while before >= self._start and self._stamps[before] == stamp:
            if self._entries[before] == entry:
                return True
            before -= 1
        self._stamps.insert(position, stamp)
        self._entries.insert(position, entry)
        return True

    def _drop_before(self, stamp: int) -> None:
        stamps = self._stamps
        start = self._start
        while start < len(stamps) and stamps[start] < stamp:
            start += 1
        if start > _SPARE:
            del stamps[:start], self._entries[:start]
            start = 0
        self._start = start

    def clear(self) -> None:
        """Remove all transforms."""
        self._stamps, self._entries, self._start = [], [], 0

    def at(self, time_ns: int) -> CachedTransform:
        """Return the transform at a time, interpolated between two known ones. Raises ExtrapolationException."""
        if not len(self):
            raise _only(time_ns, 0)
        stamps, entries = self._stamps, self._entries
        latest, oldest = stamps[-1], stamps[self._start]
        if time_ns == 0 or time_ns == latest:
            return entries[-1]
        if len(self) == 1:
            raise _only(time_ns, latest)
        if time_ns == oldest:
            return entries[self._start]
        if time_ns > latest:
            raise ExtrapolationException(
                f"Lookup would require extrapolation into the future.  Requested time {shown(time_ns)}"
                f" but the latest data is at time {shown(latest)}"
            )
        if time_ns < oldest:
            raise ExtrapolationException(
                f"Lookup would require extrapolation into the past.  Requested time {shown(time_ns)}"
                f" but the earliest data is at time {shown(oldest)}"
            )
        after = bisect_right(stamps, time_ns, self._start)
        earlier, later = entries[after - 1], entries[after]
        if earlier.parent != later.parent:
            return earlier
        ratio = float(time_ns - earlier.stamp) / float(later.stamp - earlier.stamp)
        rotation = slerp(earlier.rotation, later.rotation, ratio)
        return CachedTransform(
            earlier.stamp, rotation, between(earlier.translation, later.translation, ratio), earlier.parent
        )


def _only(requested: int, known: int) -> ExtrapolationException:
    return ExtrapolationException(
        f"Lookup would require extrapolation at time {shown(requested)}, but only time {shown(known)} is in the buffer"
    )


class StaticCache:
    """The static transform of a frame; it holds at every time and is never dropped."""

    is_static = True
    latest_stamp = 0
    oldest_stamp = 0

    def __init__(self, entry: CachedTransform) -> None:
        self._entry = entry

    def __len__(self) -> int:
        return 1

    @property
    def latest_parent(self) -> str:
        """The parent."""
        return self._entry.parent

    def insert(self, entry: CachedTransform) -> bool:
        """Replace the transform."""
        self._entry = entry
        return True

    def clear(self) -> None:
        """Do nothing: static transforms stay."""

    def at(self, time_ns: int) -> CachedTransform:
        """Return the transform."""
        return self._entry


Cache = TimeCache | StaticCache
