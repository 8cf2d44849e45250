"""What a machine that does not keep up makes of marks, what ended a submission, and what is written: without any process."""

from __future__ import annotations

import asyncio
import csv
import io
import json
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core.lessons import lag
from day6_core.lessons.grading import command, remarks, reports, shield
from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.grades import Grade, Graded
from day6_core.lessons.grading.marks import Mark, Seen
from day6_core.lessons.grading.scenarios import gradings, longest
from day6_core.lessons.lag import Lag, worst_of
from day6_core.lessons.texts import Say

DAY3 = [each for each in gradings() if each.lesson == "day3"]
SOME = Seen(Say("grade.build", name="a"), Say("grade.build_none"))
CALM, LATE = [0.03, 0.2], [0.4, 0.5]


def begins(scenario: str, at: float = 0.0) -> dict[str, Any]:
    return {"lesson": "day3", "scenario": scenario, "began": at}


def ends(scenario: str, mark: Mark, lagged: list[float] = CALM, cpu: float = 0.1, at: float = 10.0) -> dict[str, Any]:
    checks = [Seen(SOME.asked, ok=True, at=1.0).data() if mark is Mark.RIGHT else SOME.data()]
    return {
        "lesson": "day3", "scenario": scenario, "mark": mark.value, "points": float(mark is Mark.RIGHT), "checks": checks,
        "seconds": 10.0, "ended": at, "lag": lagged, "cpu": cpu, "timed": True,
    }  # fmt: skip


def end(how: str = "", stalls: list[list[float]] | None = None) -> dict[str, Any]:
    return {"ended": how, "stalls": stalls or [], "shield": "whole"}


PUPIL = {"pupil": "anna", "answers": {}}
ELSEWHERE = [begins("elsewhere"), ends("elsewhere", Mark.RIGHT)]


class Told(Grader):
    """A grader to whom is told what wardens say, play by play."""

    def __init__(self, *plays: list[dict[str, Any]]) -> None:
        super().__init__(DAY3, answers={})
        self._plays = list(plays)
        self.asked: list[Mapping[str, Any]] = []

    def _said(self, file: Path, chosen: Mapping[str, Any]) -> list[dict[str, Any]]:
        self.asked.append(chosen)
        return self._plays.pop(0)

    def one(self) -> tuple[Graded, list[int]]:
        """The only submission, and how many were played again."""
        again: list[int] = []
        told: list[Graded] = []
        (graded,) = self.grade([Path("a.zip")], 1, told.append, again.append)
        assert told == [graded]
        return graded, again


def marks(graded: Graded) -> list[tuple[str, float]]:
    return [(each.mark.value, each.points) for each in graded.results]


RIGHT, WRONG, UNPLAYED = ("right", 1.0), ("wrong", 0.0), ("unplayed", 0.0)


@pytest.mark.parametrize(
    ("lagged", "stalls", "cpu", "again"),
    [
        (CALM, [], 0.1, False),
        (LATE, [], 0.1, True),
        ([0.05, 0.6], [], 0.1, True),  # never long, but again and again
        (CALM, [[5.0, 0.3]], 0.1, True),  # not the world, but who else waited for the machine
        (CALM, [[15.0, 0.3]], 0.1, False),  # not while it was played
        (LATE, [], 1000.0, False),  # its own programs took all cores
    ],
)
def test_what_is_wrong_while_the_machine_lagged_is_played_again(
    lagged: list[float], stalls: list[list[float]], cpu: float, again: bool
) -> None:
    first = [PUPIL, *ELSEWHERE, begins("other-turtle"), ends("other-turtle", Mark.WRONG, lagged, cpu), end("", stalls)]
    grader = Told(first, [PUPIL, begins("other-turtle"), ends("other-turtle", Mark.RIGHT), end()])
    graded, replayed = grader.one()
    assert replayed == [1] * again
    assert marks(graded) == [RIGHT, RIGHT if again else WRONG]
    if again:
        assert grader.asked[1]["only"] == {"day3": ["other-turtle"]}
        assert grader.asked[1]["passed"] == {"day3": ["elsewhere"]}


