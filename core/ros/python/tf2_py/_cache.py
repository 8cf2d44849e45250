"""What a buffer remembers of one frame: its transforms to its parent over the last seconds, or the one that always holds.

Times are nanoseconds; 0 asks for the latest.
"""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

from tf2_py._exceptions import ExtrapolationException
from tf2_py._rotation import Quaternion, Vector, between, slerp

DEFAULT_CACHE_NS = 10_000_000_000
_SPARE = 256
"""So many outdated entries are kept before a list is really shortened."""


def seconds(time_ns: int) -> float:
    """Return seconds, with the whole seconds and the rest converted apart, as tf2 does."""
    whole = abs(time_ns) // 1_000_000_000
    rest = abs(time_ns) - whole * 1_000_000_000
    value = float(whole) + 1e-9 * rest
    return -value if time_ns < 0 else value


def shown(time_ns: int) -> str:
    """Return a time as tf2 prints it: seconds with six digits."""
    return f"{seconds(time_ns):.6f}"


class Entry(NamedTuple):
    """A transform from a frame to its parent at a time."""

    stamp: int
    rotation: Quaternion
    translation: Vector
    parent: str


class TimeCache:
    """Transforms sorted by time; those older than `keep_ns` before the latest are forgotten."""

    is_static = False

    def __init__(self, keep_ns: int) -> None:
        self._keep = keep_ns
        self._stamps: list[int] = []
        self._entries: list[Entry] = []
        self._start = 0
        """Entries before this one are forgotten."""

    def __len__(self) -> int:
        return len(self._stamps) - self._start

    @property
    def latest_stamp(self) -> int:
        """The time of the latest transform, 0 without any."""
        return self._stamps[-1] if len(self) else 0

    @property
    def oldest_stamp(self) -> int:
        """The time of the oldest transform, 0 without any."""
        return self._stamps[self._start] if len(self) else 0

    @property
    def latest_parent(self) -> str | None:
        """The parent in the latest transform, None without any."""
        return self._entries[-1].parent if len(self) else None

    def insert(self, entry: Entry) -> bool:
        """Remember a transform; False if it is older than everything this cache may hold."""
        latest = self.latest_stamp
        self._forget_before(latest - self._keep)
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

    def _forget_before(self, stamp: int) -> None:
        stamps = self._stamps
        start = self._start
        while start < len(stamps) and stamps[start] < stamp:
            start += 1
        if start > _SPARE:
            del stamps[:start], self._entries[:start]
            start = 0
        self._start = start

    def clear(self) -> None:
        """Forget all."""
        self._stamps, self._entries, self._start = [], [], 0

    def at(self, time_ns: int) -> Entry:
        """Return the transform at a time, between two known ones interpolated. Raises ExtrapolationException."""
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
        one, two = entries[after - 1], entries[after]
        if one.parent != two.parent:
            return one
        ratio = float(time_ns - one.stamp) / float(two.stamp - one.stamp)
        rotation = slerp(one.rotation, two.rotation, ratio)
        return Entry(one.stamp, rotation, between(one.translation, two.translation, ratio), one.parent)


def _only(requested: int, known: int) -> ExtrapolationException:
    return ExtrapolationException(
        f"Lookup would require extrapolation at time {shown(requested)}, but only time {shown(known)} is in the buffer"
    )


class StaticCache:
    """The transform of a fixed frame; it holds at every time and is never forgotten."""

    is_static = True
    latest_stamp = 0
    oldest_stamp = 0

    def __init__(self, entry: Entry) -> None:
        self._entry = entry

    def __len__(self) -> int:
        return 1

    @property
    def latest_parent(self) -> str:
        """The parent."""
        return self._entry.parent

    def insert(self, entry: Entry) -> bool:
        """Replace the transform."""
        self._entry = entry
        return True

    def clear(self) -> None:
        """Do nothing: fixed frames stay."""

    def at(self, time_ns: int) -> Entry:
        """Return the transform."""
        return self._entry


Cache = TimeCache | StaticCache
