"""Exceptions of callbacks that real rclpy shows to nobody, and of threads; only day6-tui's inspector asks for them."""

from __future__ import annotations

import atexit
import threading
from collections import deque
from collections.abc import Callable
from typing import Any, NamedTuple


class LostError(NamedTuple):
    """An exception, and the full name of the node whose callback raised it ('' if that is not known)."""

    node: str
    error: BaseException
    thread: str = ""
    """The thread that it ended, '' where it ended none."""


LOST: deque[LostError] = deque(maxlen=10)
"""The last ones."""


def remember(error: BaseException, node: str = "") -> None:
    """Keep an exception that is about to be lost."""
    LOST.append(LostError(node, error))


def follow_threads(is_valid: Callable[[], bool]) -> None:
    """Remember from now on which threads end with an exception; what they print stays as it is.

    `is_valid` tells whether the program goes on: what threads raise because everything ends is nothing to be remembered.
    """
    before = threading.excepthook

    def ended(args: Any) -> None:
        if args.exc_value is not None and not isinstance(args.exc_value, SystemExit) and is_valid():
            LOST.append(LostError("", args.exc_value, args.thread.name if args.thread is not None else "?"))
        before(args)

    threading.excepthook = ended
    # Python ends in another order around a hook of ours: nodes that are left over would not be destroyed.
    atexit.register(setattr, threading, "excepthook", before)