@pytest.mark.parametrize(("second", "mark"), [(LATE, UNPLAYED), (CALM, WRONG)])
def test_what_lags_again_is_not_played_and_never_wrong(second: list[float], mark: tuple[str, float]) -> None:
    needs = Seen(Say("grade.needs", name="elsewhere"), Say("grade.needs_saw"))
    waits = {**ends("other-turtle", Mark.UNPLAYED), "checks": [needs.data()]}
    plays = [
        [PUPIL, begins("elsewhere"), ends("elsewhere", Mark.WRONG, lagged), begins("other-turtle"), waits, end()]
        for lagged in (LATE, second)
    ]
    grader = Told(*plays)
    graded, _ = grader.one()
    assert marks(graded) == [mark, UNPLAYED]
    assert grader.asked[1]["only"] == {"day3": ["elsewhere", "other-turtle"]}  # the second waits for the first
    busy = Seen(Say("grade.busy"), Say("grade.busy_saw", seconds="0.4")).data()
    assert (graded.results[0].checks == [busy]) is (mark == UNPLAYED)


def test_what_time_does_not_matter_for_is_not_played_again() -> None:
    said = {**ends("elsewhere", Mark.WRONG, LATE), "timed": False}
    graded, again = Told(
        [PUPIL, begins("elsewhere"), said, begins("other-turtle"), ends("other-turtle", Mark.RIGHT), end()]
    ).one()
    assert (marks(graded), again) == ([WRONG, RIGHT], [])


def test_what_is_right_stays_right_however_busy_the_machine_was() -> None:
    said = [begins("elsewhere"), ends("elsewhere", Mark.RIGHT, LATE), begins("other-turtle")]
    graded, again = Told([PUPIL, *said, ends("other-turtle", Mark.RIGHT, LATE), end()]).one()
    assert (marks(graded), again) == ([RIGHT, RIGHT], [])


@pytest.mark.parametrize(
    ("how", "mark"),
    [("time", "late"), ("memory", "wrong"), ("processes", "wrong"), ("killed", "wrong"), ("", "wrong")],
)
def test_what_ended_it_marks_what_was_played_then_and_the_rest_was_not_played(how: str, mark: str) -> None:
    graded, _ = Told([PUPIL, begins("elsewhere", time.monotonic()), end(how)]).one()
    assert marks(graded) == [(mark, 0.0), UNPLAYED]
    assert all(each.problems for each in graded.results)


def test_a_fault_of_the_grader_is_nobodys_mistake() -> None:
    graded, _ = Told([PUPIL, begins("elsewhere", time.monotonic()), {"problem": "KeyError: x"}, end()]).one()
    assert marks(graded) == [UNPLAYED, UNPLAYED]
    assert "KeyError: x" in graded.results[0].problems[0][1]["en"]


def test_the_time_limit_is_what_the_scenarios_may_take() -> None:
    for grading in gradings():
        assert longest([grading]) >= sum(scenario.within for scenario in grading.scenarios)
        assert all(scenario.longest > scenario.within for scenario in grading.scenarios)
    assert Grader(DAY3, answers={})._seconds == longest(DAY3)
    assert longest(gradings()) > longest(DAY3)


def test_the_worlds_clock_is_compared_with_the_walls(monkeypatch: pytest.MonkeyPatch) -> None:
    """A session whose sleeps take longer and longer."""
    wall = 0.0
    monkeypatch.setattr(lag.time, "monotonic", lambda: wall)
    sleeps = iter((0.05, 0.06, 0.35))

    async def sleep(seconds: float) -> None:
        nonlocal wall
        took = next(sleeps, None)
        if took is None:
            raise asyncio.CancelledError
        wall += took

    found = Lag()
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(found.watch(SimpleNamespace(sleep=sleep)))  # type: ignore[arg-type]
    assert (round(found.worst, 3), round(found.total, 3)) == (0.3, 0.31)
    assert worst_of(10.0, found, [], 0.0, 0.12) == 0.3
    assert worst_of(10.0, found, [], 0.0) == worst_of(10.0, Lag(0.1, 0.2), [0.05], 0.0, 0.12) == 0.0
    assert worst_of(0.1, Lag(0.02, 0.04), [0.03], 0.0, 0.12) == 0.0  # short, and hardly late


