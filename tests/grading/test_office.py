"""submit, report and grade as a pupil and a teacher type them: what they write, what they refuse, in both languages."""

from __future__ import annotations

import csv
import io
import re
import sys
import zipfile
from pathlib import Path

import pytest

from day6_core.lessons.catalogue import HERE
from day6_core.lessons.grading import reports
from day6_core.lessons.grading.archive import unpack
from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.grades import Grade, Graded
from day6_core.lessons.grading.marks import Mark
from day6_core.lessons.grading.scenarios import gradings, read_grading
from day6_core.lessons.progress import FOLDER, Progress, StepDone, file_of, load, save
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.texts import TEXTS, Say
from day6_core.width import text_width
from day6_tui.main import main
from tests.grading.article import FILES, write
from tests.grading.own import own_gradings
from tests.grading.solutions import OTHERWISE

ONE, TWO = (step.name for step in read_lesson(HERE / "days" / "day1.md").steps[:2])


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """The home folder of a machine on which a pupil has worked and somebody else has begun."""
    home = tmp_path / "machine"
    for name, text in FILES.items():
        top, _, rest = name.partition("/")
        path = home / ("ros2_ws/src" if top == "src" else ".") / rest
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    (home / "ros2_ws" / "src" / "loose.py").write_text("print(1)\n")
    for folder in ("build", "install", "log"):
        (home / "ros2_ws" / folder).mkdir()
        (home / "ros2_ws" / folder / "out.txt").write_text("left by a build")
    progress = Progress("安娜", at={"day1": ONE})
    progress.note("day1", ONE, StepDone(solved=1_700_000_000.0, hints=2, seconds=90.0, refused=1, answers="cb"))
    progress.note("day1", TWO, StepDone(passed_over=True, hints=1, seconds=30.0))
    save(file_of(home, "安娜"), progress)
    return home


