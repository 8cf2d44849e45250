"""Workspaces: the packages in them, what of these is built and up to date, and which of them a terminal knows."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from fnmatch import fnmatchcase
from pathlib import Path
from typing import NamedTuple

from day6_core.facts.folders import LONGEST_FILE, files_in, names_in, text_of
from day6_core.facts.manifests import Refused, refused
from day6_core.facts.setup_file import EntryPoint, Setup, read_setup

MOST_PACKAGES = 100
MOST_FOLDERS = 5000
DEEPEST = 4
"""Folders below `src` in which packages are looked for."""

INSTALLED = ("launch", "config", "params", "urdf", "rviz", "meshes", "msg", "srv", "action", "worlds")
"""Folders of a package whose files usually go to its share folder."""

_NAME = re.compile(r"<name>\s*([\w-]+)\s*</name>")
_PRUNED = frozenset({"build", "install", "log", "__pycache__", "node_modules"})


class Package(NamedTuple):
    """One package in `src`."""

    name: str
    folder: Path
    python: bool
    """Whether it has a setup.py."""
    entry_points: tuple[EntryPoint, ...] = ()
    built: bool = False
    changed: tuple[str, ...] = ()
    """Files, relative to the package, that are not as they were when it was built."""
    not_installed: tuple[str, ...] = ()
    """Launch files and the like that the build left out, because setup.py or CMakeLists.txt does not name them."""
    executables: tuple[str, ...] = ()
    """What `ros2 run` finds of the last build."""
    in_bin: bool = False
    """Whether the executables went to `bin`, where `ros2 run` does not look: setup.cfg is missing."""
    files: tuple[str, ...] = ()
    """What is in it, relative to its folder."""

    @property
    def install_script(self) -> Path:
        """The file that says what is installed."""
        return self.folder / ("setup.py" if self.python else "CMakeLists.txt")

    def file_called(self, name: str) -> str | None:
        """Return the first file of that name, None if there is none."""
        return next((each for each in self.files if each.rpartition("/")[2] == name), None)

    def lacking_entry(self, executable: str) -> str:
        """Return the entry point that setup.py lacks for a program that is there; '' if it lacks none."""
        module = executable.removesuffix(".py")
        is_there = self.python and f"{self.name}/{module}.py" in self.files
        if not is_there or any(each.module.endswith(module) for each in self.entry_points):
            return ""
        return f"'{module} = {self.name}.{module}:main'"


class Workspace(NamedTuple):
    """A folder with a `src` in it."""

    folder: Path
    packages: tuple[Package, ...] = ()
    inner: tuple[tuple[Path, Path], ...] = ()
    """Packages inside the folder of another package, which colcon does not find: the inner one, the outer one."""
    twice: tuple[tuple[str, Path, Path], ...] = ()
    """Names that two packages have: the name, the two folders."""
    cut: bool = False
    """Whether there was more than is looked at."""

    @property
    def install(self) -> Path:
        """Where its builds go."""
        return self.folder / "install"


def workspaces_above(folder: Path) -> Iterator[Path]:
    """Yield the workspaces that a folder is in, or is, the innermost first."""
    return (each for each in (folder, *folder.parents) if (each / "src").is_dir())


def workspaces_around(variables: Mapping[str, str], cwd: Path) -> list[Path]:
    """Return the workspace one is in, and the usual one."""
    return list(dict.fromkeys([*workspaces_above(cwd), Path(variables.get("HOME", "/")) / "ros2_ws"]))


def sourced_prefixes(variables: Mapping[str, str]) -> Iterator[Path]:
    """Yield the prefixes in which a terminal finds packages, in its order."""
    return (Path(each) for each in variables.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if each)


def is_sourced(package: str, install: Path, variables: Mapping[str, str]) -> bool:
    """Return whether a terminal knows a package that is built into `install`."""
    return not {install, install / package}.isdisjoint(sourced_prefixes(variables))


class Unknown(NamedTuple):
    """Why a terminal does not know a package of a workspace: 'not_sourced', 'not_built', 'build_failed' or 'refused'."""

    because: str
    workspace: Path
    folder: Path
    """Of the package's sources; of a package that is built that in which it is installed."""


