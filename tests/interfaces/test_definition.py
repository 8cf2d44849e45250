"""The parser of interface texts finds, and refuses, what ROS's own parser does (recorded by record_real.py)."""

from __future__ import annotations

import gzip
import json
from pathlib import Path
from typing import Any

from day6_core.interfaces.definition import parse_action, parse_message, parse_service
from tests.support.folded import folded

RECORDED = json.loads(gzip.decompress((Path(__file__).parent / "data" / "real.json.gz").read_bytes()))["texts"]


def outcome(kind: str, text: str) -> Any:
    try:
        if kind == "msg":
            found = parse_message("pkg", "msg", "Name", text)
            return {
                "fields": [[field.type.msg_name(), field.name, repr(field.default)] for field in found.fields],
                "constants": [[constant.type, constant.name, repr(constant.value)] for constant in found.constants],
            }
        (parse_service if kind == "srv" else parse_action)("pkg", kind, "Name", text)
        return "good"
    except Exception as error:
        return f"{type(error).__name__}: {error}"


BAD_SIZE = (
    "TypeError: the size of array type '{}' must be a valid integer value > 0 "
    "optionally prefixed with '<=' if it is only an upper bound"
)
BETTER = {
    # Real ROS fills the two blanks of this text the wrong way round.
    **{f"{type_} a": BAD_SIZE.format(type_) for type_ in ("int32[0]", "int32[-1]", "int32[x]", "int32[<=0]")},
    # Real ROS ends with an IndexError for a line that begins with a blank.
    **dict.fromkeys(
        ("  int32 a", "\tint32\ta"),
        "InvalidResourceName: '' is an invalid message name. It should have the pattern '^[A-Z][A-Za-z0-9]*$'",
    ),
    # Real ROS reads these ROS 1 types and fails later, where it makes code for them.
    **{
        f"{type_} {name}": f"InvalidResourceName: '{type_}' is an invalid message name. "
        "It should have the pattern '^[A-Z][A-Za-z0-9]*$'"
        for type_, name in (("duration", "d"), ("time", "t"))
    },
}


@folded("kind, text, real", RECORDED)
def test_a_text_means_what_it_means_to_ros(kind: str, text: str, real: Any) -> None:
    assert outcome(kind, text) == BETTER.get(text, real)


def test_we_differ_from_ros_only_where_it_fails_itself() -> None:
    recorded = {text: real for kind, text, real in RECORDED if kind == "msg"}
    assert all(BETTER[text] != recorded[text] for text in BETTER)
