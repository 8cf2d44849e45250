"""The plugin of pytest: `import rclpy`, launch tests and the packages of the repository work in an ordinary `pytest`.

Every pytest beside which day6-tui is installed loads it. There it waits for the first import of something of ROS that nobody
else has, and imports nothing until then. A real ROS that was sourced, other packages with such names, and a terminal of day6-tui,
which has all of this already, are left alone.

From that import on the process is a ROS program with a graph of its own, which is also that of the processes its tests start.
Each worker of pytest-xdist has one.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Sequence
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import pytest

import day6_core

if TYPE_CHECKING:
    from day6_core.workspace.repository import Repository

_ROS = os.path.join(os.path.realpath(day6_core.__path__[0]), "ros")  # a program's day6_core has its file elsewhere
_PYTHON = os.path.join(_ROS, "python")
"""The first of `day6_core.ros.environment.python_folders`, of which nothing is imported before it is needed."""

_WORKER = "PYTEST_XDIST_WORKER"
_OF_LAUNCH = re.compile(rb"^\s*(?:from|import)\s+(launch\w*|ament_\w+)", re.MULTILINE)
"""The imports of a file that wants plugins of pytest which come with ROS. They have to be there before the file is collected."""
_COMMAND = re.compile(rb"""['" ]ros2['" ]""")


def pytest_addoption(parser: pytest.Parser, pluginmanager: pytest.PytestPluginManager) -> None:
    """Every run of pytest in this process is looked after for itself."""
    pluginmanager.register(_Run(parser), f"{__name__}.run")


class _Run:
    def __init__(self, parser: pytest.Parser) -> None:
        self._parser = parser
        self._finders: list[_Finder] = []
        self._repository: Repository | None = None
        self._waits = self._is_program = False
        """Whether this run may make the process a program, and whether it has."""
        self._plugins_missing = False

    # -- hooks ---------------------------------------------------------------------------------------------------------

    @pytest.hookimpl(tryfirst=True)
    def pytest_load_initial_conftests(self, early_config: pytest.Config, args: list[str]) -> None:
        first, last = _OfOurs(), _OfRepository(self)
        self._finders = [first]
        sys.meta_path.insert(0, first)
        if _PYTHON in sys.path:
            if _WORKER in os.environ:
                _leave_the_graph_of_the_run()
            return
        self._waits = True
        self._finders += [of_ros := _OfRos(self), last]
        sys.meta_path.insert(0, of_ros)
        sys.meta_path.append(last)
        self._folder = early_config.rootpath
        named = getattr(early_config.known_args_namespace, "file_or_dir", None) or ()
        self._tests = [early_config.invocation_params.dir / str(each).partition("::")[0] for each in named]
        if any(each.startswith("--launch-args") for each in args):
            self.become_program()
            self._load_plugins(early_config)

    @pytest.hookimpl(tryfirst=True)
    def pytest_collect_file(self, file_path: Path, parent: pytest.Collector) -> None:
        if self._waits and file_path.suffix == ".py" and self._needs_ros(file_path):
            self.become_program()
        self._load_plugins(parent.config)

    @pytest.hookimpl(optionalhook=True)
    def pytest_xdist_setupnodes(self, config: pytest.Config) -> None:
        """What all workers need is made once, before they start."""
        if self._waits and self.repository.packages:
            self.become_program()
        if self._is_program:
            from day6_core.workspace.own_graph import RUN

            os.environ[RUN] = "1"

    def pytest_report_collectionfinish(self) -> list[str]:
        if not self._is_program:
            return []
        from day6_core.ros.distribution import current

        return [f"day6-tui stands in for ROS 2 {current().title()}; these tests have a graph of their own"]

    def pytest_unconfigure(self) -> None:
        sys.meta_path[:] = [each for each in sys.meta_path if each not in self._finders]
        self._finders = []

    # -- becoming a program --------------------------------------------------------------------------------------------

    @property
    def repository(self) -> Repository:
        if self._repository is None:
            from day6_core.workspace.repository import Repository

            self._repository = Repository(self._folder, self._tests)
        return self._repository

    def become_program(self) -> None:
        """Make this process a ROS program, unless there is a real ROS; the packages of the repository are built for it."""
        if not self._waits:
            return
        self._waits = False
        if _PYTHON in sys.path or is_elsewhere("rclpy"):
            return
        self._is_program = self._plugins_missing = True
        from day6_core.workspace.own_graph import graph_until_exit
        from day6_core.workspace.repository import sourced

        folder, env = graph_until_exit(os.environ)
        colcon = (sys.executable, "-m", "day6_tui.main", "colcon")
        trouble = self.repository.build(colcon, folder, os.environ) if self.repository.packages else ""
        env = sourced(folder / "install", env)
        os.environ.update(env)
        wanted = [*self.repository.sources(), *env["PYTHONPATH"].split(os.pathsep)]
        sys.path += [each for each in dict.fromkeys(wanted) if each not in sys.path]
        if trouble:
            import warnings

            warnings.warn(pytest.PytestWarning(f"day6-tui colcon build\n{trouble}"), stacklevel=2)

    def _needs_ros(self, file: Path) -> bool:
        try:
            text = file.read_bytes()
        except OSError:
            return False
        imported = {each.decode() for each in _OF_LAUNCH.findall(text)}
        if any(not is_elsewhere(each) for each in imported.intersection(_shipped())):
            return True
        return bool(_COMMAND.search(text) and self.repository.packages)

    def _load_plugins(self, config: pytest.Config) -> None:
        """Register the plugins that pytest would have found at its start if this had been a ROS program then."""
        if not self._plugins_missing:
            return
        self._plugins_missing = False
        from importlib.metadata import distributions

        manager = config.pluginmanager
        for each in (entry for package in distributions(path=[_PYTHON]) for entry in package.entry_points):
            if each.group != "pytest11" or manager.is_blocked(each.name):
                continue
            if not manager.is_registered(plugin := each.load()):  # a conftest may have named it
                manager.register(plugin, each.name)
        for name, value in vars(self._parser.parse_known_args([])).items():
            if not hasattr(config.option, name):
                setattr(config.option, name, value)


