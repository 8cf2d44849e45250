"""Files that the server puts into homes and reads there, while the owner of the home does what owners can do."""

from __future__ import annotations

import asyncio
import contextlib
import os
import shutil
import sys
import threading
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("the server needs Unix", allow_module_level=True)

from day6_core.classroom.handed import clean_file_name
from day6_core.isolation import users
from day6_core.isolation.cell import Cell, IsolationError, Limits
from day6_core.isolation.same_user import Nothing
from day6_tui.web import pupil_files
from day6_tui.web.pupil_files import BadPath, Bounds, PupilFiles, Wanted, parts_of

PUPIL = 70042
"""A Unix user of a pupil, where the tests are root."""


class Home:
    """A pupil's home, and beside it what is none of the pupil's business."""

    def __init__(self, folder: Path, uid: int | None) -> None:
        self.path = folder / "homes" / "anna"
        self.outside = folder / "server"
        self.outside.mkdir()
        (self.outside / "tokens").write_text("secret")
        self.uid = uid
        if uid is not None:
            self.path.mkdir(parents=True)
            os.chown(self.path, uid, uid)
        self.cell = Cell("anna", self.path, folder / "run", uid)
        self.files = PupilFiles(Nothing(), lambda name: self.cell)

    def put(self, path: str, data: bytes = b"print()\n", **how: bool) -> str:
        return asyncio.run(self.files.put("anna", path, data, **how))

    def read(self, path: str, most: int = 1000) -> bytes:
        *above, last = parts_of(path)
        with pupil_files._folder(self.cell, above) as folder:
            return pupil_files._contents(self.cell, folder, last, most)

    def names(self, folder: str) -> list[str]:
        found = asyncio.run(self.files.tree("anna", [Wanted(folder)], Bounds()))
        return [path.removeprefix(f"{folder}/") for path in found.files]

    def made(self, path: str, text: str = "mine") -> Path:
        """A file that the pupil has made."""
        file = self.path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        if self.uid is not None:
            for each in (file, *file.parents[: len(Path(path).parts) - 1]):
                os.chown(each, self.uid, self.uid)
        return file

    def untouched(self) -> bool:
        """Whether nothing has come of it outside."""
        return {each.name: each.read_text() for each in self.outside.iterdir()} == {"tokens": "secret"}


@pytest.fixture(params=["one user", "users"])
def home(request: pytest.FixtureRequest, tmp_path: Path) -> Home:
    if request.param == "users" and os.geteuid() != 0:
        pytest.skip("only root gives files away")
    return Home(tmp_path, PUPIL if request.param == "users" else None)


def test_a_file_is_put_and_is_the_pupils(home: Home) -> None:
    assert home.put("handed/maps/map.py") == "handed/maps/map.py"
    assert home.read("handed/maps/map.py") == b"print()\n"
    for each in ("handed", "handed/maps", "handed/maps/map.py"):
        assert (home.path / each).stat().st_uid == (os.geteuid() if home.uid is None else home.uid)
    assert [each.name for each in (home.path / "handed" / "maps").iterdir()] == ["map.py"]


def test_no_file_of_the_pupil_is_ever_changed(home: Home) -> None:
    mine = home.made("handed/map.py")
    assert [home.put("handed/map.py"), home.put("handed/map.py")] == ["handed/map_2.py"] * 2  # the second is there
    with pytest.raises(FileExistsError):
        home.put("handed/map.py", renames=False)
    (home.path / "handed" / "link.py").symlink_to(home.outside / "tokens")
    assert home.put("handed/link.py", b"secret") == "handed/link_2.py"
    assert mine.read_text() == "mine" and home.untouched()


@pytest.mark.parametrize("path", ["", "/", "/etc/x", "//etc/x", "../x", "handed/../../x", "a\0b", "\ud800", "a/" * 20])
def test_a_path_stays_in_the_home(home: Home, path: str) -> None:
    with pytest.raises(BadPath):
        home.put(path)
    with pytest.raises(BadPath):
        home.read(path)


