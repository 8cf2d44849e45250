"""Parameters: a name, a type and a value."""

from __future__ import annotations

import array
from collections.abc import Iterable
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Final, Generic, Literal, TypeVar, overload

from rclpy._day6.incidental import also
from rclpy._day6.withdrawn import withdraw

if TYPE_CHECKING:
    from rcl_interfaces.msg import Parameter as ParameterMsg
    from rcl_interfaces.msg import ParameterValue

PARAMETER_SEPARATOR_STRING: Final = "."

__all__ = [
    "PARAMETER_SEPARATOR_STRING",
    "AllowableParameterValue",
    "AllowableParameterValueT",
    "Parameter",
    "ParameterMsg",
    "ParameterType",  # noqa: F822 made when asked for
    "ParameterValue",
    "get_parameter_value",
    "parameter_dict_from_yaml_file",
    "parameter_value_to_python",
]

if TYPE_CHECKING:
    AllowableParameterValue = (
        bool
        | int
        | float
        | str
        | list[bytes]
        | tuple[bytes, ...]
        | list[bool]
        | tuple[bool, ...]
        | list[int]
        | tuple[int, ...]
        | array.array[int]
        | list[float]
        | tuple[float, ...]
        | array.array[float]
        | list[str]
        | tuple[str, ...]
        | None
    )
else:
    AllowableParameterValue = Any
AllowableParameterValueT = TypeVar("AllowableParameterValueT", bound="AllowableParameterValue")

# Made on first use, as many programs never need these messages.
_MESSAGES = {"ParameterMsg": "Parameter", "ParameterType": "ParameterType", "ParameterValue": "ParameterValue"}

_also = also(__name__)


def __getattr__(name: str) -> Any:
    if name in _MESSAGES:
        import rcl_interfaces.msg

        value = globals()[name] = getattr(rcl_interfaces.msg, _MESSAGES[name])
        return value
    return _also(name)


