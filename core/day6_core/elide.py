"""Shortening the names of topics and nodes."""

from __future__ import annotations

from day6_core.width import text_width

LEAST_HEAD = 4
"""Characters, a slash among them."""


def elide(name: str, longest: int, ellipsis: str) -> str:
    """Shorten a name to `longest` cells: its first and last parts stay, the middle becomes an ellipsis.

    Where there is no room for the whole first part, its beginning stays if that is long enough to tell something.
    """
    if text_width(name) <= longest:
        return name
    parts = name.split("/")
    for kept in range(len(parts) - 2, 0, -1):
        short = "/".join([*parts[:2], ellipsis, *parts[-kept:]])
        if kept < len(parts) - 2 and text_width(short) <= longest:
            return short
    ends = ["/".join([ellipsis, *parts[-kept:]]) for kept in range(len(parts) - 1, 0, -1)]
    for short in (end for end in ends if text_width(end) <= longest):
        head = name[: longest - text_width(short)]
        if len(head) >= LEAST_HEAD and text_width(head + short) <= longest:
            return head + short
    if short := next((end for end in ends if text_width(end) <= longest), ""):
        return short
    if name.startswith("/"):
        return _without_middle(name, longest, ellipsis)
    return ellipsis + name[len(name) - longest + len(ellipsis) :]


def _without_middle(name: str, longest: int, ellipsis: str) -> str:
    """The beginning and the end of a node's or topic's name: it is told from others by either."""
    room = max(0, longest - text_width(ellipsis))
    head, tail = name[: (room + 1) // 2], name[len(name) - room // 2 :] if room > 1 else ""
    while text_width(head) + text_width(tail) > room:  # wide characters
        head, tail = (head[:-1], tail) if text_width(head) >= text_width(tail) else (head, tail[1:])
    return head + ellipsis + tail
