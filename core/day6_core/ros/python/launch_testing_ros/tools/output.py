"""The filter of output that also knows what middleware prints."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import ament_index_python
from launch_testing.tools import output


def get_rmw_output_filter(rmw_implementation: str, filter_type: str) -> list[str]:
    """Return what an rmw implementation says of its own lines in the ament index: 'prefixes' or 'patterns'.

    Raises TypeError for another `filter_type`.
    """
    if filter_type not in ("prefixes", "patterns"):
        raise TypeError(f"Unsupported filter_type \"{filter_type}\". Supported types: ['prefixes', 'patterns']")
    kind = f"rmw_output_{filter_type}"
    if not ament_index_python.has_resource(kind, rmw_implementation):
        return []
    return ament_index_python.get_resource(kind, rmw_implementation)[0].splitlines()


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """Return a filter as launch_testing's, which leaves out the lines of an rmw implementation, too."""
    prefixes = list(output.get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = list(output.get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns)
    if filtered_rmw_implementation:
        prefixes += get_rmw_output_filter(filtered_rmw_implementation, "prefixes")
        patterns += get_rmw_output_filter(filtered_rmw_implementation, "patterns")
    return output.basic_output_filter(prefixes, patterns)
