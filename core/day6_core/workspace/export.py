"""`day6-tui export`: packages of the workspace as a zip that builds unchanged on a real ROS 2.

The zip has a folder with `src/` and a short text with the commands to type there. Nothing in the packages is changed: a real
robot runs exactly what the student wrote. Only files inside the packages are packed: a link that leads out of one is refused,
so that no zip contains a file nobody meant to give away.
"""

from __future__ import annotations

import argparse
import os
import stat
import sys
import time
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.session.folder import working_folder
from day6_core.whole_file import replacing
from day6_core.workspace.packages import Package, find_packages, holds_packages

_LEFT_OUT = frozenset({"__pycache__", ".git", ".vscode", ".idea", ".pytest_cache", "build", "install", "log"})
_BUILT_TYPES = ("ros.", "python", "cmake")

LARGEST = 500_000_000
"""Bytes of the largest file that is packed: no source file is larger, but a forgotten bag or disk image is."""

_PIECE = 1 << 20

_README = """\
Packages from day6-tui: {names}

On a computer with ROS 2, in the folder of this file:

    rosdep install --from-paths src -y --ignore-src
    colcon build
    source install/setup.bash
"""


class ExportError(Exception):
    """There is nothing to export, a named package is missing, or something must not be packed."""


class Exported(NamedTuple):
    """The packages in the zip, and the files of their folders that were left out, with the reason."""

    packages: list[str]
    left_out: list[str]


def main(arguments: list[str]) -> int:
    """Run `day6-tui export ARGUMENTS`; returns the exit status."""
    options = _parser().parse_args(arguments)
    workspace = _workspace(options.workspace, options.home)
    target = Path(options.output or f"{workspace.name}.zip")
    try:
        done = export(workspace, options.packages, target)
    except ExportError as error:
        print(f"day6-tui export: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"day6-tui export: {str(error.filename or target)!r}: {error.strerror or error}", file=sys.stderr)
        return 1
    for text in done.left_out:
        print(f"day6-tui export: left out: {text}", file=sys.stderr)
    print(f"{target}: {', '.join(done.packages)} (of {workspace})")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="day6-tui export",
        description="Put packages of the workspace into a zip that builds on a real ROS 2 unchanged.",
    )
    parser.add_argument("packages", nargs="*", metavar="PKG", help="names of packages (default: all)")
    parser.add_argument(
        "--workspace",
        type=Path,
        metavar="DIR",
        help="the workspace (default: the one you are in, else ~/ros2_ws of the desktop)",
    )
    parser.add_argument("--home", type=Path, metavar="DIR", help="the folder that is ~ (default: that of the desktop)")
    parser.add_argument("-o", "--output", metavar="FILE", help="the zip to write (default: the workspace's name, here)")
    return parser


def _workspace(given: Path | None, home: Path | None) -> Path:
    if given is not None:
        return given.expanduser().resolve()
    if home is None and (here := workspace_around(working_folder())) is not None:
        return here
    from day6_core.places import default_home

    return (home or default_home()).expanduser().resolve() / "ros2_ws"


def workspace_around(folder: Path) -> Path | None:
    """Return the workspace around a folder: the nearest one above it that has packages in `src` or has been built.

    One that was only just made, with an empty `src`, counts where one stands in it or in its `src`. A package outside
    any workspace is its own workspace; None outside everything.
    """
    package = None
    for each in (folder, *folder.parents):
        if (each / "package.xml").is_file():
            package = each  # it may also have a folder src
        elif holds_packages(each / "src") or (each / "install" / ".colcon_install_layout").is_file():
            return each
    return package or next((each for each in (folder, folder.parent) if _is_new(each, folder)), None)


def _is_new(workspace: Path, here: Path) -> bool:
    source = workspace / "src"
    return here in (workspace, source) and source.is_dir() and not any(source.iterdir())