@pytest.mark.skipif(sys.platform == "win32", reason="nothing is graded on Windows")
def test_who_wants_a_core_and_gets_none_is_late(monkeypatch: pytest.MonkeyPatch) -> None:
    """One process runs at each look, but gets a core only at first; another sleeps."""
    wall = 0.0

    def sleep(seconds: float) -> None:
        nonlocal wall
        wall += seconds

    worked = {7: iter([(True, 0.0), (True, 0.15), (True, 0.16), (False, 0.16)]), 8: iter([(False, 0.0)] * 4)}
    reaped = iter([(0, 0), (0, 0), (0, 0), (0, 0), (5, 0)])
    monkeypatch.setattr(shield, "_worked", lambda pid: next(worked[pid]))
    monkeypatch.setattr(shield, "own_memory", lambda _: 0)
    monkeypatch.setattr(shield, "waitpid", lambda *_: next(reaped))
    monkeypatch.setattr(shield, "_monotonic", lambda: wall)
    monkeypatch.setattr(shield, "_sleep_beside", lambda _, seconds: sleep(seconds))
    late: list[float] = []
    assert shield.watch(5, 60.0, lambda: [7, 8], lambda seconds: late.append(round(seconds, 2))) == ""
    assert late == [0.0, 0.0, 0.14, 0.0]


@pytest.mark.skipif(sys.platform == "win32", reason="nothing is graded on Windows")
@pytest.mark.parametrize(
    ("runs", "own_seconds", "ended"), [(True, True, ""), (True, False, "time"), (False, True, "time")]
)
def test_seconds_in_which_a_submission_waits_for_a_core_may_be_left_out(
    monkeypatch: pytest.MonkeyPatch, runs: bool, own_seconds: bool, ended: str
) -> None:
    """It gets a hundredth of the time in which it could run; what it sleeps is its own."""
    wall = 0.0

    def sleep(seconds: float) -> None:
        nonlocal wall
        wall += seconds

    monkeypatch.setattr(shield, "_worked", lambda pid: (runs, wall / 100))
    monkeypatch.setattr(shield, "own_memory", lambda _: 0)
    monkeypatch.setattr(shield, "waitpid", lambda *_: (5, 0) if wall > 100 else (0, 0))
    monkeypatch.setattr(shield, "_monotonic", lambda: wall)
    monkeypatch.setattr(shield, "_sleep_beside", lambda _, seconds: sleep(seconds))
    assert shield.watch(5, 60.0, lambda: [7], lambda _: None, own_seconds=own_seconds) == ended


# -- what is written ---------------------------------------------------------------------------------------------------

EVIL = '=HYPERLINK("http://x")'


def some() -> list[Graded]:
    where = Say("trail.where", corner=3, x="5.5", y="8.2", slack="0.2", seen_x="5.9", seen_y="8.1", seconds="12.0")
    wrong = Seen(Say("trail.driven", turtle="turtle1", shape=Say("shape.pentagram")), Say("trail.saw_little"), where)
    elsewhere = Grade("day3", "elsewhere", DAY3[0].scenarios[0].title, Mark.WRONG, 0.4, checks=[wrong.data()])
    other = Grade("day3", "other-turtle", DAY3[0].scenarios[1].title)
    other.conclude(Mark.UNPLAYED, Say("grade.busy"), Say("grade.busy_saw", seconds="2"))
    return [
        Graded(Path("a.zip"), EVIL, results=[elsewhere, other]),
        Graded(Path("b.zip"), refused={"zh": "坏", "en": "bad"}),
    ]


def test_lines_say_what_was_asked_what_was_seen_and_where_they_differ() -> None:
    first, second = reports.data_of(some(), {"a.zip": "Nearly!"})["submissions"]
    assert reports.in_text(first, "en").splitlines() == [
        'a.zip  =HYPERLINK("http://x")  0.4 of 2; not played: 1',
        "    Remark: Nearly!",
        "    day3 elsewhere: The turtle starts elsewhere, facing another way  [wrong, 0.4 of 1]",
        "        asked: turtle1 has drawn a pentagram by driving, without teleports",
        "        seen:  There is no straight line yet.",
        "        where: corner 3: asked (5.5, 8.2) ± 0.2 m, seen (5.9, 8.1) after 12.0 s",
        "    day3 other-turtle: A turtle with another name draws it, too  [not played, 0 of 1]",
        "        asked: the machine keeps up with the scenario",
        f"        seen:  {Say('grade.busy_saw', seconds='2').text('en')}",
    ]
    assert "应在 (5.5, 8.2) ± 0.2 米" in reports.in_text(first, "zh")
    assert reports.in_text(second, "zh") == "b.zip  没有收：坏"


def test_everything_is_made_of_one_plain_structure() -> None:
    data = reports.data_of(some(), {"a.zip": "well <done>"}, seed="s")
    again = json.loads(reports.as_json(data))
    assert again == data
    total = Say("grade.total", count=2, seconds=1, jobs=1, seed="s")
    for language in ("zh", "en"):
        assert reports.as_csv(again, language, {}) == reports.as_csv(data, language, {})
        assert reports.as_page(again, language, total) == reports.as_page(data, language, total)


