"""What a real machine has and this one doesn't: the hint says so, and doesn't blame the pupil's line."""

from __future__ import annotations

import os
from typing import Any

import pytest

from tests.shell.explanations.asking import said

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a terminal there has no pty")


@pytest.mark.parametrize(
    ("typed", "told"),
    [
        ("coproc ls", "coproc is a bash command that this terminal doesn't have"),
    ],
)
def test_what_this_terminal_lacks_of_bash_is_told_at_once(tall: Any, typed: str, told: str) -> None:
    assert "bash has this, the shell of day6-tui does not" in said(tall, typed)
    card = said(tall, "why")
    assert told.capitalize() in card or told in card
    assert "wrong place" not in card and "What to check" not in card


@pytest.mark.parametrize("typed", ["echo hi (there)", "echo 'a=(1)' (b)", "a = (1)", "echo a; )"])
def test_what_is_wrong_in_bash_too_is_not_called_lacking(tall: Any, typed: str) -> None:
    seen = said(tall, typed)
    assert "syntax error" in seen and "hint" not in seen
    card = said(tall, "why")
    assert "The shell doesn't understand how this line is written" in card and "doesn't have" not in card


@pytest.mark.process
@pytest.mark.parametrize(
    ("module", "told", "next_"),
    [
        ("vision_msgs.msg", "sudo apt install ros-jazzy-vision-msgs", ""),
        ("nav2_msgs.action", "a part of Navigation2, which plans a robot's way", "ros2 run day6_world world"),
        ("rospy", "rospy belongs to ROS 1, and this is ROS 2: here it is rclpy", ""),
        ("tf.transformations", "tf belongs to ROS 1, and this is ROS 2: here it is tf2_ros", ""),
    ],
)
def test_a_package_of_ros_that_is_not_here_is_not_looked_for_in_pip(
    machine: Any, tall: Any, module: str, told: str, next_: str
) -> None:
    (machine.desk.home / "camera.py").write_text(f"import {module}\n")
    seen = said(tall, "python3 camera.py")
    assert "hint: " in seen and told in seen and "pip3" not in seen
    card = said(tall, "why")
    assert told in card and "pip3" not in card and (f"Type next {next_}" in card if next_ else "Type next" not in card)
    tall.line("export DAY6_LANG=zh")
    assert "提示：" in said(tall, "python3 camera.py")


@pytest.mark.parametrize(
    ("line", "told", "next_"),
    [
        ("ros2 run moveit_ros_move_group move_group", "MoveIt, which plans the movements of arms", ""),
        ("ros2 launch gazebo_ros gazebo.launch.py", "a simulator (Gazebo, Webots)", "ros2 run day6_world world"),
        ("ros2 run usb_cam usb_cam_node_exe", "is for cameras", "ros2 run image_tools cam2image"),
        ("ros2 run teleop_twist_joy teleop_node", "reads a gamepad", "ros2 run teleop_twist_keyboard"),
        ("ros2 run nav2_mgs x", "", ""),
    ],
)
def test_a_package_that_nobody_has_here_is_told_as_what_it_is(tall: Any, line: str, told: str, next_: str) -> None:
    assert "not found" in said(tall, line)
    card = said(tall, "why")
    assert told in card and (f"Type next {next_}" in card if next_ else "day6_world" not in card)


@pytest.mark.process
@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("operator", "ImportError: cannot import name 'eq' from 'operator'"),
        ("string", "ImportError: cannot import name 'Template' from 'string'"),
    ],
)
def test_a_file_named_as_a_module_of_python_hurts_as_on_real_ros_and_is_told(
    machine: Any, tall: Any, name: str, what: str
) -> None:
    """What real rclpy 9.1.2 ended with, without the wheels' own start-up files."""
    (machine.desk.home / f"{name}.py").write_text("def add(a, b):\n    return a + b\n")
    (machine.desk.home / "node.py").write_text("import rclpy\n")
    seen = said(tall, "python3 node.py")
    told = f"your own file {name}.py has the name of Python's module {name}"
    assert what in seen and told in seen
    card = said(tall, "why")
    assert told[1:] in card and f"Type next mv {name}.py my_{name}.py" in card


