"""Exceptions of callbacks that real rclpy shows to nobody; only day6-tui's inspector asks for them (`_reports`)."""

from __future__ import annotations

from collections import deque
from typing import NamedTuple


class LostError(NamedTuple):
    """An exception, and the full name of the node whose callback raised it ('' if that is not known)."""

    node: str
    error: BaseException


LOST: deque[LostError] = deque(maxlen=10)
"""The last ones."""


def remember(error: BaseException, node: str = "") -> None:
    """Keep an exception that is about to be lost."""
    LOST.append(LostError(node, error))
