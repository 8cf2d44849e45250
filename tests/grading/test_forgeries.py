"""More than a hundred things that are no solution are not taken for one, each for its own reason; a good submission passes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from day6_core.lessons.grading.grades import Grade, Graded
from day6_core.lessons.grading.scenarios import gradings
from tests.grading.article import Patient, write
from tests.grading.forgeries import ALL, GROUPS, Forgery, together

AT_A_TIME = 8
"""Submissions of each group that are graded at once; more would slow down the tests that run beside."""


def _submissions(folder: Path, group: str) -> Iterator[tuple[Path, list[Forgery]]]:
    """Pack the submissions."""
    for number, spoiled in enumerate(together(group)):
        changed: dict[str, str | None] = {}
        for forgery in spoiled:
            changed.update(forgery.files)
        yield write(folder / f"{group}-{number}.zip", changed), spoiled


class _Spoiled(Patient):
    """Plays of each submission only what its forgeries spoil, and what that needs."""

    def __init__(self, lessons: tuple[str, ...], spoiled: Mapping[Path, list[Forgery]]) -> None:
        chosen = [each for each in gradings() if each.lesson in lessons]
        super().__init__(chosen, answers={})
        self._needs = {(each.lesson, one.name): one.needs for each in chosen for one in each.scenarios}
        self._spoiled = spoiled

    def _play(self, graded: Graded, *_: object) -> None:
        wanted: dict[str, list[str]] = {}
        for each in self._spoiled[graded.file]:
            wanted.setdefault(each.lesson, []).extend((*self._needs[each.lesson, each.scenario], each.scenario))
        super()._play(graded, wanted)


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Grade]:
    """How the spoiled scenario of every forgery went, by the forgery's id."""
    folder = tmp_path_factory.mktemp("forged")

    def graded(group: str) -> dict[str, Grade]:
        packed = dict(_submissions(folder, group))
        return {
            forgery.id: result
            for each in _Spoiled(GROUPS[group][0], packed).grade(list(packed), AT_A_TIME)
            for forgery in packed[each.file]
            for result in each.results
            if (result.lesson, result.scenario) == (forgery.lesson, forgery.scenario)
        }

    with ThreadPoolExecutor() as pool:
        return {name: result for found in pool.map(graded, GROUPS) for name, result in found.items()}


@pytest.mark.process
@pytest.mark.parametrize("forgery", ALL, ids=lambda forgery: forgery.id)
def test_it_is_refused_for_its_reason(forgery: Forgery, seen: dict[str, Grade]) -> None:
    result = seen[forgery.id]
    said = " ".join(f"{wanted['en']} {saw['en']}" for wanted, saw in result.problems)
    assert not result.passed
    assert re.search(forgery.reason, said), said
    assert "Traceback" not in said


def test_there_are_more_than_a_hundred() -> None:
    every = [forgery.id for _, parts in GROUPS.values() for part in parts for forgery in part if forgery is not None]
    assert len(set(every)) == len(every) > 100