def why_unknown(package: str, variables: Mapping[str, str], cwd: Path) -> Unknown | None:
    """Return why a terminal does not know a package; None if it does know it, or nothing is known of such a package."""
    workspaces = workspaces_around(variables, cwd)
    for workspace in workspaces:
        install = workspace / "install"
        if _prefix(install, package) is not None:
            known = is_sourced(package, install, variables)
            return None if known else Unknown("not_sourced", workspace, install)
    for workspace in workspaces:
        folder = _source_of(package, workspace)
        if folder is not None:
            if refused(folder / "package.xml") is not None:
                return Unknown("refused", workspace, folder)
            failed = text_of(workspace / "build" / package / "colcon_build.rc").strip() not in ("", "0")
            return Unknown("build_failed" if failed else "not_built", workspace, folder)
    return None


def refused_manifests(workspace: Path) -> Iterator[tuple[Path, Refused]]:
    """Yield the package.xml files below `src` that colcon does not take, each with the reason."""
    for manifest in _manifests_in(workspace / "src")[0]:
        if (reason := refused(manifest)) is not None:
            yield manifest, reason


def executables_in(prefix: Path, package: str) -> list[str]:
    """Return the programs of a package that are installed at a prefix."""
    return [each for each in names_in(prefix / "lib" / package) if not each.startswith(("_", "."))]


def find_package(name: str, workspaces: Iterable[Path]) -> tuple[Workspace, Package] | None:
    """Return the first package of that name with its workspace, of which nothing else is read. Raises OSError."""
    for workspace in workspaces:
        folder = _source_of(name, workspace)
        if folder is not None:
            return Workspace(workspace), _read_package(workspace, folder)
    return None


def packages_lacking_comma(workspaces: Iterable[Path]) -> Iterator[tuple[Path, int]]:
    """Yield the packages whose setup.py lacks a comma between two entry points, with the line."""
    return ((folder, setup.comma) for folder, setup in _setups(workspaces) if setup.comma)


def entries_of_wrong_form(workspaces: Iterable[Path]) -> Iterator[tuple[Path, str]]:
    """Yield the packages with an entry point that is not 'name = package.file:function', and the name of that one."""
    return (
        (folder, entry.name)
        for folder, setup in _setups(workspaces)
        for entry in setup.entry_points
        if entry.flaw == "form"
    )


def _setups(workspaces: Iterable[Path]) -> Iterator[tuple[Path, Setup]]:
    """What the setup.py of each package says."""
    for workspace in workspaces:
        for manifest in _manifests_in(workspace / "src")[0]:
            yield manifest.parent, read_setup(manifest.parent)


def _source_of(package: str, workspace: Path) -> Path | None:
    folders = (manifest.parent for manifest in _manifests_in(workspace / "src")[0])
    return next((folder for folder in folders if _name_of(folder) == package), None)


def read_workspace(folder: Path) -> Workspace:
    """Read a workspace with all its packages. Raises OSError."""
    manifests, inner, cut = _manifests_in(folder / "src")
    packages: list[Package] = []
    twice: list[tuple[str, Path, Path]] = []
    for manifest in manifests:
        package = _read_package(folder, manifest.parent)
        other = next((each for each in packages if each.name == package.name), None)
        if other is None:
            packages.append(package)
        else:
            twice.append((package.name, other.folder, package.folder))
    return Workspace(folder, tuple(packages), tuple(inner), tuple(twice), cut)


def _manifests_in(source: Path) -> tuple[list[Path], list[tuple[Path, Path]], bool]:
    """Return the package.xml files below `src`, those inside other packages, and whether there are too many."""
    found: list[Path] = []
    inner: list[tuple[Path, Path]] = []
    for count, (folder, folders, names) in enumerate(os.walk(source)):
        here = Path(folder)
        outer = next((each.parent for each in found if each.parent in here.parents), None)
        if "COLCON_IGNORE" in names or len(here.relative_to(source).parts) > DEEPEST:
            folders.clear()
            continue
        folders[:] = sorted(each for each in folders if not each.startswith(".") and each not in _PRUNED)
        if "package.xml" in names:
            if outer is None:
                found.append(here / "package.xml")
            else:
                inner.append((here, outer))
        if len(found) >= MOST_PACKAGES or count >= MOST_FOLDERS:
            return found, inner, True
    return found, inner, False


