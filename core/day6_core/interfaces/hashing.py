"""RIHS01 type hashes: sha256 of a JSON description of a type and of all types it refers to (REP 2016)."""

from __future__ import annotations

from day6_core.interfaces import registry
from day6_core.interfaces.definition import Field
from day6_core.interfaces.fields import ARRAY, BOUNDED, SINGLE, FieldType
from day6_core.ros import differences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_NESTED_ID = 1
_STRING_IDS = {("string", False): 17, ("wstring", False): 18, ("string", True): 21, ("wstring", True): 22}
_ARRAY_OFFSET, _BOUNDED_OFFSET, _UNBOUNDED_OFFSET = 48, 96, 144


def type_hash(cls: Any) -> str:
    """Return 'RIHS01_…' of a message, service or action class (default values and constants are not part of it).

    Raises:
        TypeError: for anything else.
    """
    return hash_of(registry.type_name(cls))


def hash_of(name: str) -> str:
    """Return 'RIHS01_…' of an interface by its full name, '' in Humble; raises the errors of `registry.structure`."""
    known = registry.hashes.get(name)
    if known is None and not differences.value("messages.have_hashes"):
        known = registry.hashes[name] = ""
    if known is None:
        known = registry.hashes[name] = "RIHS01_" + _sha256(description_text(name).encode())
    return known


def _sha256(data: bytes) -> str:
    """The digest, by what hashlib is made of: it loads no OpenSSL, and a student's own hashlib.py is not in its way."""
    try:
        from _sha2 import sha256  # type: ignore[import-not-found]
    except ImportError:  # before Python 3.12
        try:
            from _sha256 import sha256  # type: ignore[import-not-found]
        except ImportError:
            from hashlib import sha256
    digest: str = sha256(data).hexdigest()
    return digest


def description_text(name: str) -> str:
    """Return the text that is hashed: JSON on one line, with separators ', ' and ': '."""
    own = _members(name)
    referenced: dict[str, list[Field]] = {}
    pending = [field.type.base for field in own if field.type.nested]
    while pending:
        other = pending.pop()
        if other not in referenced:
            referenced[other] = _members(other)
            pending += [field.type.base for field in referenced[other] if field.type.nested]
    others = ", ".join(_description(other, referenced[other]) for other in sorted(referenced))
    return f'{{"type_description": {_description(name, own)}, "referenced_type_descriptions": [{others}]}}'


def _members(name: str) -> list[Field]:
    """Return the members of a type in the hash: the fields of a message, the parts of a service or action."""
    _, kind, own = registry.split_name(name)
    if kind == "action" and registry.base_name(name) == name:
        parts = {
            "goal": "_Goal", "result": "_Result", "feedback": "_Feedback", "send_goal_service": "_SendGoal",
            "get_result_service": "_GetResult", "feedback_message": "_FeedbackMessage",
        }  # fmt: skip
    elif (kind == "srv" and registry.base_name(name) == name) or own.endswith(("_SendGoal", "_GetResult")):
        parts = {"request_message": "_Request", "response_message": "_Response", "event_message": "_Event"}
    else:
        fields = registry.structure(name).fields
        return fields or [Field(FieldType("uint8"), "structure_needs_at_least_one_member")]
    return [Field(FieldType(name + part), member) for member, part in parts.items()]


def _description(name: str, members: list[Field]) -> str:
    fields = ", ".join(_member(field) for field in members)
    return f'{{"type_name": "{name}", "fields": [{fields}]}}'


def _member(field: Field) -> str:
    type_ = field.type
    if type_.nested:
        number = _NESTED_ID
    elif type_.primitive is not None:
        number = type_.primitive.type_id
    else:
        number = _STRING_IDS[type_.base, bool(type_.string_bound)]
    if type_.count != SINGLE:
        number += {ARRAY: _ARRAY_OFFSET, BOUNDED: _BOUNDED_OFFSET}.get(type_.count, _UNBOUNDED_OFFSET)
    return (
        f'{{"name": "{field.name}", "type": {{"type_id": {number}, "capacity": {type_.size}, '
        f'"string_capacity": {type_.string_bound}, "nested_type_name": "{type_.base if type_.nested else ""}"}}}}'
    )
