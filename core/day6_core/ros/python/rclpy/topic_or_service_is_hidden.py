"""Hidden topics and services."""

from day6_core.graph import names

HIDDEN_TOPIC_PREFIX = "_"


def topic_or_service_is_hidden(name: str) -> bool:
    """Return whether a part of the name starts with an underscore."""
    return names.is_hidden(name)
