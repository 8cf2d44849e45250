"""Finds the packages of a workspace, as colcon does: it searches the base paths, but not inside packages."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from configparser import ConfigParser
from configparser import Error as ConfigError
from dataclasses import dataclass, field
from glob import glob
from pathlib import Path

from day6_core.workspace.files import NotOurOutput
from day6_core.workspace.manifest import Manifest, ManifestError, read_manifest
from day6_core.workspace.meta import Meta, MetaFiles, Warn

IGNORE_MARKER = "COLCON_IGNORE"
_IGNORE_MARKERS = (IGNORE_MARKER, "AMENT_IGNORE", "CATKIN_IGNORE")
_VENV = "pyvenv.cfg"
"""In an environment of Python, whose site-packages are none of the workspace. The real colcon wants a marker there, too."""
_IDENTIFICATION = "colcon.colcon_core.package_identification"


@dataclass(eq=False)
class Package:
    """A package in the source tree. `path` is absolute, `shown` is the path in messages (relative to where colcon runs)."""

    name: str
    type: str
    """'ros.ament_python', 'ros.ament_cmake', 'python', 'cmake' …"""
    path: Path
    shown: str
    manifest: Manifest | None = None
    depends: dict[str, list[str]] = field(default_factory=lambda: {"build": [], "run": [], "test": []})
    meta: Meta = field(default_factory=Meta)
    """What files beside the manifest say; its dependencies are among `depends`."""

    def dependencies(self, *categories: str) -> set[str]:
        """Return the names of the dependencies in some categories (no argument: in all)."""
        return {name for each in categories or ("build", "run", "test") for name in self.depends[each]}


def find_packages(
    base_paths: Iterable[str],
    cwd: Path,
    environment: Mapping[str, str],
    warn: Warn,
    *,
    paths: Iterable[str] = (),
    metas: MetaFiles | None = None,
) -> list[Package]:
    """Return the packages below `base_paths` and exactly at `paths`, sorted by name and path. Both may contain `*`.

    Folders with an ignore marker, hidden folders, and folders visited before (a loop of links) are skipped.
    """
    found: list[Package] = []
    seen: set[Path] = set()
    for root in _expanded(base_paths, cwd):
        for folder in _crawl(root, seen):
            package = identify(folder, _shown(folder, cwd), environment, warn, metas)
            if package is not None:
                found.append(package)
                seen.add(folder.resolve())
    for folder in _expanded(paths, cwd):
        if folder.is_dir() and folder.resolve() not in seen and not is_ignored(folder):
            seen.add(folder.resolve())
            package = identify(folder, _shown(folder, cwd), environment, warn, metas)
            if package is not None:
                found.append(package)
    return sorted(found, key=lambda package: (package.name, package.shown))


def refuse_sources(base: Path) -> None:
    """Refuse a folder for build output that contains packages and was not filled by an earlier build.

    Raises:
        NotOurs: there are packages in it.
    """
    if any(os.path.lexists(base / name) for name in (*_IGNORE_MARKERS, ".built_by", ".colcon_install_layout")):
        return
    if (found := _first_package(base)) is not None:
        raise NotOurOutput(f"'{base}' holds sources ('{found}'): choose another folder for the build's output")


def holds_packages(base: Path) -> bool:
    """Return whether there is a package in a folder or below it."""
    return _first_package(base) is not None


def _first_package(base: Path) -> Path | None:
    for folder in _crawl(base, set()):
        if identify(folder, str(folder), {}, lambda logger, text, level="": None) is not None:
            return folder
    return None


def _expanded(paths: Iterable[str], cwd: Path) -> Iterator[Path]:
    """Yield absolute paths; one with `*` stands for the folders it matches (colcon_core's expand_dir_wildcards)."""
    for path in paths:
        names = sorted(glob(path, root_dir=cwd)) if "*" in path else [path]
        yield from (cwd / name for name in names if "*" not in path or (cwd / name).is_dir())


def is_ignored(folder: Path) -> bool:
    """Return whether no packages are looked for in a folder and below it."""
    return any(os.path.lexists(folder / name) for name in (*_IGNORE_MARKERS, _VENV))


def _crawl(root: Path, seen: set[Path]) -> Iterator[Path]:
    """Yield folders from the root down; the caller adds those that are packages to `seen`, and they are not searched."""
    waiting = [root]
    while waiting:
        folder = waiting.pop()
        real = folder.resolve()
        if real in seen or not folder.is_dir() or is_ignored(folder):
            continue
        yield folder
        if real in seen:
            continue
        seen.add(real)
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name, reverse=True)
        except OSError:
            continue  # an unreadable folder has no packages for this user
        waiting.extend(folder / entry.name for entry in entries if not entry.name.startswith(".") and entry.is_dir())


