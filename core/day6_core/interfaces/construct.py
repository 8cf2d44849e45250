"""Generates the source of a message class's constructor and of default values."""

from __future__ import annotations

from day6_core.interfaces import checks
from day6_core.interfaces.definition import Field, Structure
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE, UNBOUNDED, FieldType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_INLINE_LIMIT = 12
"""Nested messages that a constructor creates inline instead of calling their constructors."""


def default_source(field: Field) -> str:
    """Return the source of a field's default value; the class of a nested message is named `E_<field>`."""
    type_ = field.type
    if field.default is None:
        return _zero_source(type_, f"E_{field.name}()")
    values = field.default
    if type_.base == "byte":
        values = bytes([values]) if type_.count == SINGLE else [bytes([value]) for value in values]
    if not type_.is_numeric_array():
        return repr(values)
    assert type_.primitive is not None
    if type_.count == ARRAY:
        return f"numpy.array({values!r}, dtype=numpy.{type_.primitive.numpy})"
    return f"array({type_.primitive.code!r}, {values!r})"


def _zero_source(type_: FieldType, nested: str) -> str:
    primitive = type_.primitive
    if type_.count in (BOUNDED, UNBOUNDED):
        return f"array({primitive.code!r})" if primitive is not None and primitive.numpy else "[]"
    if type_.count == ARRAY:
        if primitive is not None and primitive.numpy:
            return f"numpy.zeros({type_.size}, dtype=numpy.{primitive.numpy})"
        if type_.nested:
            return f"[{nested} for _ in range({type_.size})]"
        return f"[{primitive.zero if primitive is not None else repr('')}] * {type_.size}"
    if type_.nested:
        return nested
    return primitive.zero if primitive is not None else "''"


def constructor_lines(structure: Structure, find_class: Callable[[str], type], names: dict[str, Any]) -> list[str]:
    """Return the lines of `__init__`: plain slot assignments without arguments, field by field otherwise.

    Adds the nested classes the source needs to `names`.
    """
    lines = ["def __init__(self, **kwargs):", *checks.slot_lines("    self")]
    if structure.fields:
        lines.append("    if not kwargs:")
        _Defaults(lines, find_class, names).fill("self", structure)
        lines.append("        return")
    names["FIELDS"] = frozenset(field.name for field in structure.fields)
    lines += ["    if not FIELDS.issuperset(kwargs):", "        check_arguments(self, kwargs)"]
    for field in structure.fields:
        name, primitive = field.name, field.type.primitive
        lines.append(f"    if {name!r} in kwargs:")
        # As in real ROS a string among numbers raises array()'s TypeError here, but the setter's AssertionError with a default.
        if _is_stored_array(field.type) and field.default is None and primitive is not None:
            lines.append(f"        self.{name} = array({primitive.code!r}, kwargs[{name!r}])")
        else:
            lines.append(f"        self.{name} = kwargs[{name!r}]")
        lines += ["    else:", f"        self._{name} = {default_source(field)}"]
    return lines


class _Defaults:
    """Appends assignments of defaults; nested messages are created inline, equal immutable values share a statement."""

    def __init__(self, lines: list[str], find_class: Callable[[str], type], names: dict[str, Any]) -> None:
        self.lines = lines
        self.find_class = find_class
        self.names = names
        self.count = 0

    def fill(self, target: str, structure: Structure) -> None:
        """Assign its default to every field of `target`, a variable of the generated code."""
        same: dict[str, list[str]] = {}
        for field in structure.fields:
            slot = f"{target}._{field.name}"
            source = default_source(field)
            if field.type.nested and field.type.count == SINGLE:
                self._make(slot, field)
            elif field.type.nested and field.type.count == ARRAY:
                name = self._class_name(field)
                self.lines.append(f"        {slot} = [{name}() for _ in range({field.type.size})]")
            elif field.type.count == SINGLE:
                same.setdefault(source, []).append(slot)
            else:
                self.lines.append(f"        {slot} = {source}")
        self.lines += [f"        {' = '.join(slots)} = {source}" for source, slots in same.items()]

    def _make(self, slot: str, field: Field) -> None:
        name = self._class_name(field)
        structure = self.names[name]._structure
        if self.count > _INLINE_LIMIT or any(uses_numpy(inner.type) for inner in structure.fields):
            self.lines.append(f"        {slot} = {name}()")
            return
        variable = f"n{self.count}"
        self.lines += [f"        {variable} = new({name})", *checks.slot_lines(f"        {variable}")]
        self.fill(variable, structure)
        self.lines.append(f"        {slot} = {variable}")

    def _class_name(self, field: Field) -> str:
        self.count += 1
        name = f"C{self.count}"
        self.names[name] = self.find_class(field.type.base)
        return name


def _is_stored_array(type_: FieldType) -> bool:
    return type_.count in (BOUNDED, UNBOUNDED) and type_.is_numeric_array()


def uses_numpy(type_: FieldType) -> bool:
    """Return whether values of this type are numpy arrays."""
    return type_.count == ARRAY and type_.is_numeric_array()
