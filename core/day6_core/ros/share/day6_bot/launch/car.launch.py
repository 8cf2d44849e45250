"""The car from above: `ros2 launch day6_bot car.launch.py`, and its wheels turn as soon as somebody says so on /joint_states.

`robot:=FILE` shows a robot of one's own.
"""

import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, Shutdown
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node

from day6_urdf import shipped_model


def nodes(context):
    robot = os.path.expanduser(LaunchConfiguration("robot").perform(context))
    if robot.endswith(".xacro"):
        description = Command(["xacro ", f"'{robot}'"]).perform(context)
    else:
        with open(robot, encoding="utf-8") as file:
            description = file.read()
    return [
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[{"robot_description": description}],
            on_exit=Shutdown(),
        ),
        Node(package="day6_bot", executable="car_view"),
    ]


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "robot", default_value=str(shipped_model()), description="the URDF or xacro file of the robot"
            ),
            OpaqueFunction(function=nodes),
        ]
    )
