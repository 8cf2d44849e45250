"""Compares two texts by meaning."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions
from launch.utilities.type_utils import is_substitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_TRUTH = {"true": True, "1": True, "false": False, "0": False}


@expose_substitution("equals")
class EqualsSubstitution(Substitution):
    """'true' or 'false'. 'True' equals '1', '1.0' equals '1.00', None is an empty text."""

    def __init__(self, left: Any, right: Any) -> None:
        super().__init__()
        self.__left = normalize_to_list_of_substitutions(_as_text(left))
        self.__right = normalize_to_list_of_substitutions(_as_text(right))

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if len(data) != 2:
            raise TypeError("and substitution expects 2 arguments")
        return cls, {"left": data[0], "right": data[1]}

    @property
    def left(self) -> list[Substitution]:
        return self.__left

    @property
    def right(self) -> list[Substitution]:
        return self.__right

    def describe(self) -> str:
        return f"{type(self).__name__}({self.left} {self.right})"

    def perform(self, context: LaunchContext) -> str:
        left, right = perform_substitutions(context, self.left), perform_substitutions(context, self.right)
        return str(_equal(left, right)).lower()


def _as_text(value: Any) -> Any:
    if is_substitution(value):
        return value
    if isinstance(value, list) and all(isinstance(each, Substitution) for each in value):
        return value
    return "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)


def _equal(left: str, right: str) -> bool:
    if left.lower() in _TRUTH and right.lower() in _TRUTH:
        return _TRUTH[left.lower()] == _TRUTH[right.lower()]
    try:
        return math.isclose(float(left), float(right))
    except ValueError:
        return left == right
