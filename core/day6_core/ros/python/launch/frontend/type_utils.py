"""The types that XML and YAML launch files can name."""

from __future__ import annotations

from typing import Any, List  # noqa: UP035

from launch.frontend.entity import Entity
from launch.utilities.type_utils import is_typing_list

_TYPES: dict[str, Any] = {
    "str": str,
    "bool": bool,
    "float": float,
    "int": int,
    "list_of_str": List[str],  # noqa: UP006
    "list_of_bool": List[bool],  # noqa: UP006
    "list_of_float": List[float],  # noqa: UP006
    "list_of_int": List[int],  # noqa: UP006
    "yaml": None,
}


def check_is_list_entity(data_type: Any) -> bool:
    """Return whether a data type is a list of entities, which stands for "the children of that name"."""
    if not is_typing_list(data_type):
        return False
    members = getattr(data_type, "__args__", None) or (None,)
    return isinstance(members[0], type) and issubclass(members[0], Entity)


def get_data_type_from_identifier(type_identifier: str) -> Any:
    """Return the type that the attribute `type` of a `param` names. Raises ValueError for an unknown one."""
    if type_identifier not in _TYPES:
        raise ValueError(f"Got invalid type identifier '{type_identifier}'")
    return _TYPES[type_identifier]
