"""Sourcing `install/setup.bash` in the simulated terminal: it applies the .dsv files and runs no shell script.

So it works on Windows, which has no bash, and with a workspace built by the real colcon.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from importlib.abc import Loader
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType

from day6_core.interfaces import add_prefixes
from day6_core.interfaces.package import package_files
from day6_core.interfaces.registry import KINDS, package_folder
from day6_core.places import as_on_linux
from day6_core.ros.distribution import current
from day6_core.ros.environment import program_environment, python_folders
from day6_core.ros.executables import are_on, with_executables
from day6_core.ros.setup_lines import distribution_of
from day6_core.workspace.local_setup_util import Environment, source_package, source_workspace
from day6_core.workspace.setup_scripts import chained_in

_SHELLS = ("bash", "sh", "zsh")
_ROS_VARIABLES = ("ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION", "PYTHONPATH")


def source_setup(path: Path, environment: Mapping[str, str]) -> dict[str, str] | None:
    """Return the variables that sourcing `path` changes, None if it isn't a setup script of a ROS or colcon workspace.

    Raises:
        FileNotFoundError: the script is that of a ROS distribution this machine does not have.
        ValueError: a .dsv file is malformed.
    """
    ros = distribution_of(as_on_linux(path))
    if ros is not None:
        return _source_ros(path, ros, environment)
    stem, _, shell = path.name.rpartition(".")
    if shell not in _SHELLS or not path.is_file():
        return None
    folder = path.parent
    result = Environment(environment)
    if stem in ("setup", "local_setup") and (folder / ".colcon_install_layout").is_file():
        for prefix in chained_in(path) if stem == "setup" else ():
            if Path(prefix).is_dir():
                source_workspace(prefix, result)
        source_workspace(str(folder), result)
        return result.changed
    if stem == "package" and (folder / "package.dsv").is_file():
        source_package(str(folder.parent.parent), folder.name, result)
        return result.changed
    return None


class _WorkspaceInterfaces:
    """Imports modules like `day6_msgs.msg` from sourced workspaces for the programs of this process.

    The programs have separate environments but share one `sys.path`; a student's other modules must not be added to it.
    """

    @staticmethod
    def find_spec(fullname: str, path: Sequence[str] | None = None, target: object = None) -> ModuleSpec | None:
        package, _, kind = fullname.partition(".")
        folder = package_folder(package)
        if folder is None or (kind and (kind not in KINDS or not Path(folder, kind).is_dir())):
            return None
        text = package_files(package, [kind] if kind else [])["/".join((*fullname.split("."), "__init__.py"))]
        return ModuleSpec(fullname, _TextLoader(text), is_package=True)


class _TextLoader(Loader):
    def __init__(self, text: str) -> None:
        self._text = text

    def exec_module(self, module: ModuleType) -> None:
        exec(self._text, module.__dict__)


def import_interfaces(changed: Mapping[str, str]) -> None:
    """Make the interfaces of sourced packages importable for the programs of this process."""
    add_prefixes([path for path in changed.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if path])
    if not any(isinstance(finder, _WorkspaceInterfaces) for finder in sys.meta_path):
        sys.meta_path.append(_WorkspaceInterfaces())


def _source_ros(path: Path, distribution: str, environment: Mapping[str, str]) -> dict[str, str]:
    if distribution != current():
        raise FileNotFoundError(2, "No such file or directory", str(path))
    result = Environment(environment)
    after = program_environment({**environment, "PYTHONPATH": ""})
    for name in _ROS_VARIABLES[:-1]:
        result.set(name, after[name])
    for folder in reversed(python_folders()):
        result.extend("PYTHONPATH", folder)
    if not are_on(result.variables.get("PATH", "")):
        result.set("PATH", with_executables(result.variables.get("PATH", "")))
    return result.changed
