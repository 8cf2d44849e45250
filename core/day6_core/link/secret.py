"""The secret of `--secret FILE|WORD`, which this process and other machines present to each other at its doors."""

from __future__ import annotations

import os
import stat
import sys

from day6_core.link.unusable import Unusable
from day6_core.reason import reason
from day6_core.whole_file import open_at_once

USER = "day6"
"""The user name that goes with it: a real ROS 2 gives Zenoh's `transport/auth/usrpwd` this name and the secret."""
SHORTEST = 8
_LONGEST = 256


def secret_of(text: str) -> str:
    """Return the secret in a file, or `text` itself if it is not a path.

    A word on a command line can be read by every user of the machine; a file that others can read is refused.

    Raises:
        Unusable: the secret cannot be used, for this reason.
    """
    return _checked(read_private(text), where=text) if is_path(text) else _checked(text)


def is_path(text: str) -> bool:
    """Return whether this means a file, and not a word."""
    return os.path.lexists(text) or "/" in text or os.sep in text


def read_private(path: str) -> str:
    """Return what is in a file that nobody else can read. Raises Unusable."""
    try:
        with open(path, "rb", opener=open_at_once) as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode):
                raise Unusable("secret_no_file", path=path)
            if sys.platform != "win32" and status.st_mode & 0o077:
                raise Unusable("secret_open", path=path)
            return file.read(4 * _LONGEST).decode("utf-8", errors="replace").strip()
    except OSError as error:
        raise Unusable("secret_unread", path=path, reason=reason(error)) from None


def _checked(secret: str, **where: str) -> str:
    if len(secret) < SHORTEST:
        raise Unusable("secret_short", **where, count=len(secret), least=SHORTEST)
    if len(secret) > _LONGEST:
        raise Unusable("secret_long", **where, most=_LONGEST)
    if not secret.isprintable() or ":" in secret or any(character.isspace() for character in secret):
        raise Unusable("secret_word", **where)
    return secret
