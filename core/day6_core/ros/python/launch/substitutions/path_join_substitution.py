"""Parts of a path, joined."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("path-join")
class PathJoinSubstitution(Substitution):
    """`os.path.join` of the parts, which may each consist of several substitutions; `path / part` adds one."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType]) -> None:
        super().__init__()
        parts = [part if isinstance(part, Iterable) else [part] for part in substitutions]
        self.__substitutions = [normalize_to_list_of_substitutions(part) for part in parts]

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[Any, dict[str, Any]]:
        if not data:
            raise TypeError("path-join substitution expects at least 1 path component")
        return cls, {"substitutions": data}

    @property
    def substitutions(self) -> list[list[Substitution]]:
        return self.__substitutions

    def __truediv__(self, additional_path: SomeSubstitutionsType) -> PathJoinSubstitution:
        return PathJoinSubstitution([*self.__substitutions, additional_path])

    def describe(self) -> str:
        parts = ["".join(each.describe() for each in part) for part in self.__substitutions]
        return f"PathJoin('{' + '.join(parts)}')"

    def perform(self, context: LaunchContext) -> str:
        return os.path.join(*(perform_substitutions(context, part) for part in self.__substitutions))
