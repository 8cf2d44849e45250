"""Writes files so that none is ever half there: into a temporary file beside the target, which then takes its name."""

from __future__ import annotations

import os
import sys
import tempfile
from contextlib import suppress
from pathlib import Path


def write_text(path: Path, text: str, *, executable: bool = False) -> None:
    """Write a UTF-8 file with its folders. OSError names the file; on failure what was there before is still there."""
    write_bytes(path, text.encode("utf-8", "surrogateescape"), executable=executable)


def write_bytes(path: Path, data: bytes, *, executable: bool = False) -> None:
    """The same for bytes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.is_symlink():
        path.unlink()
    number, temporary = tempfile.mkstemp(prefix=".day6-", dir=path.parent)
    try:
        with os.fdopen(number, "wb") as file:
            file.write(data)
        if sys.platform != "win32":
            os.chmod(temporary, 0o755 if executable else 0o666 & ~_umask())
        os.replace(temporary, path)
    except OSError as error:
        with suppress(OSError):
            os.unlink(temporary)
        raise OSError(error.errno, error.strerror, str(path)) from error


def _umask() -> int:
    """The umask, read where reading does not change it for other threads."""
    try:
        with open("/proc/self/status", encoding="ascii", errors="replace") as file:
            for line in file:
                if line.startswith("Umask:"):
                    return int(line.split()[1], 8)
    except OSError:
        pass  # not Linux: the usual one
    return 0o022


def link_or_copy(source: Path, target: Path) -> None:
    """Make `target` a link to `source`; where links are not allowed (Windows) a file is copied."""
    target.parent.mkdir(parents=True, exist_ok=True)
    if target.is_symlink() or target.is_file():
        if target.is_symlink() and target.resolve() == source.resolve():
            return
        target.unlink()
    elif target.is_dir():
        import shutil

        shutil.rmtree(target)
    try:
        target.symlink_to(source, target_is_directory=source.is_dir())
    except (OSError, NotImplementedError):
        if sys.platform != "win32":
            raise
        import shutil

        if source.is_dir():
            shutil.copytree(source, target)
        else:
            shutil.copy2(source, target)
