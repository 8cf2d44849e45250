"""Creates SLOT_TYPES: the types of a class's fields as objects of `rosidl_parser.definition`."""

from __future__ import annotations

from day6_core.interfaces.definition import Structure
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE, FieldType

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def slot_types(structure: Structure) -> tuple[Any, ...]:
    """Return one type object per field, in order."""
    from rosidl_parser import definition

    return tuple(_slot_type(definition, field.type) for field in structure.fields)


def _slot_type(definition: Any, type_: FieldType) -> Any:
    element = _element(definition, type_)
    if type_.count == SINGLE:
        return element
    if type_.count == ARRAY:
        return definition.Array(element, type_.size)
    if type_.count == BOUNDED:
        return definition.BoundedSequence(element, type_.size)
    return definition.UnboundedSequence(element)


def _element(definition: Any, type_: FieldType) -> Any:
    if type_.primitive is not None:
        return definition.BasicType(type_.primitive.idl)
    if type_.nested:
        package, kind, name = type_.base.split("/")
        return definition.NamespacedType([package, kind], name)
    if type_.base == "string":
        return definition.BoundedString(type_.string_bound) if type_.string_bound else definition.UnboundedString()
    return definition.BoundedWString(type_.string_bound) if type_.string_bound else definition.UnboundedWString()
