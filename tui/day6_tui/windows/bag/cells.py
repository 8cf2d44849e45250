"""How rqt_bag's window draws: counts as bars, the colours of types, dates."""

from __future__ import annotations

import time
from collections.abc import Sequence

from rich.segment import Segment
from rich.style import Style

from day6_core.ros.programs.rqt_bag.model.view import NANOSECONDS

Cell = tuple[str, Style]

COLOURS = {
    "sensor_msgs/msg/Image": (0x3FC1C1, 0x006D6D),
    "sensor_msgs/msg/CompressedImage": (0x3FC1C1, 0x006D6D),
    "sensor_msgs/msg/CameraInfo": (0x8F9BFF, 0x20208C),
    "sensor_msgs/msg/LaserScan": (0xFF7B6B, 0x990000),
    "tf2_msgs/msg/TFMessage": (0x5FCB6B, 0x006E00),
}
"""On dark and on light: rqt_bag's colours of types (timeline_frame._datatype_colors), brightened for dark."""

OTHERS = (0x7AA2F7, 0x000066)


def bars_of(counts: Sequence[float], bars: str) -> list[str]:
    """Counts as bars: none for none, the highest for the most of the line."""
    top = max(counts, default=0.0)
    if top <= 0:
        return [" "] * len(counts)
    steps = len(bars) - 1
    return [" " if count < 0.01 else bars[max(1, round(count / top * steps))] for count in counts]


def runs(cells: Sequence[Cell]) -> list[Segment]:
    """Cells as segments, one for each run of a style."""
    found: list[tuple[list[str], Style]] = []
    for char, style in cells:
        if found and found[-1][1] is style:
            found[-1][0].append(char)
        else:
            found.append(([char], style))
    return [Segment("".join(chars), style) for chars, style in found]


def short(type_name: str) -> str:
    return type_name.replace("/msg/", "/")


def date(time_ns: int) -> str:
    """A time as rqt_bag writes it: seconds until 1975, else the local date (bag_widget._stamp_to_str)."""
    seconds, rest = divmod(time_ns, NANOSECONDS)
    if seconds < 5 * 365 * 86400:
        return f"{time_ns / NANOSECONDS:.3f}s"
    return f"{time.strftime('%b %d %Y %H:%M:%S', time.localtime(seconds))}.{rest // 1_000_000:03d}"
