"""Expansion of relative and private names."""

from __future__ import annotations

from day6_tui.core.graph import names
from rclpy._resolve import expand

_SOURCE = "/project/src/rcl/expand_topic_name.c"


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the full form of a topic name for a node; ValueError if one of the three is malformed.

    The result may still be no valid full name (`//y` from `{ns}/y` in the root namespace), as in real rclpy.
    """
    # expand_topic_name accepts "~foo", which a publisher refuses later.
    tilde = topic_name.startswith("~") and topic_name[1:2] not in ("", "/")
    for subject, name, flaw, line in (
        ("topic name", topic_name, None if tilde else names.flaw_of_topic_name(topic_name), 73),
        ("node name", node_name, names.flaw_of_node_name(node_name), 84),
        ("node namespace", node_namespace, names.flaw_of_namespace(node_namespace), 94),
    ):
        if flaw is not None:
            raise ValueError(f"{subject} '{name}' is invalid: {flaw.message}, at {_SOURCE}:{line}")
    return expand(topic_name, node_name, node_namespace)
