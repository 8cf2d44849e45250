"""xacro files: by the command of the simulated terminal, by `ros2 run`, and in a real terminal."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.waiting import run

pytestmark = pytest.mark.process

pytest.importorskip("xacro")

CAR = """<?xml version="1.0"?>
<robot name="car" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="radius" default="0.05"/>
  <xacro:macro name="wheel" params="side y">
    <link name="${side}_wheel"/>
    <joint name="${side}_joint" type="continuous"><parent link="base"/><child link="${side}_wheel"/>
      <origin xyz="0 ${y} ${2 * $(arg radius)}"/></joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:wheel side="left" y="0.15"/>
  <xacro:wheel side="right" y="-0.15"/>
</robot>
"""


def day6(tmp_path: Path, *words: str) -> subprocess.CompletedProcess[str]:
    return run(
        [sys.executable, "-m", "day6_tui.main", *words],
        cwd=tmp_path,
        env={**os.environ, "DAY6_RUNTIME_DIR": str(tmp_path), "DAY6_LINK": "off"},
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "car.urdf.xacro").write_text(CAR, encoding="utf-8")
    return tmp_path


def test_macros_arithmetic_and_arguments_become_a_robot_that_check_urdf_likes(folder: Path) -> None:
    lesson = "xacro car.urdf.xacro radius:=0.1 > car.urdf && check_urdf car.urdf; ros2 run xacro xacro car.urdf.xacro"
    done = day6(folder, "exec", "--home", str(folder / "home"), "-c", lesson)
    assert "    child(2):  right_wheel" in done.stdout, done.stderr
    assert '<origin xyz="0 -0.15 0.2"/>' in (folder / "car.urdf").read_text(encoding="utf-8")
    assert '<origin xyz="0 -0.15 0.1"/>' in done.stdout


def test_in_a_real_terminal_too(folder: Path) -> None:
    done = day6(folder, "xacro", "car.urdf.xacro")
    assert done.returncode == 0 and '<link name="left_wheel"/>' in done.stdout


def test_packages_are_found(folder: Path) -> None:
    (folder / "where.xacro").write_text('<robot name="$(find day6_bot)"/>', encoding="utf-8")
    assert Path("share", "day6_bot").as_posix() in day6(folder, "xacro", "where.xacro").stdout.replace("\\", "/")


def test_a_missing_file_and_a_macro_nobody_knows_are_told(folder: Path) -> None:
    missing = day6(folder, "xacro", "nothing.xacro")
    assert missing.returncode != 0 and "nothing.xacro" in missing.stderr and "Traceback" not in missing.stderr
    (folder / "bad.xacro").write_text(CAR.replace("<xacro:wheel side", "<xacro:weel side", 1), encoding="utf-8")
    bad = day6(folder, "xacro", "bad.xacro")
    assert bad.returncode != 0 and "weel" in bad.stderr
