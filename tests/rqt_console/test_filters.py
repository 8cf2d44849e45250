"""The console's filters, and its files."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from day6_core.reason import reason
from day6_core.ros.programs.rqt_console import files, kept, model
from day6_core.ros.programs.rqt_console.filters import Filter, FilterChoice
from day6_core.ros.programs.rqt_console.model import Console, Record
from tests.support.stepped_machine import SteppedMachine

RECORDS = (
    Record(1, "Oh no! I hit the wall!", 30, "turtlesim", 5_000_000_000, "./_turtle_interface.py:_clamp:97"),
    Record(2, "Publishing: 'Hello World: 1'", 20, "talker", 6_000_000_000, "talker.py:tick:7"),
    Record(3, 'two\nlines, a "quoted" one; and 海龟', 40, "talker", 7_000_000_001, ""),
)


def left(choice: FilterChoice) -> list[int]:
    return [record.number for record in RECORDS if choice.shows(record)]


@pytest.mark.parametrize(
    ("excluded", "numbers"),
    [
        (Filter("message", "wall"), [2, 3]),
        (Filter("message", "WALL"), [1, 2, 3]),  # as in the real one a text is looked for as it is
        (Filter("message", r"World: \d$"), [1, 2, 3]),
        (Filter("message", r"World: \d'$", is_regex=True), [1, 3]),
        (Filter("message", "^two.*one", is_regex=True), [1, 2]),  # over the end of a line
        (Filter("message", "(wall", is_regex=True), [1, 2, 3]),
        (Filter("severity", levels=frozenset((20, 40))), [1]),
        (Filter("node", nodes=frozenset(("talker",))), [1]),
        (Filter("time", start_ns=6_000_000_000), [1]),
        (Filter("time", start_ns=5_500_000_000, stop_ns=6_500_000_000), [1, 3]),
        (Filter("location", "tick"), [1, 3]),
        (Filter("location", r"^\./", is_regex=True), [2, 3]),
        (Filter("custom", "World", levels=frozenset((40,))), [1, 2, 3]),
        (Filter("custom", "World", levels=frozenset((20,)), nodes=frozenset(("talker",))), [1, 3]),
        (Filter("custom"), [1, 2, 3]),
        (Filter("node", nodes=frozenset(("talker",)), enabled=False), [1, 2, 3]),
    ],
)
def test_a_filter_leaves_out_what_it_means(excluded: Filter, numbers: list[int]) -> None:
    assert left(FilterChoice((excluded,))) == numbers


def test_several_filters_each_leave_something_out() -> None:
    choice = FilterChoice((Filter("message", "wall"), Filter("message", "lines")))
    assert left(choice) == [2]
    assert left(choice.with_filter("excludes", 0, None)) == [1, 2]


def test_only_what_stands_out_is_shown_if_one_wants_that() -> None:
    choice = FilterChoice(highlights=(Filter("message", "wall"), Filter("severity", levels=frozenset((40,)))))
    assert [record.number for record in RECORDS if choice.is_highlighted(record)] == [1, 3]
    assert left(choice) == [1, 2, 3]
    assert left(replace(choice, only_highlighted=True)) == [1, 3]
    assert left(FilterChoice(only_highlighted=True)) == [1, 2, 3]


def test_a_wrong_regular_expression_says_what_is_wrong_and_none_can_hang() -> None:
    assert "missing )" in Filter("message", "(wall", is_regex=True).problem
    assert not Filter("message", "(wall").problem
    hard = replace(RECORDS[0], text="a" * 3000)
    assert not Filter("message", "(a|a)*b", is_regex=True).matches(hard)


def test_a_costly_expression_is_looked_for_in_slices(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(model, "SLICE_SECONDS", -1.0)
    console = Console()
    console.take_loaded(replace(RECORDS[number % 3], number=number) for number in range(1, 301))
    counts = []
    while console.is_behind:
        counts.append(len(console.shown()))
    assert counts == [100, 200, 300] and not console.is_behind
    console.toggle_node("talker")
    assert console.is_behind and len(console.shown()) < 100


def test_a_file_is_the_real_ones_and_comes_back() -> None:
    text = files.written(RECORDS)
    assert text.splitlines()[:3] == [
        "message;severity;node;stamp;location",
        '"Oh no! I hit the wall!";"30";"turtlesim";"5.000000000";"./_turtle_interface.py:_clamp:97"',
        '"Publishing: \'Hello World: 1\'";"20";"talker";"6.000000000";"talker.py:tick:7"',
    ]
    assert files.read(text) == (list(RECORDS), [])


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ('"x";"25";"n";"1.0";"l"', "Unknown severity value: 25"),
        ('"x";"20";"n";"1";"l"', "Unknown timestamp format: 1"),
        ('"x";"20"', "2 of 5 columns"),
    ],
)
def test_rows_that_are_none_are_skipped_and_told(row: str, reason: str) -> None:
    good = '"y";"20";"n";"1.000000002";"l"'
    found = files.read(f"message;severity;node;stamp;location\n{row}\nrubbish\n\n{good}\n")
    assert [record.text for record in found.records] == ["y"] and found.skipped == [reason]
    assert found.records[0].stamp_ns == 1_000_000_002


def test_a_file_of_anything_else_is_refused() -> None:
    with pytest.raises(ValueError, match="missing file header"):
        files.read("a,b\n1,2\n")


def test_saving_and_loading(tmp_path: Path) -> None:
    machine = SteppedMachine()
    try:
        machine.start("rqt_console", "rqt_console", screen=True, home=tmp_path)
        console = machine.display.windows[0].model
        for text in ("one", "two"):
            machine.node.get_logger().warning(text)
        machine.advance(0.1)
        assert console.save("log", console.shown()) == tmp_path / "log.csv"
        console.clear()
        console.load("log.csv")
        machine.until(lambda: bool(console.message))
        assert [(each.text, each.severity) for each in console.shown()] == [("one", "Warn"), ("two", "Warn")]
        assert console.paused
        console.load("nowhere")
        with pytest.raises(FileNotFoundError) as error:
            Path("nowhere").read_bytes()
        machine.until(lambda: reason(error.value) in console.message)
    finally:
        machine.end()


def test_a_perspective_keeps_the_filters() -> None:
    before, after = Console(), Console()
    before.set_filter("excludes", 1, Filter("message", "wa.l", is_regex=True))
    before.set_filter("highlights", 1, Filter("time", start_ns=7, stop_ns=9, enabled=False))
    before.toggle_level(20)
    before.toggle_paused()
    before.show_highlighted_only(True)
    kept.take_settings(after, kept.kept_settings(before))
    assert after.choice == before.choice and after.paused
    kept.take_settings(after, {"filters": [3, {"side": "excludes", "kind": "message", "text": 7}, {"side": "x"}]})
    assert after.choice.excludes == (Filter("message"),)


def test_what_loads_is_behind_what_is_here() -> None:
    console = Console()
    console.receive(SimpleNamespace(stamp=SimpleNamespace(sec=1, nanosec=0), level=20, name="n", msg="x", file="",
                                    function="", line=0))  # fmt: skip
    console.take_loaded(RECORDS)
    assert [each.number for each in console.shown()] == [1, 2, 3, 4]
