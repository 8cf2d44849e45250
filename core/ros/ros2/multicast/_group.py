"""The arguments of both verbs, and the sockets."""

from __future__ import annotations

import socket
import struct
from argparse import ArgumentParser

from day6_tui.core.ros.ros2.cli.options import number_type

GROUP = "225.0.0.1"
PORT = 49150
LARGEST = 4096

positive = number_type(int, lambda value: value > 0, "value must be a positive integer")


def add_group_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--group", default=GROUP, help="The multicast group address")
    parser.add_argument("--port", type=positive, default=PORT, help="The multicast port")


def send(data: bytes, group: str, port: int, ttl: int | None) -> None:
    """Send one packet. Raises OSError (no network, a wrong address), OverflowError and struct.error for wrong numbers."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as sender:
        if ttl is not None:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, struct.pack("b", ttl))
        sender.sendto(data, (group, port))


def member(group: str, port: int) -> socket.socket:
    """Return a socket that hears the group; close it in the end. Raises OSError or OverflowError."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    try:
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if hasattr(socket, "SO_REUSEPORT"):  # Windows has none
            receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        receiver.bind(("", port))
        membership = struct.pack("=4sl", socket.inet_aton(group), socket.INADDR_ANY)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        receiver.setblocking(False)
    except BaseException:
        receiver.close()
        raise
    return receiver
