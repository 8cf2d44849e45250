"""The part of the timeline that is seen: zooming, moving, its divisions. Times are nanoseconds since 1970."""

from __future__ import annotations

import math
import time
from typing import NamedTuple

NANOSECONDS = 1_000_000_000

LEAST_NS = 5 * NANOSECONDS
"""So much is seen of a shorter bag (timeline_frame.reset_zoom)."""

CLOSEST_NS = NANOSECONDS // 1000
FARTHEST_NS = 400 * 86400 * NANOSECONDS
"""The least and the most that can be seen at once."""

PAN = 0.05
"""The part of it by which an arrow key moves (timeline_frame.translate_timeline_left)."""

ZOOM_IN, ZOOM_OUT = 0.5, 2.0
WHEEL_IN, WHEEL_OUT = 0.8, 1.2
"""Factors of the buttons and of a notch of the wheel (timeline_frame.zoom_in, on_mousewheel)."""

_DIVISIONS = (
    0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1, 5, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400,
    604800,
)  # fmt: skip
"""Seconds between two divisions that may be labelled (timeline_frame.py)."""


class TimeSpan(NamedTuple):
    """From when until when is seen."""

    left: int
    right: int

    @property
    def span(self) -> int:
        return self.right - self.left

    def time_at(self, column: float, columns: int) -> int:
        """The time in the middle of a column."""
        return self.left + round(self.span * (column + 0.5) / max(1, columns))

    def column_of(self, time_ns: int, columns: int) -> int:
        """The column of a time, which may lie outside."""
        return (time_ns - self.left) * columns // max(1, self.span)

    def zoom(self, factor: float, centre: int) -> TimeSpan:
        """See more (> 1) or less; what is at `centre` stays in its place."""
        span = min(max(round(self.span * factor), CLOSEST_NS), FARTHEST_NS)
        left = centre - (centre - self.left) * span // max(1, self.span)
        return TimeSpan(left, left + span)

    def pan(self, part: float) -> TimeSpan:
        """Move by a part of what is seen."""
        by = round(self.span * part)
        return TimeSpan(self.left + by, self.right + by)

    def following(self, time_ns: int, start: int, end: int) -> TimeSpan:
        """The view that shows a time: moved on by three quarters when it left it, as far as the bag goes."""
        by = 0
        if time_ns > self.right:
            by = max(time_ns - self.right, min(time_ns - self.right + self.span * 3 // 4, end - self.right))
        elif time_ns < self.left:
            by = min(time_ns - self.left, max(time_ns - self.left - self.span * 3 // 4, start - self.left))
        return TimeSpan(self.left + by, self.right + by)


def whole(start: int, end: int) -> TimeSpan:
    """The view of everything."""
    return TimeSpan(start, max(end, start + LEAST_NS))


def divisions(view: TimeSpan, start: int, columns: int, room: int) -> list[tuple[int, str]]:
    """Columns with their labels, which tell the time since the beginning of the bag; `room`: cells a label needs."""
    per_column = view.span / NANOSECONDS / max(1, columns)
    longest = _DIVISIONS[-1]
    needed = per_column * room
    step = next((each for each in _DIVISIONS if each >= needed), longest * math.ceil(needed / longest))
    step_ns = round(step * NANOSECONDS)
    first = max(0, -(-(view.left - start) // step_ns))
    found = []
    for number in range(first, first + columns):
        elapsed = number * step_ns
        column = view.column_of(start + elapsed, columns)
        if column >= columns:
            break
        found.append((column, label(step, elapsed)))
    return found


def label(division: float, elapsed_ns: int) -> str:
    """How rqt_bag writes a time at a division (timeline_frame._get_label)."""
    seconds, rest = divmod(elapsed_ns, NANOSECONDS)
    minutes, hours = seconds // 60, seconds // 3600
    for least, text in (
        (604800, f"{hours // 168}w"),
        (86400, f"{hours // 24}d"),
        (3600, f"{hours}h"),
        (300, f"{minutes}m"),
        (1, f"{minutes}m{seconds % 60:02d}s"),
        (0.1, f"{seconds}.{rest // 100_000_000}s"),
        (0.01, f"{seconds}.{rest // 10_000_000:02d}s"),
    ):
        if division >= least:
            return text
    return f"{seconds}.{rest // 1_000_000:03d}s"


def size_text(size: int) -> str:
    """A size as rqt_bag writes it, '1.25 MB' (bag_widget._filesize_to_str)."""
    value, unit = float(size), 0
    while value >= 1024 and unit < 4:
        value, unit = value / 1024, unit + 1
    return f"{round(value, 2)} {('B', 'KB', 'MB', 'GB', 'TB')[unit]}" if size > 0 else "0 B"


def proposed_name() -> str:
    """The name that rqt_bag proposes for a new bag (bag_widget._on_record_settings_selected)."""
    return time.strftime("%Y-%m-%d-%H-%M-%S")
