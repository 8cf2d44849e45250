"""Progress is kept whole, joined with what another desktop wrote, and never overwrites what is not ours."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import textwrap
import threading
from pathlib import Path

import pytest

from day6_core.lessons.progress import (
    MOST_EXAMS,
    MOST_STEPS,
    VERSION,
    Progress,
    ProgressError,
    StepDone,
    decode,
    encode,
    file_of,
    load,
    name_mistake,
    pupils,
    save,
)


def test_what_is_saved_is_loaded_again(tmp_path: Path) -> None:
    progress = Progress("安娜", at={"day1": "two"}, last="day1")
    progress.note("day1", "one", StepDone(solved=100.0, hints=2, seconds=12.5, refused=1))
    path = file_of(tmp_path, "安娜")
    save(path, progress)
    found = load(path)
    assert found.step("day1", "one") == StepDone(100.0, False, 2, 12.5, 1)
    assert (found.pupil, found.at, found.last, found.solved("day1")) == ("安娜", {"day1": "two"}, "day1", 1)
    if os.name == "posix":
        assert path.stat().st_mode & 0o077 == 0


def test_two_desktops_of_one_pupil_lose_nothing(tmp_path: Path) -> None:
    path = file_of(tmp_path, "anna")

    def work(lesson: str) -> None:
        progress = Progress("anna")
        for number in range(20):
            progress.note(lesson, f"s{number}", StepDone(solved=1.0 + number))
            save(path, progress)

    threads = [threading.Thread(target=work, args=(f"day{number}",)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [load(path).solved(f"day{number}") for number in range(4)] == [20] * 4


def test_the_first_solution_counts(tmp_path: Path) -> None:
    path = file_of(tmp_path, "anna")
    for done in (StepDone(hints=1), StepDone(solved=5.0, hints=1), StepDone(solved=9.0), StepDone(passed_over=True)):
        progress = Progress("anna")
        progress.note("day1", "one", done)
        save(path, progress)
    assert load(path).step("day1", "one") == StepDone(solved=5.0, hints=1)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{", "not JSON"),
        ("[]", "no progress"),
        ('{"a": 1}', "no progress"),
        (json.dumps({"version": VERSION + 1}), "newer"),
        ("\udcff", "not JSON"),
        ("[" * 100_000, "not JSON"),
    ],
)
def test_a_file_that_is_not_ours_is_left_as_it_is(tmp_path: Path, text: str, reason: str) -> None:
    path = file_of(tmp_path, "anna")
    path.parent.mkdir(parents=True)
    data = text.encode("utf-8", "surrogateescape")
    path.write_bytes(data)
    with pytest.raises(ProgressError, match=reason):
        load(path)
    with pytest.raises(ProgressError, match=reason):
        save(path, Progress("anna"))
    assert path.read_bytes() == data


def test_what_makes_no_sense_in_a_file_is_left_out(tmp_path: Path) -> None:
    path = file_of(tmp_path, "anna")
    path.parent.mkdir(parents=True)
    odd = {"one": {"solved": "yes", "hints": 1e300}, "two": 7, "three": {"solved": 3.0}}
    path.write_text(json.dumps({"version": 1, "steps": {"day1": odd, "day2": []}, "at": {"day1": 4}, "exams": 3}))
    found = load(path)
    assert found.steps == {"day1": {"one": StepDone(), "three": StepDone(solved=3.0)}, "day2": {}}
    assert (found.at, found.exams) == ({}, [])


@pytest.mark.parametrize("name", ["anna", "安娜", "a/../b", "..", "con.txt", "a b", "É"])
def test_any_name_has_a_file_of_its_own(tmp_path: Path, name: str) -> None:
    assert name_mistake(name) == ""
    path = file_of(tmp_path, name)
    assert path.parent == file_of(tmp_path, "x").parent
    save(path, Progress(name))
    assert [progress.pupil for progress in pupils(tmp_path)] == [name]


@pytest.mark.parametrize(
    ("name", "mistake"), [("", "empty"), ("  ", "empty"), ("x" * 41, "long"), ("a\x1bb", "control")]
)
def test_a_name_that_cannot_be_is_refused(name: str, mistake: str) -> None:
    assert name_mistake(name) == mistake


@pytest.mark.process
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="kill -9 is POSIX")
def test_kill_9_in_the_middle_of_saving_leaves_a_whole_file(tmp_path: Path) -> None:
    path = file_of(tmp_path, "anna")
    script = textwrap.dedent(f"""
        import day6_core.lessons.progress as p
        from pathlib import Path
        progress = p.Progress("anna")
        for number in range(100_000):
            progress.note("day1", f"s{{number}}", p.StepDone(solved=1.0))
            p.save(Path({str(path)!r}), progress)
            print(number, flush=True)
    """)
    process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    last = -1
    for line in process.stdout:
        last = int(line)
        if last >= 25:
            process.kill()
            break
    process.wait()
    assert load(path).solved("day1") >= last + 1
    save(path, Progress("anna"))  # nothing that was left behind stands in the way


def test_what_somebody_has_made_up_by_the_hundred_thousand_costs_nobody_else_anything() -> None:
    """A server joins the files of one home, of thirty homes."""
    files = [
        json.dumps({"version": 1, "exams": [{first: number} for number in range(100_000)]}).encode() for first in "ab"
    ]
    exams = decode(files[0]).joined(decode(files[1])).exams
    assert exams[-1] == {"a": 99_999} and len(exams) == 2 * MOST_EXAMS
    steps = {f"lesson{number}": {} for number in range(MOST_STEPS + 1)}
    with pytest.raises(ProgressError):
        decode(json.dumps({"version": 1, "steps": steps}).encode())


def test_what_cannot_be_written_again_is_told_as_what_it_is() -> None:
    with pytest.raises(ProgressError):
        encode(decode(b'{"version": 1, "exams": [{"a": "\\ud800"}]}'))
    deep = decode(b'{"version": 1, "exams": [{"a": %b%b}]}' % (b"[" * 900, b"]" * 900))
    with contextlib.suppress(ProgressError):  # some Pythons write it
        encode(deep)
