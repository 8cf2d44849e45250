"""What the router of a class lets through: from pupils only UP, to pupils only DOWN. So no pupil reaches another's graph.

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


def rules() -> dict[str, Any]:
    """Return Zenoh's `access_control`, as seen from the router: ingress is what a pupil sends to it."""
    made = [
        {"id": f"{way}_{flow}", "permission": "allow", "flows": [flow], "messages": messages, "key_exprs": _below(key)}
        for way, key, flow, messages in (
            ("up", UP, "ingress", _SENDING),
            ("up", UP, "egress", _RECEIVING),
            ("down", DOWN, "ingress", _RECEIVING),
            ("down", DOWN, "egress", _SENDING),
        )
    ]
    return {
        "enabled": True,
        "default_permission": "deny",
        "rules": made,
        "subjects": [{"id": "everybody"}],
        "policies": [{"rules": [rule["id"] for rule in made], "subjects": ["everybody"]}],
    }
