"""Hostile files are refused in words, and nothing of them is written outside the folder; claims are not believed."""

from __future__ import annotations

import io
import json
import stat
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from day6_core.lessons.grading.archive import SubmissionRefused, unpack
from tests.grading.article import write

MANIFEST = json.dumps({"version": 1, "pupil": "anna", "answers": {}})


def _zip(
    target: Path, *entries: tuple[str | zipfile.ZipInfo, str | bytes], manifest: str | bytes | None = MANIFEST
) -> Path:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        if manifest is not None:
            archive.writestr("day6-submission.json", manifest)
        for name, data in entries:
            archive.writestr(name, data)
    return target


def _special(name: str, kind: int, to: str = "/etc/passwd") -> tuple[zipfile.ZipInfo, str]:
    info = zipfile.ZipInfo(name)
    info.create_system = 3
    info.external_attr = (kind | 0o777) << 16
    return info, to


NAMES = [
    "../evil.py", "src/../../evil.py", "/etc/evil.py", "src/a/../../../evil", "src//evil.py", "src/./evil.py",
    "C:/evil.py", "src\\..\\evil.py", "src/a\nb.py", "src/\x1b[2J.py", "home/.bashrc", "home/.profile",
    "home/.local/lib/python3.11/site-packages/usercustomize.py", "home/a/b.py", "loose/.hidden", "loose/x/y.py",
    ".bashrc", "install/setup.bash", "build/day6_publisher/colcon_build.rc", ".config/day6-tui/pupils/anna.json",
    "progress.json", "verdict.json", "ros2_ws/install/x", "run/0/meet", "tmp/x", "src", "home/", "SRC/a.py",
    "src/" + "a/" * 30 + "x.py", "src/" + "n" * 300 + ".py", "src/../home/.bashrc", "~/star.py", "-rf",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_leads_elsewhere_is_refused(name: str, tmp_path: Path) -> None:
    file = _zip(tmp_path / "s.zip", (name, "evil"))
    home = tmp_path / "box" / "home"
    home.mkdir(parents=True)
    if name.endswith("/"):
        unpack(file, home)  # a folder is nothing
    else:
        with pytest.raises(SubmissionRefused):
            unpack(file, home)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["box", "home", "s.zip"]


@pytest.mark.parametrize("kind", [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR, stat.S_IFBLK, stat.S_IFSOCK])
def test_links_and_devices_are_refused(kind: int, tmp_path: Path) -> None:
    file = _zip(tmp_path / "s.zip", _special("src/a.py", kind))
    with pytest.raises(SubmissionRefused, match="link or a device"):
        unpack(file, tmp_path / "home")


def test_a_file_below_a_link_is_refused(tmp_path: Path) -> None:
    file = _zip(tmp_path / "s.zip", _special("src/a", stat.S_IFLNK, "/tmp"), ("src/a/evil.py", "x"))
    with pytest.raises(SubmissionRefused):
        unpack(file, tmp_path / "home")


def _bomb(path: Path) -> None:
    _zip(path, *((f"src/{n}.py", b"\0" * 15_000_000) for n in range(10)))


def _lying_bomb(path: Path) -> None:
    """The sizes in the zip say 10 bytes."""
    _zip(path, ("src/a.py", b"\0" * 30_000_000))
    data = bytearray(path.read_bytes())
    wanted = struct.pack("<I", 30_000_000)
    at = data.find(wanted)
    while at >= 0:
        data[at : at + 4] = struct.pack("<I", 10)
        at = data.find(wanted)
    path.write_bytes(bytes(data))


def _many(path: Path) -> None:
    _zip(path, *((f"src/{n}.py", "") for n in range(2500)))


def _nested(path: Path) -> None:
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w") as archive:
        archive.writestr("day6-submission.json", MANIFEST)
    path.write_bytes(b"x" * 100 + inner.getvalue()[:-5])


def _locked(path: Path) -> None:
    _zip(path, ("src/a.py", "x"))
    data = bytearray(path.read_bytes())
    for mark, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = data.rfind(mark)
        data[at + offset] |= 1
    path.write_bytes(bytes(data))


def _large(path: Path) -> None:
    with open(path, "wb") as file:
        file.truncate(30_000_000)


def _no_method(path: Path) -> None:
    _zip(path, ("src/a.py", "x" * 100))
    data = bytearray(path.read_bytes())
    for mark, offset in ((b"PK\x03\x04", 8), (b"PK\x01\x02", 10)):
        at = data.rfind(mark)
        data[at + offset] = 97
    path.write_bytes(bytes(data))


BROKEN: dict[str, tuple[Callable[[Path], object], str]] = {
    "a bomb": (_bomb, "unpacked"),
    "a bomb that lies about its size": (_lying_bomb, "unpacked|intact"),
    "too many files": (_many, "files"),
    "half a zip": (_nested, "intact"),
    "locked": (_locked, "password"),
    "too large": (_large, "larger"),
    "an unknown compression": (_no_method, "intact"),
    "no zip": (lambda path: path.write_bytes(b"print('passed')"), "intact"),
    "empty": (lambda path: path.write_bytes(b""), "intact"),
    "a folder": (lambda path: path.mkdir(), "cannot be read"),
    "not there": (lambda path: None, "cannot be read"),
    "nothing said of itself": (lambda path: _zip(path, manifest=None), "not made by"),
    "its words are no JSON": (lambda path: _zip(path, manifest="{"), "cannot be read"),
    "its words are a list": (lambda path: _zip(path, manifest="[]"), "cannot be read"),
    "its words are not UTF-8": (lambda path: _zip(path, manifest=b"\xff\xfe"), "cannot be read"),
    "its words are ten thousand brackets": (lambda path: _zip(path, manifest="[" * 100_000), "cannot be read"),
    "its words are two megabytes": (lambda path: _zip(path, manifest=" " * 2_000_000 + MANIFEST), "cannot be read"),
    "a newer version": (lambda path: _zip(path, manifest='{"version": 99}'), "newer"),
    "a version that is true": (lambda path: _zip(path, manifest='{"version": "1"}'), "cannot be read"),
    "one file twice": (lambda path: _zip(path, ("src/a.py", "x"), ("src/a.py", "y")), "twice"),
    "a file that is also a folder": (lambda path: _zip(path, ("src/a", "x"), ("src/a/b", "y")), "twice"),
    "loose and package at one place": (lambda path: _zip(path, ("src/a.py", "x"), ("loose/a.py", "y")), "twice"),
}


@pytest.mark.filterwarnings("ignore:Duplicate name")
@pytest.mark.parametrize("what", BROKEN)
def test_a_broken_file_is_refused_in_words(what: str, tmp_path: Path) -> None:
    make, reason = BROKEN[what]
    make(tmp_path / "s.zip")
    with pytest.raises(SubmissionRefused, match=reason) as refused:
        unpack(tmp_path / "s.zip", tmp_path / "home")
    assert refused.value.say.text("zh") != refused.value.say.text("en")


def test_what_a_submission_claims_is_cut_to_what_makes_sense(tmp_path: Path) -> None:
    claims = {
        "pupil": "a" * 500, "passed": True, "score": 100, "results": {"day5": "passed"}, "home": 7,
        "answers": {"day1": {"q": "abc", "r": 7, "s": "<script>", "t": "b" * 99, "u": "B"}, "day2": [1], "day3": {"q": "c"}},
    }  # fmt: skip
    submission = unpack(write(tmp_path / "s.zip", {}, claims), tmp_path / "home")
    assert (len(submission.pupil), submission.home) == (200, "")
    assert submission.answers == {"day1": {"q": "abc"}, "day3": {"q": "c"}}
    assert not hasattr(submission, "passed")


def test_the_pupils_home_in_launch_files_becomes_ours(tmp_path: Path) -> None:
    home = tmp_path / "home"
    unpack(write(tmp_path / "s.zip"), home)
    launch = home / "ros2_ws/src/day6_publisher/launch/day6_display.launch.py"
    assert f"open('{home}/ros2_ws/src" in launch.read_text()
    assert (home / "star.py").is_file()


@pytest.mark.parametrize("claimed", ["/", "home", "/a", "/home/../x", "/home/a\nb", 5])
def test_a_strange_home_changes_nothing(claimed: object, tmp_path: Path) -> None:
    home = tmp_path / "home"
    unpack(write(tmp_path / "s.zip", {}, {"home": claimed}), home)
    launch = home / "ros2_ws/src/day6_publisher/launch/day6_display.launch.py"
    assert "open('/home/anna/ros2_ws/src" in launch.read_text()
