"""Shortening the names of topics and nodes."""

from __future__ import annotations

from day6_core.width import text_width


def elide(name: str, longest: int, ellipsis: str) -> str:
    """Shorten a name to `longest` cells: its first and last parts stay, the middle becomes an ellipsis."""
    if text_width(name) <= longest:
        return name
    parts = name.split("/")
    for kept in range(len(parts) - 2, 0, -1):
        short = "/".join([*parts[:2], ellipsis, *parts[-kept:]])
        if kept < len(parts) - 2 and text_width(short) <= longest:
            return short
    for kept in range(len(parts) - 1, 0, -1):
        short = "/".join([ellipsis, *parts[-kept:]])
        if text_width(short) <= longest:
            return short
    return ellipsis + name[len(name) - longest + len(ellipsis) :]
