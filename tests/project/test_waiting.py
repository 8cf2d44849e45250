"""The clock of all deadlines in the tests."""

from __future__ import annotations

import pytest

from tests.support import waiting


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """The wall's clock, as a list of its only reading, on a machine with a core to spare."""
    reading = [0.0]
    monkeypatch.setattr(waiting, "monotonic", lambda: reading[0])
    monkeypatch.setattr(waiting, "share_of_a_core", lambda: 1.0)
    return reading


def _seconds_until_over(clock: list[float], deadline: waiting.Deadline, every: float) -> float:
    began = clock[0]
    while not deadline.is_over():
        clock[0] += every
    return clock[0] - began


def test_a_deadline_ends_in_time(clock: list[float]) -> None:
    assert _seconds_until_over(clock, waiting.Deadline(5.0), 0.25) == 5.25


def test_a_machine_that_stood_still_does_not_end_a_deadline(clock: list[float]) -> None:
    deadline = waiting.Deadline(5.0)
    clock[0] += 3600.0
    assert not deadline.is_over()
    assert _seconds_until_over(clock, deadline, 0.25) == 4.25


def test_among_four_that_want_a_core_a_deadline_takes_four_times_as_long(
    clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(waiting, "share_of_a_core", lambda: 0.25)
    assert _seconds_until_over(clock, waiting.Deadline(5.0), 0.25) == 20.25
