from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("who", default_value="shown", description="the node's name"),
            Node(package="lab", executable="show", name=LaunchConfiguration("who"), output="screen"),
        ]
    )
