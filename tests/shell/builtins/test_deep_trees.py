"""Trees whose paths no system call takes whole, and whose depth no stack holds: what GNU's tools manage, ours do."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="Windows has no descriptors of folders")
NAME = "named"
DEPTH = 1010
"""Levels: more than Python's stack has, and more bytes of path than the system takes."""


def dig(folder: Path, depth: int = DEPTH, name: str = NAME) -> None:
    """Make folders in each other, with a file in the last one."""
    here = os.open(folder, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir(name, dir_fd=here)
        inner = os.open(name, os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = inner
    file = os.open("last", os.O_WRONLY | os.O_CREAT, dir_fd=here)
    os.write(file, b"a line\n")
    os.close(file)
    os.close(here)


def levels(folder: Path, name: str = NAME) -> tuple[int, list[str]]:
    """How deep a tree is, and what is at its end."""
    here, depth = os.open(folder, os.O_RDONLY), 0
    while os.listdir(here) == [name]:
        inner = os.open(name, os.O_RDONLY, dir_fd=here)
        os.close(here)
        here, depth = inner, depth + 1
    found = os.listdir(here)
    os.close(here)
    return depth, found


@pytest.fixture
def home(machine: Any) -> Iterator[Path]:
    """A home with such a tree; what a failing test leaves is removed, for Python's own rmtree can't."""
    (machine.desk.home / "top").mkdir()
    dig(machine.desk.home / "top")
    yield machine.desk.home
    clear(machine.desk.home)


def clear(home: Path) -> None:
    for top in home.iterdir():
        while (top / NAME / NAME).is_dir():
            (top / NAME / NAME).rename(top / "up")
            shutil.rmtree(top / NAME)
            (top / "up").rename(top / NAME)


def test_rm_ls_find_chmod_and_tree_reach_its_end(machine: Any, home: Path) -> None:
    listed = machine.run("ls -R top")
    assert (listed.status, listed.err) == (0, "")
    assert listed.out.count(":\n") == DEPTH + 1 and listed.out.endswith(f"{NAME}:\nlast\n")
    found = machine.run("find top")
    assert (found.status, found.err) == (0, "") and len(found.out.splitlines()) == DEPTH + 2
    assert found.out.splitlines()[-1].endswith(f"/{NAME}/last")
    assert machine.run("grep -r line top").out.endswith("/last:a line\n")
    drawn = machine.run("tree -L 2000 top")
    assert drawn.out.endswith(f"─ last\n\n{DEPTH} directories, 1 file\n") and drawn.err == ""
    assert machine.run("chmod -R 700 top") == (0, "", "")
    assert machine.run("ls -lR top").out.splitlines()[-1].startswith("-rwx------ ")
    assert machine.run("rm -r top; ls -A | grep top") == (1, "", "")


def test_cp_and_mv_carry_it_whole(machine: Any, home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert machine.run("cp -r top copy; mv top moved") == (0, "", "")
    assert [levels(home / name) for name in ("copy", "moved")] == [(DEPTH, ["last"])] * 2
    real, time = os.replace, (home / "moved").stat().st_mtime_ns

    def refused(source: Any, goal: Any, **folders: Any) -> None:
        raise OSError(18, os.strerror(18))

    monkeypatch.setattr(os, "replace", refused)
    assert machine.run("mv moved elsewhere") == (0, "", "")
    monkeypatch.setattr(os, "replace", real)
    assert levels(home / "elsewhere") == (DEPTH, ["last"]) and not (home / "moved").exists()
    assert (home / "elsewhere").stat().st_mtime_ns == time
    assert machine.run("rm -rf copy elsewhere") == (0, "", "")


def test_what_in_it_cannot_be_removed_keeps_the_folders_around_it(machine: Any, home: Path, plain_user: Any) -> None:
    here = home / "top" / NAME
    (here / "kept").mkdir()
    (here / "kept" / "file").touch()
    (here / "kept").chmod(0o500)
    result = machine.run("rm -r top")
    assert result == (1, "", f"rm: cannot remove 'top/{NAME}/kept/file': Permission denied\n")
    assert os.listdir(here) == ["kept"]  # and the deep rest is gone
    (here / "kept").chmod(0o700)


@pytest.mark.parametrize(
    "line", ["cat {}", "echo x > {}", "cd {}", "touch {}", "wc {}", "grep x {}", "head {}", "mkdir {}"]
)
def test_a_name_that_is_too_long_is_said_without_a_number(machine: Any, line: str) -> None:
    result = machine.run(line.format("x" * 300))
    assert "File name too long" in result.err and "Errno" not in result.err and "Traceback" not in result.err


# -- diff -r -------------------------------------------------------------------------------------------------------------


@pytest.fixture
def two(machine: Any, monkeypatch: pytest.MonkeyPatch) -> Any:
    """A machine without a diff of its own, and two folders."""
    monkeypatch.setattr("day6_core.shell.text_tools._tool", lambda name, session: "")
    for path, text in {
        "one/bin": "\0\1", "two/bin": "\0\2", "one/f": "a\n", "two/f": "b\n", "one/only1": "x\n", "two/only2": "y\n",
        "one/same": "s\n", "two/same": "s\n", "one/s/in": "q\n", "two/s/in": "r\n", "one/kind/k": "", "two/kind": "k\n",
        "one/void/d/e": "z\n",
    }.items():  # fmt: skip
        file = machine.desk.home / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return machine


F, IN = "1c1\n< a\n---\n> b\n", "1c1\n< q\n---\n> r\n"
BINARY = "Binary files one/bin and two/bin differ\n"
KIND = "File one/kind is a directory while file two/kind is a regular file\n"
ONLY = "Only in one: only1\nOnly in two: only2\n"


@pytest.mark.parametrize(
    ("options", "out"),
    [
        # As diffutils 3.8 printed it.
        ("-r", f"{BINARY}diff -r one/f two/f\n{F}{KIND}{ONLY}diff -r one/s/in two/s/in\n{IN}Only in one: void\n"),
        ("", f"{BINARY}diff one/f two/f\n{F}{KIND}{ONLY}Common subdirectories: one/s and two/s\nOnly in one: void\n"),
        ("-rq", ("Files one/bin and two/bin differ\nFiles one/f and two/f differ\n"
                 f"{KIND}{ONLY}Files one/s/in and two/s/in differ\nOnly in one: void\n")),
        ("-rN", (f"{BINARY}diff -rN one/f two/f\n{F}{KIND}diff -rN one/only1 two/only1\n1d0\n< x\n"
                 f"diff -rN one/only2 two/only2\n0a1\n> y\ndiff -rN one/s/in two/s/in\n{IN}"
                 "diff -rN one/void/d/e two/void/d/e\n1d0\n< z\n")),
    ],
)  # fmt: skip
def test_diff_r_compares_folders(two: Any, options: str, out: str) -> None:
    assert two.run(f"diff {options} one two") == (1, out, "")


@pytest.mark.skipif(sys.platform != "linux", reason="needs GNU's diff")
@pytest.mark.process
@pytest.mark.parametrize("options", ["-r", "", "-rq", "-rN", "-ruN"])
def test_diff_r_is_as_the_machines_own(two: Any, options: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if shutil.which("diff") is None:
        pytest.skip("no diff here")
    real = subprocess.run(
        ["diff", *options.split(), "one", "two"], cwd=two.desk.home, capture_output=True, text=True, check=False
    )
    ours = two.run(f"diff {options} one two")
    assert (ours.status, ours.out) == (real.returncode, re.sub(r"\t\d{4}-.*", "", real.stdout))


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("diff -r one/same one/same", (0, "", "")),
        ("diff one/f two", (1, F, "")),
        ("diff one two/f", (1, F, "")),
        ("diff -r one nothere", (2, "", "diff: nothere: No such file or directory\n")),
        ("diff one/same two", (0, "", "")),
        ("diff one/bin two/bin", (1, BINARY, "")),
        ("diff one/s two/same", (2, "", "diff: one/s/same: No such file or directory\n")),
    ],
)
def test_diff_of_a_file_and_a_folder_takes_the_one_of_that_name(two: Any, line: str, expected: Any) -> None:
    assert two.run(line) == expected


def test_diff_r_reaches_the_end_of_deep_trees(two: Any) -> None:
    for name in ("deep1", "deep2"):
        (two.desk.home / name).mkdir()
        dig(two.desk.home / name)
    result = two.run("diff -r deep1 deep2")
    clear(two.desk.home)
    assert result == (0, "", "")