def test_what_is_handed_in_comes_out_again(home: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "anna.zip"
    assert main(["submit", "--home", str(home), "-o", str(target), "--lang", "zh"]) == 0
    assert "1 个回答" in capsys.readouterr().out
    submission = unpack(target, tmp_path / "out")
    assert (submission.pupil, submission.answers) == ("安娜", {"day1": {ONE: "cb"}})
    came = {path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*") if path.is_file()}
    assert {"star.py", "ros2_ws/src/loose.py", "ros2_ws/src/day6_publisher/setup.py"} <= came
    assert not any("out.txt" in name or ".config" in name for name in came)


def test_submit_leaves_what_is_no_submission_alone(
    home: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = tmp_path / "notes.zip"
    with zipfile.ZipFile(target, "w") as archive:
        archive.writestr("notes.txt", "mine")
    before = target.read_bytes()
    assert main(["submit", "--home", str(home), "-o", str(target), "--lang", "en"]) == 1
    assert "isn't a submission" in capsys.readouterr().err
    assert target.read_bytes() == before


def test_submit_says_what_is_missing(home: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    save(file_of(home, "ben"), Progress("ben"))
    target = str(tmp_path / "x.zip")
    for words, said in (
        (["--home", str(home)], "several pupils"),
        (["--home", str(home), "--pupil", "carl"], "no pupil 'carl'"),
        (["--home", str(home), "--pupil", "a\nb"], "cannot be displayed"),
        (["--home", str(tmp_path / "nobody")], "nothing to hand in"),
    ):
        assert main(["submit", *words, "-o", target, "--lang", "en"]) == 1
        assert said in capsys.readouterr().err
    assert not Path(target).exists()


def test_answers_are_kept_by_the_progress_file(tmp_path: Path) -> None:
    path = file_of(tmp_path, "anna")
    progress = Progress("anna")
    progress.note("day1", ONE, StepDone(refused=1, answers="c"))
    save(path, progress)
    progress.note("day1", ONE, StepDone(solved=5.0, refused=1, answers="cb"))
    save(path, progress)
    assert load(path).step("day1", ONE).answers == "cb"


# -- report ------------------------------------------------------------------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("language", ["zh", "en"])
def test_the_report_of_a_machine(language: str, home: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    evil = "<script>alert(1)</script>=1+1"
    progress = Progress(evil)
    progress.note("gone", "x", StepDone(solved=5.0))
    save(file_of(home, "evil"), progress)
    assert main(["report", "--home", str(home), "--lang", language]) == 0
    lines = capsys.readouterr().out.splitlines()
    starts = {text_width(line[: re.search(r"\d+/\d+", line).start()]) for line in lines if re.search(r"\d+/\d+", line)}
    assert len(starts) == 1  # one column, whatever stands before it
    page, table = tmp_path / "r.html", tmp_path / "r.csv"
    words = ["report", "--home", str(home), "--lang", language, "--html", str(page), "--csv", str(table)]
    assert main(words) == 0
    html = page.read_text(encoding="utf-8")
    assert "<script" not in html and "安娜" in html and "http://" not in html and "https://" not in html
    rows = list(csv.reader(io.StringIO(table.read_bytes().decode("utf-8-sig"))))
    anna = next(row for row in rows if row[0] == "安娜")
    assert anna[3:7] == ["1", "3", "1", "2.0"] and anna[7].startswith("2023-11-1")
    capsys.readouterr()
    before = page.read_bytes()
    assert main(words) == 1
    assert "--force" in capsys.readouterr().err and page.read_bytes() == before
    assert main([*words, "--force"]) == 0


def test_a_formula_is_no_formula_in_a_spreadsheet(home: Path, tmp_path: Path) -> None:
    save(file_of(home, "f"), Progress('=HYPERLINK("http://x")'))
    table = tmp_path / "r.csv"
    main(["report", "--home", str(home), "--csv", str(table)])
    rows = list(csv.reader(io.StringIO(table.read_bytes().decode("utf-8-sig"))))
    assert any(row[0].startswith("'=HYPERLINK") for row in rows)
    assert not any(cell.startswith(("=", "+", "@")) for row in rows for cell in row)


def test_a_progress_file_that_cannot_be_used_is_told(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (home / FOLDER / "bad.json").write_text("{")
    assert main(["report", "--home", str(home), "--lang", "en"]) == 1
    said = capsys.readouterr()
    assert "bad.json cannot be used" in said.err and "安娜" in said.out


def test_no_pupils_is_no_empty_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", "--home", str(tmp_path), "--lang", "en"]) == 1
    assert "no pupil has done a lesson" in capsys.readouterr().err


# -- grade -------------------------------------------------------------------------------------------------------------


@pytest.mark.skipif(sys.platform == "win32", reason="nothing is graded on Windows")
def test_bad_calls_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(write(tmp_path / "a.zip"))
    there = tmp_path / "there.csv"
    there.write_text("mine")
    book = tmp_path / "book.csv"
    book.write_bytes(b"PK\x03\x04\0")
    (tmp_path / "empty").mkdir()
    (tmp_path / "bad").mkdir()
    (tmp_path / "bad" / "x.md").write_text("---\ngrading: x\n---\n# one\n")
    for words, said in (
        ([file, "--lesson", "day9"], "no scenarios for 'day9'"),
        ([file, "--csv", str(there)], "--force"),
        ([file, "--json", str(there)], "--force"),
        ([file, "--csv", str(book), "--force"], "There may be words of yours in it"),
        ([file, "--scenarios", str(tmp_path / "empty")], "no scenario in"),
        ([file, "--scenarios", str(tmp_path / "bad")], "x.md:4: '## zh TITLE' is missing"),
        ([file, "--scenarios", str(tmp_path / "nowhere")], "Not a directory"),
        ([str(tmp_path / "empty")], "no such submission"),
    ):
        assert main(["grade", *words, "--lang", "en"]) == 2
        assert said in capsys.readouterr().err
    assert (there.read_text(), book.read_bytes()) == ("mine", b"PK\x03\x04\0")


@pytest.mark.process
def test_a_teachers_own_scenario_and_both_reports(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = own_gradings(tmp_path)
    good = "import sys\nprint('heard', sys.argv[1])\n"
    bad = "print('heard', 'abcdefghij', '<b>', chr(27) + '[31m')\nraise ValueError('\\x1b]0;title\\x07')\n"
    write(tmp_path / "<b>good&.zip", {"home/echo.py": good}, {"pupil": "<script>x</script>"})
    write(tmp_path / "bad.zip", {"home/echo.py": bad})
    (tmp_path / "worse.zip").write_text("no zip")
    page, table = tmp_path / "g.html", tmp_path / "g.csv"
    words = [
        "grade",
        str(tmp_path),
        "--scenarios",
        str(folder),
        "--html",
        str(page),
        "--csv",
        str(table),
        "--lang",
        "zh",
    ]
    assert main(words) == 1
    out = capsys.readouterr().out
    assert (
        "得分 1/1" in out
        and "得分 0/1" in out
        and "不是完好的 zip" in out
        and "Traceback" not in out
        and "\x1b" not in out
    )
    html = page.read_text(encoding="utf-8")
    assert "<script" not in html and "&lt;b&gt;good&amp;.zip" in html and "Traceback" not in html and "\x1b" not in html
    rows = list(csv.DictReader(io.StringIO(table.read_bytes().decode("utf-8-sig"))))
    assert {row["file"]: row["own prints mark"] for row in rows} == {
        "<b>good&.zip": "right", "bad.zip": "wrong", "worse.zip": ""
    }  # fmt: skip
    assert {row["file"]: bool(row["own prints why"] or row["refused"]) for row in rows} == {
        "<b>good&.zip": False, "bad.zip": True, "worse.zip": True
    }  # fmt: skip


@pytest.mark.process
def test_answers_are_compared_with_the_lesson_and_nothing_else_counts(tmp_path: Path) -> None:
    claims = {
        "answers": {"day4": {"one": "cb", "two": "a"}, "day5": {"one": "b"}},
        "solved": ["one", "two", "three"], "results": {"answers": True}, "passed": True,
    }  # fmt: skip
    file = write(tmp_path / "a.zip", {}, claims)
    (tmp_path / "x.md").write_text(
        "---\ngrading: day4\ntitle: {zh: a, en: b}\n---\n# one\n~~~yaml\ncheck: [{folder: ~/ros2_ws}]\n~~~\n## zh a\n## en b\n"
    )
    chosen = [read_grading(tmp_path / "x.md")]
    for right, passed in (
        ({"one": "b", "two": "a"}, True), ({"one": "c", "two": "a"}, False), ({"one": "b", "two": "a", "three": "a"}, False),
    ):  # fmt: skip
        graded = Grader(chosen, answers={"day4": right}).grade([file], 1)[0]
        result = next(each for each in graded.results if each.scenario == "answers")
        assert result.passed is passed
    assert "three" in result.problems[0][1]["en"]


@pytest.mark.process
def test_what_is_right_gets_all_points_in_whatever_way_it_is_done(tmp_path: Path) -> None:
    by_pose = OTHERWISE["by the pose"][1]
    files = [write(tmp_path / "good.zip"), write(tmp_path / "pose.zip", by_pose)]
    found = Grader(gradings(), answers={}).grade(files, 2)
    problems = {
        (each.lesson, each.scenario): each.problems for graded in found for each in graded.results if not each.passed
    }
    assert problems == {}
    for graded in found:
        assert graded.passed == len(graded.results) == sum(len(each.scenarios) for each in gradings())
        assert graded.data()["points"] == graded.data()["most"] == graded.passed


def test_the_same_seed_draws_the_same_and_another_one_does_not() -> None:
    scenarios = [scenario for grading in gradings() for scenario in grading.scenarios if scenario.values]
    assert len(scenarios) >= 8
    for scenario in scenarios:
        assert scenario.drawn("a") == scenario.drawn("a") != scenario.drawn("b")


@pytest.mark.parametrize(
    ("yaml", "said"),
    [
        ("check: []", "checks nothing"),
        ("check: [{nod: /a}]", "did you mean 'node'"),
        ("check: [{node: '@x@'}]", "@x@ is neither"),
        ("values: {x: letter}\ncheck: [{node: /a}]", "'x' is 'word'"),
        ("values: {x: [3, 1]}\ncheck: [{node: /a}]", "'x' is 'word'"),
        ("files: {p: ../star.py}\ncheck: [{node: /a}]", "begin with '~/'"),
        ("run: [{start: turtlesim}]\ncheck: [{node: /a}]", "start: 'PACKAGE EXECUTABLE'"),
        ("run: [{publish: {topic: /a}}]\ncheck: [{node: /a}]", "publish: needs fields and topic and type"),
        ("run: [{shout: x}]\ncheck: [{node: /a}]", "no action 'shout'"),
        ("needs: [before]\ncheck: [{node: /a}]", "no earlier scenario"),
        ("within: 1000\ncheck: [{node: /a}]", "within"),
        ("stall: 0\ncheck: [{node: /a}]", "stall: a number of seconds"),
        ("must: [nodes]\ncheck: [{node: /a}]", "no 'nodes' among the checks; did you mean 'node'"),
        ("check: [{trail: {driven: 1}}]", "'driven' has to be true or false, not 1"),
        ("checks: [{node: /a}]", "unknown key 'checks'"),
        ("check: [", "not YAML"),
    ],
)
def test_mistakes_of_scenario_files_have_their_line(yaml: str, said: str, tmp_path: Path) -> None:
    path = tmp_path / "x.md"
    path.write_text(
        f"---\ngrading: x\ntitle: {{zh: a, en: b}}\n---\n# one\n~~~yaml\n{yaml}\n~~~\n## zh a\n## en b\n",
        encoding="utf-8",
    )
    with pytest.raises(Exception, match=re.escape(said)) as error:
        read_grading(path)
    assert re.search(r"x\.md:\d+: ", str(error.value))


def test_every_text_is_there_in_both_languages() -> None:
    keys = [key for key in TEXTS if key.split(".")[0] in ("grade", "submit", "report", "office", "name")]
    assert len(keys) > 60
    for key in keys:
        english, chinese = TEXTS[key]
        assert (
            english and chinese and set(re.findall(r"\{(\w+)\}", english)) == set(re.findall(r"\{(\w+)\}", chinese))
        ), key
    for grading in gradings():
        assert grading.lesson.startswith("day")
        assert all(scenario.title["zh"] != scenario.title["en"] for scenario in grading.scenarios)


def test_the_page_says_what_was_refused(tmp_path: Path) -> None:
    refused = Graded(Path("<i>.zip"), refused={"zh": "坏了", "en": "broken <b>"})
    passed = Graded(Path("ok.zip"), results=[Grade("day4", "builds", {"zh": "编译", "en": "builds"}, Mark.RIGHT, 1.0)])
    page = reports.as_page(reports.data_of([refused, passed], {}), "en", Say("grade.stopped")).decode()
    assert "broken &lt;b&gt;" in page and "&lt;i&gt;.zip" in page and "坏了" in page
    assert '<td class="good"><span lang="zh">正确 1</span><span lang="en">right 1</span></td>' in page