def export(workspace: Path, names: Iterable[str], target: Path) -> Exported:
    """Write the zip and return what is in it.

    Raises:
        ExportError, OSError: it could not be written; no new file is left.
    """
    is_package = (workspace / "package.xml").is_file()
    source = workspace / "src" if (workspace / "src").is_dir() and not is_package else workspace
    if not source.is_dir():
        raise ExportError(f"there is no workspace {workspace}")
    packages = [
        package
        for package in find_packages(["."], source, os.environ, lambda logger, text: None)
        if package.type.startswith(_BUILT_TYPES)
    ]
    known = {package.name: package for package in packages}
    wanted = list(dict.fromkeys(names)) or sorted(known)
    unknown = [name for name in wanted if name not in known]
    if unknown:
        there = f"; there are {', '.join(sorted(known))}" if known else ""
        raise ExportError(f"no package '{unknown[0]}' in {source}{there}")
    if not wanted:
        raise ExportError(f"no package in {source}")
    if os.path.lexists(target) and not zipfile.is_zipfile(target):
        raise ExportError(f"'{target}' exists and is not a zip: it is left alone; choose another file with -o")
    return Exported(wanted, _write([known[name] for name in wanted], source, workspace.name, target))


def _write(packages: list[Package], source: Path, top: str, target: Path) -> list[str]:
    """Write the zip; return what was left out."""
    left_out: list[str] = []
    target.parent.mkdir(parents=True, exist_ok=True)
    with replacing(target, mode=0o666) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(f"{top}/README.txt", _README.format(names=", ".join(package.name for package in packages)))
        for package in packages:
            inside = package.path.relative_to(source) if package.path != source else Path(package.name)
            for path in _files(package.path, {Path(file.name).resolve(), target.resolve()}, left_out):
                _add(archive, path, f"{top}/src/{(inside / path.relative_to(package.path)).as_posix()}")
    return left_out


def _add(archive: zipfile.ZipFile, path: Path, name: str) -> None:
    """Put a file into the zip as it is now: one that grows meanwhile is cut at the size it had when opened."""
    with open(path, "rb", opener=_open_at_once) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise ExportError(f"{str(path)!r} is not a file any more")
        if status.st_size > LARGEST:
            raise ExportError(
                f"{str(path)!r} has {status.st_size // 1_000_000} MB, at most {LARGEST // 1_000_000} MB are packed: "
                "move it out of the package"
            )
        try:
            name.encode()
        except UnicodeEncodeError:
            raise ExportError(f"the name of {str(path)!r} is not UTF-8: a zip cannot hold it") from None
        moment = max(time.localtime(status.st_mtime)[:6], (1980, 1, 1, 0, 0, 0))  # the earliest time in a zip
        info = zipfile.ZipInfo(name, moment)
        info.external_attr = (status.st_mode & 0xFFFF) << 16
        info.compress_type = archive.compression
        info.file_size = left = status.st_size
        with archive.open(info, "w") as packed:
            while left and (piece := file.read(min(_PIECE, left))):
                packed.write(piece)
                left -= len(piece)


def _open_at_once(path: str, flags: int) -> int:
    """Open without waiting for the other end, in case the file was replaced by a pipe."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _files(folder: Path, own: set[Path], left_out: list[str]) -> Iterator[Path]:
    """Yield the files of a package, without `own` and without files left by tools.

    A folder that links of the package lead to is packed again at the first of them only, so that loops of links end.

    Raises:
        ExportError: a link leads out of the package.
        OSError: a folder cannot be read.
    """
    root = Path(os.path.realpath(folder))
    linked = {root}
    waiting = [folder]
    while waiting:
        current = waiting.pop()
        for entry in sorted(os.scandir(current), key=lambda each: each.name):
            path = Path(entry.path)
            real = Path(os.path.realpath(path))
            if _is_tools(entry):
                continue
            if entry.is_symlink() and not real.is_relative_to(root):
                raise ExportError(
                    f"{str(path)!r} is a link to {str(real)!r}, outside the package: replace it with a copy, or remove it"
                )
            if path.is_dir():
                if entry.is_symlink() and (real in linked or real in path.parents):
                    left_out.append(f"{str(path)!r} leads to a folder that is packed already")
                else:
                    linked |= {real} if entry.is_symlink() else set()
                    waiting.append(path)
            elif path.is_file():
                if real not in own:
                    yield path
            else:
                left_out.append(f"{str(path)!r} {'is a broken link' if entry.is_symlink() else 'is not a file'}")


def _is_tools(entry: os.DirEntry[str]) -> bool:
    """Return whether an entry was left by builds, editors or version control."""
    if os.path.isdir(entry.path):
        return entry.name in _LEFT_OUT or entry.name.endswith(".egg-info") or entry.name.startswith(".")
    return entry.name.endswith((".pyc", "~", ".swp"))
