"""Builds the Python class of a message, with all attributes that rosidl_generator_py generates.

The class is made from generated source, specialised per field: the constructor fills slots directly, setters accept the usual
valid value after one test and leave the rest to `checks`. Copying and CDR are generated separately, on first use.
"""

from __future__ import annotations

from _collections_abc import Set
from array import array
from keyword import iskeyword
from operator import attrgetter

from day6_core.interfaces import checks
from day6_core.interfaces.construct import constructor_lines, default_source, uses_numpy
from day6_core.interfaces.definition import Constant, Field, InvalidSpecification, Structure
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class InterfaceType(type):
    """The common metaclass of all interface classes; `_interface_name` is like 'std_msgs/msg/String'."""

    _interface_name: str = ""
    _structure: Structure | None = None

    # As real metaclasses have; some programs call __import_type_support__ themselves. Nothing is imported here.
    _TYPE_SUPPORT: object = None

    @classmethod
    def __import_type_support__(mcs) -> None:
        mcs._TYPE_SUPPORT = mcs._interface_name


def module_name(package: str, kind: str, name: str) -> str:
    """Return the module of the real class of that name: 'std_msgs.msg._color_rgba' for ColorRGBA."""
    return f"{package}.{kind}._{snake_case(name.partition('_')[0])}"


def snake_case(name: str) -> str:
    """Return 'tf_message' for 'TFMessage', 'u_int8' for 'UInt8', 'pose2_d' for 'Pose2D', as rosidl does."""
    words = []
    for index, char in enumerate(name):
        if index and char.isupper():
            before, after = name[index - 1], name[index + 1 : index + 2]
            if after.islower() or before.islower() or before.isdigit():
                words.append("_")
        words.append(char.lower())
    return "".join(words)


class _Numpy:
    """Stands for numpy in generated code and imports it when the first array is created, not with the class."""

    def __getattr__(self, name: str) -> Any:
        import numpy

        value = getattr(numpy, name)
        setattr(self, name, value)
        return value


_numpy = _Numpy()


def build_message(structure: Structure, find_class: Callable[[str], type]) -> type:
    """Return the class of a structure. `find_class` returns the class of a nested message by its full name.

    Raises:
        InvalidSpecification: the name of a field is a Python keyword.
    """
    for field in structure.fields:
        if iskeyword(field.name):
            raise InvalidSpecification(f"'{field.name}' is a Python keyword and can not be the name of a field")
    constants = {constant.name: python_constant(constant) for constant in structure.constants}
    elements = {field.name: find_class(field.type.base) for field in structure.fields if field.type.nested}
    names: dict[str, Any] = {
        "new": object.__new__,
        "inf": float("inf"),  # repr's names for these defaults
        "nan": float("nan"),
        "numpy": _numpy,
        "array": array,
        "check": checks.CHECK_FIELDS,
        "check_arguments": checks.check_arguments,
        "check_value": checks.check_value,
        "warn_of_set": checks.warn_of_set,
        "Set": Set,
        "checked_array": checks.checked_array,
        "checked_ndarray": checks.checked_ndarray,
    }
    lines = constructor_lines(structure, find_class, names)
    defaults: dict[str, Any] = {}
    for field in structure.fields:
        lines += _setter_lines(field)
        names[f"T_{field.name}"] = field.type
        names[f"E_{field.name}"] = elements.get(field.name)
        if field.default is not None:
            defaults[f"{field.name.upper()}__DEFAULT"] = eval(default_source(field), names)
    lines += _equality_lines(structure)
    exec(compile("\n".join(lines), f"<{structure.full_name}>", "exec"), names)

    namespace: dict[str, Any] = {
        "__module__": module_name(structure.package, structure.kind, structure.name),
        "__doc__": _doc(structure.name, constants),
        "__slots__": [f"_{field.name}" for field in structure.fields],
        "_fields_and_field_types": {field.name: field.type.idl_name() for field in structure.fields},
        "SLOT_TYPES": _SlotTypes(structure),
        "__init__": names["__init__"],
        "__repr__": _repr,
        "__eq__": names["__eq__"],
        "get_fields_and_field_types": classmethod(_get_fields_and_field_types),
        **constants,
        **defaults,
    }
    if checks.IS_OPTION:
        namespace["__slots__"].append("_check_fields")
    else:
        namespace["_check_fields"] = checks.CHECK_FIELDS
    for function in (names["__init__"], names["__eq__"]):
        function.__qualname__ = f"{structure.name}.{function.__name__}"
    for field in structure.fields:
        doc = f"Message field '{field.name}'."
        namespace[field.name] = property(attrgetter(f"_{field.name}"), names[f"set_{field.name}"], None, doc)
    made: type = _metaclass(structure, constants, defaults)(structure.name, (), namespace)
    return made


def _doc(name: str, constants: dict[str, Any]) -> str:
    text = f"Message class '{name}'."
    if not constants:
        return text
    return "\n".join(
        ["", f"    {text}", "", "    Constants:", *(f"      {constant}" for constant in constants), "    "]
    )


