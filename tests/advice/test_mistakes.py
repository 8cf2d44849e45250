"""Each mistake of the corpus is made at a whole machine, in both languages, and what is told is judged (`corpus.py`)."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from day6_core.language import LANGUAGES
from day6_core.ros.environment import program_environment
from tests.advice.corpus import Family, Mistake, Typed, below, families, judged, mistakes, play, recorded
from tests.advice.recorded_outputs import RECORDED, recordable, told_again
from tests.advice.recorded_outputs import outputs as outputs_recorded
from tests.inspector.lab import Lab
from tests.support.own_places import own_places

LEAST = 150
RIGHT = 0.95
"""The share of mistakes whose true cause is named; no other may mislead."""


@pytest.fixture
def lab(language: str, short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Lab]:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "r"))
    monkeypatch.setenv("DAY6_LINK", "on")
    monkeypatch.setenv("DAY6_LANG", language)
    with closing(Lab(short_folder / "home")) as made:
        yield made


@pytest.mark.process
@pytest.mark.parametrize(
    ("mistake", "language"),
    [pytest.param(each, LANGUAGES[number % len(LANGUAGES)], id=each.id) for number, each in enumerate(mistakes())],
)
def test_what_is_told_is_as_right_as_it_was_judged(lab: Lab, mistake: Mistake, language: str) -> None:
    told = play(lab, mistake.files, mistake.typed, language)
    assert judged(mistake, told, language) == recorded(mistake), f"{told}\n{mistake.right}\n{lab.screen()}"


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_told_of_recorded_outputs_is_as_right(tmp_path: Path, language: str) -> None:
    outputs, wrong = outputs_recorded(), []
    for mistake in recordable():
        variables = {**program_environment(), "DAY6_LANG": language}
        told = told_again(mistake, outputs[mistake.id], tmp_path / mistake.id, variables)
        if judged(mistake, told, language) != recorded(mistake):
            wrong.append(f"{mistake.id}: {told}, and not {mistake.right[language]}")
    assert not wrong, "\n".join(wrong)


def test_the_programs_that_are_recorded_are_those_there_are() -> None:
    assert outputs_recorded().keys() == {each.id for each in recordable()}
    assert not own_places(RECORDED.read_text(encoding="utf-8"))


@pytest.mark.process
@pytest.mark.parametrize("language", ["zh"])
@pytest.mark.parametrize("family", families(), ids=lambda each: each.name)
def test_the_programs_work_without_a_mistake(lab: Lab, family: Family, language: str) -> None:
    for number, (name, shows) in enumerate(family.shows.items()):
        play(lab, family.files, [Typed(number, f"python3 {name}", shows)], language)
        assert not list(below(lab)), name


def test_nearly_every_mistake_is_named_and_no_other_misleads() -> None:
    made = [each for each in mistakes() if not each.silent]
    assert len({each.id for each in mistakes()}) == len(mistakes()) and len(made) >= LEAST
    assert sum(recorded(each) == "right" for each in made) >= RIGHT * len(made)
