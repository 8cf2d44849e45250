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

SAMPLES = {
    "Node": "from rclpy.node import Node",
    "LaunchDescription": "from launch import LaunchDescription",
    "get_package_share_directory": "from ament_index_python.packages import get_package_share_directory",
    "glob": "from glob import glob",
}
"""Names that the lessons' programs import, and how."""
