"""GIDs: the 16 bytes that name an endpoint among all processes.

rmw_zenoh does not send them: everybody computes XXH3-128 (seed 0) of an endpoint's liveliness token, and puts the low 64 bits
before the high ones, little endian.
"""

from __future__ import annotations

from xxhash import xxh3_128_digest


def gid_of(token: str) -> bytes:
    """Return the 16-byte GID of the endpoint that a liveliness token announces."""
    return xxh3_128_digest(token.encode())[::-1]