class Parameter(Generic[AllowableParameterValueT]):
    """A named value of a node.

    `type_` is inferred from `value` if it is not given.

    Raises:
        TypeError: for a value no parameter can have.
        ValueError: if value and type do not match.
    """

    class Type(IntEnum):
        """The types a parameter can have; numbers of rcl_interfaces/msg/ParameterType."""

        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, parameter_value: object) -> Parameter.Type:
            """Return the type of a Python value. An empty list is a BYTE_ARRAY.

            Raises:
                TypeError: if there is none.
            """
            if parameter_value is None:
                return cls.NOT_SET
            for python_type, type_ in _SCALARS:
                if isinstance(parameter_value, python_type):
                    return cls(type_)
            if not isinstance(parameter_value, (list, tuple, array.array)):
                raise TypeError(f"The given value is not one of the allowed types '{parameter_value}'.")
            for python_type, type_ in _ELEMENTS:
                if _all(parameter_value, python_type):
                    return cls(type_)
            raise TypeError(f"The given value is not a list of one of the allowed types '{parameter_value}'.")

        def check(self, parameter_value: object) -> bool:
            """Return whether a Python value can be a parameter of this type."""
            if self == Parameter.Type.NOT_SET:
                return parameter_value is None
            for python_type, type_ in _SCALARS:
                if self == type_:
                    return isinstance(parameter_value, python_type)
            element = next(python_type for python_type, type_ in _ELEMENTS if self == type_)
            numeric = self in (Parameter.Type.INTEGER_ARRAY, Parameter.Type.DOUBLE_ARRAY)
            if not isinstance(parameter_value, (list, tuple, array.array) if numeric else (list, tuple)):
                return False
            if not _all(parameter_value, element):
                return False
            return self != Parameter.Type.BYTE_ARRAY or all(len(each) == 1 for each in parameter_value)

    @classmethod
    def from_parameter_msg(cls, param_msg: ParameterMsg) -> Parameter[Any]:
        """Convert an rcl_interfaces/Parameter message."""
        type_ = Parameter.Type(param_msg.value.type)
        field = _FIELDS.get(type_)
        return cls(param_msg.name, type_, None if field is None else getattr(param_msg.value, field))

    @overload
    def __init__(self: Parameter[None], name: str, type_: Literal[Parameter.Type.NOT_SET] | None = None) -> None: ...

    @overload
    def __init__(self, name: str, type_: Parameter.Type | None = None, *, value: AllowableParameterValueT) -> None: ...

    @overload
    def __init__(self, name: str, type_: Parameter.Type | None, value: AllowableParameterValueT) -> None: ...

    def __init__(self, name: str, type_: Parameter.Type | None = None, value: AllowableParameterValue = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{Parameter.Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._type_ = type_
        self._name = name
        self._value: AllowableParameterValueT = value  # type: ignore[assignment]

    @property
    def name(self) -> str:
        """Full name, with the parts separated by dots."""
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        """The type."""
        return self._type_

    @property
    def value(self) -> AllowableParameterValueT:
        """The value; None for NOT_SET."""
        return self._value

    def get_parameter_value(self) -> ParameterValue:
        """Return the value as an rcl_interfaces/ParameterValue message."""
        from rcl_interfaces.msg import ParameterValue

        message = ParameterValue(type=self._type_.value)
        field = _FIELDS.get(self._type_)
        if field is not None:
            setattr(message, field, self._value)
        return message

    def to_parameter_msg(self) -> ParameterMsg:
        """Return name and value as an rcl_interfaces/Parameter message."""
        from rcl_interfaces.msg import Parameter as ParameterMsg

        return ParameterMsg(name=self._name, value=self.get_parameter_value())


_SCALARS: tuple[tuple[type, int], ...] = ((bool, 1), (int, 2), (float, 3), (str, 4))
_ELEMENTS: tuple[tuple[type, int], ...] = ((bytes, 5), (bool, 6), (int, 7), (float, 8), (str, 9))
_FIELDS = {
    Parameter.Type.BOOL: "bool_value",
    Parameter.Type.INTEGER: "integer_value",
    Parameter.Type.DOUBLE: "double_value",
    Parameter.Type.STRING: "string_value",
    Parameter.Type.BYTE_ARRAY: "byte_array_value",
    Parameter.Type.BOOL_ARRAY: "bool_array_value",
    Parameter.Type.INTEGER_ARRAY: "integer_array_value",
    Parameter.Type.DOUBLE_ARRAY: "double_array_value",
    Parameter.Type.STRING_ARRAY: "string_array_value",
}


def _all(values: Iterable[Any], python_type: type) -> bool:
    return all(isinstance(value, python_type) for value in values)


def get_parameter_value(string_value: str) -> ParameterValue:
    """Return the value that YAML reads from a text; anything that can't be a parameter's value stays a string."""
    import yaml
    from rcl_interfaces.msg import ParameterValue

    try:
        value = yaml.safe_load(string_value)
    except yaml.parser.ParserError:
        value = string_value
    if value is None or isinstance(value, dict):
        value = string_value if value is None else value
        return ParameterValue(type=Parameter.Type.STRING.value, string_value=value)
    if isinstance(value, list):
        fitting = next((type_ for python_type, type_ in _ELEMENTS[1:] if _all(value, python_type)), None)
        if fitting is None:
            return ParameterValue(type=Parameter.Type.STRING.value, string_value=string_value)
        return ParameterValue(type=fitting, **{_FIELDS[Parameter.Type(fitting)]: value})
    type_ = next((type_ for python_type, type_ in _SCALARS if isinstance(value, python_type)), 4)
    return ParameterValue(type=type_, **{_FIELDS[Parameter.Type(type_)]: value})


def parameter_value_to_python(parameter_value: ParameterValue) -> AllowableParameterValue:
    """Return the Python value of an rcl_interfaces/ParameterValue message.

    Raises:
        RuntimeError: for an unknown type.
    """
    try:
        type_ = Parameter.Type(parameter_value.type)
    except ValueError:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}") from None
    if type_ == Parameter.Type.NOT_SET:
        return None
    value = getattr(parameter_value, _FIELDS[type_])
    return list(value) if type_ >= Parameter.Type.BYTE_ARRAY else value


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: list[str] | None = None,
    namespace: str = "",
) -> dict[str, ParameterMsg]:
    """Read a parameter file and return the parameters (as messages, by name) of some nodes.

    `use_wildcard` adds those under `/**`; `namespace` is put before every name.

    Raises:
        RuntimeError: if the file has nothing for these nodes or isn't a parameter file.
    """
    from rclpy._day6.parameter_files import parameters_of_nodes

    return parameters_of_nodes(parameter_file, use_wildcard, target_nodes, namespace)


withdraw(__name__)
