"""The place of `_definitions`' names in the real rosbag2_py."""

from __future__ import annotations

from rosbag2_py import also

__getattr__ = also("_message_definitions")
