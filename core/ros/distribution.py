"""The distribution of ROS 2 that day6-tui simulates."""

from __future__ import annotations

DISTRO = "jazzy"
"""The value of ROS_DISTRO; package layout and texts follow this distribution."""
