"""Declaring a node's parameters."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from rclpy.parameter import Parameter
from rclpy.validate_parameter_name import validate_parameter_name

if TYPE_CHECKING:
    from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult

    from rclpy.publisher import Publisher

_NOT_SET = Parameter.Type.NOT_SET
_ONLY_A_NAME = (
    "when declaring parameter named '{}', declaring a parameter only providing its name is deprecated. "
    "You have to either:\n"
    '\t- Pass a name and a default value different to "PARAMETER NOT SET" (and optionally a descriptor).\n'
    "\t- Pass a name and a parameter type.\n"
    "\t- Pass a name and a descriptor with `dynamic_typing=True"
)


class NodeDeclarations:
    """The part of `rclpy.node.Node` that declares and undeclares parameters."""

    _parameters: dict[str, Parameter[Any]]
    _parameter_overrides: dict[str, Parameter[Any]]
    _descriptors: dict[str, Any]
    _parameter_event_publisher: Publisher[Any] | None

    def _set_parameters_atomically_common(
        self,
        parameter_list: list[Parameter[Any]],
        descriptors: dict[str, Any] | None = None,
        allow_not_set_type: bool = False,
    ) -> SetParametersResult:
        raise NotImplementedError

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter[Any]:
        """Declare a parameter and return it with the value it got: from the command line or file, else `value`.

        `value` may be a `Parameter.Type` for a parameter that has no value yet. Raises ParameterAlreadyDeclaredException,
        InvalidParameterException (name), InvalidParameterValueException (refused by range or callback),
        InvalidParameterTypeException (override of another type), TypeError, ValueError.
        """
        entry: tuple[Any, ...] = (name,)
        if value is not None or descriptor is not None:
            entry = (name, value) if descriptor is None else (name, value, descriptor)
        return self.declare_parameters("", [entry], ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Sequence[tuple[Any, ...]], ignore_override: bool = False
    ) -> list[Parameter[Any]]:
        """Declare several parameters, given as tuples (name[, value[, descriptor]]), in a namespace. See `declare_parameter`."""
        declared: list[Parameter[Any]] = []
        descriptors: dict[str, Any] = {}
        for index, entry in enumerate(parameters):
            parameter, descriptor = self._read_declaration(namespace, index, entry, ignore_override)
            declared.append(parameter)
            descriptors[parameter.name] = descriptor
        known = [parameter.name for parameter in declared if parameter.name in self._parameters]
        if known:
            raise ParameterAlreadyDeclaredException(known)
        self._declare_parameter_common(declared, descriptors)
        return [self._parameters[parameter.name] for parameter in declared]

    def _read_declaration(
        self, namespace: str, index: int, entry: tuple[Any, ...], ignore_override: bool
    ) -> tuple[Parameter[Any], Any]:
        from rcl_interfaces.msg import ParameterDescriptor

        if not 1 <= len(entry) <= 3:
            raise TypeError(
                f"Invalid parameter tuple length at index {index} in parameters list: {entry}; "
                "expecting length between 1 and 3"
            )
        name = entry[0]
        if not isinstance(name, str):
            raise TypeError(f"First element {name} at index {index} in parameters list is not a str.")
        if namespace:
            name = f"{namespace}.{name}"
        validate_parameter_name(name)
        value = entry[1] if len(entry) > 1 else None
        descriptor = entry[2] if len(entry) > 2 else ParameterDescriptor()
        if not isinstance(descriptor, ParameterDescriptor):
            raise TypeError(
                f"Third element {descriptor} at index {index} in parameters list is not a ParameterDescriptor."
            )
        if len(entry) == 1:
            # From here: _read_declaration, declare_parameters, declare_parameter; real rclpy's warning names itself too.
            warnings.warn(_ONLY_A_NAME.format(name), stacklevel=1)
            descriptor.dynamic_typing = True
        value = self._fix_type(name, value, descriptor)
        if not ignore_override and name in self._parameter_overrides:
            value = self._parameter_overrides[name].value
        elif _is_parameter_value(value):
            raise ValueError(
                "Cannot declare a Parameter from a ParameterValue without it being included in "
                "self._parameter_overrides, and ",
                "ignore_override=False",
            )
        return Parameter(name, value=value), descriptor

    @staticmethod
    def _fix_type(name: str, value: Any, descriptor: ParameterDescriptor) -> Any:
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
                raise ValueError(
                    "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET"
                )
            descriptor.type = type_
        return value

    def _declare_own_parameter(self, name: str, value: bool, **descriptor: Any) -> None:
        """Declare one of the parameters every node has, without making messages for it if nobody needs them."""
        publisher = self._parameter_event_publisher
        if name in self._parameter_overrides or (publisher is not None and publisher._endpoint_is_heard()):
            from rcl_interfaces.msg import ParameterDescriptor

            self.declare_parameters("", [(name, value, ParameterDescriptor(**descriptor))])
            return
        self._parameters[name] = Parameter(name, Parameter.Type.BOOL, value)
        self._descriptors[name] = {"name": name, "type": Parameter.Type.BOOL.value, **descriptor}

    def _declare_parameter_common(
        self, parameter_list: list[Parameter[Any]], descriptors: dict[str, Any] | None = None
    ) -> list[SetParametersResult]:
        results = []
        for parameter in parameter_list:
            result = self._set_parameters_atomically_common([parameter], descriptors, allow_not_set_type=True)
            if not result.successful:
                if descriptors and result.reason.startswith("Wrong parameter type"):
                    expected = Parameter.Type(descriptors[parameter.name].type).name
                    raise InvalidParameterTypeException(parameter, expected)
                raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)
            results.append(result)
        return results

    def undeclare_parameter(self, name: str) -> None:
        """Forget a parameter. Raises ParameterNotDeclaredException, ParameterImmutableException for a read-only one."""
        if name not in self._parameters:
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self._parameters[name]
        del self._descriptors[name]


def _is_parameter_value(value: object) -> bool:
    return type(value).__name__ == "ParameterValue" and hasattr(value, "integer_array_value")
