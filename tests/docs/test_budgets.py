"""The page on performance lists the budgets that `tests.perf.bench` measures."""

from __future__ import annotations

import re

import pytest

from tests.docs.pages import DOCS, LANGUAGES
from tests.perf import budgets
from tests.perf.budgets import Budget

DECLARED = [each for each in vars(budgets).values() if isinstance(each, Budget)]
TITLES = ("budget", "预算")


def listed(text: str) -> list[float]:
    """Return the numbers in the columns of budgets of a page's tables, from above."""
    column, found = None, []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if title := next((cell for cell in cells if cell in TITLES), None):
            column = cells.index(title)
        elif not line.startswith("|"):
            column = None
        elif column is not None:
            found += [float(number.replace(",", "")) for number in re.findall(r"\d[\d,]*(?:\.\d+)?", cells[column])]
    return found


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_has_every_budget_in_the_order_of_its_declaration(language: str) -> None:
    text = (DOCS / language / "trust" / "performance.md").read_text(encoding="utf-8")
    assert listed(text) == [budget.limit for budget in DECLARED]


def test_a_limit_is_kept_by_what_is_just_at_it_and_by_nothing_beyond() -> None:
    most, least = Budget("time", 2, "s"), Budget("speed", 2, "MB/s", least=True)
    assert [most.keeps(value) for value in (1.9, 2, 2.1)] == [True, True, False]
    assert [least.keeps(value) for value in (1.9, 2, 2.1)] == [False, True, True]
    assert most.row(2.5, "busy") == ("time", "2.5 s (busy)", "<= 2 s", False)
