"""Hidden names: those with a part that starts with an underscore."""

from __future__ import annotations

from day6_tui.core.graph.names import is_hidden

HIDDEN_TOPIC_PREFIX = "_"


def topic_or_service_is_hidden(name: str) -> bool:
    """Say whether `ros2 topic list` leaves the name out."""
    return is_hidden(name)
