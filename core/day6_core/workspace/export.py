"""`day6-tui export`: packages of the workspace as a zip that builds unchanged on a real ROS 2.

The zip has a folder with `src/` and a short text with the commands to type there. Nothing in the packages is changed: a real
robot runs exactly what the student wrote. Only files inside the packages are packed: a link that leads out of one is refused,
so that no zip contains a file nobody meant to give away.
"""

from __future__ import annotations

import os
import shlex
import stat
import sys
import time
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.command_line.texts import CommandTexts, Wording
from day6_core.command_line.values import Values
from day6_core.language import language_of
from day6_core.places import default_home
from day6_core.reason import reason
from day6_core.session.folder import working_folder
from day6_core.whole_file import open_at_once, replacing
from day6_core.workspace.packages import Package, find_packages, holds_packages

LEFT_OUT = frozenset({"__pycache__", ".git", ".vscode", ".idea", ".pytest_cache", "build", "install", "log"})
"""Names of what is made anew elsewhere, or nobody's program."""
_OF_COLCON = ("src", "build", "install", "log")
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


class Reason(NamedTuple):
    """Why something cannot be packed: the text `cli.export.<key>`."""

    key: str
    values: dict[str, object]

    def said(self, texts: Wording) -> str:
        """The reason, in the language of the texts."""
        return texts(f"cli.export.{self.key}", **self.values)


class ExportError(Exception):
    """There is nothing to export, a named package is missing, or something must not be packed."""

    def __init__(self, key: str, **values: object) -> None:
        super().__init__(key)
        self.reason = Reason(key, values)

    def __str__(self) -> str:
        return self.reason.said(CommandTexts("en"))


class Exported(NamedTuple):
    """The packages in the zip, and the files of their folders that were left out, with the reason."""

    packages: list[str]
    left_out: list[Reason]


def main(arguments: list[str]) -> int:
    """Run `day6-tui export ARGUMENTS`; returns the exit status."""
    parser = build_parser(language_of(os.environ, arguments))
    options, texts = parser.parse_args(arguments), parser.texts

    def tell(text: str) -> int:
        print(f"{parser.prog}: {text}", file=sys.stderr)
        return 1

    here = working_folder()
    workspace = _workspace(options.workspace, options.home, here)
    if workspace is None:
        tell(texts("cli.export.nowhere", folder=here))
        tell(texts("cli.export.go_there"))
        for each in _elsewhere(here):
            tell(texts("cli.export.there_is", workspace=shlex.quote(str(each))))
        return 1
    target = Path(options.output) if options.output else _default_target(workspace, here)
    try:
        done = export(workspace, options.packages, target, replace=options.force)
    except ExportError as error:
        return tell(error.reason.said(texts))
    except OSError as error:
        return tell(f"{str(error.filename or target)!r}: {reason(error)}")
    for left in done.left_out:
        tell(texts("cli.export.left_out", what=left.said(texts)))
    print(texts("cli.export.done", file=target, names=", ".join(done.packages), workspace=workspace))
    return 0


def build_parser(language: str = "en") -> CommandParser:
    """The options of `day6-tui export`, and what it takes."""
    parser = command_parser("export", language)
    texts, values = parser.texts, Values(parser.texts)
    parser.add_argument("packages", nargs="*", metavar="PKG", help=texts("cli.export.packages"))
    parser.add_argument("--workspace", type=Path, metavar="DIR", help=texts("cli.export.workspace"))
    parser.add_argument("--home", type=values.home, metavar="DIR", help=texts("cli.export.home"))
    parser.add_argument("-o", "--output", metavar="FILE", help=texts("cli.export.output"))
    parser.add_argument("-f", "--force", action="store_true", help=texts("cli.export.force"))
    return parser


def _workspace(given: Path | None, home: Path | None, here: Path) -> Path | None:
    if given is not None:
        return given.expanduser().resolve()
    return workspace_around(here) if home is None else home.expanduser().resolve() / "ros2_ws"


def workspace_around(folder: Path) -> Path | None:
    """Return the workspace in which one stands: in its top folder, or anywhere in what colcon reads and writes there.

    A workspace has packages in `src` or has been built. One that was only just made, with an empty `src`, counts where one stands
    in it or in its `src`. A package outside any workspace is its own workspace. Failing all these, `ros2_ws` in this folder is
    meant, as in the home folder of the desktop. A workspace that is merely above is not: nobody has named it.
    """
    package = None
    for each in (folder, *folder.parents):
        if (each / "package.xml").is_file():
            package = package or each  # it may also have a folder src
        elif (each == folder or folder.relative_to(each).parts[0] in _OF_COLCON) and _is_workspace(each):
            return each
    here = (each for each in (folder, folder.parent) if _is_new(each, folder))
    return package or next(here, folder / "ros2_ws" if _is_workspace(folder / "ros2_ws") else None)


