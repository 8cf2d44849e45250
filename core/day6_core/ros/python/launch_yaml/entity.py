"""A tag of a YAML launch file."""

from __future__ import annotations

from typing import Any

from launch.frontend.entity import Entity as BaseEntity
from launch.frontend.type_utils import check_is_list_entity
from launch.utilities.type_utils import is_instance_of


class Entity(BaseEntity):
    """A mapping (attributes, and other tags under `children`), or a list of other tags."""

    def __init__(self, element: Any, type_name: str, *, parent: Entity | None = None) -> None:
        self.__element = element
        self.__type_name = type_name
        self.__parent = parent
        self.__read_keys: set[str] = set()
        self.__read_children = False

    @property
    def type_name(self) -> str:
        return self.__type_name

    @property
    def parent(self) -> Entity | None:
        return self.__parent

    @property
    def children(self) -> list[Entity]:
        self.__read_children = True
        element = self.__element
        if not isinstance(element, (dict, list)):
            raise TypeError(f"Expected a dict or list, got {type(element)}:\n---\n{element}\n---")
        if isinstance(element, dict):
            if "children" not in element:
                raise ValueError(
                    f"Expected entity `{self.__type_name}` to have children entities."
                    "That can be a list of subentities or a dictionary with a `children` list element"
                )
            self.__read_keys.add("children")
            element = element["children"]
        found = []
        for child in element:
            if not isinstance(child, dict) or len(child) != 1:
                raise RuntimeError("Subentities must be a dictionary with only one key, which is the entity type")
            name, content = next(iter(child.items()))
            found.append(Entity(content, name, parent=self))
        return found

    def assert_entity_completely_parsed(self) -> None:
        if isinstance(self.__element, list):
            if not self.__read_children:
                raise ValueError(f"Unexpected nested entity(ies) found in `{self.__type_name}`: {self.__element}")
            return
        keys = set(self.__element or ()) - self.__read_keys
        if keys:
            raise ValueError(f"Unexpected key(s) found in `{self.__type_name}`: {keys}")

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        if name not in self.__element:
            if optional:
                return None
            raise AttributeError(f"Can not find attribute '{name}' in Entity '{self.__type_name}'")
        self.__read_keys.add(name)
        data = self.__element[name]
        where = f"Attribute '{name}' of Entity '{self.__type_name}'"
        if check_is_list_entity(data_type):
            if isinstance(data, list) and data and isinstance(data[0], dict):
                return [Entity(child, name, parent=self) for child in data]
            raise TypeError(f"{where} expected to be a list of dictionaries.")
        if not is_instance_of(data, data_type, can_be_str=can_be_str):
            raise TypeError(f"{where} expected to be of type '{data_type}', got '{type(data)}'")
        return data
