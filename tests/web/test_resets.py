"""Desks, lessons and homes that begin anew: nothing is lost, also where it breaks off, and nobody else's files are touched."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from day6_core.classroom.homes import BEFORE, HOMES, Strange, homes_of
from day6_core.isolation.cell import Cell
from day6_core.isolation.same_user import Nothing
from day6_core.lessons.progress import FOLDER, Progress, ProgressError, StepDone, load, pupils, save
from day6_core.places import SESSION_FILE
from day6_tui.web import resets

pytest.importorskip("fcntl", reason="this system has no server of desktops")

MODE = Nothing()
SESSION = Path(".config", "day6-tui", SESSION_FILE)


class Killed(BaseException):
    """The server is gone at this moment."""


@pytest.fixture
def anna(tmp_path: Path) -> Cell:
    """A pupil with a file, two lessons and a desktop that was left."""
    cell = Cell("anna", tmp_path / HOMES / "anna", tmp_path / "run" / "anna")
    MODE.prepare(cell)
    (cell.home / "mine.py").write_text("print(1)\n")
    (cell.home / SESSION).parent.mkdir(parents=True)
    (cell.home / SESSION).write_text("what was there")
    for pupil in ("anna", "her sister"):
        steps = {lesson: {"one": StepDone(solved=1.0), "two": StepDone(hints=2)} for lesson in ("day1", "day2")}
        save(progress_of(cell, pupil), Progress(pupil, steps, {"day1": "two", "day2": "two"}, last="day1"))
    return cell


def progress_of(cell: Cell, pupil: str = "anna") -> Path:
    return cell.home / FOLDER / f"{pupil.replace(' ', '%20')}.json"


def copies(cell: Cell) -> list[Path]:
    """Of progress files, those that were kept."""
    return sorted(path for path in (cell.home / FOLDER).iterdir() if ".json." in path.name)


def test_a_lesson_begins_anew_and_the_old_progress_of_each_name_is_kept(anna: Cell) -> None:
    before = {name: progress_of(anna, name).read_bytes() for name in ("anna", "her sister")}
    kept = resets.reset_lesson(anna, "day1")
    for name in before:
        found = load(progress_of(anna, name))
        assert found.steps.keys() == {"day2"} and found.at == {"day2": "two"} and found.last == "day1"
    assert (anna.home / kept).exists() and sorted(path.read_bytes() for path in copies(anna)) == sorted(before.values())
    assert [each.pupil for each in pupils(anna.home)] == ["anna", "her sister"]  # a copy is nobody
    assert stat.S_IMODE(progress_of(anna).stat().st_mode) == 0o600
    assert resets.reset_lesson(anna, "day1") == "" and len(copies(anna)) == 2  # there is nothing more to forget


def full(step: int) -> Callable[..., Any]:
    """What a system call does that fails at its nth use."""
    calls = 0

    def fails(*_: object, **__: object) -> None:
        nonlocal calls
        calls += 1
        if calls == step:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    return fails


@pytest.mark.parametrize("step", [1, 2])
def test_on_a_full_disk_a_lesson_stays_as_it_is(anna: Cell, monkeypatch: pytest.MonkeyPatch, step: int) -> None:
    progress_of(anna, "her sister").unlink()
    before = progress_of(anna).read_bytes()
    monkeypatch.setattr(os, "fsync", full(step))
    with pytest.raises(OSError, match="No space"):
        resets.reset_lesson(anna, "day1")
    assert progress_of(anna).read_bytes() == before
    assert all(path.read_bytes() == before for path in copies(anna)) and len(copies(anna)) == step - 1
    assert not [name for name in os.listdir(anna.home / FOLDER) if name.startswith(".day6")]


@pytest.mark.parametrize("step", [1, 2, 3, 4])
def test_a_server_that_is_killed_while_a_lesson_is_reset_has_lost_nothing(
    anna: Cell, monkeypatch: pytest.MonkeyPatch, step: int
) -> None:
    before, real, count = progress_of(anna).read_bytes(), os.replace, 0

    def replace(*words: Any, **more: Any) -> None:
        nonlocal count
        count += 1
        if count == step:
            raise Killed
        real(*words, **more)

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(Killed):
        resets.reset_lesson(anna, "day1")
    whole = [progress_of(anna), *copies(anna)]
    assert before in [path.read_bytes() for path in whole]
    assert all(load(path).steps["day2"] for path in whole)


@pytest.mark.parametrize("content", [b"", b"[]", b'{"version": 99}', b"[" * 99_999, b'{"version": ' + b"9" * 99_999])
def test_a_progress_file_that_cannot_be_read_is_left_as_it_is(anna: Cell, content: bytes) -> None:
    progress_of(anna).write_bytes(content)
    with pytest.raises(ProgressError):
        resets.reset_lesson(anna, "day1")
    assert progress_of(anna).read_bytes() == content


@pytest.mark.parametrize("what", ["file", "folder", "pipe", "large"])
def test_nothing_is_followed_out_of_a_home(anna: Cell, tmp_path: Path, what: str) -> None:
    secret = tmp_path / "secret"
    secret.mkdir()
    save(secret / "anna.json", Progress("anna", {"day1": {"one": StepDone(solved=1.0)}}))
    before = {path.name: path.read_bytes() for path in secret.iterdir()}
    path = progress_of(anna)
    path.unlink()
    if what == "folder":
        (anna.home / FOLDER).rename(tmp_path / "elsewhere")
        (anna.home / FOLDER).symlink_to(secret)
    elif what == "file":
        path.symlink_to(secret / "anna.json")
    elif what == "pipe":
        os.mkfifo(path)
    else:
        with open(path, "wb") as file:
            file.truncate(5_000_000)
    with pytest.raises((OSError, Strange)):
        resets.reset_lesson(anna, "day1")
    assert {path.name: path.read_bytes() for path in secret.iterdir()} == before


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give a file away")
def test_what_belongs_to_another_user_is_not_touched_and_what_is_written_belongs_to_the_pupil(anna: Cell) -> None:
    hers = Cell(anna.name, anna.home, anna.runtime, uid=70001)
    with pytest.raises(PermissionError):
        resets.reset_lesson(hers, "day1")
    assert not copies(anna)
    for name in ("anna", "her sister"):
        os.chown(progress_of(anna, name), 70001, 70001)
    resets.reset_lesson(hers, "day1")
    assert {path.stat().st_uid for path in [progress_of(anna), *copies(anna)]} == {70001}


def test_a_home_is_put_aside_as_a_whole_and_nobody_is_a_pupil_more_for_it(anna: Cell, tmp_path: Path) -> None:
    names = []
    for number in range(3):  # perhaps in the same second
        (anna.home / "number").write_text(str(number))
        names.append(resets.reset_home(MODE, anna))
        assert os.listdir(anna.home) == []
    assert len(set(names)) == 3 and all(name.startswith(f"{BEFORE}/anna-") for name in names)
    assert [(tmp_path / name / "number").read_text() for name in names] == ["0", "1", "2"]
    assert (tmp_path / names[0] / "mine.py").read_text() == "print(1)\n"
    assert load(progress_of(Cell("", tmp_path / names[0], anna.runtime))).steps["day1"]
    assert stat.S_IMODE((tmp_path / BEFORE).stat().st_mode) == 0o700
    assert [each.name for each in homes_of(tmp_path)] == ["anna"]


def test_a_server_that_is_killed_between_both_steps_of_a_home_has_lost_nothing(
    anna: Cell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Dying(Nothing):
        def prepare(self, cell: Cell) -> None:
            raise Killed

    with pytest.raises(Killed):
        resets.reset_home(Dying(), anna)
    (kept,) = (tmp_path / BEFORE).iterdir()
    assert (kept / "mine.py").exists() and not anna.home.exists()
    MODE.prepare(anna)  # what the next desktop does
    assert resets.reset_home(MODE, anna) and (kept / "mine.py").exists()


def test_a_home_that_cannot_be_put_aside_stays(anna: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "rename", full(1))
    with pytest.raises(OSError, match="No space"):
        resets.reset_home(MODE, anna)
    assert (anna.home / "mine.py").exists()


def test_a_desk_is_cleared_and_files_and_progress_stay(anna: Cell) -> None:
    kept = resets.clear_desk(anna)
    assert not (anna.home / SESSION).exists() and (anna.home / kept).read_text() == "what was there"
    assert (anna.home / "mine.py").exists() and load(progress_of(anna)).steps["day1"]
    assert resets.clear_desk(anna) == ""


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root keeps pupils apart as users")
def test_an_empty_home_belongs_to_the_same_unix_user_and_the_old_one_too() -> None:
    school = pytest.importorskip("tests.isolation.school", reason="pupils are users of their own on Linux only")
    from day6_core.isolation.users import Users

    with school.folder() as top:
        mode, homes = Users(), top / HOMES
        for folder in (homes, top / "run"):
            folder.mkdir()
            folder.chmod(0o711)
        uid = mode.uid_of("anna", homes)
        cell = Cell("anna", homes / "anna", top / "run" / "anna", uid)
        mode.prepare(cell)
        (cell.home / "mine").write_text("1")
        kept = top / resets.reset_home(mode, cell)
        assert (kept / "mine").exists() and os.listdir(cell.home) == []
        assert {path.stat().st_uid for path in (cell.home, kept)} == {uid} and mode.uid_of("anna", homes) == uid
        assert stat.S_IMODE(cell.home.stat().st_mode) == 0o700
