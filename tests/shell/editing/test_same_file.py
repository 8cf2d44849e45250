"""A save leaves the file the same file: its other names, its mode, its owner, its access list, as nano does."""

from __future__ import annotations

import errno
import os
import shutil
import stat
import sys
from pathlib import Path

import pytest

from day6_core.shell.editing.model import Editor
from day6_core.whole_file import must_stay, overwrite_file
from tests.support.disks import ROOT, SETPRIV, WITHOUT_RIGHTS

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no modes, and links need rights there")


def opened(path: Path, state: Path) -> Editor:
    editor = Editor(path.parent, state, "nano")
    editor.open(path)
    return editor


def test_both_names_of_a_file_show_what_was_saved_under_one(tmp_path: Path) -> None:
    first, second = tmp_path / "first.py", tmp_path / "second.py"
    first.write_text("old and rather long\n")
    os.link(first, second)
    editor = opened(first, tmp_path / "state")
    for text in ("new\n", "new and longer than the text before\n", "", "x"):
        editor.save(text)
        assert second.read_text() == text and os.path.samefile(first, second)
    assert not list((tmp_path / "state").glob("*.json")), "the copy is gone when the file is whole"


def test_a_file_with_two_names_is_written_only_when_a_copy_is_kept(tmp_path: Path) -> None:
    first, state = tmp_path / "first.py", tmp_path / "state"
    first.write_text("old\n")
    os.link(first, tmp_path / "second.py")
    editor = opened(first, state)
    shutil.rmtree(state)
    state.write_text("no folder")
    with pytest.raises(OSError):
        editor.save("new\n")
    assert first.read_text() == "old\n"


@pytest.mark.parametrize("new", [b"longer than before", b"s"])
def test_a_disk_that_is_full_leaves_a_file_with_two_names_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, new: bytes
) -> None:
    path = tmp_path / "first.py"
    path.write_bytes(b"before")
    real = os.write
    written = 0

    def write(number: int, data: bytes) -> int:
        nonlocal written
        if written >= 2:
            raise OSError(errno.ENOSPC, "No space left on device")
        written += real(number, bytes(data)[: 2 - written])
        return min(2, len(data))

    monkeypatch.setattr(os, "write", write)
    if len(new) > len(b"before"):
        with pytest.raises(OSError, match="No space left on device"):
            overwrite_file(path, new)
        assert path.read_bytes() == b"before"
    else:
        overwrite_file(path, new)
        assert path.read_bytes() == new


@pytest.mark.skipif(not hasattr(os, "setxattr"), reason="Linux' attributes")
def test_attributes_and_with_them_access_lists_stay(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    try:
        os.setxattr(path, "user.day6", b"mine")
    except OSError:
        pytest.skip("this file system keeps no attributes")
    opened(path, tmp_path / "state").save("new\n")
    assert path.read_text() == "new\n" and os.getxattr(path, "user.day6") == b"mine"


def test_a_link_to_a_file_with_two_names_is_followed(tmp_path: Path) -> None:
    first, second, link = tmp_path / "first.py", tmp_path / "second.py", tmp_path / "link.py"
    first.write_text("old\n")
    os.link(first, second)
    link.symlink_to(first)
    opened(link, tmp_path / "state").save("new\n")
    assert link.is_symlink() and second.read_text() == first.read_text() == "new\n"


@pytest.mark.parametrize("mode", [0o640, 0o755, 0o666, 0o4755])
def test_the_mode_stays(tmp_path: Path, mode: int) -> None:
    if mode == 0o4755 and not ROOT:
        pytest.skip("the system takes the set-user-ID bit off what another user than root writes")
    path = tmp_path / "a.py"
    path.write_text("old\n")
    path.chmod(mode)
    opened(path, tmp_path / "state").save("new\n")
    assert stat.S_IMODE(path.stat().st_mode) == mode


@pytest.mark.skipif(not ROOT, reason="only root gives files away")
def test_root_leaves_a_file_with_its_owner_and_group(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    os.chown(path, 1234, 4321)
    opened(path, tmp_path / "state").save("new\n")
    assert (path.stat().st_uid, path.stat().st_gid) == (1234, 4321)


def save_without_rights(path: Path, state: Path, text: str) -> str:
    """Save as a user for whom modes count; return what was raised, '' for nothing."""
    import subprocess

    if ROOT and SETPRIV is None:
        pytest.skip("root may write everywhere, and setpriv is not there")
    code = (
        "import sys; from pathlib import Path; from day6_core.shell.editing.model import Editor\n"
        "path = Path(sys.argv[1]); editor = Editor(path.parent, Path(sys.argv[2]), 'nano'); editor.open(path)\n"
        "try: editor.save(sys.argv[3])\n"
        "except OSError as error: print(error.strerror, end='')"
    )
    command = [sys.executable, "-c", code, str(path), str(state), text]
    if ROOT:
        command = [str(SETPRIV), *WITHOUT_RIGHTS, *command]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.process
def test_a_file_of_ones_own_in_a_folder_that_is_not_can_be_saved(tmp_path: Path) -> None:
    folder = tmp_path / "locked"
    folder.mkdir()
    (folder / "a.py").write_text("old\n")
    folder.chmod(0o500)
    assert save_without_rights(folder / "a.py", tmp_path / "state", "new\n") == ""
    assert (folder / "a.py").read_text() == "new\n"
    folder.chmod(0o700)


@pytest.mark.process
def test_a_file_that_may_only_be_read_is_not_replaced(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text("old\n")
    path.chmod(0o444)
    assert save_without_rights(path, tmp_path / "state", "new\n") == "Permission denied"
    assert path.read_text() == "old\n"


def test_an_ordinary_file_is_replaced_at_once(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("old\n")
    assert not must_stay(tmp_path / "a.py") and not must_stay(tmp_path / "none.py") and not must_stay(tmp_path)
