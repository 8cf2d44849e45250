"""Responses of `~/get_type_description`: the description of a type that a node uses, found by its hash."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from day6_core.interfaces import definition_text
from day6_core.interfaces.hashing import description_text
from day6_core.interfaces.registry import base_name

if TYPE_CHECKING:
    from rclpy._day6.handles import NodeHandle

_HASH_LENGTH = len("RIHS01_") + 64


def fill_response(node: NodeHandle, request: Any, response: Any) -> Any:
    """Fill the response for a request to a node."""
    if not request.type_hash.startswith("RIHS01_") or len(request.type_hash) != _HASH_LENGTH:
        response.failure_reason = "Failed to parse type hash"
        return response
    name = next((each.type_name for each in node.node.endpoints if each.type_hash == request.type_hash), None)
    if name is None:
        response.failure_reason = "Type not currently in use by this node"
        return response
    description = json.loads(description_text(name))
    others = description["referenced_type_descriptions"]
    response.type_description.type_description = _individual(description["type_description"])
    response.type_description.referenced_type_descriptions = [_individual(each) for each in others]
    if request.include_type_sources:
        response.type_sources = [_source(each) for each in (name, *(each["type_name"] for each in others))]
    response.successful = True
    return response


def _individual(description: dict[str, Any]) -> Any:
    from type_description_interfaces.msg import Field, FieldType, IndividualTypeDescription

    fields = [Field(name=each["name"], type=FieldType(**each["type"])) for each in description["fields"]]
    return IndividualTypeDescription(type_name=description["type_name"], fields=fields)


def _source(name: str) -> Any:
    from type_description_interfaces.msg import TypeSource

    base = base_name(name)
    if base != name:
        # The messages of a service or action have no definition text of their own.
        return TypeSource(type_name=name, encoding="implicit")
    return TypeSource(type_name=name, encoding=name.split("/")[1], raw_file_contents=definition_text(name))
