"""Who sits at the simulated machine: the login name of the real one."""

from __future__ import annotations

import getpass
import re

UNKNOWN = "student"
"""The name where there is none to use: root in a container, no entry for the user, a name that no Linux would take."""

_USABLE = re.compile(r"[^\W\d][\w.-]{0,31}")
"""One word, in any script: Windows allows spaces, and names that are whole addresses."""


def login_name() -> str:
    """Return the user's name as `whoami` and the prompt show it."""
    try:
        name = getpass.getuser()
    except (OSError, KeyError, ImportError):  # by version and system, where neither variables nor the system know one
        return UNKNOWN
    return name if name != "root" and _USABLE.fullmatch(name) else UNKNOWN
