"""A file that a teacher hands out, in a pupil's home: under which name, beside what is there, and what is answered."""

from __future__ import annotations

import errno
import json
import os
import sys
from pathlib import Path

import pytest

from day6_core.classroom import handed
from day6_core.classroom.handed import LARGEST, Answer, message, put, read_answer, receive


def test_a_file_is_never_changed_and_the_same_one_is_the_one(tmp_path: Path) -> None:
    assert put(tmp_path, "a.py", b"one") == put(tmp_path, "a.py", b"one") == "handed/a.py"
    assert put(tmp_path, "a.py", b"two") == put(tmp_path, "a.py", b"two") == "handed/a_2.py"
    assert sorted(path.read_bytes() for path in (tmp_path / "handed").iterdir()) == [b"one", b"two"]


@pytest.mark.skipif(sys.platform == "win32", reason="links need a right there")
def test_a_link_in_its_place_is_not_written_through(tmp_path: Path) -> None:
    (tmp_path / "handed").mkdir()
    outside = tmp_path / "outside"
    (tmp_path / "handed" / "a.py").symlink_to(outside)
    assert put(tmp_path, "a.py", b"one") == "handed/a_2.py" and not outside.exists()
    outside.write_bytes(b"two")
    assert put(tmp_path, "a.py", b"two") == "handed/a_3.py"


@pytest.mark.parametrize(
    ("name", "kept"),
    [
        ("../../.bashrc", "bashrc"),
        ("a\x1b[2J\n.py", "a[2J.py"),
        ("..", "file"),
        ("C:\\x\\y.txt", "y.txt"),
        ("", "file"),
    ],
)
def test_a_name_leads_nowhere_else_whoever_sends_it(tmp_path: Path, name: str, kept: str) -> None:
    sent = json.dumps(name).encode() + b"\ndata"  # by somebody who does not clean it
    assert read_answer(receive(tmp_path, sent)) == Answer(f"handed/{kept}")
    assert [path.name for path in tmp_path.iterdir()] == ["handed"]
    assert (tmp_path / "handed" / kept).read_bytes() == b"data"


@pytest.mark.parametrize(
    "sent", [b"", b"a.py", b'"a.py"', b"7\ndata", b"[" * 100_000 + b"\n", message("a.py", b"a" * (LARGEST + 1))]
)
def test_what_is_no_file_is_refused_with_a_reason(tmp_path: Path, sent: bytes) -> None:
    assert read_answer(receive(tmp_path, sent)).why and not any(tmp_path.iterdir())


def test_a_full_disk_is_told_in_the_systems_words_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "handed").mkdir()

    def full(path: Path, data: bytes) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(handed, "_write_new", full)
    assert read_answer(receive(tmp_path, message("a.py", b"data"))) == Answer(why=os.strerror(errno.ENOSPC))


@pytest.mark.skipif(sys.platform == "win32" or not Path("/dev/full").exists(), reason="a disk that is always full")
def test_half_a_file_is_taken_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, real = tmp_path / "a.py", Path.open

    def open_full(self: Path, mode: str) -> object:
        real(self, mode).close()
        return real(Path("/dev/full"), "wb")

    monkeypatch.setattr(Path, "open", open_full)
    with pytest.raises(OSError, match=os.strerror(errno.ENOSPC)):
        handed._write_new(path, b"data")
    assert not path.exists()


def test_a_folder_that_is_a_file_is_told(tmp_path: Path) -> None:
    (tmp_path / "handed").write_bytes(b"mine")
    assert read_answer(receive(tmp_path, message("a.py", b"data"))).why
    assert (tmp_path / "handed").read_bytes() == b"mine"


@pytest.mark.parametrize(
    "data",
    [b"", b"7", b"{}", b'{"path": "", "why": ""}', b'{"path": "a", "why": "b"}', b"[" * 100_000, b" " * 5000 + b"{}"],
)
def test_what_is_no_answer_is_refused(data: bytes) -> None:
    with pytest.raises(ValueError):
        read_answer(data)


def test_an_answer_is_harmless_on_a_terminal() -> None:
    found = read_answer(json.dumps({"path": "", "why": "\x1b[2Jno\nroom" + "x" * 1000}).encode())
    assert found.why.isprintable() and len(found.why) <= 200
