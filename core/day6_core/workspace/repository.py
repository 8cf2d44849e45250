"""The ROS packages of the repository that a `pytest` belongs to: found without looking far, and built for its tests.

They are built as `colcon build --symlink-install` builds them, but into a folder that is not the user's.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from day6_core.workspace.local_setup_util import Environment, source_workspace

_PLACES = ("", "*/", "src/*/", "src/*/*/")
"""Where packages are looked for below the top of a repository; `colcon` then finds the rest."""
_NAME = re.compile(rb"<name>\s*([\w-]+)\s*</name>")


class Repository:
    """What is known of the packages around a folder; nothing is read before it is asked for."""

    def __init__(self, folder: Path, tests: Iterable[Path] = ()) -> None:
        self._folder = folder
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
        """The packages near the top, `{name: folder}`."""
        found: dict[str, Path] = {}
        for place in _PLACES:
            for manifest in sorted(self.top.glob(f"{place}package.xml")):
                name = _NAME.search(_read(manifest))
                found.setdefault(name[1].decode() if name else manifest.parent.name, manifest.parent)
        return found

    def source_of(self, name: str) -> Path | None:
        """Return the folder in which Python finds a package of this name in the sources, None if there is none."""
        folders = self.packages.values()
        return next((each for each in folders if (each / name / "__init__.py").is_file()), None)

    def sources(self) -> list[str]:
        """Return the folders of packages that have a Python package of the same name."""
        return [str(folder) for name, folder in self.packages.items() if (folder / name / "__init__.py").is_file()]

    def build(self, colcon: Sequence[str], into: Path, variables: Mapping[str, str]) -> str:
        """Build the packages that the tests belong to, with what they need, by the words of `colcon`.

        Returns what went wrong, or ''.
        """
        bases = ("--base-paths", self.top, "--build-base", into / "build", "--install-base", into / "install")
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
        if wanted := list(self._tested()):
            words += ["--packages-up-to", *wanted]
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

    def _tested(self) -> Iterator[str]:
        tests = [Path(os.path.realpath(each)) for each in self._tests or (self._folder,)]
        for name, folder in self.packages.items():
            real = Path(os.path.realpath(folder))
            if any(each == real or real in each.parents or each in real.parents for each in tests):
                yield name


def sourced(install: Path, variables: Mapping[str, str]) -> dict[str, str]:
    """Return the variables after sourcing what `build` has built; what failed is missing."""
    environment = Environment(variables)
    if install.is_dir():
        source_workspace(str(install), environment)
    return environment.variables


def _read(manifest: Path) -> bytes:
    try:
        return manifest.read_bytes()
    except OSError:
        return b""
