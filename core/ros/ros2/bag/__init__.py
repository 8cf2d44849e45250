"""`ros2 bag …`: records, plays and describes bags; what a bag is, is in `rosbag2_py`."""

from __future__ import annotations

SUMMARY = "Various rosbag related sub-commands"
