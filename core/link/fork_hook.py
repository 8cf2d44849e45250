"""What Python calls in the child of a fork.

Python keeps the function, and with it all that its module knows, until the very end; this module knows nothing that would keep a
student's nodes from being destroyed before.
"""

from __future__ import annotations

import sys


def install() -> None:
    """Have `after_fork` of this package called in every child; does nothing where there is no fork."""
    import os

    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=_tell)


def _tell() -> None:
    link = sys.modules.get("day6_tui.core.link")
    if link is not None:
        link.after_fork()
