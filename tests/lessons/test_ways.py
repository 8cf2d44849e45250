"""Every step and drill counts what was done in another way, and refuses what only looks done (`ways.py`); no process."""

from __future__ import annotations

import sys

import pytest

from tests.lessons.ways import every_way

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="paths were recorded as Linux has them")


def test_every_step_counts_three_other_ways_at_least_and_refuses_three_cheats_at_least() -> None:
    ways = every_way()
    assert [f"{where}: {each}" for where, found in ways.items() for each in found if not each.is_as_it_should] == []
    for right in (True, False):
        few = {where: sum(each.is_right == right for each in found) for where, found in ways.items()}
        assert {where: count for where, count in few.items() if count < 3} == {}
