"""What our commands say where nothing can be written: a full disk, a read-only folder, a folder that somebody removed.

Each command gives its reason and a status that is not 0, without Python's words; and what was there is still there.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.support.disks import Disk, disk

__all__ = ["disk"]

pytestmark = [pytest.mark.process, pytest.mark.skipif(sys.platform == "win32", reason="Windows has other disks")]

ROBOT = '<robot name="r"><link name="a"/></robot>'


def outside(disk: Disk) -> Path:
    """A folder beside the disk, where all is well."""
    return disk.folder.parent


def text_of(disk: Disk, *words: str, status: int = 1, **variables: str) -> str:
    """Run the command on the spoilt disk; return what it says on either stream."""
    disk.spoil()
    state = outside(disk) / "state"
    done = disk.run(*words, HOME=str(state), XDG_DATA_HOME=str(state), ROS_LOG_DIR=str(state), **variables)
    text = done.stdout + done.stderr
    assert "Traceback" not in text and "PosixPath" not in text, text
    assert done.returncode == status, text
    return text


def shell_lines(disk: Disk, lines: str, status: int = 1) -> str:
    return text_of(disk, "exec", "--home", str(outside(disk) / "home"), "-c", lines, status=status)


@pytest.mark.parametrize("kind", ["ament_python", "ament_cmake"])
def test_pkg_create_tells(disk: Disk, kind: str) -> None:
    assert disk.is_told(text_of(disk, "ros2", "pkg", "create", "p", "--build-type", kind))


@pytest.mark.parametrize("program", ["--vscode", "--pycharm"])
def test_settings_of_an_editor_tell(disk: Disk, program: str) -> None:
    assert disk.is_told(text_of(disk, "env", program))


def test_the_environment_needs_no_disk(disk: Disk) -> None:
    assert "export ROS_DISTRO=" in text_of(disk, "env", status=0)


def test_colcon_tells(disk: Disk) -> None:
    (disk.folder / "src").mkdir() if disk.kind != "gone" else None
    assert disk.is_told(text_of(disk, "colcon", "build"))


def test_an_export_tells(disk: Disk) -> None:
    home = outside(disk) / "home"
    package = home / "ros2_ws" / "src" / "p"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        "<package format='3'><name>p</name><version>0.0.0</version><description>d</description>"
        "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (package / "setup.py").write_text("from setuptools import setup; setup(name='p')")
    text = text_of(disk, "export", "--home", str(home), "-o", "p.zip")
    assert disk.is_told(text), text


def test_a_picture_of_a_robot_tells(disk: Disk) -> None:
    (outside(disk) / "r.urdf").write_text(ROBOT)
    gone = disk.kind == "gone"  # there the original says that it made the file, and only its `dot` complains
    text = shell_lines(disk, f"urdf_to_graphviz '{outside(disk)}/r.urdf' && echo went on", status=0 if gone else 255)
    assert "can't open r.gv" in text and ("went on" in text) is gone


def test_a_dump_of_parameters_tells(disk: Disk) -> None:
    text = shell_lines(
        disk,
        "ros2 run demo_nodes_cpp parameter_blackboard & "
        "until [[ $(ros2 node list) == */parameter_blackboard* ]]; do sleep 0.1; done; "
        "ros2 param dump /parameter_blackboard > d.yaml",
        status=120 if disk.kind == "full" else 1,
    )
    assert disk.is_told(text)


def test_a_picture_of_frames_tells(disk: Disk) -> None:
    old = [disk.folder / name for name in ("tree.gv", "tree.pdf") if disk.kind != "gone"]
    for file in old:
        file.write_text("old")
    text = shell_lines(disk, "ros2 run tf2_tools view_frames --wait-time 0.1 -o tree")
    assert disk.is_told(text)
    assert all(file.read_text() == "old" for file in old)


def test_a_download_tells(disk: Disk) -> None:
    import http.server
    import threading

    class Answer(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.end_headers()
            self.wfile.write(b"x" * 100_000)

        def log_message(self, *said: object) -> None:
            pass

    server = http.server.HTTPServer(("127.0.0.1", 0), Answer)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        text = shell_lines(disk, f"wget -q http://127.0.0.1:{server.server_port}/f.txt", status=3)
    finally:
        server.shutdown()
        server.server_close()
    assert disk.is_told(text)


def test_redirections_copies_and_moves_tell_and_the_old_files_stay(disk: Disk) -> None:
    if disk.kind != "gone":
        (disk.folder / "old").write_text("old\n")
    (outside(disk) / "new").write_text("new\n" * 2000)
    new = outside(disk) / "new"
    another_disk = disk.kind == "gone" or os.stat(disk.folder).st_dev != os.stat(new).st_dev
    for line in (
        f"cp '{new}' g",
        *([f"mv '{new}' g"] if another_disk or disk.kind != "full" else []),  # on the same disk it writes nothing
        "sed -i s/o/p/ old",
        f"sort -o old '{new}'",
        "mkdir -p k && echo x > k/l",
    ):
        disk.folder.mkdir(exist_ok=True)
        assert disk.is_told(shell_lines(disk, f"{line} && (exit 0) || (exit 1)")), line
    assert new.read_text() == "new\n" * 2000
    if disk.kind != "gone":
        assert (disk.folder / "old").read_text() == "old\n"


@pytest.mark.parametrize("disk", ["gone"], indirect=True)
def test_no_command_brings_a_removed_folder_back(disk: Disk) -> None:
    for words in (["colcon", "build"], ["ros2", "pkg", "create", "p"], ["env", "--vscode"]):
        disk.folder.mkdir(exist_ok=True)
        text_of(disk, *words)
        assert not disk.folder.exists(), words
    home = outside(disk)
    lines = f"mkdir '{home}/g'; cd '{home}/g'; rmdir '{home}/g'; {{}}; s=$?; test ! -e '{home}/g' || s=99; (exit $s)"
    disk.folder.mkdir(exist_ok=True)
    for line in (
        "colcon build",
        "ros2 pkg create p",
        "python3 x.py",
        "python3 -c 'print(1)'",
        "wget -q x:/",
        "echo > a",
    ):
        done = disk.run("exec", "-c", lines.format(line)) if disk.folder.exists() else None
        disk.folder.mkdir(exist_ok=True)
        assert done is not None and done.returncode in (1, 2, 4), line
        assert "PosixPath" not in done.stderr and "Traceback" not in done.stderr
