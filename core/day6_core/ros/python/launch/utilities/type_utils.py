"""Converts texts and substitutions to values of a given type, by the rules of YAML.

A data type is `int`, `float`, `bool`, `str`, a `List` of one of them, or None for "as YAML reads it".
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, List  # noqa: UP035  (launch files write List[int])

from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.ensure_argument_type_impl import ensure_argument_type
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

ScalarTypesTuple = (int, float, bool, str)
ListTypesTuple = (List[int], List[float], List[bool], List[str])  # noqa: UP006
AllowedTypesTuple = ScalarTypesTuple + ListTypesTuple
ScalarValueType = int | float | bool | str
AllowedValueType = Any
AllowedTypesType = Any
SomeValueType = Any
NormalizedValueType = Any
StrSomeValueType = Any


def is_typing_list(data_type: Any) -> bool:
    """Return whether a type is `List`, `List[…]` or `list[…]`."""
    return data_type is List or getattr(data_type, "__origin__", None) is list  # noqa: UP006


def is_valid_scalar_type(data_type: Any) -> bool:
    """Return whether it is one of `ScalarTypesTuple`."""
    return data_type in ScalarTypesTuple


def extract_type(data_type: Any) -> tuple[type, bool]:
    """Return the scalar type and whether a list of it is meant. Raises ValueError for any other type."""
    members = getattr(data_type, "__args__", None)
    is_list = is_typing_list(data_type) and bool(members)
    scalar = members[0] if is_list and members else data_type
    if not is_valid_scalar_type(scalar):
        raise ValueError(f"Unrecognized data type: {data_type}")
    return scalar, is_list


def is_instance_of_valid_type(value: Any, *, can_be_str: bool = False) -> bool:
    """Return whether a value is a scalar or a list of scalars of one type (with `can_be_str` some may be strings)."""
    if not isinstance(value, list):
        return isinstance(value, ScalarTypesTuple)
    member = next((type(each) for each in value if type(each) is not str), str)
    if member not in ScalarTypesTuple:
        return False
    return all(isinstance(each, (member, str) if can_be_str else member) for each in value)


def is_instance_of(value: Any, data_type: Any = None, *, can_be_str: bool = False) -> bool:
    """Return whether a value has the data type, or, with `can_be_str`, is a string that may become one."""
    if data_type is None:
        return is_instance_of_valid_type(value, can_be_str=can_be_str)
    scalar, is_list = extract_type(data_type)
    allowed = (str, scalar) if can_be_str else (scalar,)
    if is_list:
        return isinstance(value, list) and all(isinstance(each, allowed) for each in value)
    return isinstance(value, allowed)


def coerce_to_type(value: str, data_type: Any = None, *, can_be_str: bool = False) -> Any:
    """Return the value of a text. Raises ValueError if it has no value of that type."""
    ensure_argument_type(value, str, "value", "coerce_to_type")
    if data_type is None:
        return _from_yaml(value, f"Failed to convert '{value}' using yaml rules", can_be_str)
    scalar, is_list = extract_type(data_type)
    allowed: Any = (str, scalar) if can_be_str else scalar
    if is_list:
        problem = f"Cannot convert value '{value}' to a list of '{allowed}'"
        output = _from_yaml(value, problem, can_be_str)
        if not isinstance(output, list):
            raise ValueError(problem)
        if not all(isinstance(each, allowed) for each in output):
            raise ValueError(f"{problem}, got {output}")
        return output
    if scalar is str:
        return value
    if scalar is bool:
        text = {"1": "true", "0": "false"}.get(value, value)
        output = _from_yaml(text, f"Failed to convert '{value}' to '{scalar}'", can_be_str)
        if isinstance(output, allowed):
            return output
        raise ValueError(f"Cannot convert value '{value}' to '{scalar}'")
    try:
        return scalar(value)
    except ValueError:
        if can_be_str:
            return value
        raise


def _from_yaml(text: str, problem: str, can_be_str: bool) -> Any:
    if not text:
        return text
    import yaml

    try:
        output = yaml.safe_load(text)
    except yaml.YAMLError as error:
        if can_be_str:
            return text
        raise ValueError(f"{problem}: yaml.safe_load() failed\n{error}") from error
    if not is_instance_of_valid_type(output, can_be_str=can_be_str):
        raise ValueError(f"{problem}: output type is not allowed, got {type(output)}")
    return output


def coerce_list(value: list[str], data_type: Any = None, *, can_be_str: bool = False) -> list[Any]:
    """Apply `coerce_to_type` to each text of a list. Raises ValueError if the values have different types."""
    ensure_argument_type(value, list, "value", "coerce_list")
    output = [coerce_to_type(each, data_type, can_be_str=can_be_str) for each in value]
    if not is_instance_of_valid_type(output, can_be_str=can_be_str):
        raise ValueError(f"cannot convert value to {data_type}. Got value=`{value}`")
    return output


def get_typed_value(value: Any, data_type: Any, *, can_be_str: bool = False) -> Any:
    """Return the value of a text, or of a list of texts."""
    if not isinstance(value, list):
        return coerce_to_type(value, data_type, can_be_str=can_be_str)
    if data_type is not None:
        data_type, is_list = extract_type(data_type)
        if not is_list:
            raise TypeError(f"Cannot convert input '{value}' of type '{type(value)}' to '{data_type}'")
    return coerce_list(value, data_type, can_be_str=can_be_str)


def is_substitution(x: Any) -> bool:
    """Return whether something is a substitution, or a sequence of strings and at least one substitution."""
    if isinstance(x, Substitution):
        return True
    if isinstance(x, str) or not isinstance(x, Iterable):
        return False
    items = list(x)
    return all(isinstance(each, (Substitution, str)) for each in items) and any(
        isinstance(each, Substitution) for each in items
    )


def normalize_typed_substitution(value: Any, data_type: Any) -> Any:
    """Return a scalar, a list of substitutions (for one scalar), or a list of scalars and such lists."""
    if isinstance(value, ScalarTypesTuple):
        if not is_instance_of(value, data_type):
            raise TypeError(f"value='{value}' is not an instance of {data_type}")
        return value
    if is_substitution(value):
        return normalize_to_list_of_substitutions(value)
    if not isinstance(value, Iterable):
        raise TypeError(
            "value should be either a scalar, a substitutions, or a mixed list of scalars and substitutions. "
            f"Got `value={value}` of type `{type(value)}`. "
        )
    items = list(value)
    kinds = {_kind(each, items) for each in items}
    if data_type is not None:
        data_type, is_list = extract_type(data_type)
        if not is_list:
            raise TypeError(
                "The provided value resolves to a list, though the required type is a scalar. "
                f"Got value='{value}', data_type='{data_type}'."
            )
    scalars = kinds - {Substitution}
    if scalars == {int, float}:
        scalars = {float}
    if len(scalars) > 1:
        raise TypeError(f"Input value is not an acceptable 'SomeValueType'.Got value='{value}'")
    kind = next(iter(scalars), None)
    if kind is not None and data_type not in (None, kind) and not (kind is int and data_type is float):
        raise TypeError(f"Got a list of '{kind}', expected a list of '{data_type}'. value='{value}'")
    if float in (kind, data_type):
        kind = float
    return [
        normalize_to_list_of_substitutions(each) if is_substitution(each) else float(each) if kind is float else each
        for each in items
    ]


def _kind(item: Any, items: list[Any]) -> Any:
    if isinstance(item, ScalarTypesTuple):
        return type(item)
    if is_substitution(item):
        return Substitution
    raise TypeError(
        "value is a list, and one of the items is not a scalar, a Substitution or a list of substitutions. "
        f"Got value='{items}'"
    )


def is_normalized_substitution(x: Any) -> bool:
    """Return whether `x` is a non-empty list of substitutions."""
    return isinstance(x, list) and len(x) > 0 and all(isinstance(each, Substitution) for each in x)


def perform_typed_substitution(context: LaunchContext, value: Any, data_type: Any) -> Any:
    """Return the value of a result of `normalize_typed_substitution`. Raises TypeError or ValueError for another type."""
    if isinstance(value, ScalarTypesTuple):
        if data_type is not None and not is_instance_of(value, data_type):
            raise TypeError(f"value=`{value}` is a scalar and not an instance of `{data_type}`")
        return value
    if is_normalized_substitution(value):
        return coerce_to_type(perform_substitutions(context, value), data_type)
    if not isinstance(value, list):
        raise TypeError(f"Input value is not an acceptable 'NormalizedValueType'.Got value='{value}'")
    scalar = None
    if data_type is not None:
        scalar, is_list = extract_type(data_type)
        if not is_list:
            raise ValueError(
                "The input value is a list, cannot convert it to a scalar. "
                f"Got value='{value}', expected type {scalar}."
            )
    output = [
        coerce_to_type(perform_substitutions(context, each), scalar) if is_normalized_substitution(each) else each
        for each in value
    ]
    if not is_instance_of(output, data_type):
        if scalar is None:
            raise ValueError("The output list is not uniform")
        raise ValueError(
            f"The output list does not match the expected type Got value='{value}', expected type {scalar}."
        )
    return output


SomeScalarType = SomeSubstitutionsType | ScalarValueType
