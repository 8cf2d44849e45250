"""Evaluates normalized parameters in a running launch."""

from __future__ import annotations

import pathlib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from launch.substitution import Substitution
from launch.utilities import ensure_argument_type, perform_substitutions

from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_ADVICE = (
    "If the parameter is meant to be a string, try wrapping it in "
    "launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
)
_UNIFORM = (
    "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, float, str. "
    'Got inconsistent input for "{}"'
)
_ALLOWED = (
    "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], Sequence[float], Sequence[str]. "
    'Got {} for "{}". '
) + _ADVICE


def evaluate_parameters(context: LaunchContext, parameters: Any) -> tuple[Any, ...]:
    """Return paths of files, dicts, and `Parameter`s."""
    found: list[Any] = []
    for each in parameters:
        if isinstance(each, ParameterFile):
            path: pathlib.Path = each.evaluate(context)
            found.append(path)
        elif isinstance(each, Parameter):
            found.append(each)
        elif isinstance(each, Mapping):
            found.append(evaluate_parameter_dict(context, each))
    return tuple(found)


def evaluate_parameter_dict(context: LaunchContext, parameters: Any) -> dict[str, Any]:
    """Return `{name: value}`. Raises TypeError for a text that isn't a valid parameter value."""
    if not isinstance(parameters, Mapping):
        raise TypeError("expected dict")
    found = {}
    for name, value in parameters.items():
        if not isinstance(name, tuple):
            raise TypeError(f"Expecting tuple of substitutions got {name!r}")
        evaluated = perform_substitutions(context, name)
        found[evaluated] = _evaluated(context, evaluated, value)
    return found


def _evaluated(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if not isinstance(value, tuple) or not value:
        ensure_argument_type(value, (float, int, str, bool, bytes), "value")
        return value
    if isinstance(value[0], Substitution):
        return _from_text(perform_substitutions(context, value), name)
    if isinstance(value[0], list):
        return _checked([_yaml(perform_substitutions(context, item), name) for item in value], name)
    return value


def _from_text(text: str, name: str) -> Any:
    value = _yaml(text, name) if text else ""
    if type(value) in (bool, int, float, str, bytes):
        return value
    if isinstance(value, Sequence):
        return _checked(value, name)
    raise TypeError(_ALLOWED.format(type(value), name))


def _yaml(text: str, name: str) -> Any:
    import yaml

    try:
        return yaml.safe_load(text)
    except yaml.YAMLError:
        raise TypeError(f"Unable to parse the value of parameter {name} as yaml. {_ADVICE}") from None


def _checked(values: Sequence[Any], name: str) -> tuple[Any, ...]:
    kind = type(values[0]) if values else None
    if kind not in (bool, int, float, str) or not all(isinstance(each, kind) for each in values):
        raise TypeError(_UNIFORM.format(name))
    return tuple(values)
