"""`day6-tui export`: packages of the workspace as a zip, which builds on a real ROS 2 as it is.

The zip has a folder with `src/` and a short text that says what to type there. Nothing in the packages is changed: what a
student writes here is what a real robot runs.
"""

from __future__ import annotations

import argparse
import os
import sys
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from day6_tui.core.whole_file import replacing
from day6_tui.core.workspace.packages import Package, find_packages

_LEFT_OUT = frozenset({"__pycache__", ".git", ".vscode", ".idea", ".pytest_cache", "build", "install", "log"})
_BUILT_TYPES = ("ros.", "python", "cmake")

_README = """\
Packages from day6-tui: {names}

On a computer with ROS 2, in the folder in which this file is:

    rosdep install --from-paths src -y --ignore-src
    colcon build
    source install/setup.bash
"""


class ExportError(Exception):
    """There is nothing to export, or not what was asked for."""


def main(arguments: list[str]) -> int:
    """Run `day6-tui export ARGUMENTS`; returns the exit status."""
    options = _parser().parse_args(arguments)
    workspace = _workspace(options.workspace, options.home)
    target = Path(options.output or f"{workspace.name}.zip")
    try:
        names = export(workspace, options.packages, target)
    except ExportError as error:
        print(f"day6-tui export: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"day6-tui export: {error.filename or target}: {error.strerror or error}", file=sys.stderr)
        return 1
    print(f"{target}: {', '.join(names)}")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="day6-tui export",
        description="Put packages of the workspace into a zip that builds on a real ROS 2 unchanged.",
    )
    parser.add_argument("packages", nargs="*", metavar="PKG", help="names of packages (default: all)")
    parser.add_argument(
        "--workspace", type=Path, metavar="DIR", help="the workspace (default: ~/ros2_ws of the desktop)"
    )
    parser.add_argument("--home", type=Path, metavar="DIR", help="the folder that is ~ (default: that of the desktop)")
    parser.add_argument("-o", "--output", metavar="FILE", help="the zip to write (default: the workspace's name, here)")
    return parser


def _workspace(given: Path | None, home: Path | None) -> Path:
    if given is not None:
        return given.expanduser().resolve()
    from day6_tui.core.shell.desk import default_home

    return (home or default_home()).expanduser().resolve() / "ros2_ws"


def export(workspace: Path, names: Iterable[str], target: Path) -> list[str]:
    """Write the zip and return the names of the packages in it. Raises ExportError or OSError; then there is no new file."""
    source = workspace / "src" if (workspace / "src").is_dir() else workspace
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
    _write([known[name] for name in wanted], source, workspace.name, target)
    return wanted


def _write(packages: list[Package], source: Path, top: str, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    with replacing(target, mode=0o666) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(f"{top}/README.txt", _README.format(names=", ".join(package.name for package in packages)))
        for package in packages:
            for path in _files(package.path, target):
                archive.write(path, f"{top}/src/{path.relative_to(source).as_posix()}")


def _files(folder: Path, target: Path) -> Iterator[Path]:
    """Yield the files of a package, without what tools leave there and without following links to folders (they may loop)."""
    for current, folders, files in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if name not in _LEFT_OUT and not name.endswith(".egg-info") and name[:1] != "."
        )
        for name in sorted(files):
            path = Path(current, name)
            if path.is_file() and path.resolve() != target.resolve() and not name.endswith((".pyc", "~", ".swp")):
                yield path
