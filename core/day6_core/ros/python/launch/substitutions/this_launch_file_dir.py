"""The folder of the current launch file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("dirname")
class ThisLaunchFileDir(Substitution):
    """The folder of the launch file that is being visited."""

    @classmethod
    def parse(cls, data: Sequence[Any]) -> tuple[type, dict[str, Any]]:
        if data:
            raise TypeError("dirname substitution doesn't expect arguments")
        return cls, {}

    def describe(self) -> str:
        return "ThisLaunchFileDir()"

    def perform(self, context: LaunchContext) -> str:
        if "current_launch_file_directory" not in context.get_locals_as_dict():
            raise SubstitutionFailure("ThisLaunchFileDir used outside of a launch file (in a script)")
        return str(context.locals.current_launch_file_directory)
