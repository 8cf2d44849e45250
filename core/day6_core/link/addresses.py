"""Zenoh endpoints as people type them (`tcp/0.0.0.0:7447`), checked before anything is opened."""

from __future__ import annotations

import ipaddress
import re
import socket
import struct
import sys
from collections.abc import Iterator
from typing import NamedTuple

ROUTER_PORT = 7447
"""rmw_zenoh's, as of any router of Zenoh."""
PROTOCOLS = ("tcp", "udp", "ws")
"""The installed Zenoh's protocols that need neither certificates nor a path."""
_NAME = re.compile(r"(?!-)[A-Za-z0-9_-]{1,63}(\.(?!-)[A-Za-z0-9_-]{1,63})*\.?")
_BARE_IPV6 = re.compile(r"[0-9A-Fa-f:]*:[0-9A-Fa-f:]*")
_NUMBERS = re.compile(r"[0-9.]+")


class Address(NamedTuple):
    """The parts of an endpoint. `host` is without the brackets of an IPv6 address."""

    protocol: str
    host: str
    port: int


def address_of(endpoint: str, *, listening: bool) -> Address:
    """Return the parts of an endpoint to listen on or to connect to.

    Host names are not resolved here: that may take seconds, and the result may change.

    Raises:
        ValueError: the endpoint is invalid; the message gives the reason.
    """
    protocol, slash, rest = endpoint.partition("/")
    if not (protocol.isalnum() and slash and rest):
        raise ValueError(f"{endpoint!r} is not an endpoint like tcp/192.168.1.5:7447")
    if protocol not in PROTOCOLS:
        raise ValueError(f"{endpoint!r} has an unknown protocol: use {', '.join(PROTOCOLS[:-1])} or {PROTOCOLS[-1]}")
    host, colon, port = rest.rpartition(":")
    if not rest.isprintable():
        raise ValueError(f"{endpoint!r} has no valid host name")
    if not colon or host.count("[") != host.count("]"):
        raise ValueError(f"{endpoint!r} has no port: write {protocol}/{rest}:7447")
    if not (port.isascii() and port.isdecimal() and 1 <= int(port) <= 65535):
        raise ValueError(f"{endpoint!r} has no port from 1 to 65535")
    return Address(protocol, _host(endpoint, protocol, host, listening=listening), int(port))


def _host(endpoint: str, protocol: str, host: str, *, listening: bool) -> str:
    bracketed = host.startswith("[") and host.endswith("]")
    if not bracketed and _BARE_IPV6.fullmatch(host):
        raise ValueError(f"{endpoint!r} needs brackets around an IPv6 address: {protocol}/[::1]:7447")
    if bracketed or _NUMBERS.fullmatch(host):
        host = host.strip("[]")
        try:
            ip = ipaddress.IPv6Address(host) if bracketed else ipaddress.IPv4Address(host)
        except ValueError:
            raise ValueError(f"{endpoint!r} has no valid address: {host}") from None
        if ip.is_unspecified and not listening:
            raise ValueError(f"{endpoint!r} means every address of this machine, so it cannot be connected to")
    elif not _NAME.fullmatch(host):
        raise ValueError(f"{endpoint!r} has no valid host name: {host or 'it is empty'}")
    return host


def own_address() -> str:
    """Return the address by which others reach this machine: that of its way to elsewhere, else of its first network.

    Nothing is sent. Without any network it is the machine's name.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address for documentation: RFC 5737
            return str(probe.getsockname()[0])
        except OSError:  # a room without internet
            found = next((each for each in _of_interfaces(probe) if not ipaddress.ip_address(each).is_loopback), None)
    return found or socket.gethostname()


def _of_interfaces(probe: socket.socket) -> Iterator[str]:
    """Yield the IPv4 addresses of this machine's network interfaces (Linux, macOS)."""
    if sys.platform == "win32":
        return
    import fcntl

    get_address = 0x8915 if sys.platform == "linux" else 0xC0206921  # SIOCGIFADDR
    for _, name in socket.if_nameindex():
        try:
            answer = fcntl.ioctl(probe.fileno(), get_address, struct.pack("16s240x", name.encode()[:15]))
        except OSError:
            continue  # it has none
        yield socket.inet_ntoa(answer[20:24])
