"""Expansion of topic and service names."""

from day6_core.graph import names
from rclpy._day6.resolve import expand


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """Return the full form of a relative, private or absolute name.

    Raises:
        ValueError: if a name is bad.
    """
    if not isinstance(topic_name, str) or not isinstance(node_name, str) or not isinstance(node_namespace, str):
        raise TypeError(
            "rclpy_expand_topic_name(): incompatible function arguments. The following argument types are supported:\n"
            "    1. (arg0: str, arg1: str, arg2: str) -> str\n\n"
            f"Invoked with: {topic_name!r}, {node_name!r}, {node_namespace!r}"
        )
    for subject, name, flaw, line in (
        ("topic name", topic_name, names.flaw_of_topic_name(topic_name), 73),
        ("node name", node_name, names.flaw_of_node_name(node_name), 84),
        ("node namespace", node_namespace, names.flaw_of_namespace(node_namespace), 94),
    ):
        if flaw is not None:
            raise ValueError(
                f"{subject} '{name}' is invalid: {flaw.message}, at /project/src/rcl/expand_topic_name.c:{line}"
            )
    return expand(topic_name, node_name, node_namespace)
