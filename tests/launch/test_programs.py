"""Programs and commands of day6-tui itself, launched from a real terminal and on a desk."""

from __future__ import annotations

import os
import re
import tempfile
from pathlib import Path
from typing import Any

import pytest
from launch._programs import ProcessPlan, resolve

from tests.launch.launch_cases import Case, our_command, play

pytestmark = pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to a process")

CONTAINER = """
from launch import LaunchDescription
from launch.actions import LogInfo, TimerAction
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        name='box', namespace='lab', package='rclcpp_components', executable='component_container', output='screen',
        composable_node_descriptions=[
            ComposableNode(package='demo_nodes_cpp', plugin='demo_nodes_cpp::Talker', name='say', namespace='up',
                           remappings=[('chatter', 'talk')]),
            ComposableNode(package='image_tools', plugin='image_tools::Cam2Image')])])
"""

DISPLAY = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', namespace='a')])
"""


def launched(tmp_path: Path, text: str, until: str) -> Any:
    command, environment = our_command()
    case = Case("own", {"main.launch.py": text}, interrupt=until)
    return play(case, tmp_path, command, {**environment, "ROS_DOMAIN_ID": "199"})


@pytest.mark.process
def test_a_container_loads_our_components_and_says_what_it_cannot_load(tmp_path: Path) -> None:
    outcome = launched(tmp_path, CONTAINER, "Failed to load node")
    assert "Loaded node '/up/say' in container '/lab/box'" in outcome.stdout
    assert "Failed to load node '' of type 'image_tools::Cam2Image' in container '/lab/box': " in outcome.stdout
    assert "[INFO] [component_container-1]: process has finished cleanly" in outcome.stdout
    assert outcome.exit_code == 0


@pytest.mark.process
def test_a_program_of_ours_is_a_process_in_a_real_terminal_and_logs(tmp_path: Path) -> None:
    outcome = launched(tmp_path, DISPLAY, "Spawning turtle [turtle1]")
    assert "[INFO] [turtlesim_node-1]: process has finished cleanly [pid <PID>" in outcome.stdout
    assert outcome.stdout.index("process started") < outcome.stdout.index("Starting turtlesim with node name /a/turtle")


@pytest.mark.process
def test_on_a_desk_it_is_one_of_the_desks_programs(machine: Any) -> None:
    path = machine.write("main.launch.py", DISPLAY)
    program = machine.start(f"ros2 launch '{path}'")
    machine.wait(lambda: "Spawning turtle [turtle1]" in machine.out.text)
    assert [each.session.name for each in machine.desk.programs.values()].count("turtlesim_node") == 1
    program.interrupt()
    machine.wait(lambda: program.status is not None)
    assert "process has finished cleanly" in machine.out.text
    assert not [each for each in machine.desk.programs.values() if each.session.name == "turtlesim_node"]


TERMINAL = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['xterm', '-e', 'true'], output='screen')])
"""


@pytest.mark.process
def test_a_terminal_is_opened_by_the_desk_where_there_is_no_display(machine: Any, monkeypatch: Any) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    path = machine.write("main.launch.py", TERMINAL)
    program = machine.start(f"ros2 launch '{path}'")
    machine.wait(lambda: program.status is not None)
    assert "[xterm-1]: process has finished cleanly" in machine.out.text  # a real one would not open


@pytest.mark.process
def test_it_goes_also_where_the_path_of_temporary_files_leaves_no_room_for_a_sockets_name(
    machine: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    long = tmp_path / ("long" * 30)
    long.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(long))
    path = machine.write("main.launch.py", DISPLAY)
    program = machine.start(f"ros2 launch '{path}'")
    machine.wait(lambda: "Spawning turtle [turtle1]" in machine.out.text)
    program.interrupt()
    machine.wait(lambda: program.status is not None)


@pytest.mark.parametrize(
    ("line", "ours"),
    [
        ("ros2 topic list | grep ros2", 1),
        ("for i in 1 2; do ros2 topic list; done", 1),
        ('/opt/ros/jazzy/bin/ros2 service call /spawn turtlesim/srv/Spawn "{x: 2}"', 1),
        ("echo ros2 > ros2", 0),
    ],
)
def test_a_shell_line_finds_our_commands_without_a_path_to_them(line: str, ours: int) -> None:
    plan = resolve([line], True, hosted=False)
    assert isinstance(plan, ProcessPlan)
    assert len(re.findall(r"_process'? command ", str(plan.args))) == ours


def test_tab_offers_packages_and_launch_files_and_what_is_in_a_package(machine: Any) -> None:
    import asyncio

    from day6_core.ros.ros2 import complete

    machine.write("work/main.launch.py", "")
    machine.write("work/notes.txt", "")
    share = machine.install("lab_of_mine")
    (share / "launch").mkdir()
    (share / "launch" / "all.launch.xml").write_text("<launch/>")
    session = machine.desk.start_program(
        ["bash"],
        _nothing,
        machine.streams(),
        env={"AMENT_PREFIX_PATH": str(machine.desk.home / "install"), "HOME": str(machine.desk.home)},
        cwd=machine.desk.home,
    ).session

    def offered(*words: str) -> list[str]:
        return asyncio.run(complete(["ros2", "launch", *words], session))

    assert offered("work/") == ["work/main.launch.py"]
    assert offered("~/wo") == ["~/work/"]
    assert offered("lab_of") == ["lab_of_mine"]
    assert offered("lab_of_mine", "") == ["all.launch.xml"]


async def _nothing(session: Any) -> int:
    return 0
