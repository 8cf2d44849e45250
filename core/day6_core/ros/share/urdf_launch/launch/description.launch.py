"""Publishes a robot description of a package, worked off by xacro."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    package, path = LaunchConfiguration("urdf_package"), LaunchConfiguration("urdf_package_path")
    robot = Command(["xacro ", PathJoinSubstitution([FindPackageShare(package), path])])
    return LaunchDescription(
        [
            DeclareLaunchArgument("urdf_package", description="The package that has the robot"),
            DeclareLaunchArgument(
                "urdf_package_path", description="The robot's file, from the share folder of its package"
            ),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": ParameterValue(robot, value_type=str)}],
            ),
        ]
    )
