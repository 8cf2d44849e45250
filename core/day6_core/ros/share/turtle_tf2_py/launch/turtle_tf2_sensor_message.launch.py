"""Two turtles with frames; the second one also tells as a point where it is."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("target_frame", default_value="turtle1", description="Target frame name."),
            Node(package="turtlesim", executable="turtlesim_node", name="sim", output="screen"),
            *(
                Node(
                    package="turtle_tf2_py",
                    executable="turtle_tf2_broadcaster",
                    name=f"broadcaster{number}",
                    parameters=[{"turtlename": turtle}],
                )
                for number, turtle in ((1, "turtle1"), (2, "turtle3"))
            ),
            Node(package="turtle_tf2_py", executable="turtle_tf2_message_broadcaster", name="message_broadcaster"),
        ]
    )
