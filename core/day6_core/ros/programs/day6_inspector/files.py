"""The facts about files: workspaces with their packages, what of them is built and up to date, parameter files.

`look` reads folders and belongs in a thread. What it reads is bounded.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from day6_core.ros.programs.day6_inspector.setup_file import EntryPoint, read_setup

MOST_WORKSPACES = 6
MOST_PACKAGES = 100
MOST_FILES = 300
LONGEST_FILE = 2_000_000
DEEPEST = 4
"""Folders below `src` in which packages are looked for."""

LAYOUT = ".colcon_install_layout"
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
    unreadable: bool = False
    """Whether setup.py could not be understood."""
    files: tuple[str, ...] = ()
    """What is in it, relative to its folder."""


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


class ParameterFile(NamedTuple):
    """A parameter file that a running command line names."""

    path: Path
    line: str
    keys: tuple[str, ...]
    """Full names of nodes, with wildcards as they stand there."""
    problem: str = ""


class Files(NamedTuple):
    """Everything that was looked at."""

    workspaces: tuple[Workspace, ...] = ()
    strays: tuple[Path, ...] = ()
    """Folders that are no workspace and have an `install` tree: `src`, the home folder."""
    gone: tuple[tuple[int, str, str], ...] = ()
    """Entries of variables that name no folder: the terminal, the variable, the entry."""
    parameters: tuple[ParameterFile, ...] = ()
    unreadable: tuple[str, ...] = ()
    """Folders that could not be read."""
    scripts: Mapping[Path, str] = MappingProxyType({})
    """The texts of `Where.scripts`."""

    def package(self, name: str) -> tuple[Workspace, Package] | None:
        """Return the first package of that name with its workspace."""
        for workspace in self.workspaces:
            for package in workspace.packages:
                if package.name == name:
                    return workspace, package
        return None


class Typed(NamedTuple):
    """A command line that runs, as it was typed."""

    source: str
    folders: tuple[Path, ...]
    """Where it may have been started: the terminal goes on to other folders, and a line may begin with `cd`."""
    home: Path
    """What `~` means in it."""

    def path(self, name: str) -> Path | None:
        """Return the file that it means by a name; None where it is not known in which folder that is."""
        path = in_home(name, self.home)
        if path.is_absolute():
            return path
        found = [folder / path for folder in self.folders]
        there = next((each for each in found if each.exists()), None)
        return there if there is not None or "cd " in self.source or not found else found[0]


def in_home(name: str, home: Path) -> Path:
    """Return the path of a name as it was typed, whose `~` is the home folder of the terminal."""
    return home / name[2:] if name.startswith("~/") else Path(name)


class Where(NamedTuple):
    """Where to look: plain data, made on the scheduler's thread."""

    home: Path
    terminals: tuple[tuple[int, Path, Mapping[str, str]], ...] = ()
    """Number, folder and variables of each."""
    lines: tuple[Typed, ...] = ()
    """Running command lines."""
    scripts: tuple[Path, ...] = ()
    """Python files that were run last."""


def look(where: Where) -> Files:
    """Look at the files. Never raises OSError: what cannot be read is named."""
    unreadable: list[str] = []
    workspaces: list[Workspace] = []
    for folder in _workspace_folders(where):
        try:
            workspaces.append(_workspace(folder))
        except OSError as error:
            unreadable.append(f"{folder}: {error.strerror}")
    strays = [folder for folder in _possible_strays(where, workspaces) if (folder / "install" / LAYOUT).is_file()]
    return Files(
        tuple(workspaces),
        tuple(strays),
        tuple(_gone(where)),
        tuple(_parameter_files(where)),
        tuple(unreadable),
        {path: _text(path) for path in where.scripts},
    )


def _workspace_folders(where: Where) -> list[Path]:
    found = [where.home / "ros2_ws"]
    for _, cwd, variables in where.terminals:
        found += [folder for folder in (cwd, *cwd.parents) if (folder / "src").is_dir() and folder != folder.parent]
        found += [Path(each).parent for each in variables.get("COLCON_PREFIX_PATH", "").split(os.pathsep) if each]
    kept = [folder for folder in dict.fromkeys(found) if (folder / "src").is_dir() and folder.name != "src"]
    return kept[:MOST_WORKSPACES]


def _possible_strays(where: Where, workspaces: Iterable[Workspace]) -> list[Path]:
    folders = [workspace.folder / "src" for workspace in workspaces]
    folders += [package.folder for workspace in workspaces for package in workspace.packages]
    if not (where.home / "src").is_dir():
        folders.append(where.home)
    return folders


def _workspace(folder: Path) -> Workspace:
    manifests, inner, cut = _manifests(folder / "src")
    packages: list[Package] = []
    twice: list[tuple[str, Path, Path]] = []
    for manifest in manifests:
        package = _package(folder, manifest)
        other = next((each for each in packages if each.name == package.name), None)
        if other is None:
            packages.append(package)
        else:
            twice.append((package.name, other.folder, package.folder))
    return Workspace(folder, tuple(packages), tuple(inner), tuple(twice), cut)


