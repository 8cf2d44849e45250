"""The network interfaces of this machine, as the system reports them; off Linux only their names."""

from __future__ import annotations

import socket
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

_ADDRESS, _BROADCAST, _NETMASK, _FLAGS, _MTU, _HARDWARE = 0x8915, 0x8919, 0x891B, 0x8913, 0x8921, 0x8927
"""Requests of netdevice(7)."""
_FLAG_NAMES = (
    "UP", "BROADCAST", "DEBUG", "LOOPBACK", "POINTOPOINT", "NOTRAILERS", "RUNNING", "NOARP", "PROMISC", "ALLMULTI",
    "MASTER", "SLAVE", "MULTICAST", "PORTSEL", "AUTOMEDIA", "DYNAMIC",
)  # fmt: skip
"""By their bits (net/if.h)."""


def interfaces() -> list[dict[str, Any]]:
    """Return the properties of each interface by the names in `ros2 doctor --report`; those with an address first."""
    return sorted(_each(), key=lambda known: (not known["inet"], not known["inet6"]))


def _each() -> Iterator[dict[str, Any]]:
    for _, name in socket.if_nameindex():
        known: dict[str, Any] = dict.fromkeys(
            ("inet", "inet4", "ether", "inet6", "netmask", "device", "flags", "mtu", "broadcast")
        )
        known["device"] = name
        if sys.platform == "linux":
            _query_linux(name, known)
        yield known


def _query_linux(name: str, known: dict[str, Any]) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as connection:
        known["inet"] = _address(connection, _ADDRESS, name)
        known["inet4"] = [known["inet"]] if known["inet"] else []
        known["netmask"] = _address(connection, _NETMASK, name) if known["inet"] else None
        flags = int.from_bytes(_request(connection, _FLAGS, name)[16:18], sys.byteorder)
        known["flags"] = ",".join(word for bit, word in enumerate(_FLAG_NAMES) if flags >> bit & 1)
        if known["inet"] and "BROADCAST" in known["flags"]:
            known["broadcast"] = _address(connection, _BROADCAST, name)
        known["mtu"] = int.from_bytes(_request(connection, _MTU, name)[16:20], sys.byteorder)
        hardware = _request(connection, _HARDWARE, name)[18:24].hex(":")
        known["ether"] = hardware if hardware not in ("00:00:00:00:00:00", "") else None
    known["inet6"] = sorted(_inet6(name), key=lambda address: "%" in address)


def _request(connection: socket.socket, request: int, name: str) -> bytes:
    """Return the kernel's reply about an interface (struct ifreq); empty if it has none."""
    if sys.platform != "linux":
        raise NotImplementedError("on Linux only")
    import fcntl

    try:
        return fcntl.ioctl(connection.fileno(), request, name.encode()[:15].ljust(256, b"\0"))
    except OSError:
        return b""


def _address(connection: socket.socket, request: int, name: str) -> str | None:
    reply = _request(connection, request, name)
    return socket.inet_ntoa(reply[20:24]) if reply else None


def _inet6(name: str) -> Iterator[str]:
    try:
        lines = Path("/proc/net/if_inet6").read_text(encoding="ascii").splitlines()
    except OSError:
        return
    for words in map(str.split, lines):
        if len(words) == 6 and words[5] == name:
            address = socket.inet_ntop(socket.AF_INET6, bytes.fromhex(words[0]))
            # Scope 20 is link-local: such an address means nothing without its interface.
            yield f"{address}%{name}" if words[3] == "20" else address
