"""`report` and `grade` on what `serve` keeps of a class: all pupils, all days; homes are other people's files."""

from __future__ import annotations

import csv
import io
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from day6_core.classroom.homes import PupilHome, folder_name
from day6_core.lessons import collected
from day6_core.lessons.catalogue import HERE, offer
from day6_core.lessons.collected import collect
from day6_core.lessons.grading import command
from day6_core.lessons.grading.archive import unpack
from day6_core.lessons.progress import FOLDER, LARGEST, Progress, StepDone, file_of, save
from day6_core.lessons.reading import read_lesson
from day6_core.lessons.report_lines import DRILLS, lines_of
from day6_core.lessons.submission import SubmissionError
from day6_tui.main import main
from tests.grading.article import FILES, has_namespaces
from tests.grading.own import own_gradings
from tests.support.waiting import PATIENCE

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="serve doesn't run there")

PACKAGE = "day6_publisher"
DAY1 = [step.name for step in read_lesson(HERE / "days" / "day1.md").steps]
DAY3 = [step.name for step in read_lesson(HERE / "days" / "day3.md").steps]


CURIOUS = """\
import glob, os, sys

opened = []
for path in [found for pattern in {patterns!r} for found in glob.glob(pattern)]:
    try:
        if os.read(os.open(path, os.O_RDONLY), 1):
            opened.append(path)
    except OSError:
        pass
print('heard', *(opened or sys.argv[1:]))
"""
"""Opens what matches, and says what could be read."""


def learned(data: Path, name: str, *, day1: int = 0, day3: int = 0) -> Path:
    """A pupil's home, as a desktop of the server leaves it."""
    home = data / "homes" / folder_name(name)
    progress = Progress(name.lower())
    for lesson, steps, solved in (("day1", DAY1, day1), ("day3", DAY3, day3)):
        for number, step in enumerate(steps[:solved]):
            progress.note(lesson, step, StepDone(solved=1_700_000_000.0 + number, hints=1, seconds=60.0))
    save(file_of(home, name.lower()), progress)
    return home


@pytest.fixture
def data(tmp_path: Path) -> Path:
    """A class of two days: Anna was there on both; Ben has no link any more; 王小明 has never come."""
    data = tmp_path / "class"
    learned(data, "Anna", day1=len(DAY1), day3=2)
    learned(data, "ben", day1=1)
    (data / "server").mkdir()
    tickets = [{"hash": "x", "kind": "pupil", "name": name} for name in ("Anna", "王小明")]
    (data / "server" / "tokens.json").write_text(json.dumps({"tickets": tickets}), encoding="utf-8")
    return data


def rows_of(table: Path) -> list[list[str]]:
    return list(csv.reader(io.StringIO(table.read_bytes().decode("utf-8-sig"))))


def test_the_class_is_a_table_of_all_days_with_those_who_have_left_or_never_came(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["report", "--data", str(data), "--lang", "en"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0].split() == [
        "pupil",
        f"day1/{len(DAY1)}",
        f"day3/{len(DAY3)}",
        *["skipped", "hints", "wrong", "minutes"],
        "last",
        "solved",
    ]
    assert max(map(len, said[:4])) <= 80
    assert [line.split()[:3] for line in said[1:3]] == [["Anna", str(len(DAY1)), "2"], ["ben", "1", "0"]]
    table, page = tmp_path / "t.csv", tmp_path / "t.html"
    assert main(["report", "--data", str(data), "--lang", "zh", "--csv", str(table), "--html", str(page)]) == 0
    heads, anna, ben, ming = rows_of(table)
    assert heads[0] == "学生" and f"（共 {len(DAY1)} 步）" in heads[1]
    assert anna[:7] == ["Anna", str(len(DAY1)), "2", "0", str(len(DAY1) + 2), "0", f"{len(DAY1) + 2:.1f}"]
    assert ben[:3] == ["ben", "1", ""] and ming[:3] == ["王小明", "", ""]
    assert f'<td class="good">{len(DAY1)}</td>' in page.read_text(encoding="utf-8")


def test_a_folder_that_is_no_class_is_told_and_home_says_what_to_type(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["report", "--home", str(data), "--lang", "en"]) == 1
    assert f"day6-tui report --data {data}" in capsys.readouterr().err
    for words in (["report"], ["grade"]):
        assert main([*words, "--data", str(tmp_path), "--lang", "en"]) != 0
        assert "is not the folder of a class" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["grade", "--lang", "en"])
    assert "one of the arguments FILE --data is required" in capsys.readouterr().err


