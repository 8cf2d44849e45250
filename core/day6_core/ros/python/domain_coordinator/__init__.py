"""A domain for each test that runs beside others."""

from __future__ import annotations

import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import cycle

__all__ = ["domain_id"]

_DOMAINS = range(1, 101)
_PORT_BASE = 32768
"""A domain is held by the TCP port with its number above this one, as in ROS: so one of a real ROS is kept out, too."""


@contextmanager
def domain_id(selector: Callable[[], int] | None = None) -> Iterator[int]:
    """Hold a domain (1 to 100) that no other process of this machine holds; `selector` proposes which to try next.

    Raises RuntimeError after 100 that others hold.
    """
    propose = cycle(_DOMAINS).__next__ if selector is None else selector
    for _ in _DOMAINS:
        domain = propose()
        with socket.socket() as held:
            try:
                held.bind(("127.0.0.1", _PORT_BASE + domain))
            except OSError:
                continue
            yield domain
            return
    raise RuntimeError("Failed to get a unique ROS domain ID")
