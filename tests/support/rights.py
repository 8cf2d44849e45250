"""What a test needs in which something may not be written, although it is started by root, who may write everywhere."""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

_VERSION_3 = 0x20080522
_EVERY_FILE = 1 << 1 | 1 << 2
"""CAP_DAC_OVERRIDE and CAP_DAC_READ_SEARCH."""


@contextmanager
def _dropped() -> Iterator[None]:
    """Take from this thread, and from those that it starts, the right to every file; capset(2)."""
    libc = ctypes.CDLL(None, use_errno=True)
    header = (ctypes.c_uint32 * 2)(_VERSION_3, 0)
    sets = (ctypes.c_uint32 * 6)()  # effective, permitted, inheritable, twice
    if libc.capget(header, sets) != 0:
        pytest.skip("this system does not tell the rights of root")
    before = sets[0]
    sets[0] &= ~_EVERY_FILE
    if libc.capset(header, sets) != 0:
        pytest.skip("root cannot give rights up here")
    try:
        yield
    finally:
        sets[0] = before
        libc.capset(header, sets)


@pytest.fixture
def plain_user() -> Iterator[None]:
    """Modes of files count, also for root."""
    if os.name != "posix":
        pytest.skip("Windows has no modes")
    if os.geteuid() != 0:
        yield
    elif sys.platform == "linux":
        with _dropped():
            yield
    else:
        pytest.skip("root may write everywhere")
