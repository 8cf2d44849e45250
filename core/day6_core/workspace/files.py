"""The folders one call of `colcon` may change, and the only way it changes them.

The build, install and log folders are ours; everything else is the user's. Whatever is written, linked or removed goes through
`Output`, which checks where a path really leads: a link in a build folder leads into the sources (the purpose of
--symlink-install), so that changing `build/pkg/pkg/x.py` would change the student's file. Every file is written whole or not
at all (`core.whole_file`).
"""

from __future__ import annotations

import errno
import os
import shutil
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from day6_core.whole_file import replace_file, replacing


class NotOurOutput(OSError):
    """A file to be written or removed is not an output of this call; it was left alone."""

    def __init__(self, text: str) -> None:
        super().__init__(errno.EPERM, text)


class BuildOutput:
    """Everything one call may change: all below its bases (build, install, log).

    A base may itself be a link, which is followed. `sources` are the folders of the packages; links into them were left by an
    earlier build, and only those are removed to make way.
    """

    def __init__(self, bases: Iterable[Path]) -> None:
        self._bases = [Path(os.path.realpath(base)) for base in bases]
        self._sources: list[Path] = []

    def protect(self, sources: Iterable[Path]) -> None:
        """Set the folders of the packages.

        Raises:
            NotOurs: one of them is inside a base, where everything counts as our output.
        """
        self._sources = [Path(os.path.realpath(source)) for source in sources]
        for source in self._sources:
            for base in self._bases:
                if source.is_relative_to(base):
                    raise NotOurOutput(
                        f"'{base}' holds sources ('{source}'): choose another folder for the build's output"
                    )

    def owns(self, path: Path) -> bool:
        """Return whether a path is below a base after following the links of its folders; the last part may be a link."""
        return any(base in _real(path).parents for base in self._bases)

    def check(self, path: Path) -> None:
        """Raise NotOurs for a path that is not below a base."""
        if not self.owns(path):
            raise NotOurOutput(
                f"'{path}' leads to '{_real(path)}', outside the build, install and log folders: left alone"
            )

    def remove(self, path: Path) -> None:
        """Remove a file, a link (never its target) or a folder with its contents. Nothing else in `colcon` removes files."""
        self.check(path)
        if any(base.is_relative_to(_real(path)) for base in self._bases):
            raise NotOurOutput(f"'{path}' holds a build, install or log folder: left alone")
        if path.is_symlink() or not path.is_dir():
            path.unlink(missing_ok=True)
        else:
            shutil.rmtree(path)

    def remove_folder_if_empty(self, path: Path) -> bool:
        """Remove a folder if it is empty; return whether it was."""
        self.check(path)
        if any(path.iterdir()):
            return False
        path.rmdir()
        return True

    def remove_links_above(self, path: Path) -> None:
        """Remove links into the sources that an earlier build left in place of a folder above `path`.

        Raises:
            NotOurs: the path still leads elsewhere.
        """
        for folder in reversed(path.parents):
            if folder.is_symlink() and not self.owns(folder / "x") and self.owns(folder) and self._is_source(folder):
                self.remove(folder)
        self.check(path)

    def make_parents(self, path: Path) -> None:
        """Create the folders above a path, after `remove_links_above`."""
        self.remove_links_above(path)
        path.parent.mkdir(parents=True, exist_ok=True)

    def _is_source(self, path: Path) -> bool:
        real = Path(os.path.realpath(path))
        return any(real.is_relative_to(source) for source in self._sources)

    def make_folder(self, path: Path) -> None:
        """Create a folder and its parents."""
        self.make_parents(path / "x")

    def write_text(self, path: Path, text: str) -> None:
        """Write a UTF-8 file and create its folders. OSError names the file; after a failure the old file is still there."""
        self.write_bytes(path, text.encode("utf-8", "surrogateescape"))

    def write_bytes(self, path: Path, data: bytes) -> None:
        """Write a binary file; otherwise like `write_text`."""
        self.make_parents(path)
        replace_file(path, data, mode=0o666, sync=False, follow=False)

    def copy(self, source: Path, target: Path, *, executable: bool = False) -> None:
        """Copy a file with its time and mode; of a link, copy its target."""
        status = source.stat()
        mode = status.st_mode & 0o777 | (0o111 if executable else 0)
        self.make_parents(target)
        with replacing(target, mode=mode, sync=False, follow=False) as file:
            file.write(source.read_bytes())
            if sys.platform != "win32":
                os.fchmod(file.fileno(), mode)
        os.utime(target, ns=(status.st_atime_ns, status.st_mtime_ns))

    def link(self, source: Path, target: Path) -> None:
        """Make `target` a link to `source`, replacing anything there; a copy where links are not allowed (Windows)."""
        if target.is_symlink() and os.path.realpath(target) == os.path.realpath(source):
            return
        self.make_parents(target)
        if os.path.lexists(target):
            self.remove(target)
        try:
            target.symlink_to(source, target_is_directory=source.is_dir())
        except (OSError, NotImplementedError):
            if sys.platform != "win32":
                raise
            if source.is_dir():
                shutil.copytree(source, target)
            else:
                shutil.copy2(source, target)


def links_in(folder: Path) -> Iterator[Path]:
    """Yield the links below a folder, following none."""
    for current, folders, files in os.walk(folder):
        yield from (path for name in (*folders, *files) if (path := Path(current, name)).is_symlink())


def _real(path: Path) -> Path:
    """Follow the links of the folders above a path, not the path itself."""
    whole = os.path.normpath(path.name) if path.name != ".." else ".."
    return Path(os.path.realpath(path)) if whole == ".." else Path(os.path.realpath(path.parent), path.name)