@pytest.mark.process
def test_files_named_as_modules_that_real_rclpy_does_without_hurt_nobody(machine: Any, tall: Any) -> None:
    names = ("signal", "hashlib", "ctypes", "dataclasses")
    for name in names:
        (machine.desk.home / f"{name}.py").write_text("MINE = 7\n")
    (machine.desk.home / "node.py").write_text(
        "import rclpy\nfrom std_msgs.msg import String\nrclpy.init()\nnode = rclpy.create_node('n')\n"
        "node.create_publisher(String, 'chatter', 10).publish(String())\nrclpy.spin_once(node, timeout_sec=0.1)\n"
        f"import {', '.join(names)}\nprint('sum', {' + '.join(f'{name}.MINE' for name in names)})\nrclpy.shutdown()\n"
    )
    seen = said(tall, "python3 node.py; echo status $?")
    assert "sum 28 status 0" in seen and "Error" not in seen


def test_a_package_of_c_plus_plus_says_plainly_why_it_is_not_built(machine: Any, tall: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_cmake --node-name go car").status == 0
    assert "has no C++ compiler" in said(tall, "cd ~/ros2_ws; colcon build")
    card = said(tall, "why")
    assert "The C++ part of car was left out" in card and "nothing is wrong with it" in card and "ament_python" in card
    said(tall, "source install/setup.bash; ros2 run car go")
    assert "go is written in C++" in said(tall, "why")


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (
            "echo 'find_package(catkin REQUIRED)' >> CMakeLists.txt",
            "This is a package of ROS 1 (catkin), and this is ROS 2",
        ),
        ("sed -i 's/ament_cmake<.build_type>/ament_pyton<\\/build_type>/' package.xml", "ament_pyton"),
        ("sed -i '/build_type/d' package.xml; rm CMakeLists.txt", "package.xml has no build_type, or a wrong one"),
    ],
)
def test_a_manifest_of_another_kind_is_what_is_blamed(machine: Any, tall: Any, change: str, told: str) -> None:
    assert machine.run(f"cd ros2_ws/src; ros2 pkg create --build-type ament_cmake car; cd car; {change}").status == 0
    seen = said(tall, "cd ~/ros2_ws; colcon build")
    card = said(tall, "why")
    assert told in seen + card and "compiler" not in seen + card


@pytest.mark.parametrize(
    ("manifest", "told"),
    [
        ("<package><name>car</name></package>", "<version> is missing in {file}"),
        ("<robot/>", "everything has to be inside <package>, not <robot>"),
        ("<package><name>car</package>", "{file} has a mistake in line 1 (mismatched tag)"),
        ("", "{file} has a mistake in line 1 (no element found)"),
    ],
)
def test_a_manifest_that_colcon_passes_over_in_silence_is_named(
    machine: Any, tall: Any, manifest: str, told: str
) -> None:
    package = machine.desk.home / "ros2_ws" / "src" / "car"
    package.mkdir()
    (package / "package.xml").write_text(manifest)
    seen = said(tall, "cd ~/ros2_ws; colcon build")
    assert (
        "0 packages finished" in seen
        and told.format(file="~/ros2_ws/src/car/package.xml") in seen
        and "so colcon leaves its package out" in seen
    )
    card = said(tall, "why")
    assert (
        told.format(file="src/car/package.xml") in card.replace("In src", "in src")
        and "Type next nano src/car/package.xml" in card
    )
    said(tall, "ros2 run car go")
    card = said(tall, "why")
    assert "its package.xml has a mistake, so colcon leaves it out" in card
    assert "Type next nano src/car/package.xml" in card


def test_a_program_that_ends_itself_has_a_card(machine: Any) -> None:
    assert "the program ended itself" in machine.run("explain 'SystemExit: 1'").out.lower()
