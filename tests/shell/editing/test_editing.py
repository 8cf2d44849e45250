"""A student's file is written whole or not at all, and what was not saved is never lost."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from day6_core.shell.editing import file as file_module
from day6_core.shell.editing.checks import check, language_of
from day6_core.shell.editing.file import CannotEdit, TextFile
from day6_core.shell.editing.model import Editor


@pytest.fixture
def state(tmp_path: Path) -> Path:
    return tmp_path / "state"


def opened(path: Path, state: Path) -> Editor:
    editor = Editor(path.parent, state, "nano")
    editor.open(path)
    return editor


def test_a_saved_text_is_the_file(tmp_path: Path, state: Path) -> None:
    editor = opened(tmp_path / "new folder" / "轮子.py", state)
    assert editor.text == ""
    editor.save("print('你好')\n")
    assert (tmp_path / "new folder" / "轮子.py").read_text(encoding="utf-8") == "print('你好')\n"
    assert os.listdir(tmp_path / "new folder") == ["轮子.py"]


def test_line_ends_of_windows_stay(tmp_path: Path, state: Path) -> None:
    path = tmp_path / "a.py"
    path.write_bytes(b"x = 1\r\ny = 2\r\n")
    editor = opened(path, state)
    assert editor.text == "x = 1\ny = 2\n"
    editor.save(editor.text + "z = 3\n")
    assert path.read_bytes() == b"x = 1\r\ny = 2\r\nz = 3\r\n"


def test_a_full_disk_leaves_the_old_file(tmp_path: Path, state: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    editor = opened(path, state)

    def full(handle: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(file_module.os, "fsync", full)
    with pytest.raises(OSError, match="No space left on device"):
        editor.save("new\n")
    assert path.read_text() == "old\n"
    assert sorted(os.listdir(tmp_path)) == ["a.py", state.name]


@pytest.mark.skipif(sys.platform == "win32", reason="permissions are other ones there")
def test_a_script_stays_executable(tmp_path: Path, state: Path) -> None:
    path = tmp_path / "run.py"
    path.write_text("#!/usr/bin/env python3\n")
    path.chmod(0o755)
    opened(path, state).save("#!/usr/bin/env python3\nprint(1)\n")
    assert path.stat().st_mode & 0o777 == 0o755


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_link_stays_a_link(tmp_path: Path, state: Path) -> None:
    (tmp_path / "real.py").write_text("old\n")
    (tmp_path / "link.py").symlink_to("real.py")
    opened(tmp_path / "link.py", state).save("new\n")
    assert (tmp_path / "link.py").is_symlink() and (tmp_path / "real.py").read_text() == "new\n"


def test_unsaved_text_comes_back_after_a_crash(tmp_path: Path, state: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    killed = opened(path, state)
    killed.keep("typed and never saved\n")
    killed.close()  # as the system does with what a process held
    again = opened(path, state)
    assert (again.text, again.recovered) == ("typed and never saved\n", True)
    assert path.read_text() == "old\n"
    again.save(again.text)
    again.close()
    assert not opened(path, state).recovered


def test_a_kept_copy_that_was_cut_short_does_no_harm(tmp_path: Path, state: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    killed = opened(path, state)
    killed.keep("typed\n")
    killed.close()
    (copy,) = state.glob("*.json")
    copy.write_bytes(copy.read_bytes()[:20])
    assert opened(path, state).text == "old\n"


def test_a_change_by_another_editor_is_noticed(tmp_path: Path, state: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    editor = opened(path, state)
    assert not editor.changed_outside()
    path.write_text("written by gedit\n")
    assert editor.changed_outside()
    assert editor.reload() == "written by gedit\n" and not editor.changed_outside()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda path: path.mkdir(), "is a directory"),
        (lambda path: path.write_bytes(b"abc\xff\xfe"), r"not UTF-8 text \(byte 3\)"),
        (lambda path: path.write_bytes(b" " * 4_000_001), "larger than 4 MB"),
    ],
)
def test_what_cannot_be_edited_says_why(tmp_path: Path, state: Path, make: object, message: str) -> None:
    path = tmp_path / "a.txt"
    make(path)  # type: ignore[operator]
    with pytest.raises(CannotEdit, match=message):
        TextFile(path, state).read()


@pytest.mark.parametrize(
    ("name", "text", "line", "message"),
    [
        ("a.py", "def f():\nreturn 1\n", 2, "IndentationError: expected an indented block"),
        ("a.py", "x = 1\n", None, ""),
        ("package.xml", "<package>\n  <name>a</nam>\n</package>", 2, "mismatched tag"),
        ("p.yaml", "a: 1\n b: 2\n", 2, "mapping values are not allowed here"),
        ("car.urdf", '<robot name="r">\n<link name="a"/>\n<link name="a"/>\n</robot>', 3, "link 'a' is not unique."),
        ("notes.txt", "def f(:", None, ""),
    ],
)
def test_the_first_mistake_is_named_with_its_line(name: str, text: str, line: int | None, message: str) -> None:
    problem = check(Path(name), text)
    assert (problem.line if problem else None) == line
    assert problem is None or message in problem.message


def test_the_language_is_told_by_the_name() -> None:
    names = ["a.py", "a.urdf", "a.launch.xml", "x.yaml", ".bashrc", "README.md", "a.stl"]
    assert [language_of(Path(name)) for name in names] == ["python", "xml", "xml", "yaml", "bash", "markdown", ""]


def test_a_folder_offers_its_sources_and_not_what_was_built(tmp_path: Path, state: Path) -> None:
    for name in ("src/a/a/node.py", "src/a/setup.py", "build/a/x.py", "install/setup.bash", ".git/config", "log/x.txt"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    found = [path.relative_to(tmp_path).as_posix() for path in Editor(tmp_path, state, "code").files()]
    assert found == ["src/a/a/node.py", "src/a/setup.py"]
