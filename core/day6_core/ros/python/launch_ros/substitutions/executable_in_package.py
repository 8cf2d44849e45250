"""The path of a package's executable."""

from __future__ import annotations

import os
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from launch_ros.substitutions.find_package import FindPackagePrefix

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class LeftOut(SubstitutionFailure):
    """The executable is a C++ program that the build left out: the launch goes on without it."""


@expose_substitution("exec-in-pkg")
class ExecutableInPackage(FindPackagePrefix):
    """`<prefix>/lib/<package>/<executable>`. Our own executables have such a path too, but no file."""

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        self.__executable = normalize_to_list_of_substitutions(executable)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if len(data) != 2:
            raise AttributeError("exec-in-package substitution expects 2 arguments")
        return cls, {"executable": data[0], "package": data[1]}

    @property
    def executable(self) -> list[Substitution]:
        return self.__executable

    def describe(self) -> str:
        package, executable = (" + ".join(each.describe() for each in subs) for subs in (self.package, self.executable))
        return f"ExecInPkg(pkg={package}, exec={executable})"

    def perform(self, context: LaunchContext) -> str:
        executable = perform_substitutions(context, self.executable)
        package = perform_substitutions(context, self.package)
        prefix = super().perform(context)
        folder = os.path.join(prefix, "lib", package)
        from ament_index_python.search_paths import BUILT_IN_PREFIX

        from day6_core.ros.left_out import noted_programs, replacements, why_not
        from day6_core.ros.program_index import named_by

        if named_by(Path(folder, executable)) is not None:
            return os.path.join(folder, executable)

        if executable in replacements(package, noted_programs(prefix, package)):
            return os.path.join(BUILT_IN_PREFIX, "lib", package, executable)
        if reason := why_not(prefix, package, executable):
            raise LeftOut(f"executable '{executable}' of package '{package}' isn't there {reason.strip()}")
        if not os.path.exists(folder) and prefix != BUILT_IN_PREFIX:
            raise SubstitutionFailure(
                f"package '{package}' found at '{prefix}', but libexec directory '{folder}' does not exist"
            )
        found = shutil.which(executable, path=folder)
        if found is None:
            raise SubstitutionFailure(f"executable '{executable}' not found on the libexec directory '{folder}' ")
        return found