def _is_workspace(folder: Path) -> bool:
    return holds_packages(folder / "src") or (folder / "install" / ".colcon_install_layout").is_file()


def _is_new(workspace: Path, here: Path) -> bool:
    source = workspace / "src"
    return here in (workspace, source) and source.is_dir() and not any(source.iterdir())


def _elsewhere(here: Path) -> list[Path]:
    """Workspaces that may be meant by somebody who stands in none: one above, and that of the desktop."""
    homes = [Path(os.path.expanduser("~")), default_home()]
    return [
        each for each in dict.fromkeys([*here.parents, *(home / "ros2_ws" for home in homes)]) if _is_workspace(each)
    ]


def _source(workspace: Path) -> Path:
    """The folder in which packages are looked for."""
    is_package = (workspace / "package.xml").is_file()
    return workspace / "src" if (workspace / "src").is_dir() and not is_package else workspace


def _default_target(workspace: Path, here: Path) -> Path:
    """A zip with the workspace's name: here, or beside what is packed if this is inside."""
    source = _source(workspace)
    name = f"{workspace.name}.zip"
    return source.parent / name if here.is_relative_to(source) else Path(name)


def export(workspace: Path, names: Iterable[str], target: Path, *, replace: bool = False) -> Exported:
    """Write the zip and return what is in it. Only with `replace` a zip that exists is replaced.

    Raises:
        ExportError, OSError: it could not be written; no new file is left.
    """
    source = _source(workspace)
    if not source.is_dir():
        raise ExportError("no_workspace", folder=workspace)
    packages = [
        package
        for package in find_packages(["."], source, os.environ, lambda logger, text, level="": None)
        if package.type.startswith(_BUILT_TYPES)
    ]
    known = {package.name: package for package in packages}
    wanted = list(dict.fromkeys(names)) or sorted(known)
    unknown = [name for name in wanted if name not in known]
    if unknown:
        key = "no_package.there" if known else "no_package"
        raise ExportError(key, name=unknown[0], folder=source, names=", ".join(sorted(known)))
    if not wanted:
        raise ExportError("empty", folder=source)
    if os.path.lexists(target) and not zipfile.is_zipfile(target):
        raise ExportError("not_zip", file=target)
    if target.resolve().is_relative_to(source.resolve()):
        raise ExportError("inside", file=target, folder=source)
    if os.path.lexists(target) and not replace:
        raise ExportError("exists", file=target)
    return Exported(wanted, _write([known[name] for name in wanted], source, workspace.name, target))


def _write(packages: list[Package], source: Path, top: str, target: Path) -> list[Reason]:
    """Write the zip; return what was left out."""
    left_out: list[Reason] = []
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
    with open(path, "rb", opener=open_at_once) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise ExportError("gone", file=repr(str(path)))
        if status.st_size > LARGEST:
            size, most = status.st_size // 1_000_000, LARGEST // 1_000_000
            raise ExportError("large", file=repr(str(path)), size=size, most=most)
        try:
            name.encode()
        except UnicodeEncodeError:
            raise ExportError("encoding", file=repr(str(path))) from None
        moment = max(time.localtime(status.st_mtime)[:6], (1980, 1, 1, 0, 0, 0))  # the earliest time in a zip
        info = zipfile.ZipInfo(name, moment)
        info.external_attr = (status.st_mode & 0xFFFF) << 16
        info.compress_type = archive.compression
        info.file_size = left = status.st_size
        with archive.open(info, "w") as packed:
            while left and (piece := file.read(min(_PIECE, left))):
                packed.write(piece)
                left -= len(piece)


def _files(folder: Path, own: set[Path], left_out: list[Reason]) -> Iterator[Path]:
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
                raise ExportError("link", file=repr(str(path)), target=repr(str(real)))
            if path.is_dir():
                if entry.is_symlink() and (real in linked or real in path.parents):
                    left_out.append(Reason("packed", {"file": repr(str(path))}))
                else:
                    linked |= {real} if entry.is_symlink() else set()
                    waiting.append(path)
            elif path.is_file():
                if real not in own:
                    yield path
            else:
                left_out.append(Reason("broken" if entry.is_symlink() else "strange", {"file": repr(str(path))}))


def is_tools_folder(name: str) -> bool:
    """Return whether a folder of this name was left by builds, editors or version control."""
    return name in LEFT_OUT or name.endswith(".egg-info") or name.startswith(".")


def _is_tools(entry: os.DirEntry[str]) -> bool:
    """Return whether an entry was left by builds, editors or version control."""
    if os.path.isdir(entry.path):
        return is_tools_folder(entry.name)
    return entry.name.endswith((".pyc", "~", ".swp"))
