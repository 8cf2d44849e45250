"""The packages and executables of a session: those on its AMENT_PREFIX_PATH first, then those of day6-tui."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from ament_index_python.packages import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes
from ament_index_python.search_paths import BUILT_IN_PREFIX

if TYPE_CHECKING:
    from day6_core.session.session import Session


class Executable(NamedTuple):
    """An executable of a package. A built-in one is a module of ours: its `path` is not a file that can be started."""

    name: str
    path: Path
    built_in: bool


def packages(session: Session) -> list[str]:
    """Return the names of all packages, sorted."""
    return sorted(get_packages_with_prefixes(session.env))


def prefix_of(session: Session, package: str) -> str | None:
    """Return the prefix of a package, None if there is no such package."""
    try:
        return get_package_prefix(package, session.env)
    except (PackageNotFoundError, ValueError):
        return None


def executables(session: Session, package: str) -> list[Executable] | None:
    """Return the executables of a package, sorted by path; None if there is no such package."""
    return executables_in(session.env, package)


def executables_in(environment: Mapping[str, str], package: str) -> list[Executable] | None:
    """Return the executables of a package that an environment finds, as `executables` does."""
    try:
        prefix = get_package_prefix(package, environment)
    except (PackageNotFoundError, ValueError):
        return None
    folder = Path(prefix, "lib", package)
    if prefix == BUILT_IN_PREFIX:
        from day6_core.ros.program_index import executables as built_in

        return [Executable(name, folder / name, True) for name in sorted(built_in(package))]
    files = [
        Executable(_name(path), path, False)
        for path in folder.rglob("*")
        if path.is_file()
        and os.access(path, os.X_OK)
        and not _in_hidden_folder(path, folder)
        and not _is_launcher(path)
    ]
    return sorted([*files, *_replacements(prefix, package)], key=lambda each: each.path)


def _replacements(prefix: str, package: str) -> list[Executable]:
    """Return our programs that replace the C++ ones which the build of a package left out."""
    from day6_core.ros.left_out import noted_programs, replacements

    folder = Path(BUILT_IN_PREFIX, "lib", package)
    return [Executable(name, folder / name, True) for name in replacements(package, noted_programs(prefix, package))]


def _name(path: Path) -> str:
    """Return the executable's name; on Windows the script of `talker` is talker-script.py, which talker.exe starts."""
    return path.name.removesuffix("-script.py") if sys.platform == "win32" else path.name


def _is_launcher(path: Path) -> bool:
    return sys.platform == "win32" and path.suffix == ".exe" and path.with_name(f"{path.stem}-script.py").exists()


def _in_hidden_folder(path: Path, root: Path) -> bool:
    return any(part.startswith(".") for part in path.relative_to(root).parts[:-1])
