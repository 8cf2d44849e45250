"""The exceptions of rclpy, with its texts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._day6.incidental import also
from rclpy._rclpy_pybind11 import InvalidHandle as InvalidHandle
from rclpy._rclpy_pybind11 import TimerCancelledError as TimerCancelledError

if TYPE_CHECKING:
    from rclpy.parameter import Parameter


__getattr__ = also(__name__)


class NotInitializedException(Exception):
    """Something needs an initialised context and there is none."""

    def __init__(self, message: str | None = None) -> None:
        super().__init__("rclpy.init() has not been called." + (f" msg:{message}" if message else ""))


class NoTypeSupportImportedException(Exception):
    """A type has no type support."""

    def __init__(self) -> None:
        super().__init__("no type_support imported")


class NameValidationException(Exception):
    """A name breaks the rules of ROS names; the text has a caret under the offending character."""

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n   {' ' * invalid_index}^")


class InvalidNamespaceException(NameValidationException):
    """A namespace is invalid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node name is invalid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic name is invalid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service name is invalid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class ParameterException(Exception):
    """Base of the exceptions about parameters."""

    def __init__(self, error_msg: str, parameters: object) -> None:
        super().__init__(f"{error_msg}: {parameters}")


class ParameterNotDeclaredException(ParameterException):
    """An undeclared parameter was used."""

    def __init__(self, parameters: str | list[str]) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared a second time."""

    def __init__(self, parameters: str | list[str]) -> None:
        super().__init__("Parameter(s) already declared", parameters)


class InvalidParameterException(ParameterException):
    """A parameter's name is invalid."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Invalid parameter name", parameter_name)


class InvalidParameterTypeException(ParameterException):
    """A parameter was declared with one type and given a value of another."""

    def __init__(self, desired_parameter: Parameter[Any], expected_type: str) -> None:
        from rclpy.parameter import Parameter

        value = desired_parameter.value
        type_name = Parameter.Type.from_parameter_value(value).name
        super().__init__(
            f"Trying to set parameter '{desired_parameter.name}' to '{value}' of type '{type_name}', "
            f"expecting type '{expected_type}'",
            desired_parameter.name,
        )


class InvalidParameterValueException(ParameterException):
    """A value was refused, by a range or by a callback of the program."""

    def __init__(self, parameter: str, value: object, reason: str) -> None:
        super().__init__(f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter)


class ParameterImmutableException(ParameterException):
    """A program tried to change a read-only parameter."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter_name)


class ParameterUninitializedException(ParameterException):
    """A parameter that was declared by type alone has no value yet."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name)


class ROSInterruptException(Exception):
    """A sleep ended because of a shutdown."""

    def __init__(self) -> None:
        super().__init__("rclpy.shutdown() has been called")


class TimeSourceChangedError(Exception):
    """Simulated time was switched on or off while somebody slept (Lyrical)."""

    def __init__(self) -> None:
        super().__init__("Time source changed")
