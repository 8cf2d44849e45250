"""Shows a robot description in RViz, with joints that can be moved."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

PUBLISHER = "joint_state_publisher"


def generate_launch_description():
    share = FindPackageShare("urdf_launch")
    with_sliders = LaunchConfiguration("jsp_gui")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "jsp_gui",
                default_value="true",
                choices=["true", "false"],
                description="Whether the joints have sliders",
            ),
            DeclareLaunchArgument(
                "rviz_config",
                default_value=PathJoinSubstitution([share, "config", "urdf.rviz"]),
                description="What RViz shows: the path of a file",
            ),
            IncludeLaunchDescription(
                PathJoinSubstitution([share, "launch", "description.launch.py"]),
                launch_arguments={
                    name: LaunchConfiguration(name) for name in ("urdf_package", "urdf_package_path")
                }.items(),
            ),
            Node(package=PUBLISHER, executable=PUBLISHER, condition=UnlessCondition(with_sliders)),
            Node(package=f"{PUBLISHER}_gui", executable=f"{PUBLISHER}_gui", condition=IfCondition(with_sliders)),
            Node(
                package="rviz2",
                executable="rviz2",
                output="screen",
                arguments=["-d", LaunchConfiguration("rviz_config")],
            ),
        ]
    )
