"""Not, and, or, any, all. Their texts are 'true' and 'false'."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.type_utils import perform_typed_substitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


def truth(context: LaunchContext, value: Sequence[Substitution]) -> bool:
    """Return the truth value of a text. Raises SubstitutionFailure if it is neither true nor false."""
    try:
        return bool(perform_typed_substitution(context, value, bool))
    except (TypeError, ValueError) as error:
        raise SubstitutionFailure(error) from error


@expose_substitution("not")
class NotSubstitution(Substitution):
    """`$(not value)`: 'true' if the value is false."""

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__value = normalize_to_list_of_substitutions(value)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        if len(data) != 1:
            raise TypeError("not substitution expects 1 argument")
        return cls, {"value": data[0]}

    @property
    def value(self) -> list[Substitution]:
        return self.__value

    def describe(self) -> str:
        return f"NotSubstitution({self.value})"

    def perform(self, context: LaunchContext) -> str:
        return str(not truth(context, self.value)).lower()


class _Pair(Substitution):
    def __init__(self, left: SomeSubstitutionsType, right: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__left = normalize_to_list_of_substitutions(left)
        self.__right = normalize_to_list_of_substitutions(right)

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


@expose_substitution("and")
class AndSubstitution(_Pair):
    """`$(and left right)`."""

    def perform(self, context: LaunchContext) -> str:
        left, right = truth(context, self.left), truth(context, self.right)
        return str(left and right).lower()


@expose_substitution("or")
class OrSubstitution(_Pair):
    """`$(or left right)`."""

    def perform(self, context: LaunchContext) -> str:
        left, right = truth(context, self.left), truth(context, self.right)
        return str(left or right).lower()


class _Several(Substitution):
    def __init__(self, *args: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__args = [normalize_to_list_of_substitutions(each) for each in args]

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type, dict[str, Any]]:
        return cls, {"args": data}

    @property
    def args(self) -> list[list[Substitution]]:
        return self.__args

    def describe(self) -> str:
        return f"{type(self).__name__}({' '.join(map(str, self.args))})"


@expose_substitution("any")
class AnySubstitution(_Several):
    """`$(any …)`: 'true' if one of them is true; a value that is neither is refused, wherever it stands."""

    def perform(self, context: LaunchContext) -> str:
        truths = [truth(context, each) for each in self.args]
        return str(any(truths)).lower()


@expose_substitution("all")
class AllSubstitution(_Several):
    """`$(all …)`: 'true' if all of them are true; a value that is neither is refused, wherever it stands."""

    def perform(self, context: LaunchContext) -> str:
        truths = [truth(context, each) for each in self.args]
        return str(all(truths)).lower()
