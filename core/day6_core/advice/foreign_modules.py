"""Modules that programs import and that are not a part of ROS here: what provides them, or what stands in their place."""

from __future__ import annotations

import re

from day6_core.ros.differences import PACKAGES
from day6_core.ros.released import is_released

PIP = {"cv2": "opencv-python", "serial": "pyserial", "PIL": "pillow", "sklearn": "scikit-learn", "yaml": "pyyaml"} | {
    name: name for name in ("matplotlib", "numpy", "pandas", "pygame", "requests", "scipy", "transforms3d")
}
"""Python packages that lessons use: module -> what pip calls it."""

FAMILIES = (
    (r"nav2_\w+|nav_2d_\w+|navigation2|costmap_queue|dwb_\w+", "nav2"),
    (r"gazebo\w*|gz_\w+|ros_gz\w*|ros_ign\w*|ignition\w*|webots_\w+", "simulator"),
    (r"moveit\w*", "moveit"),
    (r"slam_toolbox|cartographer\w*|rtabmap\w*", "slam"),
    (r"robot_localization", "localization"),
    (
        r"ros2_control\w*|ros2controlcli|controller_\w+|\w+_(?:controllers?|broadcaster)|hardware_interface|control_toolbox",
        "control",
    ),
    (r"rplidar\w*|sllidar\w*|[ly]dlidar\w*|urg_node\w*|hls_lfcd_\w+|velodyne\w*", "lidar"),
    (r"usb_cam|v4l2_camera|camera_\w+|realsense2_\w+|depthai\w*|image_(?!tools)\w+", "camera"),
    (r"joy\w*|teleop_twist_joy", "joystick"),
    (r"turtlebot[34]_\w+|irobot_create_\w+", "turtlebot"),
    (r"rosbridge_\w+|rosapi\w*|foxglove_\w+", "browser"),
    (r"micro_ros_\w+|mavros\w*|px4_\w+", "board"),
)
"""Packages of ROS that are not here, by what they are for: pattern -> the texts `foreign.<…>`."""

NEXT = {
    **dict.fromkeys(("nav2", "simulator", "slam", "localization", "lidar", "turtlebot"), "ros2 run day6_world world"),
    "camera": "ros2 run image_tools cam2image --ros-args -p burger_mode:=true",
    "joystick": "ros2 run teleop_twist_keyboard teleop_twist_keyboard",
}
"""What can do the part here."""


def family_of(name: str) -> str:
    """What a package of ROS that is not here is for: a key of `NEXT` and the texts, 'other', or '' for a name
    that no package of ROS has, or one of another distribution's that is here."""
    if not is_released(name) or name in PACKAGES:
        return ""
    return next((key for pattern, key in FAMILIES if re.fullmatch(pattern, name)), "other")


OF_ROS_1 = {"rospy": "rclpy", "tf": "tf2_ros", "actionlib": "rclpy.action", "roslib": "rclpy", "roslaunch": "launch"}
"""Modules of ROS 1, and what there is of them in ROS 2."""

COMMON = frozenset({
    "copy", "datetime", "glob", "json", "math", "os", "random", "re", "signal", "socket", "struct", "subprocess", "sys",
    "threading", "time",
})  # fmt: skip
"""Modules of Python whose name alone says that they are meant."""

OF_MATH = frozenset({"acos", "asin", "atan", "atan2", "cos", "degrees", "hypot", "pi", "radians", "sin", "sqrt", "tan"})
"""Names that programs for robots use of the module math."""

AMBIGUOUS = frozenset({"Clock", "Counter", "Duration", "Event", "Log", "Parameter", "Path", "Time"})
"""Names of messages that Python or rclpy has as well."""

SAMPLES = {
    "Node": "from rclpy.node import Node",
    "QoSProfile": "from rclpy.qos import QoSProfile",
    "ReliabilityPolicy": "from rclpy.qos import ReliabilityPolicy",
    "DurabilityPolicy": "from rclpy.qos import DurabilityPolicy",
    "ActionClient": "from rclpy.action import ActionClient",
    "ActionServer": "from rclpy.action import ActionServer",
    "MultiThreadedExecutor": "from rclpy.executors import MultiThreadedExecutor",
    "ExternalShutdownException": "from rclpy.executors import ExternalShutdownException",
    "DeclareLaunchArgument": "from launch.actions import DeclareLaunchArgument",
    "LaunchConfiguration": "from launch.substitutions import LaunchConfiguration",
    "TransformBroadcaster": "from tf2_ros import TransformBroadcaster",
    "LaunchDescription": "from launch import LaunchDescription",
    "get_package_share_directory": "from ament_index_python.packages import get_package_share_directory",
    "glob": "from glob import glob",
}
"""Names that the lessons' programs import, and how."""