class _Finder(Protocol):
    def find_spec(
        self, fullname: str, path: Sequence[str] | None = None, target: object = None
    ) -> ModuleSpec | None: ...


class _OfOurs:
    """Imports day6-tui's own modules as they are. Of a package with a plugin pytest rewrites every module, for its assertions."""

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: object = None) -> ModuleSpec | None:
        return PathFinder.find_spec(fullname, path) if fullname.startswith(("day6_core.", "day6_tui.")) else None


class _OfRos:
    """The first finder of modules: it sees the import of a package of ROS before a mere folder of that name is taken for it."""

    def __init__(self, run: _Run) -> None:
        self._run = run
        self._names = frozenset(_shipped())

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: object = None) -> ModuleSpec | None:
        if path is None and fullname in self._names and _PYTHON not in sys.path and not is_elsewhere(fullname):
            self._run.become_program()
        return None


class _OfRepository:
    """The last finder: it is asked for what nobody has. Packages of the repository are imported from their sources."""

    def __init__(self, run: _Run) -> None:
        self._run = run

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: object = None) -> ModuleSpec | None:
        if path is not None or fullname in _asking or _PYTHON in sys.path:
            return None
        if (folder := self._run.repository.source_of(fullname)) is not None:
            return PathFinder.find_spec(fullname, [str(folder)])
        if fullname in self._run.repository.packages:  # its interfaces have to be built
            self._run.become_program()
            return PathFinder.find_spec(fullname)
        return None


_asking: set[str] = set()
"""The modules that the finders of others are being asked for."""


def is_elsewhere(name: str) -> bool:
    """Return whether a package is on the path without us, or stands in `sys.modules` (a mock); a mere folder is none."""
    if name in sys.modules:
        return True
    if name in _asking:
        return True
    _asking.add(name)
    try:
        spec = find_spec(name)
        return spec is not None and spec.origin is not None
    finally:
        _asking.discard(name)


def _shipped() -> Iterator[str]:
    """Yield the names of all packages that come with day6-tui, in any distribution."""
    for folder in (_PYTHON, *(entry.path for entry in os.scandir(os.path.join(_ROS, "python_of")))):
        yield from (name for name in os.listdir(folder) if name.isidentifier() and name != "day6_core")


def _leave_the_graph_of_the_run() -> None:
    """In a worker: what pytest itself has is inherited, but not its graph."""
    from day6_core.workspace.own_graph import RUN, graph_until_exit

    if os.environ.pop(RUN, None):
        os.environ.update(graph_until_exit(os.environ)[1])
