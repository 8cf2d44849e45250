"""The QoS of turtlesim's topics (turtlesim/qos.hpp)."""

from __future__ import annotations

from rclpy.qos import QoSProfile

TOPIC_QOS = QoSProfile(depth=7)
"""Of every topic of turtlesim and its tutorials: keep last 7, reliable, volatile."""
