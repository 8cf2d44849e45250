"""A turtle to drive, and a second one that follows the frame `target_frame`."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("target_frame", default_value="turtle1", description="Target frame name."),
            Node(package="turtlesim", executable="turtlesim_node", name="sim"),
            *(
                Node(
                    package="turtle_tf2_py",
                    executable="turtle_tf2_broadcaster",
                    name=f"broadcaster{number}",
                    parameters=[{"turtlename": f"turtle{number}"}],
                )
                for number in (1, 2)
            ),
            Node(
                package="turtle_tf2_py",
                executable="turtle_tf2_listener",
                name="listener",
                parameters=[{"target_frame": LaunchConfiguration("target_frame")}],
            ),
        ]
    )
