"""Multicast packets."""

from __future__ import annotations

from typing import Any

from day6_core.ros.ros2.cli import multicast
from day6_core.ros.ros2.cli.multicast import GROUP as DEFAULT_GROUP
from day6_core.ros.ros2.cli.multicast import PORT as DEFAULT_PORT


def send(data: bytes, *, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, ttl: int | None = None) -> None:
    """Send one packet."""
    multicast.send(data, group, port, ttl)


def receive(*, group: str = DEFAULT_GROUP, port: int = DEFAULT_PORT, timeout: float | None = None) -> tuple[bytes, Any]:
    """Return the next packet and where it comes from. Raises TimeoutError after `timeout` seconds."""
    with multicast.member(group, port) as receiver:
        receiver.settimeout(timeout)
        return receiver.recvfrom(multicast.LARGEST)
