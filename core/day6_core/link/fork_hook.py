"""The function Python calls in the child of a fork.

Python keeps the function, and everything its module references, until the interpreter ends; this module references nothing
that would keep a student's nodes from being destroyed earlier.
"""

from __future__ import annotations

import sys


def install() -> None:
    """Have this package's `after_fork` called in every child; does nothing on systems without fork."""
    import os

    if hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=_forget_links)


def _forget_links() -> None:
    after_fork = getattr(sys.modules.get("day6_core.link"), "after_fork", None)
    if after_fork is not None:
        after_fork()
