"""The facts about files: the workspaces that are in use, what lies beside them, parameter files.

`look` reads folders and belongs in a thread. What it reads is bounded.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from day6_core.facts.folders import LONGEST_FILE, text_of
from day6_core.facts.workspaces import Package, Workspace, read_workspace, workspaces_above
from day6_core.reason import reason

MOST_WORKSPACES = 6
LAYOUT = ".colcon_install_layout"


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

    @property
    def packages(self) -> int:
        """How many packages there are."""
        return sum(len(workspace.packages) for workspace in self.workspaces)

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
            workspaces.append(read_workspace(folder))
        except OSError as error:
            unreadable.append(f"{folder}: {error.strerror}")
    strays = [folder for folder in _possible_strays(where, workspaces) if (folder / "install" / LAYOUT).is_file()]
    return Files(
        tuple(workspaces),
        tuple(strays),
        tuple(_gone(where)),
        tuple(_parameter_files(where)),
        tuple(unreadable),
        {path: text_of(path) for path in where.scripts},
    )


def _workspace_folders(where: Where) -> list[Path]:
    found = [where.home / "ros2_ws"]
    for _, cwd, variables in where.terminals:
        found += [folder for folder in workspaces_above(cwd) if folder != folder.parent]
        found += [Path(each).parent for each in variables.get("COLCON_PREFIX_PATH", "").split(os.pathsep) if each]
    kept = [folder for folder in dict.fromkeys(found) if (folder / "src").is_dir() and folder.name != "src"]
    return kept[:MOST_WORKSPACES]


def _possible_strays(where: Where, workspaces: Iterable[Workspace]) -> list[Path]:
    folders = [workspace.folder / "src" for workspace in workspaces]
    folders += [package.folder for workspace in workspaces for package in workspace.packages]
    if not (where.home / "src").is_dir():
        folders.append(where.home)
    return folders


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
        return ParameterFile(path, line, (), reason(error))
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
