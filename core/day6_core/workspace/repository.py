"""The ROS packages of the repository that a `pytest` belongs to: found without looking far, and built for its tests.

They are built as `colcon build --symlink-install` builds them, but into a folder that is not the user's.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from day6_core.workspace.local_setup_util import Environment, source_workspace
from day6_core.workspace.packages import is_ignored

_MANIFEST = "package.xml"
_DEPTH = 4
"""How far below the top of a repository packages are looked for: `workspace/src/repository/package`."""
_MOST_FOLDERS = 1000
"""So many are looked at, at most: 50 ms in large folders, which a repository without packages pays when an import fails in it."""
_LEFT_OUT = frozenset({"build", "install", "log", "node_modules", "__pycache__"})
_NAME = re.compile(rb"<name>\s*([\w-]+)\s*</name>")


class Repository:
    """What is known of the packages around a folder; nothing is read before it is asked for."""

    def __init__(self, folder: Path, tests: Iterable[Path] = ()) -> None:
        # started in a package of a repository with a pyproject.toml at its top, pytest runs that package's tests only
        self._folder = started if (started := Path.cwd()).is_relative_to(folder) else folder
        self._tests = tuple(tests)
        """The files and folders that were named to pytest."""

    @cached_property
    def top(self) -> Path:
        """The folder with `.git`, else the workspace whose `src` this is in, else the folder itself."""
        around = (self._folder, *self._folder.parents)
        for folder in around:
            if (folder / ".git").exists():
                return folder
        return next((folder.parent for folder in around if folder.name == "src"), self._folder)

    @cached_property
    def packages(self) -> dict[str, Path]:
        """The packages in the repository and, where it is one of several in `src`, in those beside it, `{name: folder}`."""
        found: dict[str, Path] = {}
        for root in (self.top, *([self.top.parent] if self.top.parent.name == "src" else [])):
            for folder in _package_folders(root):
                name = _NAME.search(_read(folder / _MANIFEST))
                found.setdefault(name[1].decode() if name else folder.name, folder)
        return found

    def source_of(self, name: str) -> Path | None:
        """Return the folder in which Python finds a package of this name in the sources, None if there is none."""
        folders = self.packages.values()
        return next((each for each in folders if (each / name / "__init__.py").is_file()), None)

    def sources(self) -> list[str]:
        """Return the folders of the tested packages that have a Python package of the same name.

        What else is in those of other packages is not for these tests: modules of the same name might be.
        """
        own = ((name, self.packages[name]) for name in self._tested)
        return [str(folder) for name, folder in own if (folder / name / "__init__.py").is_file()]

    def build(self, colcon: Sequence[str], into: Path, variables: Mapping[str, str]) -> str:
        """Build the packages that the tests belong to, with what they need, by the words of `colcon`.

        Returns what went wrong, or ''.
        """
        if not self._tested:
            return ""
        bases = ("--build-base", into / "build", "--install-base", into / "install", "--paths", *self.packages.values())
        words = [
            *colcon,
            "--log-base",
            os.devnull,
            "build",
            "--symlink-install",
            "--continue-on-error",
            *map(str, bases),
        ]
        words += ["--event-handlers", "console_start_end-", "summary-", "desktop_notification-"]
        words += ["--packages-up-to", *self._tested]
        done = subprocess.run(
            words,
            cwd=self.top,
            env=dict(variables),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
        )
        return done.stdout if done.returncode else ""

    @cached_property
    def _tested(self) -> list[str]:
        return self._around(self._tests or [self._folder]) or self._around([self.top])

    def _around(self, places: Iterable[Path]) -> list[str]:
        """Return the packages that some files or folders are in, or have in them."""
        found = []
        real = [Path(os.path.realpath(each)) for each in places]
        for name, folder in self.packages.items():
            package = Path(os.path.realpath(folder))
            if any(each.is_relative_to(package) or package.is_relative_to(each) for each in real):
                found.append(name)
        return found


def sourced(install: Path, variables: Mapping[str, str]) -> dict[str, str]:
    """Return the variables after sourcing what `build` has built; what failed is missing."""
    environment = Environment(variables)
    if install.is_dir():
        source_workspace(str(install), environment)
    return environment.variables


def _package_folders(top: Path) -> Iterator[Path]:
    """Yield the folders of packages, those nearest to the top first; they are not searched."""
    waiting = deque([(top, 0)])
    for _ in range(_MOST_FOLDERS):
        if not waiting:
            return
        folder, depth = waiting.popleft()
        if is_ignored(folder):
            continue
        try:
            with os.scandir(folder) as entries:
                names = {entry.name: entry.is_dir(follow_symlinks=False) for entry in entries}
        except OSError:
            continue
        if _MANIFEST in names:
            yield folder
        elif depth < _DEPTH:
            below = sorted(name for name, is_folder in names.items() if is_folder and not name.startswith("."))
            waiting.extend((folder / name, depth + 1) for name in below if name not in _LEFT_OUT)


def _read(manifest: Path) -> bytes:
    try:
        return manifest.read_bytes()
    except OSError:
        return b""
