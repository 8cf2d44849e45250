"""The robots of urdf_tutorial, by the commands of the tutorials."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from day6_core.ros.environment import SHARE_PATH
from day6_urdf.check import check_text
from tests.support.waiting import run

ROBOTS = SHARE_PATH / "urdf_tutorial/urdf"
LAUNCHED = """
ros2 launch urdf_tutorial display.launch.py model:=urdf/08-macroed.urdf.xacro > /dev/null 2>&1 &
ros2 topic echo --once /joint_states sensor_msgs/msg/JointState --field name
{wait}
kill %1
"""


def wait_for(*nodes: str) -> str:
    """Lines that wait for nodes, which a launch starts one after the other: what one of them says tells nothing of the rest."""
    return "\n".join(f"until ros2 node list | grep -x /{node}; do sleep 0.1; done" for node in nodes)


def typed(tmp_path: Path, lines: str) -> str:
    done = run(
        [
            sys.executable,
            "-m",
            "day6_tui.main",
            "exec",
            "--home",
            str(tmp_path / "home"),
            "-c",
            lines,
        ],
        cwd=tmp_path,
        env={**os.environ, "DAY6_RUNTIME_DIR": str(tmp_path), "DAY6_LINK": "off"},
    )
    return done.stdout


@pytest.mark.parametrize(
    ("file", "links", "moving"),
    [
        ("01-myfirst", 1, 0), ("02-multipleshapes", 2, 0), ("03-origins", 2, 0), ("04-materials", 3, 0),
        ("05-visual", 16, 0), ("06-flexible", 16, 8), ("07-physics", 16, 8),
    ],
)  # fmt: skip
def test_a_robot_is_right(file: str, links: int, moving: int) -> None:
    found = check_text((ROBOTS / f"{file}.urdf").read_text(encoding="utf-8"))
    assert found.robot is not None and not found.diagnostics
    assert len(found.robot.links) == links
    assert len([joint for joint in found.robot.joints if joint.type != "fixed"]) == moving


@pytest.mark.process
def test_the_robot_with_macros_is_the_one_with_physics(tmp_path: Path) -> None:
    pytest.importorskip("xacro")
    made = check_text(typed(tmp_path, f"xacro '{ROBOTS}/08-macroed.urdf.xacro'")).robot
    written = check_text((ROBOTS / "07-physics.urdf").read_text(encoding="utf-8")).robot
    assert made is not None and written is not None
    assert {link.name for link in made.links} == {link.name for link in written.links}
    ends = [
        {joint.name: (joint.type, joint.parent, joint.child) for joint in robot.joints} for robot in (made, written)
    ]
    assert ends[0] == ends[1]


@pytest.mark.process
def test_display_takes_a_model_of_its_package(tmp_path: Path) -> None:
    pytest.importorskip("xacro")
    shown = typed(tmp_path, LAUNCHED.format(wait=wait_for("robot_state_publisher", "rviz")))
    assert "gripper_extension" in shown


@pytest.mark.process
@pytest.mark.parametrize("kind", ["py", "xml", "yaml"])
def test_the_dummy_robot_comes_up_by_each_of_its_launch_files(tmp_path: Path, kind: str) -> None:
    lines = f"ros2 launch dummy_robot_bringup dummy_robot_bringup_launch.{kind} > /dev/null 2>&1 &\n"
    nodes = wait_for("dummy_joint_states", "dummy_laser", "dummy_map_server", "robot_state_publisher")
    shown = typed(tmp_path, f"{lines}ros2 topic echo --once /tf tf2_msgs/msg/TFMessage\n{nodes}\nkill %1")
    assert "single_rrbot_link" in shown
