"""The folders that one call of `colcon` may change, and the only way in which it changes them.

Build, install and log folder are ours; everything else is the user's. Whatever is written, linked or removed goes through
`Output`, which looks where a path really leads: a link in a build folder leads into the sources (that is what
--symlink-install is for), and what is done to `build/pkg/pkg/x.py` would then be done to the pupil's file. Every file is
written whole or not at all (`core.whole_file`).
"""

from __future__ import annotations

import errno
import os
import shutil
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from day6_tui.core.whole_file import replace_file, replacing


class NotOurs(OSError):
    """What was to be written or removed is not an output of this call; it was left alone."""

    def __init__(self, text: str) -> None:
        super().__init__(errno.EPERM, text)


class Output:
    """What one call may change: everything below its bases (build, install, log), none of them itself a link's victim.

    A base may be a link of the user's: then what it leads to is meant. `sources` are the folders of the packages; links
    into them are what an earlier build left, and only those are taken out of the way.
    """

    def __init__(self, bases: Iterable[Path]) -> None:
        self._bases = [Path(os.path.realpath(base)) for base in bases]
        self._sources: list[Path] = []

    def protect(self, sources: Iterable[Path]) -> None:
        """Name the folders of the packages. Raises NotOurs if one lies in a base: all of it would count as our output."""
        self._sources = [Path(os.path.realpath(source)) for source in sources]
        for source in self._sources:
            for base in self._bases:
                if source.is_relative_to(base):
                    raise NotOurs(f"'{base}' holds sources ('{source}'): name another folder for what the build makes")

    def owns(self, path: Path) -> bool:
        """Say whether a path is below a base once all links of its folders are followed; the last part may be a link."""
        return any(base in _real(path).parents for base in self._bases)

    def check(self, path: Path) -> None:
        """Raise NotOurs for what is not below a base."""
        if not self.owns(path):
            raise NotOurs(f"'{path}' leads to '{_real(path)}', outside the build, install and log folders: left alone")

    def remove(self, path: Path) -> None:
        """Remove a file, a link (never what it leads to) or a folder with all in it. Nothing else in `colcon` removes."""
        self.check(path)
        if any(base.is_relative_to(_real(path)) for base in self._bases):
            raise NotOurs(f"'{path}' holds a build, install or log folder: left alone")
        if path.is_symlink() or not path.is_dir():
            path.unlink(missing_ok=True)
        else:
            shutil.rmtree(path)

    def remove_folder_if_empty(self, path: Path) -> bool:
        """Return whether the folder was empty, and thus removed."""
        self.check(path)
        if any(path.iterdir()):
            return False
        path.rmdir()
        return True

    def clear_way(self, path: Path) -> None:
        """Remove links into the sources that an earlier build left where a folder above `path` has to be.

        Raises NotOurs if the path leads elsewhere all the same.
        """
        for folder in reversed(path.parents):
            if folder.is_symlink() and not self.owns(folder / "x") and self.owns(folder) and self._is_source(folder):
                self.remove(folder)
        self.check(path)

    def make_way(self, path: Path) -> None:
        """Make the folders above a path, after `clear_way`."""
        self.clear_way(path)
        path.parent.mkdir(parents=True, exist_ok=True)

    def _is_source(self, path: Path) -> bool:
        real = Path(os.path.realpath(path))
        return any(real.is_relative_to(source) for source in self._sources)

    # -- writing -------------------------------------------------------------------------------------------------------

    def make_folder(self, path: Path) -> None:
        """Make a folder with those above it."""
        self.make_way(path / "x")

    def write_text(self, path: Path, text: str) -> None:
        """Write a UTF-8 file with its folders. OSError names the file; on failure what was there before is still there."""
        self.write_bytes(path, text.encode("utf-8", "surrogateescape"))

    def write_bytes(self, path: Path, data: bytes) -> None:
        """The same for bytes."""
        self.make_way(path)
        replace_file(path, data, mode=0o666, sync=False, follow=False)

    def copy(self, source: Path, target: Path, *, executable: bool = False) -> None:
        """Copy a file with its time and mode; a link is copied as the file it leads to."""
        status = source.stat()
        mode = status.st_mode & 0o777 | (0o111 if executable else 0)
        self.make_way(target)
        with replacing(target, mode=mode, sync=False, follow=False) as file:
            file.write(source.read_bytes())
            if sys.platform != "win32":
                os.fchmod(file.fileno(), mode)
        os.utime(target, ns=(status.st_atime_ns, status.st_mtime_ns))

    def link(self, source: Path, target: Path) -> None:
        """Make `target` a link to `source`, in place of what was there; where links are not allowed (Windows) a copy."""
        if target.is_symlink() and os.path.realpath(target) == os.path.realpath(source):
            return
        self.make_way(target)
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
    """Follow the links of the folders above, not that of the path itself."""
    whole = os.path.normpath(path.name) if path.name != ".." else ".."
    return Path(os.path.realpath(path)) if whole == ".." else Path(os.path.realpath(path.parent), path.name)
