"""The car in RViz with its wheels turning: `ros2 launch day6_bot display.launch.py`.

`sliders:=true` moves the joints by hand, `robot:=FILE` shows a robot of one's own, `spin:=false` leaves /joint_states to others.
"""

import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

from day6_tui.urdf import shipped_model

ARGUMENTS = (
    ("robot", str(shipped_model()), "the URDF or xacro file of the robot"),
    (
        "rviz_config",
        PathJoinSubstitution([FindPackageShare("day6_bot"), "rviz", "day6_bot.rviz"]),
        "what RViz shows, and how",
    ),
    ("spin", "true", "turn the wheels by wheel_spinner"),
    ("sliders", "false", "sliders for the joints, in place of wheel_spinner"),
)


def nodes(context):
    value = {name: LaunchConfiguration(name).perform(context) for name, _, _ in ARGUMENTS}
    robot = os.path.expanduser(value["robot"])
    if robot.endswith(".xacro"):
        description = Command(["xacro ", f"'{robot}'"]).perform(context)
    else:
        with open(robot, encoding="utf-8") as file:
            description = file.read()
    shown = [
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[{"robot_description": description}],
        ),
        Node(package="rviz2", executable="rviz2", name="rviz2", arguments=["-d", value["rviz_config"]]),
    ]
    if value["sliders"].lower() == "true":
        shown.append(Node(package="joint_state_publisher_gui", executable="joint_state_publisher_gui"))
    elif value["spin"].lower() == "true":
        shown.append(Node(package="day6_bot", executable="wheel_spinner"))
    return shown


def generate_launch_description():
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=about) for name, default, about in ARGUMENTS
    ]
    return LaunchDescription([*declared, OpaqueFunction(function=nodes)])
