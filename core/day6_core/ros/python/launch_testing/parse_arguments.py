"""Reads the arguments of a launch."""

from __future__ import annotations

from collections.abc import ItemsView, Iterable


def parse_launch_arguments(launch_arguments: Iterable[str]) -> ItemsView[str, str]:
    """Return the names and values of words `name:=value`; of two with one name the last one counts.

    Raises RuntimeError for any other word.
    """
    found: dict[str, str] = {}
    for word in launch_arguments:
        name, separator, value = word.partition(":=")
        if not separator or not name or (not value and word.count(":=") == 1):
            raise RuntimeError(f"malformed launch argument '{word}', expected format '<name>:=<value>'")
        found[name] = value
    return found.items()
