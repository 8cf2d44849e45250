"""Shows one of the robots of this package: `model:=urdf/05-visual.urdf`."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare("urdf_tutorial")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "gui", default_value="true", choices=["true", "false"], description="Whether the joints have sliders"
            ),
            DeclareLaunchArgument(
                "rvizconfig",
                default_value=PathJoinSubstitution([share, "rviz", "urdf.rviz"]),
                description="What RViz shows: the path of a file",
            ),
            DeclareLaunchArgument(
                "model",
                default_value=PathJoinSubstitution(["urdf", "01-myfirst.urdf"]),
                description="The robot's file, from the share folder of urdf_tutorial",
            ),
            IncludeLaunchDescription(
                PathJoinSubstitution([FindPackageShare("urdf_launch"), "launch", "display.launch.py"]),
                launch_arguments={
                    "urdf_package": "urdf_tutorial",
                    "urdf_package_path": LaunchConfiguration("model"),
                    "rviz_config": LaunchConfiguration("rvizconfig"),
                    "jsp_gui": LaunchConfiguration("gui"),
                }.items(),
            ),
        ]
    )
