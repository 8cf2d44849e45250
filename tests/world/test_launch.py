"""The world by its launch file, as a whole in a process of its own."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.support.waiting import run

LESSON = """
ros2 launch day6_world world.launch.py world:=walls robot:=car.urdf.xacro > /dev/null &
until [[ $(ros2 node list) == */robot_state_publisher*/world* ]]; do sleep 0.1; done
ros2 param get /robot_state_publisher use_sim_time
ros2 topic pub --once /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.3}}" > /dev/null
sleep 1
ros2 topic echo --once --field pose.pose.position.y /odom
ros2 node list
kill %1
"""


@pytest.mark.process
def test_a_xacro_robot_in_the_world_of_a_launch_file(tmp_path: Path) -> None:
    from day6_urdf import shipped_model

    text = shipped_model("day6_bot_gazebo").read_text(encoding="utf-8")
    text = text.replace(
        '<robot name="day6_bot">',
        '<robot name="day6_bot" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="r" value="0.05"/>',
    ).replace('cylinder radius="0.05"', 'cylinder radius="${r}"')
    (tmp_path / "car.urdf.xacro").write_text(text, encoding="utf-8")
    home = tmp_path / "home"
    done = run(
        [sys.executable, "-m", "day6_tui.main", "exec", "--home", str(home), "--timeout", "250", "-c", LESSON],
        cwd=tmp_path,
        env={**os.environ, "DAY6_RUNTIME_DIR": str(tmp_path), "DAY6_LINK": "off"},
    )
    assert "Boolean value is: True" in done.stdout, done.stderr
    assert "/robot_state_publisher\n/world\n" in done.stdout
    assert "0.0\n---" in done.stdout
