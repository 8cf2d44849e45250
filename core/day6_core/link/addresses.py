"""Zenoh endpoints as people type them (`tcp/0.0.0.0:7447`), checked before anything is opened."""

from __future__ import annotations

import ipaddress
import re
import socket
import struct
import sys
from collections.abc import Iterator
from typing import NamedTuple

from day6_core.link.unusable import Unusable

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


def meant(text: str, port: int | None = None) -> str:
    """Return the endpoint that HOST:PORT stands for, and HOST alone where `port` is the usual one; any other text as it is."""
    host = f"[{text}]" if text.count(":") > 1 and not text.startswith("[") else text
    if "/" in text or not text:
        return text
    if ":" in host and not host.endswith("]"):
        return f"tcp/{host}"
    return text if port is None else f"tcp/{host}:{port}"


def address_of(endpoint: str, *, listening: bool) -> Address:
    """Return the parts of an endpoint to listen on or to connect to.

    Host names are not resolved here: that may take seconds, and the result may change.

    Raises:
        Unusable: the endpoint is invalid, for this reason.
    """
    protocol, slash, rest = endpoint.partition("/")
    if not (protocol.isalnum() and slash and rest):
        raise Unusable("endpoint", endpoint=endpoint)
    if protocol not in PROTOCOLS:
        raise Unusable("protocol", endpoint=endpoint, others=", ".join(PROTOCOLS[:-1]), last=PROTOCOLS[-1])
    host, colon, port = rest.rpartition(":")
    if not rest.isprintable():
        raise Unusable("host", endpoint=endpoint)
    if not colon or host.count("[") != host.count("]"):
        raise Unusable("port_missing", endpoint=endpoint, right=f"{protocol}/{rest}:{ROUTER_PORT}")
    if not (port.isascii() and port.isdecimal() and 1 <= int(port) <= 65535):
        raise Unusable("port", endpoint=endpoint)
    return Address(protocol, _host(endpoint, protocol, host, listening=listening), int(port))


def _host(endpoint: str, protocol: str, host: str, *, listening: bool) -> str:
    bracketed = host.startswith("[") and host.endswith("]")
    if not bracketed and _BARE_IPV6.fullmatch(host):
        raise Unusable("brackets", endpoint=endpoint, right=f"{protocol}/[::1]:{ROUTER_PORT}")
    if bracketed or _NUMBERS.fullmatch(host):
        host = host.strip("[]")
        try:
            ip = ipaddress.IPv6Address(host) if bracketed else ipaddress.IPv4Address(host)
        except ValueError:
            raise Unusable("address", endpoint=endpoint, host=host) from None
        if ip.is_unspecified and not listening:
            raise Unusable("every", endpoint=endpoint)
    elif not _NAME.fullmatch(host):
        raise Unusable("host_named" if host else "host_empty", endpoint=endpoint, host=host)
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
