"""Paths of Unix sockets are as short as on macOS, 103 bytes (sys/un.h), also where the system allows more: Linux has 107."""

from __future__ import annotations

import os
import sys
from typing import Any

LONGEST = 103


def install() -> None:
    """From now on this process can't use longer ones; once."""
    sys.addaudithook(_audit)


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    if event in ("socket.bind", "socket.connect") and isinstance(arguments[1], (str, bytes)):
        path = os.fsencode(arguments[1])
        if len(path) > LONGEST and path[0]:  # Linux has names that are no paths, too
            raise OSError("AF_UNIX path too long")
