"""Checks of a parameter against its descriptor: its type, its range and steps. The texts are rclpy's."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult


def accepted() -> SetParametersResult:
    """Return the result for a parameter that may be set."""
    from rcl_interfaces.msg import SetParametersResult

    return SetParametersResult(successful=True)


def refused(reason: str) -> SetParametersResult:
    """Return the result for a parameter that may not be set."""
    from rcl_interfaces.msg import SetParametersResult

    return SetParametersResult(successful=False, reason=reason)


def refusal_of_type(parameter: Parameter[Any], descriptor: ParameterDescriptor, declared: bool) -> str | None:
    """Return why a parameter's type is wrong, None if it is right; with dynamic typing the descriptor takes on its type."""
    type_ = parameter.type_
    if descriptor.dynamic_typing:
        descriptor.type = type_.value
        return None
    if type_ == Parameter.Type.NOT_SET:
        return "Static parameter cannot be undeclared" if declared else None
    if type_.value != descriptor.type:
        return f"Wrong parameter type, expected '{Parameter.Type(descriptor.type):d}' got '{type_:d}'"
    return None


def refusal_of_range(parameter: Parameter[Any], descriptor: ParameterDescriptor, rel_tol: float) -> str | None:
    """Return why a number is out of range or between two steps, None if it is valid."""
    if parameter.type_ == Parameter.Type.INTEGER and descriptor.integer_range:
        return _refusal_of_integer(parameter, descriptor.integer_range[0])
    if parameter.type_ == Parameter.Type.DOUBLE and descriptor.floating_point_range:
        return _refusal_of_float(parameter, descriptor.floating_point_range[0], rel_tol)
    return None


def _refusal_of_integer(parameter: Parameter[Any], allowed: Any) -> str | None:
    low, high = sorted((allowed.from_value, allowed.to_value))
    value, step = parameter.value, allowed.step
    if value in (low, high):
        return None
    if not low < value < high:
        return f"Parameter {parameter.name} out of range. Min: {low}, Max: {high}, value: {value}"
    if step and (value - low) % step:
        return (
            f"The parameter value for {parameter.name} is not a valid step. "
            f"Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None


def _refusal_of_float(parameter: Parameter[Any], allowed: Any, rel_tol: float) -> str | None:
    low, high = sorted((allowed.from_value, allowed.to_value))
    value, step = parameter.value, allowed.step
    if math.isclose(value, low, rel_tol=rel_tol) or math.isclose(value, high, rel_tol=rel_tol):
        return None
    if not low < value < high:
        return f"Parameter {parameter.name} out of range Min: {low}, Max: {high}, value: {value}"
    if step and not math.isclose(low + round((value - low) / step) * step, value, rel_tol=rel_tol):
        return (
            f"The parameter value for {parameter.name} is not close enough to a valid step. "
            f"Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None
