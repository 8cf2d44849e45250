"""A tag of a launch file, in whatever language."""

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
        """Raise ValueError if it has an attribute or a child that was never read."""
        raise NotImplementedError

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """Return an attribute as `data_type` (`List[Entity]`: the children of that name); None if it is optional and missing.

        Raises AttributeError if it is missing, TypeError if it has another type.
        """
        raise NotImplementedError
