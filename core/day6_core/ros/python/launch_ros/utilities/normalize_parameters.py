"""Normalizes the parameters that launch files give.

Names become tuples of substitutions (nested dicts: joined by a dot). A value is a bool, int, float, bytes, a literal
string, a tuple of substitutions (one text that YAML reads), a tuple of bools, ints or floats, a tuple of lists of
substitutions (one text per item), or a `ParameterValue`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType_types_tuple
from launch.substitution import Substitution
from launch.substitutions.text_substitution import TextSubstitution
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue


def normalize_parameters(parameters: Any) -> tuple[Any, ...]:
    """Return the normalized files, dicts and `Parameter`s of a list. Raises TypeError for anything but a list."""
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f"Expecting list of parameters, got {parameters}")
    found: list[Any] = []
    for each in parameters:
        if isinstance(each, Mapping):
            found.append(normalize_parameter_dict(each))
        elif isinstance(each, (Parameter, ParameterFile)):
            found.append(each)
        else:
            found.append(ParameterFile(each))
    return tuple(found)


def normalize_parameter_dict(parameters: Any, *, _prefix: Sequence[Substitution] = ()) -> dict[Any, Any]:
    """Return one flat dict. Raises TypeError for values of other types."""
    if not isinstance(parameters, Mapping):
        raise TypeError("expected dict")
    found: dict[Any, Any] = {}
    for name, value in parameters.items():
        parts = normalize_to_list_of_substitutions(name)
        if _prefix:
            parts = [*_prefix, TextSubstitution(text="."), *parts]
        if isinstance(value, Mapping):
            found.update(normalize_parameter_dict(value, _prefix=parts))
        else:
            found[tuple(parts)] = _value(value)
    return found


def _value(value: Any) -> Any:
    if isinstance(value, (ParameterValue, str, float, bool, int, bytes)):
        return value
    if isinstance(value, Substitution):
        return (value,)
    if isinstance(value, Sequence):
        return _items(value)
    raise TypeError(f"Unexpected type for parameter value {value!r}")


def _items(value: Sequence[Any]) -> tuple[Any, ...]:
    kinds = set()
    for item in value:
        ensure_argument_type(item, (float, int, str, bool, *SomeSubstitutionsType_types_tuple), "subvalue")
        kinds.add(Substitution if isinstance(item, Substitution) else type(item))
    if kinds in ({int}, {bool}):
        return tuple(value)
    if kinds in ({float}, {int, float}):
        return tuple(float(item) for item in value)
    if Substitution in kinds and kinds <= {str, Substitution}:
        return tuple(normalize_to_list_of_substitutions(value))
    # Strings; lists of substitutions, one per item; and mixtures, which are wrong unless YAML reads one type.
    return tuple(
        _as_yaml(item) if isinstance(item, (float, int, str)) else normalize_to_list_of_substitutions(item)
        for item in value
    )


def _as_yaml(item: float | int | str) -> list[Substitution]:
    import yaml

    return [TextSubstitution(text=yaml.safe_dump(item))]
