"""What the router of a class lets through: from pupils only UP, to pupils only DOWN. So no pupil reaches another's graph.

In a room all share one graph, but what the teacher asks and shows still comes from nobody else.
Whoever has the secret may still claim to be any pupil, as with names on a blackboard.
"""

from __future__ import annotations

from typing import Any

from day6_core.link.classroom.keys import DOWN, UP

_SENDING = ["put", "delete", "query", "liveliness_token"]
_RECEIVING = ["declare_subscriber", "declare_queryable", "reply", "declare_liveliness_subscriber", "liveliness_query"]


def _below(key: str) -> list[str]:
    # Wildcards do not match a chunk that begins with @.
    return [f"{key}/**", f"{key}/**/@ros2_lv/**", f"{key}/**/@adv/**"]


def rules(*, is_room: bool = False) -> dict[str, Any]:
    """Return Zenoh's `access_control`, as seen from the router: ingress is what a pupil sends to it."""
    ways = [
        ("up", UP, "ingress", _SENDING),
        ("up", UP, "egress", _RECEIVING),
        ("down", DOWN, "ingress", _RECEIVING),
        ("down", DOWN, "egress", _SENDING),
    ]
    permission, default = "allow", "deny"
    if is_room:
        ways, permission, default = [("down", DOWN, "ingress", _SENDING)], "deny", "allow"
    made = [
        {
            "id": f"{way}_{flow}",
            "permission": permission,
            "flows": [flow],
            "messages": messages,
            "key_exprs": _below(key),
        }
        for way, key, flow, messages in ways
    ]
    return {
        "enabled": True,
        "default_permission": default,
        "rules": made,
        "subjects": [{"id": "everybody"}],
        "policies": [{"rules": [rule["id"] for rule in made], "subjects": ["everybody"]}],
    }
