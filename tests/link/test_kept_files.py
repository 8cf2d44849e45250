"""A process notices that the files by which others find it are gone, and keeps them from looking forgotten."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from day6_core.link import kept_files
from day6_core.link.kept_files import KeptFiles, identity, spared


@pytest.fixture
def files(tmp_path: Path) -> list[Path]:
    folder = tmp_path / "base" / "0"
    folder.mkdir(parents=True)
    found = [folder / name for name in ("p-1-2", "meet")]
    for path in found:
        path.touch()
    return found


def test_a_file_that_is_gone_or_another_is_noticed(files: list[Path]) -> None:
    kept = KeptFiles()
    assert not kept.are_gone(files) and not kept.are_gone(files)
    files[1].rename(files[1].with_name("was"))
    assert kept.are_gone(files)
    files[1].touch()  # somebody else's
    assert kept.are_gone(files)
    assert not KeptFiles().are_gone(files)


def test_files_folders_and_the_locks_beside_them_are_marked_as_used_every_hour(
    files: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    lock = files[0].with_name("p-1-2.lock")
    lock.touch()
    stranger = files[0].with_name("stranger")
    stranger.touch()
    now = 1_000_000.0
    monkeypatch.setattr(kept_files.time, "time", lambda: now)
    kept = KeptFiles()
    used = (*files, lock, files[0].parent, files[0].parent.parent)
    for later, expected in ((0.0, True), (60.0, False), (3600.0, True)):
        now += later
        for path in (*used, stranger):
            os.utime(path, (0, 0))
        assert not kept.are_gone(files)
        assert {path.stat().st_atime > 0 and path.stat().st_mtime > 0 for path in used} == {expected}, later
        assert stranger.stat().st_mtime == 0


def test_files_that_are_spared_have_their_names_again_unless_those_are_taken(files: list[Path]) -> None:
    missing = files[0].with_name("missing")
    known = [identity(path) for path in files]
    with spared([*files, missing]):
        files[0].unlink()
        files[1].unlink()
        files[1].touch()  # of another process: with an old one in its place nobody would find it
        taken = identity(files[1])
    assert taken != known[1]
    assert [identity(path) for path in (*files, missing)] == [known[0], taken, None]
    assert sorted(os.listdir(files[0].parent)) == ["meet", "p-1-2"]
