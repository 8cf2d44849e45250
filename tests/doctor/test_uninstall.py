"""`day6-tui uninstall`: lists everything, removes what is its own, and never what is not."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from day6_core import places
from day6_core.link.file_lock import FileLock
from day6_core.places import BASES, LEFT_BEHIND
from day6_core.ros.executables import write_executables
from day6_tui.upkeep import installation, uninstall
from day6_tui.upkeep.removal import Size, size_of
from day6_tui.upkeep.running import Running, running
from tests.support.short_folder import make_short_folder

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="says where its folders are by XDG_DATA_HOME")

SOCKETS = (
    "0/meet",
    "0/meeting.lock",
    "desktop-0a1b2c3d.lock",
    "c0a1b2c3d/k/desktop-0a1b2c3d.lock",
    "c0a1b2c3d/p/0a1b2c3d/0/port",
)


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A user's home folder in which day6-tui has been used."""
    for name, value in (
        ("HOME", tmp_path),
        ("XDG_DATA_HOME", tmp_path / "share"),
        ("DAY6_RUNTIME_DIR", make_short_folder("d6u-") / "run"),
        ("ROS_LOG_DIR", tmp_path / ".ros/log"),
    ):
        monkeypatch.setenv(name, str(value))
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr("tempfile.gettempdir", lambda: str(tmp_path / "temporary"))
    monkeypatch.setitem(BASES, "system", BASES["system"]._replace(find=list))  # a server of root's may run here
    data, run = tmp_path / "share/day6-tui", runtime()
    for path in (
        *(
            "settings.json",
            "stubs/std_msgs/msg/__init__.pyi",
            "stubs/std_msgs/__init__.pyi",
            "stubs-humble/a/srv/__init__.pyi",
        ),
        *("home/ros2_ws/src/car/setup.py", "home/.config/day6-tui/pupils/anna.json", "home/.bash_history"),
        *("unsaved/text", "class/homes/anna/x.py", "class/server/tokens.json"),
    ):
        write(data / path)
    for name in SOCKETS:
        write(run / name)
    write(tmp_path / ".ros/log/x.log")
    for name in ("bin-0123456789ab", ".bin-abcdefgh"):
        (data / name).mkdir()
        write_executables(data / name)
    yield tmp_path


def runtime() -> Path:
    return Path(os.environ["DAY6_RUNTIME_DIR"])


def write(path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("x" * 1000, encoding="utf-8")


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file() or path.is_symlink()}


USERS = {
    *("home/ros2_ws/src/car/setup.py", "home/.config/day6-tui/pupils/anna.json", "home/.bash_history"),
    *("unsaved/text", "class/homes/anna/x.py", "class/server/tokens.json"),
}


