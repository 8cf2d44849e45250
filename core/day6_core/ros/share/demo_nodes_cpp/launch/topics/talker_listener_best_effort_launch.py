"""A talker, and a listener that would rather miss a message than wait for it."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="demo_nodes_cpp", executable="talker", output="screen"),
            Node(package="demo_nodes_cpp", executable="listener_best_effort", output="screen"),
        ]
    )
