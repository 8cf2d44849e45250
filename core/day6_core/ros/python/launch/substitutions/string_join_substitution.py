"""Texts, joined by a delimiter."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("string-join")
class StringJoinSubstitution(Substitution):
    """The parts, which may each consist of several substitutions, with `delimiter` between them."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = "") -> None:
        super().__init__()
        self.__substitutions = [normalize_to_list_of_substitutions(part) for part in substitutions]
        self.__delimiter = normalize_to_list_of_substitutions(delimiter)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[Any, dict[str, Any]]:
        if len(data) < 2:
            raise TypeError("string-join substitution expects at least 2 arguments: 1 delimiter + at least 1 component")
        return cls, {"delimiter": data[0], "substitutions": data[1:]}

    @property
    def substitutions(self) -> list[list[Substitution]]:
        return self.__substitutions

    @property
    def delimiter(self) -> list[Substitution]:
        return self.__delimiter

    def describe(self) -> str:
        parts = ["".join(each.describe() for each in part) for part in self.__substitutions]
        return f"StringJoin('{' + '.join(parts)}')"

    def perform(self, context: LaunchContext) -> str:
        delimiter = perform_substitutions(context, self.__delimiter)
        return delimiter.join(perform_substitutions(context, part) for part in self.__substitutions)
