"""The parameters of a C++ node: rclcpp's rules and refusals (rclcpp/node_interfaces/node_parameters.cpp)."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rclcpp.exceptions import ParameterNotDeclared, RclcppException
from rclpy._day6.parameter_rules import accepted, refused
from rclpy._day6.parameter_store import ParameterStore
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.parameter import Parameter
from rclpy.parameter_service import ParameterService

if TYPE_CHECKING:
    from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, SetParametersResult

_NOT_SET = Parameter.Type.NOT_SET

TYPE_NAMES = {
    0: "not set",
    1: "bool",
    2: "integer",
    3: "double",
    4: "string",
    5: "byte_array",
    6: "bool_array",
    7: "integer_array",
    8: "double_array",
    9: "string_array",
}
"""rclcpp::to_string(ParameterType), by the numbers of ParameterType."""


class CppParameterStore(ParameterStore):
    """Parameters as rclcpp keeps them: sorted by name, with one type for life unless declared with `dynamic_typing`."""

    # -- declaring -----------------------------------------------------------------------------------------------------

    def _declare(self, parameter: Parameter[Any], descriptors: Mapping[str, ParameterDescriptor]) -> None:
        name = parameter.name
        if parameter.type_ == _NOT_SET:
            descriptor = descriptors[name]
            descriptor.name = name
            self._keep([parameter], descriptors)
            self._tell([], [], [])
            return
        result = self._set_checked([parameter], descriptors)
        if result.successful:
            return
        if result.reason.startswith("Wrong parameter type"):
            what = f"parameter '{name}' has invalid type: {result.reason}"
            raise RclcppException(what, "InvalidParameterTypeException")
        what = f"parameter '{name}' could not be set: {result.reason}"
        raise RclcppException(what, "InvalidParameterValueException")

    def _tell(self, *lists: list[Parameter[Any]]) -> None:
        if self._listener is not None and self._listener.has_subscribers():
            self._listener.changed(*lists)

    # -- getting -------------------------------------------------------------------------------------------------------

    def by_prefix(self, prefix: str) -> dict[str, Parameter[Any]]:
        """Return the parameters below a prefix, by their names without it, sorted; '' means all."""
        return dict(sorted(super().by_prefix(prefix).items()))

    def names_below(self, prefixes: list[str], depth: int) -> ListParametersResult:
        """Return names and prefixes of parameters below some prefixes (none: all), down to a depth (0: any), sorted."""
        result = super().names_below(prefixes, depth)
        names = sorted(result.names)
        result.names = names
        result.prefixes = list(dict.fromkeys(name.rpartition(".")[0] for name in names if "." in name))
        return result

    def describe(self, name: str) -> ParameterDescriptor:
        """Return a parameter's descriptor; one with only the name for an undeclared one, where such are allowed."""
        descriptor = super().describe(name)
        descriptor.name = name
        return descriptor

    # -- setting -------------------------------------------------------------------------------------------------------

    def set_atomically(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        """Set all parameters or none; the result has the reason. Raises ParameterNotDeclared."""
        for callback in self.pre_set_callbacks:
            parameters = callback(parameters)
        if not parameters:
            return refused(
                "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying "
                "the original parameters list."
            )
        for parameter in parameters:
            name = parameter.name
            if not name:
                raise RclcppException("parameter name must not be empty", "InvalidParametersException")
            if name not in self.parameters:
                if not self.allow_undeclared:
                    raise ParameterNotDeclared(name)
            elif self.descriptors[name].read_only:
                return refused(f"parameter '{name}' cannot be set because it is read-only")
        if any(self._is_deletion(each) and not self.descriptors[each.name].dynamic_typing for each in parameters):
            return refused("cannot undeclare a statically typed parameter")
        return self._set_checked(parameters)

    def _is_deletion(self, parameter: Parameter[Any]) -> bool:
        known = self.parameters.get(parameter.name)
        return parameter.type_ == _NOT_SET and known is not None and known.type_ != _NOT_SET

    def _obeys(
        self, parameter: Parameter[Any], descriptor: ParameterDescriptor, check_read_only: bool
    ) -> SetParametersResult:
        if not descriptor.dynamic_typing and descriptor.type != parameter.type_.value:
            return refused(
                f"Wrong parameter type, parameter {{{parameter.name}}} is of type {{{TYPE_NAMES[descriptor.type]}}}, "
                f"setting it to {{{TYPE_NAMES[parameter.type_]}}} is not allowed."
            )
        kind = _range_left(parameter, descriptor)
        if kind:
            return refused(f"Parameter {{{parameter.name}}} doesn't comply with {kind} range.")
        return accepted()

    def _keep(
        self, parameters: list[Parameter[Any]], declared: Mapping[str, ParameterDescriptor] | None
    ) -> tuple[list[Parameter[Any]], list[Parameter[Any]], list[Parameter[Any]]]:
        """Store parameters; returns which are new, changed and deleted. Only one with a value is deleted by having none."""
        new: list[Parameter[Any]] = []
        changed: list[Parameter[Any]] = []
        deleted: list[Parameter[Any]] = []
        for parameter in parameters:
            name = parameter.name
            if declared is None and self._is_deletion(parameter):
                deleted.append(parameter)
                del self.parameters[name], self.descriptors[name]
                continue
            if declared is not None:
                self.descriptors[name] = declared[name]
            if name in self.parameters:
                changed.append(parameter)
            else:
                if declared is None:
                    self.descriptors.update({name: {"dynamic_typing": True}})
                if parameter.type_ != _NOT_SET:
                    new.append(parameter)
            self.parameters[name] = parameter
            descriptor = self.descriptors[name]
            descriptor.name = name
            if descriptor.dynamic_typing:
                descriptor.type = parameter.type_.value
        return new, changed, deleted


def _range_left(parameter: Parameter[Any], descriptor: ParameterDescriptor) -> str:
    """Return which range a value is outside of, or between two steps of: 'integer', 'floating point', '' for none."""
    value = parameter.value
    if parameter.type_ == Parameter.Type.INTEGER and descriptor.integer_range:
        allowed = descriptor.integer_range[0]
        if value in (allowed.from_value, allowed.to_value):
            return ""
        inside = allowed.from_value <= value <= allowed.to_value
        fits = inside and (not allowed.step or (value - allowed.from_value) % allowed.step == 0)
        return "" if fits else "integer"
    if parameter.type_ == Parameter.Type.DOUBLE and descriptor.floating_point_range:
        floating = descriptor.floating_point_range[0]
        if _equal(value, floating.from_value) or _equal(value, floating.to_value):
            return ""
        inside = floating.from_value <= value <= floating.to_value
        return "" if inside and (not floating.step or _is_on_step(value, floating)) else "floating point"
    return ""


def _is_on_step(value: float, allowed: Any) -> bool:
    steps = round((value - allowed.from_value) / allowed.step)
    return _equal(value, allowed.from_value + steps * allowed.step)


def _equal(one: float, other: float) -> bool:
    """Return whether two doubles are as good as equal to rclcpp: a hundred units in the last place apart."""
    return abs(one - other) <= sys.float_info.epsilon * abs(one + other) * 100


class CppParameterService(ParameterService):
    """The parameter services of a C++ node (rclcpp/parameter_service.cpp)."""

    def _set_parameters_atomically_callback(self, request: Any, response: Any) -> Any:
        try:
            parameters = [Parameter.from_parameter_msg(each) for each in request.parameters]
            response.result = self._get_node().set_parameters_atomically(parameters)
        except ParameterNotDeclaredException:
            response.result = refused("One or more parameters were not declared before setting")
        return response
