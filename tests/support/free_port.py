"""A port of this machine on which a test will listen later: one that nobody gets in between who asks for any port."""

from __future__ import annotations

import random
import socket

_OURS = range(10_000, 21_000)
"""Below those of meeting points (`link/paths.py`), and those that systems give to connections and to whoever binds port 0."""

_random = random.SystemRandom()  # tests that run beside this one, and those that seed `random`, must not get the same


def free_port(kind: int = socket.SOCK_STREAM) -> int:
    """Return a port of 127.0.0.1 that nobody has."""
    while True:
        port = _random.choice(_OURS)
        with socket.socket(type=kind) as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
        return port
