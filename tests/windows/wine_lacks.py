"""Loaded at the start of every Python under Wine (`run`): other ways to what ends the process or has no end there."""

from __future__ import annotations

import _ssl
import os


def _getppid() -> int:
    """Return the number of the parent; Python's own asks for a snapshot of the process, which Wine does not make."""
    import ctypes

    facts = (ctypes.c_size_t * 6)()  # PROCESS_BASIC_INFORMATION
    ctypes.windll.ntdll.NtQueryInformationProcess(ctypes.c_size_t(-1), 0, facts, ctypes.sizeof(facts), None)  # type: ignore[attr-defined]
    return facts[5]


os.getppid = _getppid
_ssl.enum_certificates = lambda store: []  # type: ignore[attr-defined]  # reading them fails a thousand times