def test_links_are_not_followed(home: Home) -> None:
    home.made("work/a.py")
    (home.path / "out").symlink_to(home.outside)
    (home.path / "work" / "out").symlink_to(home.outside)
    (home.path / "work" / "tokens").symlink_to(home.outside / "tokens")
    for path in ("out/x", "out/tokens", "work/out/tokens", "work/tokens"):
        with pytest.raises(OSError):
            home.read(path)
    for path in ("out/x", "work/out/deep/x"):
        with pytest.raises(OSError):
            home.put(path)
    assert home.names("work") == ["a.py"] and home.untouched()


def test_what_is_no_plain_file_or_too_large_is_not_read(home: Home) -> None:
    home.made("large", "x" * 11)
    os.mkfifo(home.path / "pipe")
    for path in ("pipe", "large"):
        with pytest.raises(OSError):
            home.read(path, most=10)


def test_a_home_has_a_limit(home: Home) -> None:
    home.cell = replace(home.cell, limits=Limits(disk=100))
    with pytest.raises(OSError):
        home.put("handed/large", b"x" * 101)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_what_is_not_the_pupils_is_neither_read_nor_given_away(tmp_path: Path) -> None:
    home = Home(tmp_path, PUPIL)
    (home.path / "foreign").mkdir()
    (home.path / "foreign" / "x").write_text("root's")
    os.link(home.outside / "tokens", home.path / "hard")  # as a system without fs.protected_hardlinks lets a pupil
    for path in ("foreign/x", "hard"):
        with pytest.raises(PermissionError):
            home.read(path)
    with pytest.raises(PermissionError):
        home.put("foreign/y")
    assert (home.path / "foreign").stat().st_uid == 0


def test_a_folder_that_becomes_a_link_just_when_it_is_opened(home: Home, monkeypatch: pytest.MonkeyPatch) -> None:
    mkdir = os.mkdir

    def swapped(path: Any, *rest: Any, **more: Any) -> None:
        mkdir(path, *rest, **more)
        os.rename(home.path / "handed", home.path / "gone")
        os.symlink(home.outside, home.path / "handed")

    home.made("x")
    monkeypatch.setattr(os, "mkdir", swapped)
    with pytest.raises(OSError):
        home.put("handed/map.py")
    assert home.untouched()


def test_a_pupil_who_swaps_folders_for_links_all_the_time(home: Home) -> None:
    home.made("handed/x")
    over = threading.Event()

    def swap() -> None:
        handed, kept = home.path / "handed", home.path / "kept"
        while not over.is_set():
            os.rename(handed, kept)
            with contextlib.suppress(FileExistsError):  # made anew meanwhile
                os.symlink(home.outside, handed)
                os.unlink(handed)
            try:
                os.rename(kept, handed)
            except OSError:
                shutil.rmtree(kept)

    pupil = threading.Thread(target=swap)
    pupil.start()
    put = 0
    try:
        for number in range(300):
            try:
                home.files._put("anna", f"handed/{number}", b"x", True)
                put += 1
            except OSError:
                continue
    finally:
        over.set()
        pupil.join()
    assert home.untouched() and put


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("map.py", "map.py"),
        ("C:\\Users\\me\\地图.py", "地图.py"),
        ("../../etc/passwd", "passwd"),
        (".bashrc", "bashrc"),
        ("-rf", "rf"),
        ("a\x1b[31m\u202eb\n.py", "a[31mb.py"),
        ("..", "file"),
        ("", "file"),
        ("\ud800.py", "py"),
        ("x" * 300 + ".urdf", "x" * 95 + ".urdf"),
        ("长" * 300 + ".py", "长" * 32 + ".py"),
    ],
)
def test_the_name_of_a_file_from_outside(text: str, name: str) -> None:
    assert clean_file_name(text) == name


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_two_new_pupils_never_get_the_same_user_while_they_wait_for_their_turn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(users, "CLAIMS", tmp_path / "uids")
    found = [users.Users().claim(tmp_path / "homes" / name, range(70_000, 70_002)) for name in ("anna", "ben")]
    assert set(found) == {70_000, 70_001}
    with pytest.raises(IsolationError):
        users.Users().claim(tmp_path / "homes" / "carl", range(70_000, 70_002))
