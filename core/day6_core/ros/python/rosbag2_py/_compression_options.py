"""The place of `_compression`'s names in the real rosbag2_py."""

from __future__ import annotations

from rosbag2_py import also

__getattr__ = also("_compression_options")
