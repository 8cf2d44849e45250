"""Files are written in one way: whole or not at all, with the mode they should have, and nothing left over."""

from __future__ import annotations

import errno
import io
import os
import re
import signal
import stat
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from day6_core.whole_file import append_private, replace_file, write_private
from tests.support.source_files import sources
from tests.support.waiting import until

ROOT = Path(__file__).parents[2]
posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no modes")


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@pytest.fixture
def umask_027() -> object:
    before = os.umask(0o027)
    yield
    os.umask(before)


@posix
def test_a_new_file_obeys_the_umask_and_an_old_one_keeps_its_mode(tmp_path: Path, umask_027: object) -> None:
    new, old, script = tmp_path / "new", tmp_path / "old", tmp_path / "script"
    old.write_bytes(b"old")
    old.chmod(0o604)
    replace_file(new, b"n")
    replace_file(old, b"o")
    replace_file(script, b"s", mode=0o777)
    assert [mode(path) for path in (new, old, script)] == [0o640, 0o604, 0o750]
    assert old.read_bytes() == b"o"


@posix
def test_private_files_are_private_also_where_they_were_not(tmp_path: Path) -> None:
    folder = tmp_path / "state"
    folder.mkdir(mode=0o755)
    (folder / "copy").write_bytes(b"old")
    (folder / "copy").chmod(0o644)
    write_private(folder / "copy", b"new")
    write_private(folder / "deep" / "er" / "copy", b"new")
    history = tmp_path / "history"
    history.write_bytes(b"a\n")
    history.chmod(0o664)
    append_private(history, b"b\n")
    append_private(tmp_path / "other", b"c\n")
    assert [mode(path) for path in (folder, folder / "copy", folder / "deep" / "er")] == [0o700, 0o600, 0o700]
    assert [mode(path) for path in (history, tmp_path / "other")] == [0o600, 0o600]
    assert history.read_bytes() == b"a\nb\n"


@posix
def test_a_link_is_followed_or_replaced_as_wanted(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"old")
    (tmp_path / "link").symlink_to("file")
    replace_file(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "file").read_bytes() == b"new"
    replace_file(tmp_path / "link", b"own", follow=False)
    assert not (tmp_path / "link").is_symlink() and (tmp_path / "file").read_bytes() == b"new"


def fails(target: Path, number: int) -> None:
    """Writing `target` raises the error of that number, which names it, and leaves no other file."""
    before = sorted(target.parent.iterdir()) if target.parent.is_dir() else []
    with pytest.raises(OSError) as caught:
        replace_file(target, b"new" * 10000)
    assert (caught.value.errno, caught.value.filename) == (number, str(target))
    assert (sorted(target.parent.iterdir()) if target.parent.is_dir() else []) == before


