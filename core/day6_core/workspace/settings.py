"""The settings of one call of `colcon build` or `colcon test`, for the tasks that process a package."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from day6_core.workspace.files import BuildOutput
from day6_core.workspace.packages import Package


@dataclass
class BuildSettings:
    """Folders are absolute. `warn(logger, text[, level])` prints a line of colcon's log, `print_error(text)` plain text."""

    build_base: Path
    install_base: Path
    environment: Mapping[str, str]
    output: BuildOutput
    """Writes, links and removes, below the bases of this call only."""
    warn: Callable[..., None]
    print_error: Callable[[str], None]
    merge_install: bool = False
    symlink_install: bool = False
    test_result_base: Path | None = None
    needs: Mapping[str, list[str]] = field(default_factory=dict)
    """package -> the workspace packages it needs, in build order"""
    around_test: Callable[[Mapping[str, str]], AbstractContextManager[Mapping[str, str]]] = nullcontext
    """Provides the variables of each process of tests while it runs, made of those it would have."""
    args: Namespace = field(default_factory=Namespace)
    """The options of the call, of which tasks read those for packages of their type."""

    def option(self, name: str, package: Package) -> Any:
        """Return the value of an option for a package, of which files may say more; None if the verb doesn't have it."""
        given, own = getattr(self.args, name, None), package.meta.options.get(name.replace("_", "-"))
        if isinstance(given, list) and isinstance(own, list):
            return [*given, *own]
        return given if own is None else own

    def prefix(self, package: str) -> Path:
        """Return the install prefix of a package."""
        return self.install_base if self.merge_install else self.install_base / package
