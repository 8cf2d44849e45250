"""A tag of an XML launch file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.frontend.entity import Entity as BaseEntity
from launch.frontend.type_utils import check_is_list_entity
from launch.utilities.type_utils import get_typed_value

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element


class Entity(BaseEntity):
    """A tag with attributes, which are texts; `name-sep` is the separator of the list in `name`."""

    def __init__(self, xml_element: Element, *, parent: Entity | None = None) -> None:
        self.__element = xml_element
        self.__parent = parent
        self.__read_attributes: set[str] = set()
        self.__read_children: set[str] = set()

    @property
    def type_name(self) -> str:
        return self.__element.tag

    @property
    def parent(self) -> Entity | None:
        return self.__parent

    @property
    def children(self) -> list[Entity]:
        self.__read_children = {each.tag for each in self.__element}
        return [Entity(each, parent=self) for each in self.__element]

    def assert_entity_completely_parsed(self) -> None:
        tags = {each.tag for each in self.__element} - self.__read_children
        if tags:
            raise ValueError(f"Unexpected nested tag(s) found in `{self.type_name}`: {tags}")
        attributes = set(self.__element.attrib) - self.__read_attributes
        if attributes:
            raise ValueError(f"Unexpected attribute(s) found in `{self.type_name}`: {attributes}")

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        found: Any
        if check_is_list_entity(data_type):
            found = [Entity(each, parent=self) for each in self.__element if each.tag == name]
            if found:
                self.__read_children.add(name)
                return found
        elif name in self.__element.attrib:
            return self.__typed(name, data_type, can_be_str)
        if optional:
            return None
        raise AttributeError(f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'")

    def __typed(self, name: str, data_type: Any, can_be_str: bool) -> Any:
        value: Any = self.__element.attrib[name]
        self.__read_attributes.add(name)
        separator = self.__element.attrib.get(f"{name}-sep")
        if separator is not None:
            self.__read_attributes.add(f"{name}-sep")
            value = value.split(separator)
        try:
            return get_typed_value(value, data_type, can_be_str=can_be_str)
        except ValueError:
            raise TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}'."
                f"'{value}' can not be converted to one of those types"
            ) from None