def _name_of(folder: Path) -> str:
    """The name of the package that lies in a folder."""
    named = _NAME.search(text_of(folder / "package.xml"))
    return named[1] if named else folder.name


def _read_package(workspace: Path, folder: Path) -> Package:
    """Read the package that lies in a folder. Raises OSError."""
    name, setup = _name_of(folder), folder / "setup.py"
    package = Package(
        name,
        folder,
        setup.is_file(),
        read_setup(folder).entry_points,
        files=tuple(path.relative_to(folder).as_posix() for path in files_in(folder)),
    )
    prefix = _prefix(workspace / "install", name)
    if prefix is None:
        return package
    executables = executables_in(prefix, name)
    changed, missing = _compared(package, prefix)
    wanted = [entry.name for entry in package.entry_points if entry.name not in executables]
    in_bin = bool(wanted) and all((prefix / "bin" / each).exists() for each in wanted)
    if wanted and not in_bin:
        changed.append("setup.py")
    if missing and package.python and _is_newer(setup, prefix / "share" / name / "package.xml"):
        changed.append("setup.py")  # its data_files were changed after the build
        missing = []
    return package._replace(
        built=True,
        changed=tuple(dict.fromkeys(changed)),
        not_installed=tuple(missing),
        executables=tuple(executables),
        in_bin=in_bin,
    )


def _prefix(install: Path, name: str) -> Path | None:
    """Return where a package is installed, None if it is not built."""
    for prefix in (install / name, install):
        if (prefix / "share" / name / "package.xml").is_file():
            return prefix
    return None


def _is_newer(setup: Path, installed: Path) -> bool:
    """Whether a setup.py was changed after the build that wrote `installed`."""
    try:
        changed = setup.stat().st_mtime
        return changed > installed.stat().st_mtime and changed > installed.parent.stat().st_mtime
    except OSError:
        return False


def names_file(script: Path, file: str) -> bool:
    """Return whether a setup.py or CMakeLists.txt has a file of its package installed: by its name, a wildcard or its folder."""
    place, _, name = file.rpartition("/")
    text, folder = text_of(script), re.escape(place)
    wildcards = re.findall(rf"{folder}(?:/|['\"],\s*['\"])([^'\"]*\*[^'\"]*)['\"]", text) if place else ()
    whole = rf"DIRECTORY\b[^)]*(?<![\w/]){folder}(?![\w/])"
    return (
        name in text
        or any(fnmatchcase(name, each) for each in wildcards)
        or (place != "" and re.search(whole, text) is not None)
    )


def _compared(package: Package, prefix: Path) -> tuple[list[str], list[str]]:
    """Return the files that are not as they were installed, and those that were not installed because nothing names them."""
    folder, name = package.folder, package.name
    changed: list[str] = []
    missing: list[str] = []
    module = folder / name
    installed = next(prefix.glob(f"lib/python3*/site-packages/{name}"), None)
    if installed is not None and module.is_dir():  # without it the build made links (--symlink-install)
        for path in files_in(module, ".py"):
            other = installed / path.relative_to(module)
            if _differs(path, other):
                changed.append(str(path.relative_to(folder)))
    share = prefix / "share" / name
    for kind in INSTALLED:
        for path in files_in(folder / kind):
            other = share / path.relative_to(folder)
            if other.exists():
                if _differs(path, other):
                    changed.append(str(path.relative_to(folder)))
            elif kind == "launch" and not any(share.rglob(path.name)):
                file = path.relative_to(folder).as_posix()
                (changed if names_file(package.install_script, file) else missing).append(file)
    return changed, missing


def _differs(source: Path, installed: Path) -> bool:
    """Whether a file is another one than the installed one; a link is the same file."""
    if installed.is_symlink():
        return False
    try:
        mine, other = source.stat(), installed.stat()
        if mine.st_size != other.st_size:
            return True
        return mine.st_size <= LONGEST_FILE and source.read_bytes() != installed.read_bytes()
    except FileNotFoundError:
        return not installed.exists()
