"""The secret of `--secret FILE|WORD`, which this process and other machines present to each other at its doors."""

from __future__ import annotations

import os
import stat
import sys

USER = "day6"
"""The user name that goes with it: a real ROS 2 gives Zenoh's `transport/auth/usrpwd` this name and the secret."""
SHORTEST = 8
_LONGEST = 256


def secret_of(text: str) -> str:
    """Return the secret in a file, or `text` itself if it is not a path.

    A word on a command line can be read by every user of the machine; a file that others can read is refused.

    Raises:
        ValueError: the secret cannot be used; the message gives the reason.
    """
    if not (os.path.lexists(text) or "/" in text or os.sep in text):
        return _checked(text, "the secret")
    try:
        secret = _read(text)
    except OSError as error:
        raise ValueError(f"{text}: {error.strerror or error}") from None
    return _checked(secret, text)


def _read(path: str) -> str:
    # Non-blocking, because opening a FIFO waits for its writer.
    with os.fdopen(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)), "rb") as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise ValueError(f"{path} is not a file")
        if sys.platform != "win32" and status.st_mode & 0o077:
            raise ValueError(f"other users can read {path}; do: chmod 600 {path}")
        return file.read(4 * _LONGEST).decode("utf-8", errors="replace").strip()


def _checked(secret: str, where: str) -> str:
    if len(secret) < SHORTEST:
        raise ValueError(f"{where} has {len(secret)} characters, at least {SHORTEST} are needed")
    if len(secret) > _LONGEST:
        raise ValueError(f"{where} has more than {_LONGEST} characters")
    if not secret.isprintable() or ":" in secret or any(character.isspace() for character in secret):
        raise ValueError(f"{where} must be one word without a colon")
    return secret
