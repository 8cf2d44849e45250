"""Modules that programs import and that are not a part of ROS here: what provides them, or what stands in their place."""

from __future__ import annotations

PIP = {"cv2": "opencv-python", "serial": "pyserial", "PIL": "pillow", "sklearn": "scikit-learn", "yaml": "pyyaml"} | {
    name: name for name in ("matplotlib", "numpy", "pandas", "pygame", "requests", "scipy", "transforms3d")
}
"""Python packages that lessons use: module -> what pip calls it."""

NOT_HERE = frozenset({
    "ackermann_msgs", "apriltag_msgs", "camera_info_manager", "can_msgs", "control_msgs", "controller_manager",
    "controller_manager_msgs", "cv_bridge", "diagnostic_updater", "gazebo_msgs", "geographic_msgs", "gps_msgs",
    "grid_map_msgs", "image_geometry", "interactive_markers", "laser_geometry", "mavros_msgs", "message_filters",
    "moveit", "moveit_configs_utils", "moveit_msgs", "nav2_common", "nav2_msgs", "nav2_simple_commander",
    "octomap_msgs", "pcl_msgs", "rclpy_message_converter", "realsense2_camera_msgs", "robot_localization",
    "ros_gz_interfaces", "rosbridge_library", "sensor_msgs_py", "slam_toolbox", "tf_transformations", "turtlebot3_msgs",
    "vision_msgs", "webots_ros2_driver",
})  # fmt: skip
"""Modules of well-known packages of ROS that pip does not have; some are here all the same."""

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