def _shown(folder: Path, cwd: Path) -> str:
    try:
        return folder.relative_to(cwd).as_posix()
    except ValueError:
        return str(folder)


def identify(
    folder: Path, shown: str, environment: Mapping[str, str], warn: Warn, metas: MetaFiles | None = None
) -> Package | None:
    """Return the package in a folder; None if the folder is not a package."""
    metas = metas or MetaFiles()
    name, type_ = metas.identity(folder, shown)
    package = _identified(folder, shown, environment, warn, name, type_)
    if package is not None:
        package.meta = metas.about(package.name, folder, shown)
        for category, names in package.meta.dependencies.items():
            package.depends[category] = [*package.depends[category], *sorted(names)]
    elif name or type_:
        warn(_IDENTIFICATION, f"package '{shown}' has type or name but is incomplete")
    return package


def _identified(
    folder: Path, shown: str, environment: Mapping[str, str], warn: Warn, name: str, type_: str
) -> Package | None:
    """Identify a package whose name or type may be given already."""
    manifest = None
    if type_ in ("", "ros") or (name and type_.startswith("ros.")):
        try:
            manifest = read_manifest(folder, shown, environment)
        except ManifestError as error:
            if error.schema_named:
                warn(_IDENTIFICATION, f"Failed to parse ROS package manifest in '{shown}': {error}")
    complete = bool(name and type_)
    if manifest is not None:
        for text in manifest.warnings:
            warn("", f"WARNING: {text}")
        kind = type_ if complete else f"ros.{manifest.build_type}"
        package = Package(name or manifest.name, kind, folder, shown, manifest)
        package.depends = {
            "build": manifest.build_depends,
            "run": manifest.run_depends,
            "test": manifest.test_depends,
        }
        return package
    if complete:
        return Package(name, type_, folder, shown)
    if type_ in ("", "cmake") and (folder / "CMakeLists.txt").is_file():
        return Package(name or _cmake_name(folder) or folder.name, "cmake", folder, shown)
    if type_ in ("", "python") and (folder / "setup.py").is_file():
        own = _python_name(folder)
        if own is not None and name in ("", own):
            return Package(own, "python", folder, shown)
        if own is not None:
            warn(_IDENTIFICATION, "Package name already set to different value", level="ERROR")
    return None


def _cmake_name(folder: Path) -> str | None:
    text = (folder / "CMakeLists.txt").read_text(encoding="utf-8", errors="replace")
    match = re.search(r"(?im)^\s*project\s*\(\s*([\w.-]+)", text)
    return match.group(1) if match else None


def _python_name(folder: Path) -> str | None:
    """Return the name in setup.cfg or setup.py without running it (listing packages must not execute anything)."""
    parser = ConfigParser(interpolation=None)
    try:
        if (folder / "setup.cfg").is_file():
            parser.read(folder / "setup.cfg", encoding="utf-8")
        name = parser.get("metadata", "name", fallback=None)
    except (ConfigError, UnicodeDecodeError, OSError):
        name = None
    if name:
        return name
    text = (folder / "setup.py").read_text(encoding="utf-8", errors="replace")
    return _name_argument(text)


def _name_argument(text: str) -> str | None:
    """Find `name=` in the call of setup(): a string, or a variable set to one."""
    match = re.search(r"\bsetup\s*\(", text)
    given = re.search(r"\bname\s*=\s*(?:['\"]([^'\"]+)['\"]|(\w+))", text[match.end() :]) if match else None
    if given is None:
        return None
    if given.group(1):
        return given.group(1)
    variable = re.search(rf"(?m)^\s*{re.escape(given.group(2))}\s*=\s*['\"]([^'\"]+)['\"]", text)
    return variable.group(1) if variable else None
