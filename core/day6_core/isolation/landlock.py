"""Landlock, the Linux security module by which a process without rights restricts itself: its three system calls.

Numbers and structures are those of linux/landlock.h; the documentation of the kernel (userspace-api/landlock) says from which
version ("ABI") on it has what. What a version lacks is left out here, so a caller asks `version` or, better, tries.
"""

from __future__ import annotations

import ctypes
import errno
import os
import struct
import sys

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
"""Numbers of the system calls, which since Linux 5.1 are the same on every architecture."""
_GET_VERSION = 1
_PATH_BENEATH = 1

_EXECUTE, _WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
_TRUNCATE, _IOCTL_DEV = 1 << 14, 1 << 15
_READ = _EXECUTE | _READ_FILE | _READ_DIR
_OF_FILES = _EXECUTE | _WRITE_FILE | _READ_FILE | _TRUNCATE | _IOCTL_DEV
"""The rights that a rule for a file (not a folder) may name."""
_HANDLED = ((1, (1 << 13) - 1), (2, 1 << 13), (3, _TRUNCATE), (5, _IOCTL_DEV), (9, 1 << 16))
"""From which version on there are which rights to files; the last is connecting to a Unix socket by its path."""
_SCOPES = 0b11
"""Abstract Unix sockets, signals; since version 6."""


def _call(number: int, *arguments: object) -> int:
    library = ctypes.CDLL(None, use_errno=True)
    result: int = library.syscall(number, *arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result


def prctl(option: int, value: int) -> None:
    """Call prctl(2). Raises OSError."""
    library = ctypes.CDLL(None, use_errno=True)
    if library.prctl(option, ctypes.c_ulong(value), *(ctypes.c_ulong(0),) * 3) < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))


def version() -> int:
    """Return the version of Landlock that runs here, 0 for none."""
    try:
        return _call(_CREATE_RULESET, None, ctypes.c_size_t(0), ctypes.c_uint32(_GET_VERSION))
    except (OSError, AttributeError):
        return 0


def restrict(readable: list[str], writable: list[str], *, scoped: bool) -> None:
    """Leave this process and all it starts only these files and folders, with `scoped` only each other to signal.

    Without any folder, files stay as they are. Paths that do not exist are passed over. PR_SET_NO_NEW_PRIVS must be set.
    Raises OSError.
    """
    here = version()
    handled = 0
    if readable or writable:
        for since, rights in _HANDLED:
            handled |= rights if here >= since else 0
    scopes = _SCOPES if scoped and here >= 6 else 0
    if not handled and not scopes:
        return
    attributes = struct.pack("=QQQ", handled, 0, scopes)[: 24 if here >= 6 else 16 if here >= 4 else 8]
    rules = _call(_CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), ctypes.c_uint32(0))
    try:
        for path in readable:
            _allow(rules, path, _READ & handled)
        for path in writable:
            _allow(rules, path, handled)
        _call(_RESTRICT_SELF, ctypes.c_int(rules), ctypes.c_uint32(0))
    finally:
        os.close(rules)


def _allow(rules: int, path: str, rights: int) -> None:
    if sys.platform != "linux":
        raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except (FileNotFoundError, NotADirectoryError):
        return
    try:
        if not os.path.isdir(path):
            rights &= _OF_FILES
        rule = struct.pack("=Qi", rights, place)
        _call(_ADD_RULE, ctypes.c_int(rules), ctypes.c_int(_PATH_BENEATH), rule, ctypes.c_uint32(0))
    finally:
        os.close(place)
