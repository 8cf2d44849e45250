"""The folders of executables, one per interpreter: made when needed, completed by a newer version, removed when it is gone."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from day6_core.ros import executables
from day6_core.ros.executables import is_executable_of_ours, remove_orphans, texts, with_executables

posix_only = pytest.mark.skipif(
    os.name == "nt", reason="a batch file names no interpreter, so there is one folder for all"
)


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty data folder; this process forgets which folder it has."""
    monkeypatch.setattr(executables, "data_folder", lambda: tmp_path / "data")
    forget()
    yield tmp_path / "data"
    monkeypatch.undo()
    forget()


def forget() -> None:
    for each in (executables.texts, executables._digest, executables._folder):
        each.cache_clear()


def used_by(interpreter: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder that an installation with this interpreter puts on the PATH, where it needs one for the first time."""
    forget()
    monkeypatch.setattr(sys, "executable", str(interpreter))
    return Path(with_executables("/usr/bin").split(os.pathsep)[0])


def interpreter(folder: Path) -> Path:
    folder.mkdir(parents=True)
    (folder / "python3").touch()
    return folder / "python3"


@posix_only
def test_the_folder_of_an_installation_goes_when_its_interpreter_has_gone(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = interpreter(tmp_path / "o'ne venv"), interpreter(tmp_path / "two")
    of_first, of_second = used_by(first, monkeypatch), used_by(second, monkeypatch)
    assert {of_first, of_second} == set(data.iterdir()) and (of_first / "ros2").is_file()
    first.unlink()
    of_third = used_by(interpreter(tmp_path / "three"), monkeypatch)
    assert {of_second, of_third} == set(data.iterdir())
    assert set(os.listdir(of_second)) == set(texts())


@posix_only
def test_a_newer_version_of_the_same_interpreter_has_the_same_folder_and_adds_what_is_missing(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    python = interpreter(tmp_path / "one")
    with monkeypatch.context() as older:
        older.setattr(executables, "COMMANDS", {"rqt": ("rqt", "rqt")})
        before = used_by(python, older)
        assert not (before / "rviz2").exists()
        path = with_executables("/usr/bin")
    inode = (before / "ros2").stat().st_ino
    assert used_by(python, monkeypatch) == before and (before / "rviz2").is_file()
    assert (before / "ros2").stat().st_ino == inode  # whoever runs it is not disturbed
    (before / "rviz2").unlink()
    forget()
    assert with_executables(path) == path and os.access(before / "rviz2", os.X_OK)
    assert list(data.iterdir()) == [before]


@posix_only
def test_what_is_not_ours_in_such_a_folder_stays(data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    python = interpreter(tmp_path / "one")
    folder = used_by(python, monkeypatch)
    (folder / "notes.txt").write_text("mine\n", encoding="utf-8")
    (folder / "link").symlink_to(folder / "ros2")
    (data / "bin-mine").mkdir()
    (data / "bin-mine/python3").write_text("#!/bin/sh\necho mine\n", encoding="utf-8")
    (data / "bin-link").symlink_to(folder)
    python.unlink()
    remove_orphans(data)
    assert {each.name for each in folder.iterdir()} == {"notes.txt", "link"}
    assert (data / "bin-mine/python3").exists() and (data / "bin-link").is_symlink()


def test_only_our_own_files_count_as_ours(tmp_path: Path) -> None:
    written = {f"{system}-{name}": text for system in ("posix", "nt") for name, text in texts(system).items()}
    for name, text in written.items():
        (tmp_path / name).write_text(text, encoding="utf-8", newline="")
        assert is_executable_of_ours(tmp_path / name), name
    for number, text in enumerate(
        ("", "#!/bin/sh\n", "#!/bin/sh\nexec ls\n", "#!/bin/sh\nexec '", "\0", "exec a b $@")
    ):
        (tmp_path / f"{number}.txt").write_text(text, encoding="utf-8")
        assert not is_executable_of_ours(tmp_path / f"{number}.txt"), text
    assert not is_executable_of_ours(tmp_path) and not is_executable_of_ours(tmp_path / "nothing")


@posix_only
@pytest.mark.process
def test_several_installations_leave_one_folder_each_and_what_is_in_use_works(tmp_path: Path) -> None:
    """Three interpreters in turn, each a link to this one, as in a virtual environment."""
    environment = {**os.environ, "XDG_DATA_HOME": str(tmp_path / "data"), "HOME": str(tmp_path)}
    environment["PYTHONPATH"] = os.pathsep.join(sys.path)
    kept = {}
    for name in ("one", "two", "three"):
        python = tmp_path / name / "python3"
        python.parent.mkdir()
        python.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} "$@"\n', encoding="utf-8")
        python.chmod(0o755)
        code = (
            f"import sys; sys.executable = {str(python)!r}\n"
            "from day6_core.ros.executables import with_executables; print(with_executables('/bin').split(':')[0])"
        )
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
        kept[name] = Path(done.stdout.strip())
        if name == "two":
            (tmp_path / "one/python3").unlink()
    assert set(kept["two"].parent.iterdir()) == {kept["two"], kept["three"]}
    done = subprocess.run([kept["two"] / "ros2", "--help"], env=environment, capture_output=True, text=True)
    assert done.returncode == 0 and "usage: ros2" in done.stdout
