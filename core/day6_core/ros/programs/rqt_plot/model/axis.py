"""Axes: which values are seen, and where round numbers are on them."""

from __future__ import annotations

import bisect
import math
from collections.abc import Sequence

_STEPS = (1.0, 2.0, 5.0, 10.0)


def seen(times: Sequence[float], values: Sequence[float], start: float, end: float) -> tuple[int, int]:
    """Return the range of indexes of the points to draw for a span of time: one more on either side, for the lines there."""
    count = min(len(times), len(values))
    first = bisect.bisect_left(times, start, 0, count)
    last = bisect.bisect_right(times, end, 0, count)
    return max(0, first - 1), min(count, last + 1)


def limits(lowest: float, highest: float, most: int) -> tuple[float, float, float]:
    """Return the lower and upper edge for values between two, and the step of the ticks: about `most` round numbers.

    The edges are ticks themselves, so that they stand still while the values move a little.
    """
    if highest - lowest <= 1e-9 * max(abs(lowest), abs(highest), 1e-9):
        pad = abs(highest) * 0.1 or 1.0
        lowest, highest = lowest - pad, highest + pad
    step = round_step((highest - lowest) / most)
    return math.floor(lowest / step + 1e-6) * step, math.ceil(highest / step - 1e-6) * step, step


def round_step(rough: float) -> float:
    """Return 1, 2 or 5 times a power of ten, the smallest that is not below `rough`."""
    power = 10.0 ** math.floor(math.log10(rough))
    return next(factor * power for factor in _STEPS if factor * power >= rough * (1 - 1e-9))


def ticks(low: float, high: float, most: int) -> list[float]:
    """Return at most `most` round numbers between two, equally spaced by 1, 2 or 5 times a power of ten."""
    if most < 1 or not (math.isfinite(low) and math.isfinite(high)) or high <= low:
        return []
    step = round_step((high - low) / most)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)][:most]


def label(value: float, step: float) -> str:
    """Return a tick's text, with as many decimals as its neighbours need."""
    if value == 0 or abs(value) < step * 1e-6:
        return "0"
    if abs(value) >= 1e6 or step < 1e-4:
        return f"{value:.3g}"
    decimals = max(0, -math.floor(math.log10(step) + 1e-9)) if step > 0 else 0
    return f"{value:.{decimals}f}"
