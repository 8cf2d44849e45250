"""What the table of platforms claims: every feature goes here, and nothing else than what was recorded stands in the table."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.docs import reference
from tests.platforms import rows
from tests.platforms.features import FEATURES, REASONS, Feature
from tests.platforms.play import YES, play
from tests.support.short_folder import make_short_folder

NAME = ("a try", "试一试")


@pytest.mark.person
@pytest.mark.parametrize("feature", FEATURES, ids=lambda feature: feature.key)
def test_a_feature_does_on_this_machine_what_it_says(feature: Feature, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DAY6_LINK")  # with which tests keep programs alone
    assert play(feature, make_short_folder()) == YES


@pytest.mark.process
@pytest.mark.parametrize(
    ("typed", "result"),
    [
        ("$ day6-tui --version\nnothing like that", "fails: "),
        ("$ day6-tui no-such-command", "fails: "),
        ('$ day6-tui exec -c "echo bags need lz4, which isn\\\'t installed; false"', "no: "),
    ],
)
def test_what_does_not_come_is_no_success(typed: str, result: str, tmp_path: Path) -> None:
    assert play(Feature("try", NAME, typed), tmp_path).startswith(result)


def test_what_was_recorded_is_of_features_that_there_are() -> None:
    recorded = rows.recorded()
    assert len({row.label for row in recorded}) == len(recorded)
    for row in recorded:
        assert row.cells.keys() <= {feature.key for feature in FEATURES}, row.name
        assert {cell.partition(":")[0] for cell in row.cells.values()} <= {YES, "no", "fails"}, row.name


@pytest.mark.parametrize(
    ("cells", "shown"),
    [
        ({}, "never run"),
        ({"pixels": "yes"}, "yes"),
        ({"pixels": "fails: waited for the turtle"}, "fails"),
        ({"pixels": "no: Pictures of pixels need pillow, which isn't installed: pip install pillow"}, "needs pillow"),
        ({"pixels": "no: serve needs Unix sockets and pseudo-terminals: Linux or macOS"}, REASONS[-1][1][0]),
    ],
)
def test_a_cell_says_what_was_seen_and_one_never_tried_says_that(
    cells: dict[str, str], shown: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    row = rows.Row("macOS arm64", "macOS 15", "3.12.1", "", "2026-11-29", "9b60b7ff", cells)
    monkeypatch.setattr(reference, "recorded", lambda: [row])
    line = next(line for line in reference.runs("en").splitlines() if "(`pixels`)" in line)
    assert line.split(" | ")[1:] == [shown, "never run", "never run |"], line


def test_a_row_takes_the_place_of_that_of_the_same_system(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rows, "RUNS", tmp_path / "runs.json")
    rows.RUNS.write_text("[]", encoding="utf-8")
    row = rows.Row("Linux x86_64", "Debian 12", "3.11.7", "", "2026-11-29", "9b60b7ff", {"version": "yes"})
    for each in (row, row._replace(lacks="pillow"), row._replace(date="later", cells={"doctor": "yes"})):
        rows.record(each)
    assert [each.date for each in rows.recorded()] == ["later", row.date]
    assert [*rows.recorded()[0].cells] == ["version", "doctor"]
    rows.record(row._replace(commit="another", cells={"doctor": "yes"}))
    assert [*rows.recorded()[0].cells] == ["doctor"]