def test_a_folder_in_the_place_and_a_folder_that_is_gone(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    fails(tmp_path / "folder", errno.EISDIR)
    fails(tmp_path / "nowhere" / "file", errno.ENOENT)


@pytest.mark.usefixtures("plain_user")
def test_a_read_only_folder(tmp_path: Path) -> None:
    folder = tmp_path / "locked"
    folder.mkdir()
    (folder / "file").write_bytes(b"old")
    folder.chmod(0o500)
    fails(folder / "file", errno.EACCES)
    assert (folder / "file").read_bytes() == b"old"
    folder.chmod(0o700)


@pytest.mark.parametrize("step", ["fsync", "replace"])
def test_a_full_disk_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    def full(*arguments: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    (tmp_path / "file").write_bytes(b"old")
    monkeypatch.setattr(os, step, full)
    fails(tmp_path / "file", errno.ENOSPC)
    assert (tmp_path / "file").read_bytes() == b"old"


@pytest.mark.skipif(os.name != "posix" or not os.path.exists("/dev/full"), reason="/dev/full is Linux's")
def test_a_device_is_written_to_and_stays_one(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("/dev/full")
    with pytest.raises(OSError, match="No space left"):
        replace_file(tmp_path / "link", b"x")
    replace_file(Path("/dev/null"), b"x")
    assert all(stat.S_ISCHR(os.stat(name).st_mode) for name in ("/dev/null", "/dev/full"))


WRITER = """
import sys
from pathlib import Path
from day6_core.whole_file import replace_file
print("ready", flush=True)
number = 0
while True:
    number += 1
    replace_file(Path(sys.argv[1]), bytes([65 + number % 26]) * (200_000 + number % 7), sync=False)
"""


@pytest.mark.process
@posix
def test_kill_9_in_the_middle_of_saving_leaves_one_whole_text(tmp_path: Path) -> None:
    target = tmp_path / "file"
    target.write_bytes(b"A" * 200_001)
    for attempt in range(8):
        with subprocess.Popen([sys.executable, "-c", WRITER, str(target)], stdout=subprocess.PIPE) as writer:
            assert writer.stdout is not None and writer.stdout.readline()
            first = target.stat().st_mtime_ns
            until(lambda first=first: target.stat().st_mtime_ns != first, every=0)  # it has begun to write
            for _ in range(attempt * 40):
                target.stat()
            writer.send_signal(signal.SIGKILL)
        data = target.read_bytes()
        assert len(data) >= 200_000 and data == data[:1] * len(data)


ALLOWED = {
    "day6_core/whole_file.py": "the one way",
    "day6_core/shell/outward/subshell.py": "scripts in a temporary folder of its own",
    "day6_core/workspace/create.py": "a new package, which is a hidden folder until it is whole",
    "day6_core/ros/python/rosbag2_py/_reader.py": "unpacks into a temporary folder",
    "day6_core/shell/builtins/shell_itself.py": "`umask` only shows what it is",
    "day6_core/shell/language/substitution.py": "the temporary file of `<( )`, gone with the command that reads it",
    "day6_core/workspace/files.py": "colcon's output: the one way, and only where colcon may write",
    "day6_core/ros/executables.py": "commands for PATH, in a new folder that gets its name when it is whole",
    "day6_core/lessons/grading/archive.py": "unpacks into a temporary folder",
    "day6_core/lessons/grading/apart.py": "in a temporary folder of its own",
    "day6_core/lessons/grading/shield.py": "not files: what the kernel reads in /proc",
    "day6_core/isolation/attacks.py": "what one cell tries on another; the files are its own, in a folder of the trial's",
    "day6_core/isolation/enter.py": "writes no file: the umask of the pupil's program, which it becomes",
    "day6_core/isolation/groups.py": "not files: control groups",
    "day6_core/isolation/trial.py": "in a temporary folder of its own",
    "day6_core/link/paths.py": "the link knows nothing of the rest; its folder is private",
}


def test_nothing_else_writes_files_in_a_way_of_its_own() -> None:
    # `output` is day6_core/workspace/files.py's Output, which writes in the one way and only what is its own.
    ways = re.compile(r"(?<!output)\.write_(?:text|bytes)\(|mkstemp\(|os\.umask\(")
    found = set()
    for path, text in sources():
        if ways.search(text):
            found.add(path.as_posix())
    assert found <= set(ALLOWED), found - set(ALLOWED)


# -- what the windows and commands write -------------------------------------------------------------------------------


def export(path: Path) -> None:
    from day6_core.workspace.export import export as pack

    package = path.parent / "src" / "one"
    package.mkdir(parents=True, exist_ok=True)
    (package / "package.xml").write_text(
        "<package format='3'><name>one</name><version>0.0.0</version><description>d</description>"
        "<maintainer email='a@b.c'>m</maintainer><license>l</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (package / "setup.py").write_text("from setuptools import setup\nsetup(name='one')\n")
    pack(path.parent, [], path / "out.zip", replace=True)


def copy_model(path: Path) -> None:
    from day6_urdf.shipped import copy_model as copy

    copy(path)


def metadata(path: Path) -> None:
    import rosbag2_py

    rosbag2_py.MetadataIo().write_metadata(str(path), rosbag2_py.BagMetadata())


def vscode(path: Path) -> None:
    from day6_core.shell.outward.ide import write_vscode

    write_vscode(path, path / "stubs")


WRITERS: dict[str, Callable[[Path], object]] = {
    "metadata.yaml": metadata,
    "out.zip": export,
    ".vscode/settings.json": vscode,
}


@pytest.mark.parametrize("name", WRITERS)
def test_each_writer_leaves_the_old_file_whole_on_a_full_disk(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    folder = tmp_path / "here"
    old = folder / name
    old.parent.mkdir(parents=True)
    before = {".json": b"{}", ".zip": b"PK\5\6" + bytes(18)}.get(
        old.suffix, b"old"
    )  # an empty zip: no other is replaced
    old.write_bytes(before)

    def full(source: object, target: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OSError, match="No space left"):
        WRITERS[name](folder)
    assert old.read_bytes() == before
    assert [path.name for path in old.parent.iterdir()] == [old.name]


def test_an_export_that_fails_half_way_leaves_no_zip(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "here"
    folder.mkdir()

    def full(*arguments: object, **more: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(zipfile.ZipFile, "open", full)
    with pytest.raises(OSError, match="No space left"):
        export(folder)
    assert not list(folder.iterdir())


@pytest.mark.process
def test_a_robot_that_was_half_copied_is_not_taken_for_ones_own_the_next_time(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    line = "from day6_urdf.shipped import copy_model; from pathlib import Path; copy_model(Path('.'))"
    result = subprocess.run(
        [sys.executable, "-c", line],
        cwd=tmp_path,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},  # Python would leave halves of its own
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)),
        capture_output=True,
        text=True,
        check=False,
    )
    assert "OSError" in result.stderr and not list(tmp_path.iterdir())


@posix
def test_the_log_of_the_desktop_is_private_and_a_full_disk_does_not_show(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import logging

    from day6_tui.screen.log_file import keep_log_off_the_screen

    handlers: list[logging.Handler] = []
    monkeypatch.setattr(logging.getLogger(), "addHandler", handlers.append)
    keep_log_off_the_screen({"DAY6_LOG": str(tmp_path / "log")})
    keep_log_off_the_screen({"DAY6_LOG": "/dev/full"})
    record = logging.makeLogRecord({"msg": "hello"})
    for handler in handlers:
        handler.handle(record)
    assert "hello" in (tmp_path / "log").read_text() and mode(tmp_path / "log") == 0o600
    assert capfd.readouterr().err == ""
    keep_log_off_the_screen({"DAY6_LOG": str(tmp_path / "no" / "log")})
    assert "No such file or directory" in capfd.readouterr().err
    handlers[0].close()


@posix
def test_the_history_of_the_terminals_is_private(tmp_path: Path) -> None:
    from day6_core.shell.line.history import History

    file = tmp_path / ".bash_history"
    file.write_text("ls\n")
    file.chmod(0o644)
    History(file).add("echo secret")
    assert mode(file) == 0o600 and file.read_text() == "ls\necho secret\n"


@posix
def test_half_a_line_is_not_left_where_the_disk_is_full(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Filling(io.FileIO):
        def write(self, data: Any) -> int:
            if len(data) == 3:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            return super().write(data[:-3])

    file = tmp_path / "f"
    append_private(file, b"one\n")
    monkeypatch.setattr("day6_core.whole_file.open", lambda number, *_, **__: Filling(number, "wb"), raising=False)
    with pytest.raises(OSError, match=os.strerror(errno.ENOSPC)):
        append_private(file, b"second\n")
    assert file.read_bytes() == b"one\n"
