"""Declarations of parameters, (name[, value[, descriptor]]), checked and completed as in rclpy/node.py."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from day6_core.ros import differences
from rclpy.parameter import Parameter
from rclpy.validate_parameter_name import validate_parameter_name

if TYPE_CHECKING:
    from typing import TypeAlias

    from rcl_interfaces.msg import ParameterDescriptor, ParameterValue

    from rclpy.parameter import AllowableParameterValue

    ParameterInput: TypeAlias = AllowableParameterValue | Parameter.Type | ParameterValue
    ParameterTuple: TypeAlias = (
        tuple[str] | tuple[str, ParameterInput] | tuple[str, ParameterInput, ParameterDescriptor]
    )

_NOT_SET = Parameter.Type.NOT_SET
_ONLY_A_NAME = (
    "when declaring parameter named '{}', declaring a parameter only providing its name is deprecated. "
    "You have to either:\n"
    '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
    "\t- Pass a name and a parameter type.\n"
    "\t- Pass a name and a descriptor with `dynamic_typing=True"
)


def declared_parameter(
    namespace: str, index: int, entry: ParameterTuple, overrides: Mapping[str, Parameter[Any]]
) -> tuple[Parameter[Any], ParameterDescriptor]:
    """Return the parameter declared by an entry of `declare_parameters`, with the value of its override if it has one.

    Raises InvalidParameterException (name), TypeError and ValueError (value or descriptor).
    """
    from rcl_interfaces.msg import ParameterDescriptor

    if not 1 <= len(entry) <= 3:
        raise TypeError(
            f"Invalid parameter tuple length at index {index} in parameters list: {entry}; "
            "expecting length between 1 and 3"
        )
    name: object = entry[0]
    if not isinstance(name, str):
        raise TypeError(f"First element {name} at index {index} in parameters list is not a str.")
    if namespace:
        name = f"{namespace}.{name}"
    validate_parameter_name(name)
    value = entry[1] if len(entry) > 1 else None
    descriptor = entry[2] if len(entry) > 2 else ParameterDescriptor()
    if not isinstance(descriptor, ParameterDescriptor):
        raise TypeError(f"Third element {descriptor} at index {index} in parameters list is not a ParameterDescriptor.")
    if len(entry) == 1:
        if differences.value("parameters.need_more_than_a_name"):
            raise TypeError(_ONLY_A_NAME.format(name))
        # Real rclpy's warning names its own line too.
        warnings.warn(_ONLY_A_NAME.format(name), stacklevel=1)
        descriptor.dynamic_typing = True
    value = _with_type(name, value, descriptor)
    if name in overrides:
        value = overrides[name].value
    elif _is_parameter_value(value):
        raise ValueError(
            "Cannot declare a Parameter from a ParameterValue without it being included in "
            "self._parameter_overrides, and ",
            "ignore_override=False",
        )
    return Parameter(name, value=value), descriptor


def _with_type(name: str, value: Any, descriptor: ParameterDescriptor) -> Any:
    """Put the declared type into the descriptor; returns the value, None for a bare type."""
    if isinstance(value, Parameter.Type):
        if value == _NOT_SET:
            raise ValueError(f"Cannot declare parameter {{{name}}} as statically typed of type NOT_SET")
        if descriptor.dynamic_typing:
            raise ValueError(
                f"When declaring parameter {{{name}}} passing a descriptor with"
                "`dynamic_typing=True` is not allowed when the parameter type is provided"
            )
        descriptor.type = value.value
        return None
    if not descriptor.dynamic_typing:
        type_ = value.type if _is_parameter_value(value) else Parameter.Type.from_parameter_value(value).value
        if type_ == _NOT_SET:
            raise ValueError("Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET")
        descriptor.type = type_
    return value


def _is_parameter_value(value: object) -> bool:
    return type(value).__name__ == "ParameterValue" and hasattr(value, "integer_array_value")
