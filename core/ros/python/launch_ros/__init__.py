"""Launching of ROS nodes: names, signatures and texts of ros2/launch_ros."""

from __future__ import annotations

from launch_ros import actions, descriptions, event_handlers, events, ros_adapters, substitutions

__all__ = ["actions", "descriptions", "event_handlers", "events", "ros_adapters", "substitutions"]
