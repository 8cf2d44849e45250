"""Launches ROS nodes, with the names, signatures and texts of ros2/launch_ros.

It builds on launch, which imports it only by name (`launch/_entry_points`); rclpy is imported when it is needed.
"""

from __future__ import annotations

from launch_ros import actions, descriptions, event_handlers, events, ros_adapters, substitutions

__all__ = ["actions", "descriptions", "event_handlers", "events", "ros_adapters", "substitutions"]