def test_the_table_is_a_row_for_each_submission_without_a_formula() -> None:
    words = {"a.zip": "-1: too late", "gone.zip": "see me"}
    data = reports.data_of(some(), words)
    rows = list(csv.DictReader(io.StringIO(reports.as_csv(data, "en", words).decode("utf-8-sig"))))
    assert [row["file"] for row in rows] == ["a.zip", "b.zip", "gone.zip"]
    first = rows[0]
    assert (first["points"], first["most"], first["unplayed"]) == ("0.4", "2.0", "1")
    assert (first["day3 elsewhere points"], first["day3 elsewhere mark"]) == ("0.4", "wrong")
    assert "corner 3: asked" in first["day3 elsewhere why"]
    assert not any(cell.startswith(("=", "+", "-", "@")) for row in rows for cell in row.values())


def test_the_page_is_whole_escaped_and_in_both_languages() -> None:
    page = reports.as_page(
        reports.data_of(some(), {"a.zip": "<script>1</script>"}), "zh", Say("grade.stopped")
    ).decode()
    assert "<script" not in page and "&lt;script&gt;" in page and "src=" not in page and "href=" not in page
    assert 'id="zh" checked' in page and 'id="en"' in page
    for text in ("第 3 个角：应在", "corner 3: asked", "没有运行", "not played", "坏", "bad"):
        assert text in page


@pytest.mark.parametrize("coding", ["utf-8-sig", "utf-8", "gb18030"])
@pytest.mark.parametrize("sign", [",", ";", "\t"])
def test_the_teachers_words_stay_as_spreadsheets_save_them(coding: str, sign: str, tmp_path: Path) -> None:
    words = {"a.zip": "画得好，-1", "gone.zip": '说 "好"; 再来'}
    path = tmp_path / "marks.csv"
    for _ in range(3):
        data = reports.data_of(some(), words)
        rows = list(csv.reader(io.StringIO(reports.as_csv(data, "zh", words).decode("utf-8-sig"))))
        text = io.StringIO()
        csv.writer(text, delimiter=sign).writerows(rows)
        path.write_bytes(text.getvalue().encode(coding))
        assert remarks.read(path) == words


@pytest.mark.skipif(sys.platform == "win32", reason="nothing is graded on Windows")
def test_the_teachers_words_stay_when_graded_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """They are written while it is graded, too, and for a pupil who hands in nothing the next time."""
    table, page, everything = (tmp_path / f"marks.{kind}" for kind in ("csv", "html", "json"))
    words = ["grade", str(tmp_path / "a.zip"), "--lesson", "day3", "--lang", "en", "--force"]
    words += ["--csv", str(table), "--html", str(page), "--json", str(everything)]
    written: list[str] = []

    class Quick(Grader):
        def grade(self, files: list[Path], jobs: int, told: Any = None, again: Any = None) -> list[Graded]:
            if written:
                rows = list(csv.reader(io.StringIO(table.read_text(encoding="utf-8-sig"))))
                rows[1][rows[0].index("remark")] = written.pop()
                with table.open("w", encoding="utf-8-sig", newline="") as file:
                    csv.writer(file).writerows([*rows, ["gone.zip", "", "", "", "", "see me"]])
            found = some()
            told(found[0])
            return found

    monkeypatch.setattr(command, "Grader", Quick)
    for remark in ("", "=1+1 well done", ""):
        written += [remark] if remark else []
        assert command.main(words) == 1
    assert remarks.read(table) == {"a.zip": "=1+1 well done", "gone.zip": "see me"}
    assert "'=1+1 well done" in table.read_text(encoding="utf-8-sig")
    assert "well done" in page.read_text(encoding="utf-8")
    assert json.loads(everything.read_text(encoding="utf-8"))["submissions"][0]["remark"] == "=1+1 well done"
    assert "Remark: =1+1 well done" in capsys.readouterr().out


@pytest.mark.parametrize("text", [b"PK\x03\x04\xff\xfe\0\0", b"name,words\r\na,b\r\n", b'file,remark\r\n"a'])
def test_a_file_whose_words_cannot_be_read_is_left_alone(text: bytes, tmp_path: Path) -> None:
    path = tmp_path / "marks.csv"
    path.write_bytes(text)
    with pytest.raises(remarks.Unreadable):
        remarks.read(path)
    assert remarks.read(tmp_path / "none.csv") == remarks.read(None) == {}
