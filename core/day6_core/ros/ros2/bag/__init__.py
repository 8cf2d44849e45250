"""`ros2 bag …`: records, plays and describes bags; the bags themselves are `rosbag2_py`'s.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

from __future__ import annotations

SUMMARY = "Various rosbag related sub-commands"
