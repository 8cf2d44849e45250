"""The arguments that both verbs share, and the sockets."""

from __future__ import annotations

import socket
import struct
from argparse import ArgumentParser

from day6_core.ros.ros2.cli.options import positive_int

GROUP = "225.0.0.1"
PORT = 49150
LARGEST = 4096


def add_group_arguments(parser: ArgumentParser) -> None:
    """Add the address and the port of the group."""
    parser.add_argument("--group", default=GROUP, help="The multicast group address")
    parser.add_argument("--port", type=positive_int, default=PORT, help="The multicast port")


def send(data: bytes, group: str, port: int, ttl: int | None) -> None:
    """Send one packet. Raises OSError (no network, a wrong address), OverflowError and struct.error for wrong numbers."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP) as sender:
        if ttl is not None:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, struct.pack("b", ttl))
        sender.sendto(data, (group, port))


def member(group: str, port: int) -> socket.socket:
    """Return a socket that receives from the group; the caller closes it. Raises OSError or OverflowError."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM, socket.IPPROTO_UDP)
    try:
        receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if hasattr(socket, "SO_REUSEPORT"):  # Windows doesn't have it
            receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        receiver.bind(("", port))
        membership = struct.pack("=4sl", socket.inet_aton(group), socket.INADDR_ANY)
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        receiver.setblocking(False)
    except BaseException:
        receiver.close()
        raise
    return receiver
