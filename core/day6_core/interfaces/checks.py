"""Checks the values of fields, with the AssertionError texts of rosidl_generator_py.

Setters of the generated classes accept the usual valid values themselves; everything else is checked here: valid values of
unusual types (a tuple, a UserList, numpy.float64) and invalid ones. Real ROS checks always in Humble, and from Iron on only if
ROS_PYTHON_CHECK_FIELDS=1 or `check_fields=True`. day6-tui is for learners and checks unless ROS_PYTHON_CHECK_FIELDS=0; but where
real ROS would not check, numeric arrays take all that `array.array` and `numpy.array` take there.
"""

from __future__ import annotations

import os
from _collections_abc import Sequence, Set
from array import array

from day6_core.interfaces.fields import ARRAY, SINGLE, UNBOUNDED, FieldType
from day6_core.ros import differences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

IS_OPTION: bool = differences.value("messages.check_fields") == "option"
"""Whether a message can be told not to check; in Humble it has no such slot and only `python -O` turns the checks off."""
TEACHING = 1
"""The `_check_fields` of messages that nobody asked to be checked: true, and not True."""
CHECK_FIELDS: bool | int = (
    {"0": False, "1": True}.get(os.environ.get("ROS_PYTHON_CHECK_FIELDS", ""), TEACHING) if IS_OPTION else __debug__
)
"""The `_check_fields` of new messages; read once at import, as in real ROS."""
WARNS_OF_SETS: bool = differences.value("messages.sets") == "deprecated"
KEEPS_WHAT_FITS: bool = differences.value("messages.keep_what_fits")
_SEQUENCE = "sequence" if WARNS_OF_SETS else "a set or sequence"


def warn_of_set() -> None:
    """Say what newer distributions say of a set for an array field."""
    from warnings import warn

    text = "Using set or subclass of set is deprecated, please use a subclass of collections.abc.Sequence like list"
    warn(text, DeprecationWarning, stacklevel=2)


def slot_lines(message: str) -> list[str]:
    """Return the line of generated code that tells a new message whether it checks, none where it has no such slot."""
    return [f"{message}._check_fields = check"] if IS_OPTION else []


def check_arguments(message: Any, arguments: dict[str, Any]) -> None:
    """Apply a constructor's `check_fields` argument, then check that all other names are fields (if checks are on).

    Raises:
        AssertionError: a name is not a field.
    """
    if IS_OPTION and "check_fields" in arguments:
        message._check_fields = arguments["check_fields"]
    if message._check_fields:
        unknown = sorted(name for name in arguments if "_" + name not in message.__slots__)
        if unknown:
            raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(unknown)}")


def check_value(type_: FieldType, name: str, value: Any, element: type | None) -> None:
    """Check the value of a field that isn't a numeric array; `element` is the class of a nested message.

    Raises:
        AssertionError: the value does not fit.
    """
    if type_.count == SINGLE:
        _check_single(type_, name, value, element)
    else:
        _check_collection(type_, name, value, element)


def _check_single(type_: FieldType, name: str, value: Any, element: type | None) -> None:
    primitive = type_.primitive
    if element is not None:
        if not isinstance(value, element):
            raise AssertionError(f"The '{name}' field must be a sub message of type '{element.__name__}'")
    elif primitive is None:
        if type_.string_bound:
            from collections import UserString

            if not isinstance(value, (str, UserString)) or len(value) > type_.string_bound:
                raise AssertionError(f"The '{name}' field must be string value not longer than {type_.string_bound}")
        elif not isinstance(value, str):
            raise AssertionError(f"The '{name}' field must be of type 'str'")
    elif primitive.python is bytes:
        if not isinstance(value, (bytes, bytearray)) or len(value) != 1:
            raise AssertionError(f"The '{name}' field must be of type 'bytes' or 'ByteString' with length 1")
    else:
        if not isinstance(value, primitive.python):
            raise AssertionError(f"The '{name}' field must be of type '{primitive.python.__name__}'")
        if primitive.python is not bool and not _in_range(type_, value):
            if primitive.python is int:
                sign = "an integer" if primitive.low else "an unsigned integer"
                raise AssertionError(f"The '{name}' field must be {sign} in [{primitive.low}, {primitive.high}]")
            raise AssertionError(
                f"The '{name}' field must be a {primitive.idl} in [-{primitive.high}, {primitive.high}]"
            )


def _in_range(type_: FieldType, value: Any) -> bool:
    primitive = type_.primitive
    assert primitive is not None
    if primitive.python is int:
        return bool(primitive.low <= value <= primitive.high)
    # Written so that NaN passes, as in the real checks.
    return not (value < -primitive.high or value > primitive.high) or value in (float("inf"), float("-inf"))


