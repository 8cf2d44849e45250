"""The check of a rate: the window is as long as a slow topic needs."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.lessons.checks import Verdict
from day6_core.lessons.checks.messages import rate


def judged(times: Sequence[float], now: float, least: float, most: float | None = None) -> Verdict:
    """The verdict on messages that came at `times` (s)."""
    arrivals = [(round(when * 1e9), None) for when in times]
    live: Any = SimpleNamespace(
        now_ns=lambda: round(now * 1e9), heard=lambda _: SimpleNamespace(since=lambda _: arrivals)
    )
    return rate(live, "/beacon", least, most)


@pytest.mark.parametrize("hertz", [0.2, 0.5, 0.625, 1.0, 2.0, 30.0])
@pytest.mark.parametrize("late", [0.0, 0.5, 0.95])
def test_slow_and_fast_topics_are_measured(hertz: float, late: float) -> None:
    times = [10 + number / hertz for number in range(12)]
    now = times[-1] + late / hertz
    assert judged(times, now, 0.8 * hertz, 1.2 * hertz).ok
    assert not judged(times, now, 1.3 * hertz).ok
    assert not judged(times, now, 0.5 * hertz, 0.8 * hertz).ok


def test_a_slow_topic_that_ended_is_noticed() -> None:
    times = [0.0, 2.0, 4.0, 6.0]
    assert judged(times, 6.5, 0.4).ok
    assert not judged(times, 12.0, 0.4).ok
