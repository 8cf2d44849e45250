"""Where somebody calls from."""

from __future__ import annotations

import ipaddress


def source(address: str) -> str:
    """What counts as one and the same place: an IPv4 address, or the 64 bits of an IPv6 network, whose rest its owner chooses."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(found, ipaddress.IPv4Address):
        return str(found)
    if found.ipv4_mapped is not None:
        return str(found.ipv4_mapped)
    return str(ipaddress.ip_network((found, 64), strict=False))