def _manifests(source: Path) -> tuple[list[Path], list[tuple[Path, Path]], bool]:
    """Return the package.xml files below `src`, those inside other packages, and whether there are too many."""
    found: list[Path] = []
    inner: list[tuple[Path, Path]] = []
    for folder, folders, names in os.walk(source):
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
        if len(found) >= MOST_PACKAGES:
            return found, inner, True
    return found, inner, False


def _package(workspace: Path, manifest: Path) -> Package:
    folder = manifest.parent
    named = _NAME.search(_text(manifest))
    name = named[1] if named else folder.name
    setup = read_setup(_text(folder / "setup.py"), folder) if (folder / "setup.py").is_file() else None
    package = Package(
        name,
        folder,
        setup is not None,
        tuple(setup.entry_points) if setup is not None else (),
        unreadable=setup is not None and setup.unreadable,
        files=tuple(path.relative_to(folder).as_posix() for path in _files(folder)),
    )
    prefix = _prefix(workspace / "install", name)
    if prefix is None:
        return package
    executables = sorted(_names(prefix / "lib" / name))
    changed, missing = _compared(folder, name, prefix)
    wanted = [entry.name for entry in package.entry_points if entry.name not in executables]
    in_bin = bool(wanted) and all((prefix / "bin" / each).exists() for each in wanted)
    if wanted and not in_bin:
        changed.append("setup.py")
    if missing and setup is not None and setup.newer_than(prefix / "share" / name / "package.xml"):
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


def _compared(folder: Path, name: str, prefix: Path) -> tuple[list[str], list[str]]:
    """Return the files that differ from what was installed, and those that were not installed although others of the kind are."""
    changed: list[str] = []
    missing: list[str] = []
    module = folder / name
    installed = next(prefix.glob(f"lib/python3*/site-packages/{name}"), None)
    if installed is not None and module.is_dir():  # without it the build made links (--symlink-install)
        for path in _files(module, ".py"):
            other = installed / path.relative_to(module)
            if _differs(path, other):
                changed.append(str(path.relative_to(folder)))
    share = prefix / "share" / name
    for kind in INSTALLED:
        for path in _files(folder / kind):
            other = share / path.relative_to(folder)
            if other.exists():
                if _differs(path, other):
                    changed.append(str(path.relative_to(folder)))
            elif kind == "launch" and not any(share.rglob(path.name)):
                missing.append(str(path.relative_to(folder)))
    return changed, missing


def _files(folder: Path, suffix: str = "") -> Iterator[Path]:
    if not folder.is_dir():
        return
    count = 0
    for here, folders, names in os.walk(folder):
        folders[:] = sorted(each for each in folders if each != "__pycache__" and not each.startswith("."))
        for each in sorted(names):
            if each.endswith(suffix) and not each.startswith(".") and not each.endswith((".pyc", "~", ".swp")):
                count += 1
                if count > MOST_FILES:
                    return
                yield Path(here, each)


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


def _names(folder: Path) -> list[str]:
    with suppress(OSError):
        return [each for each in os.listdir(folder) if not each.startswith(("_", "."))]
    return []


def _text(path: Path) -> str:
    with suppress(OSError), path.open(encoding="utf-8", errors="replace") as file:
        return file.read(LONGEST_FILE)
    return ""


def _gone(where: Where) -> Iterator[tuple[int, str, str]]:
    for number, _, variables in where.terminals:
        for variable in ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"):
            for entry in variables.get(variable, "").split(os.pathsep):
                if entry and not entry.startswith("/opt/ros/") and not Path(entry).exists():
                    yield number, variable, entry


# -- parameter files -----------------------------------------------------------------------------------------------------


def _parameter_files(where: Where) -> Iterator[ParameterFile]:
    for line in where.lines:
        for name in re.findall(r"--params-file[ =](\S+)", line.source):
            if (path := line.path(name.strip("'\""))) is not None:
                yield _parameter_file(path, line.source)


def _parameter_file(path: Path, line: str) -> ParameterFile:
    import yaml

    try:
        if path.stat().st_size > LONGEST_FILE:
            return ParameterFile(path, line, (), "too large")
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except OSError as error:
        return ParameterFile(path, line, (), error.strerror or str(error))
    except (ValueError, RecursionError, yaml.YAMLError):
        return ParameterFile(path, line, (), "no YAML")
    return ParameterFile(path, line, tuple(_node_keys(content, "")))


def _node_keys(content: object, before: str) -> Iterator[str]:
    """Yield the names above every `ros__parameters`."""
    if not isinstance(content, dict):
        return
    for key, value in content.items():
        if key == "ros__parameters":
            yield before or "/"
        else:
            yield from _node_keys(value, f"{before}/{str(key).strip('/')}")
