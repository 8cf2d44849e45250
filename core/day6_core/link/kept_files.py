"""The files by which others find this process. Cleaners take what nobody has used for days, and somebody may take all of them.

macOS removes files from /tmp after 3 days (/usr/libexec/tmp_cleaner: locks, not sockets), systemd-tmpfiles both after 10; at the
last log-out XDG_RUNTIME_DIR goes as a whole, and asks to be used every 6 hours (XDG Base Directory Specification).
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

USED_SECONDS = 3600.0
"""Between two times at which they are marked as used."""


class KeptFiles:
    """Notices when some of these files are gone or others have their names, and keeps them in use."""

    def __init__(self) -> None:
        self._known: dict[Path, tuple[int, int]] = {}
        self._used_at = 0.0

    def are_gone(self, paths: Iterable[Path]) -> bool:
        """Return whether one of these files isn't there, or not the one that an earlier look found."""
        now = time.time()  # also goes on while the machine sleeps
        is_time = not 0 <= now - self._used_at < USED_SECONDS
        for path in paths:
            if (found := identity(path)) is None or self._known.setdefault(path, found) != found:
                return True
            if is_time:
                for used in (path, path.with_name(f"{path.name}.lock"), path.parent, path.parent.parent):
                    mark_as_used(used)
        self._used_at = now if is_time else self._used_at
        return False


def identity(path: Path) -> tuple[int, int] | None:
    """Return what tells a file from another of its name; None if there is none."""
    try:
        status = os.lstat(path)
    except OSError:
        return None
    return status.st_dev, status.st_ino


@contextmanager
def spared(paths: Iterable[Path]) -> Iterator[None]:
    """Let these files have their names again afterwards, whoever has removed them meanwhile, unless the names are taken."""
    aside = {path: path.with_name(f"{path.name}.{os.getpid()}") for path in paths}
    for path, other in aside.items():
        with suppress(OSError):
            os.link(path, other)
    try:
        yield
    finally:
        for path, other in aside.items():
            with suppress(OSError):
                os.link(other, path)
            with suppress(OSError):
                os.unlink(other)


def mark_as_used(path: Path) -> None:
    """Let a file or folder look as if somebody had used it now; nothing happens if it isn't there, or not ours."""
    with suppress(OSError, NotImplementedError):
        os.utime(path, follow_symlinks=os.utime not in os.supports_follow_symlinks)
