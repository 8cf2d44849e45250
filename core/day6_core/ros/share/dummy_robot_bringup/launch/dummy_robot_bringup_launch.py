"""The dummy robot: a map, joint states, a laser scan, and the transforms of its links."""

from launch import LaunchDescription
from launch.substitutions import FileContent, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    robot = FileContent(PathJoinSubstitution([FindPackageShare("dummy_robot_bringup"), "launch", "single_rrbot.urdf"]))
    return LaunchDescription(
        [
            Node(package="dummy_map_server", executable="dummy_map_server", output="screen"),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                output="screen",
                parameters=[{"robot_description": robot}],
            ),
            Node(package="dummy_sensors", executable="dummy_joint_states", output="screen"),
            Node(package="dummy_sensors", executable="dummy_laser", output="screen"),
        ]
    )