def _metaclass(structure: Structure, constants: dict[str, Any], defaults: dict[str, Any]) -> Any:
    """Return the class's metaclass, on which constants and defaults are read-only properties, as in real ROS."""
    namespace: dict[str, Any] = {
        "__module__": module_name(structure.package, structure.kind, structure.name),
        "__doc__": f"Metaclass of message '{structure.name}'.",
        "_interface_name": structure.full_name,
        "_structure": structure,
    }
    for name, value in constants.items():
        namespace[name] = _constant_property(value, f"Message constant '{name}'.")
    for name, value in defaults.items():
        field = name.removesuffix("__DEFAULT").lower()
        namespace[name] = _constant_property(value, f"Return default value for message field '{field}'.")
    return type(f"Metaclass_{structure.name}", (InterfaceType,), namespace)


def _constant_property(value: Any, doc: str) -> property:
    return property(lambda cls: value, doc=doc)


def python_constant(constant: Constant) -> Any:
    """Return the value in Python: bytes for `byte`, the number or string for other types."""
    return bytes([constant.value]) if constant.type == "byte" else constant.value


def _setter_lines(field: Field) -> list[str]:
    """Return the setter `set_<name>(self, value)`: one test for the usual valid value, `checks` for everything else."""
    name, type_, primitive = field.name, field.type, field.type.primitive
    lines = [f"def set_{name}(self, value):"]
    if checks.WARNS_OF_SETS and type_.count != SINGLE:
        lines += ["    if type(value) is not list and isinstance(value, Set):", "        warn_of_set()"]
    store = f"    self._{name} = value"
    if checks.KEEPS_WHAT_FITS and type_.count != SINGLE and not type_.is_numeric_array():
        store += " if isinstance(value, list) else list(value)"
    if type_.is_numeric_array():
        assert primitive is not None
        if type_.count == ARRAY:
            plain, checked = f"numpy.array(value, dtype=numpy.{primitive.numpy})", "checked_ndarray"
        else:
            plain, checked = f"array({primitive.code!r}, value)", "checked_array"
        value = (
            f"    value = {checked}(T_{name}, {name!r}, value, self._check_fields) if self._check_fields else {plain}"
        )
        return [*lines, value, store]
    test = f"    if self._check_fields and {_bad_value_test(field)}:"
    return [*lines, test, f"        check_value(T_{name}, {name!r}, value, E_{name})", store]


def _bad_value_test(field: Field) -> str:
    """Return the source of a test that is false for the usual valid value."""
    type_, primitive = field.type, field.type.primitive
    if type_.count != SINGLE:
        if type_.string_bound:
            return "True"
        python = f"E_{field.name}" if type_.nested else "str" if primitive is None else primitive.python.__name__
        relation = {ARRAY: "!=", BOUNDED: ">"}.get(type_.count)
        length = f" or len(value) {relation} {type_.size}" if relation else ""
        return f"(type(value) is not list{length} or not {{{python}}}.issuperset(map(type, value)))"
    if type_.nested:
        return f"type(value) is not E_{field.name}"
    if primitive is None:
        if type_.string_bound:
            return f"(type(value) is not str or len(value) > {type_.string_bound})"
        return "type(value) is not str"
    if primitive.python is bytes:
        return "(type(value) is not bytes or len(value) != 1)"
    if primitive.python is int:
        return f"(type(value) is not int or not {primitive.low} <= value <= {primitive.high})"
    if primitive.code == "f":
        return f"(type(value) is not float or not {-primitive.high} <= value <= {primitive.high})"
    return f"type(value) is not {primitive.python.__name__}"


def _equality_lines(structure: Structure) -> list[str]:
    lines = ["def __eq__(self, other):", "    if not isinstance(other, self.__class__):", "        return False"]
    for field in structure.fields:
        different = f"self._{field.name} != other._{field.name}"
        if uses_numpy(field.type):
            different = f"any({different})"
        lines += [f"    if {different}:", "        return False"]
    return [*lines, "    return True"]


def _get_fields_and_field_types(cls: Any) -> dict[str, str]:
    """Return the names of the fields and their types, like {'data': 'string'}."""
    return dict(cls._fields_and_field_types)


def _repr(self: Any) -> str:
    """Return 'std_msgs.msg.String(data='x')'; an array.array is shown as a plain list."""
    arguments = []
    for field in type(self)._structure.fields:
        value = getattr(self, field.name)
        text = repr(value)
        if field.type.count != ARRAY and field.type.is_numeric_array():
            text = "[]" if len(value) == 0 else text[len("array('X', ") : -1]
        arguments.append(f"{field.name}={text}")
    package = type(self).__module__.rpartition(".")[0]
    return f"{package}.{type(self).__name__}({', '.join(arguments)})"


class _SlotTypes:
    """Creates SLOT_TYPES on first access, then replaces itself with the tuple."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure

    def __get__(self, instance: object, owner: Any) -> Any:
        from day6_core.interfaces.slot_types import slot_types

        for cls in owner.__mro__:
            if vars(cls).get("SLOT_TYPES") is self:
                cls.SLOT_TYPES = slot_types(self.structure)
                return cls.SLOT_TYPES
        raise AttributeError("SLOT_TYPES")
