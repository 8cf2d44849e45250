"""`day6-tui export`: the zip builds on a real ROS 2 as it is."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from workshop import Workshop

from day6_tui.core.workspace.export import ExportError, export, main

REAL_COLCON = os.environ.get("DAY6_REAL_COLCON") or shutil.which("colcon")
"""The real one, wherever it is installed."""


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
