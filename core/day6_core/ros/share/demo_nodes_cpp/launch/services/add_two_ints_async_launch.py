"""A server that adds, and a client that asks it once with a callback."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="demo_nodes_cpp", executable="add_two_ints_server", output="screen"),
            Node(package="demo_nodes_cpp", executable="add_two_ints_client_async", output="screen"),
        ]
    )
