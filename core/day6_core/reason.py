"""Why something failed, as real tools say it: "No space left on device", never Python's "[Errno 28] No space left on device"."""

from __future__ import annotations

import os

LONGEST_NAME = 255
"""Characters of a path that are shown in an error; one that is itself too long fills the screen."""


_AS_ELSEWHERE = (2, 3, 5, 80, 112, 145, 183, 267)
"""Errors of Windows for which C has words: something is missing, refused, there already, not empty, no folder; a full disk."""


def reason(error: BaseException) -> str:
    """Return the system's words for an error of the system, else what the error says.

    Windows' own depend on its language, and neither cards nor courses know them; where it can, this returns C's.
    """
    if isinstance(error, OSError) and error.errno and getattr(error, "winerror", None) in _AS_ELSEWHERE:
        return os.strerror(error.errno)
    return (isinstance(error, OSError) and error.strerror) or str(error) or type(error).__name__


def named_reason(error: BaseException) -> str:
    """Return the same, behind the name of the file that the error is about."""
    name = error.filename if isinstance(error, OSError) and isinstance(error.filename, str) else ""
    return f"{name}: {reason(error)}" if 0 < len(name) <= LONGEST_NAME else reason(error)


def reason_and_name(error: OSError) -> str:
    """Return the same with the file's name behind it, as Python writes it."""
    return f"{reason(error)}: '{error.filename}'" if error.filename else reason(error)


def fault(error: BaseException) -> str:
    """Return what a fault of ours is reported as: the kind of the error and its reason, in one line of a traceback's form."""
    return f"{type(error).__name__}: {named_reason(error)}"