def hostile(home: Path, secret: Path) -> dict[str, str]:
    """Put into a home what no desktop writes; returns what is said of each file."""
    folder = home / FOLDER
    os.symlink(secret, folder / "a-link.json")
    os.mkfifo(folder / "b-pipe.json")
    (folder / "c-folder.json").mkdir()
    (folder / "d-large.json").write_bytes(b" " * (LARGEST + 1))
    (folder / "e-deep.json").write_bytes(b"[" * 100_000)
    (folder / "f-digits.json").write_text('{"version": 1, "changed": ' + "9" * 50_000 + "}")
    (folder / "g-bytes.json").write_bytes(b"\xff\xfe")
    (folder / "h-newer.json").write_text('{"version": 99}')
    (folder / "i-\x1b[31m.json").write_text("{")
    strange = "not a file, but a link, a pipe or a folder"
    return {
        "a-link": strange, "b-pipe": strange, "c-folder": strange, "d-large": "too large", "e-deep": "not JSON",
        "g-bytes": "not JSON", "h-newer": "newer day6-tui", "i-": "not JSON",
    }  # fmt: skip


def test_progress_files_are_not_believed_to_be_what_they_are_called(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    secret = tmp_path / "secret.json"
    secret.write_text(json.dumps({"version": 1, "pupil": "x", "steps": {"day1": {DAY1[0]: {"solved": 1}}}}))
    expected = hostile(learned(data, "mallory", day1=2), secret)
    linked = learned(data, "eve")
    (linked / ".config").rename(tmp_path / "elsewhere")
    (linked / ".config").symlink_to(learned(data, "Anna", day1=len(DAY1)) / ".config")
    (data / "homes" / "oscar").symlink_to(data / "homes" / "anna")
    flood = Progress("flood")
    for number in range(3000):
        flood.note(f"lesson{number}", "x", StepDone(solved=1e9 if number < 2 else 0.0, seconds=1e11))
    save(file_of(data / "homes" / "flood", "flood"), flood)
    table = tmp_path / "t.csv"
    assert main(["report", "--data", str(data), "--lang", "en", "--csv", str(table)]) == 1
    said = capsys.readouterr().err
    for name, why in expected.items():
        assert any(f"/{name}" in line and why in line for line in said.splitlines()), name
    assert "\x1b" not in said and "secret" not in said
    rows = {row[0]: row for row in rows_of(table)}
    assert rows["mallory"][1] == "2" and rows["eve"][1] == "" and "oscar" not in rows
    assert "pupils: " in rows["eve"][-1] and rows["flood"][3] == "2" and len(rows["flood"]) < 12


def test_homes_that_belong_to_others_are_told_and_nobody_is_left_out(
    data: Path, plain_user: None, capsys: pytest.CaptureFixture[str]
) -> None:
    (data / "homes" / "ben").chmod(0)
    assert main(["report", "--data", str(data), "--lang", "en"]) == 1
    (data / "homes" / "ben").chmod(0o700)
    said = capsys.readouterr()
    assert "run this as the user who runs the server, root" in said.err and "Permission denied" in said.err
    assert "Anna" in said.out and "ben" in said.out


# -- grade -------------------------------------------------------------------------------------------------------------


def work_of(home: Path) -> None:
    for name, text in FILES.items():
        top, _, rest = name.partition("/")
        if top == "src":
            path = home / "ros2_ws" / "src" / rest
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    (home / "ros2_ws" / "src" / PACKAGE / "setup.py").chmod(0o755)
    (home / "star.py").write_text("print('star')\n")


def test_what_a_pupil_has_is_collected_and_nothing_that_a_link_leads_to(data: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").mkdir()
    (tmp_path / "secret" / "secret.py").write_text("secret")
    home = data / "homes" / "anna"
    work_of(home)
    source = home / "ros2_ws" / "src"
    (home / "linked.py").symlink_to(tmp_path / "secret" / "secret.py")
    (source / PACKAGE / "linked.py").symlink_to(tmp_path / "secret" / "secret.py")
    (source / PACKAGE / "linked").symlink_to(tmp_path / "secret")
    os.mkfifo(source / PACKAGE / "pipe.py")
    os.mkfifo(home / "pipe.py")
    for tools in ("build", ".git", "__pycache__"):
        (source / PACKAGE / tools).mkdir()
        (source / PACKAGE / tools / "x.py").write_text("left by a tool")
    deep = source / PACKAGE
    for _ in range(40):
        deep = deep / "d"
        deep.mkdir()
    (deep / "x.py").write_text("deep")
    packed = collect(PupilHome("Anna", home), tmp_path / "anna.zip")
    submission = unpack(tmp_path / "anna.zip", tmp_path / "out")
    assert submission.pupil == "Anna" and packed.packages == [PACKAGE]
    assert submission.home and str(home).startswith(submission.home)  # a long one is cut short
    came = {path.relative_to(tmp_path / "out").as_posix() for path in (tmp_path / "out").rglob("*") if path.is_file()}
    own = {f"ros2_ws/{name}" for name in FILES if name.startswith("src/")}
    assert came == {"star.py", *own}
    assert os.access(tmp_path / "out" / "ros2_ws" / "src" / PACKAGE / "setup.py", os.X_OK)
    left = " ".join(each.text("en") for each in packed.left_out)  # type: ignore[union-attr]
    assert all(
        name in left
        for name in (
            f"/{PACKAGE}/linked.py",
            f"/{PACKAGE}/linked ",
            f"/{PACKAGE}/pipe.py",
            "/anna/linked.py",
            "/anna/pipe.py",
            "/d ",
        )
    )


def test_a_workspace_that_is_a_link_or_endless_is_not_collected(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_of(data / "homes" / "anna")
    ben = PupilHome("ben", data / "homes" / "ben")
    (ben.folder / "ros2_ws").symlink_to(data / "homes" / "anna" / "ros2_ws")
    with pytest.raises(SubmissionError, match="nothing to hand in"):
        collect(ben, tmp_path / "ben.zip")
    monkeypatch.setattr(collected, "MOST_FILES", 3)
    with pytest.raises(SubmissionError, match="MB"):
        collect(PupilHome("Anna", data / "homes" / "anna"), tmp_path / "anna.zip")
    assert list(tmp_path.glob("*.zip")) == []


def test_names_that_no_zip_takes_are_left_out_and_told(data: Path, tmp_path: Path) -> None:
    home = data / "homes" / "anna"
    try:
        Path(os.fsdecode(os.fsencode(home) + b"/\xff.py")).write_text("print()")
    except OSError:
        pytest.skip("this system has no such names")
    progress = {"version": 1, "pupil": "anna", "steps": {"day1": {"\ud800": {"answers": "a"}}}}
    file_of(home, "anna").write_text(json.dumps(progress), encoding="utf-8")
    (home / "star.py").write_text("print()")
    packed = collect(PupilHome("Anna", home), tmp_path / "anna.zip")
    assert packed.loose == ["star.py"] and "no submission may have" in packed.left_out[-1].text("en")  # type: ignore[union-attr]


def test_one_closed_home_keeps_nobody_elses_work(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (data / "homes" / "anna" / "star.py").write_text("print()")
    (data / "homes" / folder_name("王小明")).write_text("a file in place of the home")
    found = command._collected(data, tmp_path, "", lambda name, why: print(name, why))
    assert [path.name for path in found] == ["anna.zip"]
    assert "王小明" in capsys.readouterr().out


def test_a_lesson_that_is_called_like_the_drills_changes_the_table_of_nobody(data: Path) -> None:
    offered = offer(None)
    made_up = Progress("anna", {DRILLS: {"x": StepDone(solved=1.0)}})
    assert [line.lesson for line in lines_of([made_up], offered.lessons, offered.drills)] == [""]


@pytest.mark.process
def test_a_class_is_graded_from_its_homes(data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = own_gradings(tmp_path)
    others = ["homes/*/.config/*/*/*", "server/*"] if has_namespaces() else []
    patterns = [f"{tempfile.gettempdir()}/d6g-*/*.zip" for _ in others[:1]] + [f"{data}/{each}" for each in others]
    (data / "homes" / "anna" / "echo.py").write_text(CURIOUS.format(patterns=patterns))
    table = tmp_path / "g.csv"
    assert main(["grade", "--data", str(data), "--scenarios", str(folder), "--csv", str(table), "--lang", "en"]) == 0
    said = capsys.readouterr()
    assert "ben: there is nothing to hand in" in said.err and "王小明: has never come" in said.err
    _, row = rows_of(table)
    assert row[:4] == ["anna.zip", "Anna", "1.0", "1.0"]


@pytest.mark.process
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="what root may read is closed to others")
def test_programs_that_root_grades_open_nothing_of_roots(data: Path, tmp_path: Path) -> None:
    school = pytest.importorskip("tests.isolation.school", reason="a user without rights is made on Linux only")
    if (python := school.python_for_others()) is None:
        pytest.skip("no Python here that other users may run")
    (data / "server" / "tokens.json").chmod(0o600)
    os.chmod(data / "homes" / "ben", 0o700)
    tmp_path.chmod(0o711)
    devices = [str(path) for path in Path("/dev").iterdir() if path.is_block_device()][:3]
    patterns = [f"{data}/server/*", f"{data}/homes/ben/*", "/etc/shadow", *devices]
    for name, program in (
        ("anna", CURIOUS.format(patterns=patterns)),
        ("ben", "import sys\nprint('heard', sys.argv[1])\n"),
    ):
        (data / "homes" / name / "echo.py").write_text(program)
    folder = own_gradings(tmp_path)
    folder.chmod(0o700)
    done = subprocess.run(
        [python, "-m", "day6_tui.main", "grade", "--data", str(data), "--scenarios", str(folder), "--lang", "en"],
        capture_output=True,
        text=True,
        cwd="/",
        timeout=10 * PATIENCE,
    )
    assert done.returncode == 0, done.stdout + done.stderr