def _check_collection(type_: FieldType, name: str, value: Any, element: type | None) -> None:
    primitive = type_.primitive
    python = element if element is not None else str if primitive is None else primitive.python
    assert python is not None
    if not _is_collection(value) or not _length_fits(type_, len(value)) or not _elements_fit(type_, value, python):
        raise AssertionError(_collection_text(type_, name, python))


def _is_collection(value: Any) -> bool:
    if isinstance(value, str) or not isinstance(value, (Sequence, Set)):
        return False
    from collections import UserString

    return not isinstance(value, UserString)


def _length_fits(type_: FieldType, length: int) -> bool:
    return type_.count == UNBOUNDED or (length == type_.size if type_.count == ARRAY else length <= type_.size)


def _elements_fit(type_: FieldType, value: Any, python: type) -> bool:
    if not all(isinstance(item, python) for item in value):
        return False
    if type_.string_bound:
        return all(len(item) <= type_.string_bound for item in value)
    if python is int or python is float:
        return all(_in_range(type_, item) for item in value)
    return True


def _collection_text(type_: FieldType, name: str, python: type) -> str:
    text = f"The '{name}' field must be {_SEQUENCE}"
    if type_.count != UNBOUNDED:
        text += f" with length {'' if type_.count == ARRAY else '<= '}{type_.size}"
    text += f" and each value of type '{python.__name__}'"
    primitive = type_.primitive
    if python is int and primitive is not None:
        text += f" and each {'integer' if primitive.low else 'unsigned integer'} in [{primitive.low}, {primitive.high}]"
    elif python is float and primitive is not None:
        text += f" and each {primitive.idl} in [{-primitive.high:f}, {primitive.high:f}]"
    elif type_.string_bound:
        text += f" and each string value not longer than {type_.string_bound}"
    return text


def checked_array(type_: FieldType, name: str, value: Any, check: bool | int) -> Any:
    """Return the array.array that a numeric sequence field stores; `check` is the message's `_check_fields`.

    Raises:
        AssertionError: the value does not fit.
        TypeError: as raised by array().
    """
    primitive = type_.primitive
    assert primitive is not None
    code = primitive.code
    if isinstance(value, array) and (check is True or value.typecode == code):
        if value.typecode != code:
            raise AssertionError(f"The '{name}' array.array() must have the type code of '{code}'")
        if not _length_fits(type_, len(value)):
            raise AssertionError(f"The '{name}' array.array() must have a size <= {type_.size}")
        return value if check is True or KEEPS_WHAT_FITS else array(code, value)
    kind = type(value)
    plain = (kind is bytes or kind is bytearray) and code == "B"
    if not plain and (kind is list or kind is tuple):
        plain = _all_plain(type_, value)
    if not plain or not _length_fits(type_, len(value)):
        if check is not True and (made := _made(array, code, value)) is not None and _length_fits(type_, len(made)):
            return made
        _check_collection(type_, name, value, None)
    return array(code, value)


def _made(maker: Callable[[Any, Any], Any], *arguments: Any) -> Any:
    """Return the array that a value makes, None if it makes none."""
    try:
        return maker(*arguments)
    except (TypeError, ValueError, OverflowError):
        return None


def _all_plain(type_: FieldType, values: list[Any] | tuple[Any, ...]) -> bool:
    """Return quickly whether all values certainly fit; False only means that the slow check must decide."""
    primitive = type_.primitive
    assert primitive is not None
    if not values:
        return True
    if set(map(type, values)) != {primitive.python}:
        return False
    if primitive.code == "d":
        return True
    # A leading NaN makes both comparisons false and leads to the slow check; elsewhere min and max ignore it.
    low = -primitive.high if primitive.code == "f" else primitive.low
    return bool(min(values) >= low and max(values) <= primitive.high)


def checked_ndarray(type_: FieldType, name: str, value: Any, check: bool | int) -> Any:
    """Return the numpy.ndarray, of shape (size,), that a fixed numeric array field stores; `check` as for `checked_array`.

    Raises:
        AssertionError: the value does not fit.
    """
    import numpy

    primitive = type_.primitive
    assert primitive is not None
    dtype = getattr(numpy, primitive.numpy)
    if isinstance(value, numpy.ndarray) and (check is True or value.dtype == dtype):
        if value.dtype != dtype:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have the dtype of 'numpy.{primitive.numpy}'")
        if value.size != type_.size:
            raise AssertionError(f"The '{name}' numpy.ndarray() must have a size of {type_.size}")
        return value if check is True else numpy.array(value)
    if check is not True and (made := _made(numpy.array, value, dtype)) is not None and made.size == type_.size:
        return made
    _check_collection(type_, name, value, None)
    return numpy.array(value, dtype=dtype)
