"""`day6-tui export`: the zip builds on a real ROS 2 as it is."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import socket
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from day6_core.workspace.export import LARGEST, ExportError, export, main
from tests.workspace.workshop import Workshop

posix_only = pytest.mark.skipif(sys.platform == "win32", reason="needs links, pipes and sockets")
REAL_COLCON = os.environ.get("DAY6_REAL_COLCON") or shutil.which("colcon")
"""The real one, wherever it is installed."""


@pytest.mark.process
def test_the_zip_has_the_sources_and_nothing_that_a_build_made(workshop: Workshop, tmp_path: Path) -> None:
    workshop.create("one", "--node-name hi")
    workshop.create("two")
    workshop.run("colcon build")
    (workshop.workspace / "src/one/one/__pycache__").mkdir(exist_ok=True)
    (workshop.workspace / "src/one/one/__pycache__/hi.cpython-311.pyc").touch()
    assert export(workshop.workspace, [], tmp_path / "out.zip").packages == ["one", "two"]
    with zipfile.ZipFile(tmp_path / "out.zip") as archive:
        names = set(archive.namelist())
        assert "Packages from day6-tui: one, two\n" in archive.read("ros2_ws/README.txt").decode()
    assert {"ros2_ws/src/one/setup.py", "ros2_ws/src/one/one/hi.py", "ros2_ws/src/two/resource/two"} <= names
    assert not [name for name in names if "__pycache__" in name or "install" in name or "build" in name]


def test_only_the_packages_that_are_named(workshop: Workshop, tmp_path: Path) -> None:
    workshop.create("one")
    workshop.create("two")
    assert main(["two", "--workspace", str(workshop.workspace), "-o", str(tmp_path / "two.zip")]) == 0
    with zipfile.ZipFile(tmp_path / "two.zip") as archive:
        assert not [name for name in archive.namelist() if "/one/" in name]


def test_an_unknown_package_leaves_the_old_zip_alone(workshop: Workshop, tmp_path: Path) -> None:
    workshop.create("one")
    target = tmp_path / "out.zip"
    target.write_bytes(b"the old one")
    with pytest.raises(ExportError, match=r"no package 'tow' in .*; there are one"):
        export(workshop.workspace, ["tow"], target)
    assert target.read_bytes() == b"the old one"
    assert list(tmp_path.glob(".day6-*")) == []


def test_a_loop_of_links_is_not_followed(workshop: Workshop, tmp_path: Path) -> None:
    package = workshop.create("one")
    (package / "loop").symlink_to(package, target_is_directory=True)
    assert export(workshop.workspace, [], tmp_path / "out.zip").packages == ["one"]


@pytest.mark.outside
@pytest.mark.process
@pytest.mark.skipif(REAL_COLCON is None, reason="the real colcon is not installed here")
@pytest.mark.skipif(sys.platform == "win32", reason="sources by bash")
def test_the_real_colcon_builds_what_was_exported(workshop: Workshop, tmp_path: Path) -> None:
    assert REAL_COLCON is not None
    workshop.create("one", "--node-name hi")
    workshop.create("two", "--dependencies one")
    export(workshop.workspace, [], tmp_path / "out.zip")
    shutil.unpack_archive(tmp_path / "out.zip", tmp_path / "robot")
    folder = tmp_path / "robot" / "ros2_ws"
    env = {**os.environ, "PATH": f"{Path(REAL_COLCON).parent}{os.pathsep}{os.environ['PATH']}"}
    env.pop("PYTHONPATH", None)
    built = subprocess.run([REAL_COLCON, "build"], cwd=folder, env=env, capture_output=True, text=True, timeout=120)
    assert built.returncode == 0, built.stderr
    assert "Summary: 2 packages finished" in built.stdout
    ran = subprocess.run(
        ["bash", "-c", "source install/setup.bash && install/one/lib/one/hi"],
        cwd=folder,
        env=env,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (ran.stdout, ran.stderr) == ("Hi from one.\n", "")


def packed(target: Path) -> set[str]:
    with zipfile.ZipFile(target) as archive:
        assert archive.testzip() is None
        return {name.removeprefix("ros2_ws/src/") for name in archive.namelist()}


@posix_only
@pytest.mark.parametrize(
    "goal", ["/etc/hostname", "../../../secret.txt", "../two/setup.py", "/etc", "/dev/zero", "/gone"]
)
def test_a_link_out_of_the_package_is_refused(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str], goal: str
) -> None:
    package = workshop.create("one")
    workshop.create("two")
    (workshop.home / "secret.txt").write_text("secret\n", encoding="utf-8")
    (package / "data").symlink_to(goal)
    target = tmp_path / "out.zip"
    assert main(["--workspace", str(workshop.workspace), "-o", str(target)]) == 1
    told = capsys.readouterr()
    assert re.search(
        r"/one/data' is a link to '.*', outside the package: replace it with a copy, or remove it", told.err
    )
    assert (told.out, list(tmp_path.glob("*.zip"))) == ("", [])


@posix_only
def test_links_within_a_package_are_packed_as_what_they_lead_to_and_circles_end(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workshop.create("one")
    (package / "real").mkdir()
    (package / "real/a.txt").write_text("a\n", encoding="utf-8")
    for name in range(8):
        (package / f"real/again{name}").symlink_to("..")
        (package / f"other{name}").symlink_to("real")
    (package / "a.txt").symlink_to("real/a.txt")
    (package / "itself").symlink_to("itself")
    (package / "nothing").symlink_to("nowhere")
    target = tmp_path / "out.zip"
    assert main(["--workspace", str(workshop.workspace), "-o", str(target)]) == 0
    assert {"one/a.txt", "one/real/a.txt", "one/other0/a.txt"} <= packed(target)
    assert len(packed(target)) < 40
    told = capsys.readouterr().err
    assert "one/real/again0' leads to a folder that is packed already\n" in told
    assert "one/itself' is a broken link\n" in told
    assert "one/nothing' is a broken link\n" in told


@posix_only
def test_what_is_no_file_is_left_out_and_told(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    package = workshop.create("one")
    os.mkfifo(package / "pipe")
    monkeypatch.chdir(package)  # the path of a socket may be no longer than 100 bytes
    with socket.socket(socket.AF_UNIX) as made:
        made.bind("socket")
    target = tmp_path / "out.zip"
    assert main(["--workspace", str(workshop.workspace), "-o", str(target)]) == 0
    told = capsys.readouterr().err
    assert "one/pipe' is not a file\n" in told
    assert "one/socket' is not a file\n" in told
    assert not packed(target) & {"one/pipe", "one/socket"}


def test_a_huge_file_is_refused_at_once(workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    package = workshop.create("one")
    with open(package / "disk.img", "wb") as file:
        file.truncate(LARGEST * 100)
    assert main(["--workspace", str(workshop.workspace), "-o", str(tmp_path / "out.zip")]) == 1
    assert (
        "one/disk.img' has 50000 MB, at most 500 MB are packed: move it out of the package" in capsys.readouterr().err
    )
    assert list(tmp_path.glob("*.zip")) == []


@posix_only
@pytest.mark.parametrize("name", ["notes.txt", "folder"])
def test_what_cannot_be_read_is_told(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    package = workshop.create("one")
    (package / "notes.txt").touch()
    (package / "folder").mkdir()
    real_open, real_scan = os.open, os.scandir

    def no_open(path: str, *more: object, **named: object) -> int:
        if Path(path).name == name:  # root may read everything
            raise PermissionError(13, "Permission denied", str(path))
        return real_open(path, *more, **named)

    def no_scan(path: str | Path) -> object:
        if Path(path).name == name:
            raise PermissionError(13, "Permission denied", str(path))
        return real_scan(path)

    monkeypatch.setattr("day6_core.workspace.export.os.open", no_open)
    monkeypatch.setattr("day6_core.workspace.export.os.scandir", no_scan)
    assert main(["--workspace", str(workshop.workspace), "-o", str(tmp_path / "out.zip")]) == 1
    assert f"one/{name}': Permission denied" in capsys.readouterr().err
    assert list(tmp_path.glob("*.zip")) == []


def test_a_file_that_is_no_zip_is_not_overwritten(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    package = workshop.create("one")
    before = (package / "setup.py").read_bytes()
    assert main(["--workspace", str(workshop.workspace), "-o", str(package / "setup.py")]) == 1
    assert "setup.py' exists and isn't a zip: it is left alone" in capsys.readouterr().err
    assert (package / "setup.py").read_bytes() == before


@pytest.mark.parametrize(
    ("language", "told"), [("en", "' exists: --force replaces it"), ("zh", "”已经存在：加 --force")]
)
def test_a_zip_that_exists_is_replaced_only_by_force(
    workshop: Workshop,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    language: str,
    told: str,
) -> None:
    monkeypatch.setenv("DAY6_LANG", language)
    workshop.create("one")
    words = ["--workspace", str(workshop.workspace), "-o", str(tmp_path / "out.zip")]
    assert main(words) == 0
    before = (tmp_path / "out.zip").read_bytes()
    workshop.create("two")
    assert main(words) == 1
    assert f"out.zip{told}" in capsys.readouterr().err
    assert (tmp_path / "out.zip").read_bytes() == before
    assert main([*words, "--force"]) == 0
    assert "two/setup.py" in packed(tmp_path / "out.zip")


def test_no_zip_is_written_into_what_it_packs(
    workshop: Workshop, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    package = workshop.create("one")
    assert main(["--workspace", str(workshop.workspace), "-o", str(package / "out.zip")]) == 1
    assert "out.zip' would be inside " in capsys.readouterr().err
    monkeypatch.chdir(package)
    assert main([]) == 0  # and the one without a name lies beside it
    target = workshop.workspace / "ros2_ws.zip"
    assert capsys.readouterr().out == f"{target}: one (from {workshop.workspace})\n"
    assert list(workshop.workspace.rglob("*.zip")) == [target]


@pytest.mark.parametrize("where", ["notes", "notes/deep", "src2"])
def test_a_workspace_that_is_merely_above_is_named_and_not_packed(
    workshop: Workshop, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    workshop.create("one")
    folder = workshop.workspace / where
    folder.mkdir(parents=True)
    monkeypatch.chdir(folder)
    assert main([]) == 1
    told = capsys.readouterr()
    assert told.out == "" and list(workshop.home.rglob("*.zip")) == []
    assert told.err == (
        f"day6-tui export: {folder} isn't in a workspace: there is no package.xml, and no folder src with packages\n"
        "day6-tui export: go to your workspace with cd, or name it: day6-tui export --workspace DIR\n"
        f"day6-tui export: for example: day6-tui export --workspace {shlex.quote(str(workshop.workspace))}\n"
    )


def test_in_an_empty_folder_the_workspace_of_the_desktop_is_named_and_not_packed(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(workshop.home))
    monkeypatch.setenv("USERPROFILE", str(workshop.home))
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path / "empty")
    for language, example in ("en", "for example: "), ("zh", "例如："):
        monkeypatch.setenv("DAY6_LANG", language)
        workshop.create(f"of_{language}")
        assert main([]) == 1
        assert (
            f"{example}day6-tui export --workspace {shlex.quote(str(workshop.workspace))}\n" in capsys.readouterr().err
        )
    assert list((tmp_path / "empty").iterdir()) == []


def test_the_folder_that_holds_ros2_ws_packs_it(
    workshop: Workshop, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    workshop.create("one")
    monkeypatch.chdir(workshop.home)
    assert main([]) == 0
    assert capsys.readouterr().out == f"ros2_ws.zip: one (from {workshop.workspace})\n"
    monkeypatch.chdir(workshop.home.parent)
    assert main(["--home", str(workshop.home), "-o", "other.zip"]) == 0
    assert capsys.readouterr().out == f"other.zip: one (from {workshop.workspace})\n"


@pytest.mark.process
def test_the_command_in_an_empty_folder_says_so(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "day6_tui.main", "export"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        encoding="utf-8",
    )
    assert (done.returncode, done.stdout, list(tmp_path.iterdir())) == (1, "", [])
    assert f"{tmp_path} isn't in a workspace" in done.stderr


def test_a_file_from_before_1980_is_packed(workshop: Workshop, tmp_path: Path) -> None:
    package = workshop.create("one")
    os.utime(package / "setup.py", (0, 0))
    export(workshop.workspace, [], tmp_path / "out.zip")
    assert "one/setup.py" in packed(tmp_path / "out.zip")


@pytest.mark.parametrize("where", [".", "src", "src/one", "src/one/one", "src/more"])
def test_the_workspace_one_stands_in_is_packed_and_named(
    workshop: Workshop,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    where: str,
) -> None:
    workspace = tmp_path / "my_ws"
    shutil.copytree(workshop.create("one"), workspace / "src/one")
    (workspace / "src/one/src").mkdir()
    (workspace / "src/more").mkdir()
    monkeypatch.chdir(workspace / where)
    target = tmp_path / "out.zip"
    assert main(["-o", str(target)]) == 0
    assert capsys.readouterr().out == f"{target}: one (from {workspace})\n"
    with zipfile.ZipFile(target) as archive:
        assert "my_ws/src/one/setup.py" in archive.namelist()


@pytest.mark.parametrize("where", [".", "src"])
def test_an_empty_workspace_one_stands_in_is_named_in_the_error(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    source = tmp_path / "new_ws/src"
    source.mkdir(parents=True)
    monkeypatch.chdir(source.parent / where)
    assert main([]) == 1
    assert capsys.readouterr().err == f"day6-tui export: no package in {source}\n"


def test_a_package_in_no_workspace_is_its_own(
    workshop: Workshop, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    alone = tmp_path / "deep/alone"
    shutil.copytree(workshop.create("one"), alone)
    (alone / "src").mkdir()
    monkeypatch.chdir(alone / "one")
    target = tmp_path / "out.zip"
    assert main(["-o", str(target)]) == 0
    assert capsys.readouterr().out == f"{target}: one (from {alone})\n"
    with zipfile.ZipFile(target) as archive:
        assert "alone/src/one/setup.py" in archive.namelist()
