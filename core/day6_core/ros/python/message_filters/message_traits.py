"""Where the time of a message comes from."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time


def get_time_from_message_header(message: Any) -> Time | None:
    """Return the stamp of a message's header, None for a message without one."""
    if not hasattr(message, "header") or not hasattr(message.header, "stamp"):
        return None
    stamp = message.header.stamp
    return stamp if hasattr(stamp, "nanoseconds") else Time.from_msg(stamp)
