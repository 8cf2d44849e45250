"""A test of many folded cases runs each of them, names each that fails with its difference, and never passes without one."""

from __future__ import annotations

import pytest

from tests.support.folded import SHOWN, folded


def failure_of(test) -> list[str]:
    with pytest.raises(pytest.fail.Exception) as caught:
        test()
    return str(caught.value).splitlines()


def test_every_case_is_run_and_each_that_fails_is_told_with_its_difference() -> None:
    seen = []

    @folded("first, second", [(1, 1), (1, 2), (3, 3), (4, 5)], ids=lambda case: f"case {case[0]}-{case[1]}")
    def test(first: int, second: int) -> None:
        seen.append(first)
        assert first == second

    told = failure_of(test)
    assert seen == [1, 1, 3, 4]
    assert told[0] == "2 of 4 cases failed"
    assert [line for line in told if line.startswith("--")] == ["-- case 1-2", "-- case 4-5"]
    assert [line for line in told if line.startswith("E ")] == ["E   assert 1 == 2", "E   assert 4 == 5"]
    assert sum("in test" in line for line in told) == 2, "the place, once for each"


def test_where_all_is_well_it_passes() -> None:
    @folded("value", range(3))
    def test(value: int) -> None:
        assert value < 3

    test()


def test_without_a_case_it_fails() -> None:
    @folded("value", [])
    def test(value: int) -> None:
        raise AssertionError("is not called")

    assert failure_of(test) == ["0 of 0 cases failed"]


@pytest.mark.parametrize("outcome", [pytest.skip, pytest.xfail, pytest.fail])
def test_a_case_cannot_get_away(outcome) -> None:
    @folded("value", ["a", "b"])
    def test(value: str) -> None:
        if value == "b":
            outcome("no more")

    told = failure_of(test)
    assert told[:2] == ["1 of 2 cases failed", "-- 'b'"] and "no more" in told[-1]


def test_one_case_can_be_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []
    test = folded("value", ["one", "two"])(lambda value: seen.append(value))
    monkeypatch.setenv("PYTEST_CASE", "wo")
    test()
    assert seen == ["two"]
    monkeypatch.setenv("PYTEST_CASE", "three")
    assert failure_of(test) == ["0 of 0 cases failed"]


def test_of_very_many_failures_the_names_are_told() -> None:
    @folded("value", range(SHOWN + 5))
    def test(value: int) -> None:
        raise AssertionError

    told = failure_of(test)
    assert sum(line.startswith("-- ") for line in told) == SHOWN + 5
    assert sum(line.startswith("E ") for line in told) == SHOWN


@folded("number", [1, 2])
def test_fixtures_are_given_besides(tmp_path, number: int) -> None:
    assert tmp_path.is_dir() and number in (1, 2)
