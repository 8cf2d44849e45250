"""Counts the node names of a launch."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_KEY = "unique_ros_node_names"


def add_node_name(context: LaunchContext, node_name: str) -> None:
    """Count a node with that name."""
    if _KEY not in context.get_locals_as_dict():
        context.extend_globals({_KEY: Counter()})
    context.get_locals_as_dict()[_KEY][node_name] += 1


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """Return how many nodes with that name the launch has started."""
    return int(context.get_locals_as_dict().get(_KEY, {}).get(node_name, 0))
