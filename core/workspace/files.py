"""Puts files into build and install folders: written whole (`core.whole_file`), linked, or copied."""

from __future__ import annotations

import sys
from pathlib import Path

from day6_tui.core.whole_file import replace_file


def write_text(path: Path, text: str, *, executable: bool = False) -> None:
    """Write a UTF-8 file with its folders. OSError names the file; on failure what was there before is still there."""
    write_bytes(path, text.encode("utf-8", "surrogateescape"), executable=executable)


def write_bytes(path: Path, data: bytes, *, executable: bool = False) -> None:
    """The same for bytes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, data, mode=0o777 if executable else 0o666, sync=False, follow=False)


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
