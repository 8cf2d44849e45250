"""A tag of a launch file, whatever the file's language."""

from __future__ import annotations

from typing import Any


class Entity:
    """Base of the entities of `launch_xml` and `launch_yaml`."""

    @property
    def type_name(self) -> str:
        """The name of the tag."""
        raise NotImplementedError

    @property
    def parent(self) -> Entity | None:
        return None

    @property
    def children(self) -> list[Any]:
        """The entities in it."""
        raise NotImplementedError

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if there is anything in it that nobody asked for."""
        raise NotImplementedError

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """Return an attribute as `data_type` (`List[Entity]`: the children of that name); None if optional and not there.

        Raises AttributeError if it is not there, TypeError if it is of another type.
        """
        raise NotImplementedError
