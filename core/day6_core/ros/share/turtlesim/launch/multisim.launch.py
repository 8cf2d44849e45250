"""Two turtlesims side by side, each with a namespace of its own."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(
                package="turtlesim", executable="turtlesim_node", namespace=namespace, name="turtlesim", output="screen"
            )
            for namespace in ("turtlesim1", "turtlesim2")
        ]
    )
