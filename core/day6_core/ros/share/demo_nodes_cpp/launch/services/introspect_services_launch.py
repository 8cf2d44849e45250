"""A server and a client that can tell on topics what they say to each other."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="demo_nodes_cpp", executable="introspection_service", output="screen"),
            Node(package="demo_nodes_cpp", executable="introspection_client", output="screen"),
        ]
    )