def test_without_options_everything_is_listed_and_nothing_removed(
    home: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = files(home) | files(runtime())
    assert uninstall.main(["--lang", "en"]) == 0
    told = capsys.readouterr().out
    assert files(home) | files(runtime()) == before
    assert "~/share/day6-tui/settings.json" in told and "1.0 kB" in told and "rm -r ~/share/day6-tui/home\n" in told
    assert "~/.ros/log" in told.partition("always kept")[2] and str(home) not in told
    for name in ("bin-0123456789ab", ".bin-abcdefgh", "stubs", "stubs-humble", "unsaved", "class"):
        assert f"~/share/day6-tui/{name} " in told, name


def test_data_goes_and_the_users_files_stay(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert uninstall.main(["--data", "--yes", "--lang", "en"]) == 0
    assert files(home / "share/day6-tui") == USERS and (home / ".ros/log/x.log").exists()
    assert not runtime().exists()
    told = capsys.readouterr().out
    assert "Your files were kept:" in told and "rm -r ~/share/day6-tui/class\n" in told


def test_what_a_killed_program_has_left_goes_after_a_day(home: Path) -> None:
    old, new = home / "temporary/day6-shell-abcdefgh", home / "temporary/day6-shell-ijklmnop"
    for folder in (old, new):
        write(folder / "rc")
    os.utime(old, (1, old.stat().st_mtime - LEFT_BEHIND - 60))
    assert uninstall.main(["--data", "--yes"]) == 0
    assert not old.exists() and new.exists()


def test_with_files_nothing_is_left_but_what_a_real_ros_shares(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert uninstall.main(["--data", "--files", "--yes"]) == 0
    assert files(home) == {".ros/log/x.log"} and not (home / "share/day6-tui").exists()


def test_foreign_files_stay_and_are_named_and_no_link_is_followed(
    home: Path, capsys: pytest.CaptureFixture[str], tmp_path_factory: pytest.TempPathFactory
) -> None:
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    write(elsewhere / "kept.py")
    data = home / "share/day6-tui"
    for path in (data / "stubs/mine.txt", data / "bin-0123456789ab/mine", runtime() / "0/mine", data / "mine"):
        write(path)
    (data / "bin-linked").symlink_to(elsewhere)
    (data / "home/linked").symlink_to(elsewhere)
    (data / "stubs/linked").symlink_to(elsewhere)
    assert uninstall.main(["--data", "--files", "--yes", "--lang", "en"]) == 0
    assert files(elsewhere) == {"kept.py"}
    assert files(data) == {"stubs/mine.txt", "bin-0123456789ab/mine", "mine", "bin-linked", "stubs/linked"}
    assert files(runtime()) == {"0/mine"}
    told = capsys.readouterr().out
    for name in ("stubs/mine.txt", "bin-0123456789ab/mine", "bin-linked", "stubs/linked"):
        assert f"left alone, not from day6-tui: ~/share/day6-tui/{name}\n" in told, name


@pytest.mark.parametrize(("language", "what"), [("en", "a detached desktop"), ("zh", "一个已分离的桌面")])
def test_nothing_is_removed_while_a_desktop_runs(
    home: Path, capsys: pytest.CaptureFixture[str], language: str, what: str
) -> None:
    before = files(home) | files(runtime())
    held = FileLock(runtime() / "desktop-0a1b2c3d.lock")
    assert held.try_acquire()
    try:
        assert uninstall.main(["--data", "--yes", "--lang", language]) == 1
    finally:
        held.release()
    assert what in capsys.readouterr().err
    assert files(home) | files(runtime()) == before
    assert running() == []


def test_programs_and_servers_that_run_are_seen_and_this_process_is_not(home: Path) -> None:
    write(runtime() / "3" / f"p-0a1b-{os.getppid()}")
    write(runtime() / "3" / f"p-0a1b-{os.getpid()}")
    write(runtime() / "3" / "p-0a1b-4194304")  # more than a process id can be
    server = FileLock(runtime() / "c0a1b2c3d/lock")
    assert server.try_acquire()
    try:
        assert set(running()) == {Running("program", "3", os.getppid()), Running("server")}
    finally:
        server.release()


def test_looking_for_what_runs_creates_nothing(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(runtime() / "nothing"))
    assert running() == [] and not runtime().exists()


@pytest.mark.parametrize(("answers", "left"), [("n", "all"), ("", "all"), ("y n", "files"), ("y y", "none")])
def test_each_question_is_asked_and_heard(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], answers: str, left: str
) -> None:
    given = iter(answers.split() or [""])
    asked: list[str] = []

    def answer(question: str) -> str:
        asked.append(question)
        return next(given, "n")

    monkeypatch.setattr("builtins.input", answer)
    monkeypatch.setattr(uninstall.sys, "stdin", SimpleNamespace(isatty=lambda: True))
    before = files(home / "share/day6-tui")
    assert uninstall.main(["--data", "--files", "--lang", "en"]) == (0 if left == "none" else 1)
    assert files(home / "share/day6-tui") == {"all": before, "files": USERS, "none": set()}[left]
    assert asked[0].startswith("Remove these") and asked[1].startswith("Remove YOUR files")


def test_where_nobody_can_be_asked_nothing_is_removed(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = files(home)
    assert uninstall.main(["--data", "--lang", "en"]) == 2
    assert "--yes removes without asking" in capsys.readouterr().err and files(home) == before


def test_in_a_terminal_of_the_desktop_it_refuses(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("DAY6_JOB", "x.1.")
    assert uninstall.main(["--lang", "en"]) == 1
    assert "type it in a real terminal" in capsys.readouterr().err


def test_our_folders_go_when_they_are_empty_and_others_do_not(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DAY6_RUNTIME_DIR")
    write(home / ".cache/day6-tui/run/0/meet")
    monkeypatch.setattr(places, "runtime_folders", lambda: [home / ".cache/day6-tui/run"])
    assert uninstall.main(["--data", "--files", "--yes"]) == 0
    assert list((home / ".cache").iterdir()) == [] and (home / "share").is_dir()


def test_files_alone_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as refused:
        uninstall.main(["--files", "--lang", "en"])
    assert refused.value.code == 2 and "--files goes with --data" in capsys.readouterr().err


def test_what_cannot_be_removed_is_said(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refuse(path: Path, *, missing_ok: bool = False) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "unlink", refuse)
    assert uninstall.main(["--data", "--yes"]) == 1
    assert "~/share/day6-tui/settings.json: Permission denied" in capsys.readouterr().err


def test_sizes_are_those_of_the_files(tmp_path: Path) -> None:
    write(tmp_path / "a/b")
    write(tmp_path / "c")
    (tmp_path / "a/link").symlink_to(tmp_path)
    assert size_of(tmp_path) == Size(2000 + (tmp_path / "a/link").lstat().st_size)
    assert not size_of(tmp_path, -1).whole
    assert [str(Size(each)) for each in (0, 999, 1000, 2_500_000, 3 * 10**9)] == [
        "0 B",
        "999 B",
        "1.0 kB",
        "2.5 MB",
        "3.0 GB",
    ]
    assert str(Size(1000, whole=False)) == ">1.0 kB"


class Metadata:
    """What importlib.metadata has of an installed package."""

    version = "1.2.3"

    def __init__(self, **texts: str) -> None:
        self._texts = {name.replace("_json", ".json"): text for name, text in texts.items()}

    def read_text(self, name: str) -> str | None:
        return self._texts.get(name)


EDITABLE = '{"url": "file:///src/day6%20tui", "dir_info": {"editable": true}}'


@pytest.mark.parametrize(
    ("prefix", "metadata", "kind", "command"),
    [
        ("/h/.local/share/pipx/venvs/day6-tui", {"INSTALLER": "pip\n"}, "pipx", "pipx uninstall day6-tui"),
        ("/h/.local/share/uv/tools/day6-tui", {"INSTALLER": "uv"}, "uv tool", "uv tool uninstall day6-tui"),
        ("/h/x/.venv", {"INSTALLER": "uv"}, "uv", "uv pip uninstall --python '/h/my venv/bin/python3' day6-tui"),
        ("/h/x/.venv", {"INSTALLER": "pip"}, "pip", "'/h/my venv/bin/python3' -m pip uninstall day6-tui"),
        ("/h/x/.venv", {}, "pip", "'/h/my venv/bin/python3' -m pip uninstall day6-tui"),
    ],
)
def test_the_package_is_removed_by_what_has_installed_it(
    monkeypatch: pytest.MonkeyPatch, prefix: str, metadata: dict[str, str], kind: str, command: str
) -> None:
    monkeypatch.setattr(installation, "distribution", lambda name: Metadata(**metadata))
    monkeypatch.setattr(sys, "prefix", prefix)
    monkeypatch.setattr(sys, "executable", "/h/my venv/bin/python3")
    found = installation.installation()
    assert (found.kind, found.version, found.removal(), found.source) == (kind, "1.2.3", command, None)


def test_an_editable_installation_and_a_checkout_name_their_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "distribution", lambda name: Metadata(direct_url_json=EDITABLE))
    assert installation.installation().source == Path("/src/day6 tui")

    def missing(name: str) -> Any:
        raise installation.PackageNotFoundError(name)

    monkeypatch.setattr(installation, "distribution", missing)
    monkeypatch.setattr(installation, "__file__", "/src/tui/day6_tui/upkeep/installation.py")
    found = installation.installation()
    assert (found.removal(), found.source) == ("", Path("/src").resolve())


@pytest.mark.process
def test_the_installed_command_after_a_desktop_was_used(home: Path) -> None:
    def run(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "day6_tui.main", *words],
            env={**os.environ, "TMPDIR": str(home / "temporary")},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            encoding="utf-8",
            cwd=home,
        )

    assert run("exec", "-c", "ros2 node list; echo hi > mine.txt").returncode == 0
    done = run("uninstall", "--lang", "zh")
    assert (done.returncode, done.stderr) == (0, "")
    assert "~/share/day6-tui/bin-" in done.stdout and "rm -r ~/share/day6-tui/home\n" in done.stdout
    assert run("uninstall", "--data").returncode == 2
    assert files(home / "share/day6-tui") >= USERS and (home / "share/day6-tui/settings.json").exists()
