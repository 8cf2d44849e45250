"""The car in RViz with its wheels turning: `ros2 launch day6_bot display.launch.py`.

`sliders:=true` moves the joints by hand, `robot:=FILE` shows a robot of one's own, `spin:=false` leaves /joint_states to others.
"""

import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

from day6_urdf import shipped_model


def nodes(context):
    robot = os.path.expanduser(LaunchConfiguration("robot").perform(context))
    sliders = LaunchConfiguration("sliders").perform(context)
    spin = LaunchConfiguration("spin").perform(context)
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
        Node(package="rviz2", executable="rviz2", name="rviz2", arguments=["-d", LaunchConfiguration("rviz_config")]),
    ]
    if sliders.lower() == "true":
        shown.append(Node(package="joint_state_publisher_gui", executable="joint_state_publisher_gui"))
    elif spin.lower() == "true":
        shown.append(Node(package="day6_bot", executable="wheel_spinner"))
    return shown


def generate_launch_description():
    rviz_config = PathJoinSubstitution([FindPackageShare("day6_bot"), "rviz", "day6_bot.rviz"])
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "robot", default_value=str(shipped_model()), description="the URDF or xacro file of the robot"
            ),
            DeclareLaunchArgument("rviz_config", default_value=rviz_config, description="what RViz shows, and how"),
            DeclareLaunchArgument("spin", default_value="true", description="turn the wheels by wheel_spinner"),
            DeclareLaunchArgument(
                "sliders", default_value="false", description="sliders for the joints, in place of wheel_spinner"
            ),
            OpaqueFunction(function=nodes),
        ]
    )
