"""What the real `ros2` has and day6-tui has not yet. A row goes when the module of that name comes."""

from __future__ import annotations

from typing import NamedTuple


class Later(NamedTuple):
    """A command: the line that help shows, and the verbs that are missing, each with its line."""

    summary: str
    verbs: dict[str, str] = {}


LATER: dict[str, Later] = {
    "component": Later(
        "Various component related sub-commands",
        {
            "list": "Output a list of running containers and components",
            "load": "Load a component into a container node",
            "standalone": "Run a component into its own standalone container node",
            "types": "Output a list of components registered in the ament index",
            "unload": "Unload a component from a container node",
        },
    ),
    "extension_points": Later("List extension points"),
    "extensions": Later("List extensions"),
    "lifecycle": Later(
        "Various lifecycle related sub-commands",
        {
            "get": "Get lifecycle state for one or more nodes",
            "list": "Output a list of available transitions",
            "nodes": "Output a list of nodes with lifecycle",
            "set": "Trigger lifecycle state transition",
        },
    ),
    "multicast": Later(
        "Various multicast related sub-commands",
        {
            "receive": "Receive a single UDP multicast packet",
            "send": "Send a single UDP multicast packet",
        },
    ),
}

VERBS: dict[str, dict[str, str]] = {
    "service": {"echo": "Echo a service"},
}
"""Verbs that are missing from commands that are there."""

HIDDEN = frozenset({"extension_points", "extensions"})
"""Commands that the real help does not list either."""


def later_verbs(command: str) -> dict[str, str]:
    """Return the missing verbs of a command with their lines."""
    return LATER[command].verbs if command in LATER else VERBS.get(command, {})


def missing(command: str | None, verb: str | None) -> str | None:
    """Return what to say to a command line that names something missing, None if it is there (or nowhere)."""
    if command is None:
        return None
    if command in LATER and not LATER[command].verbs:
        return f"ros2 {command} is not yet part of day6-tui"
    if verb is not None and verb in later_verbs(command):
        return f"ros2 {command} {verb} is not yet part of day6-tui"
    return None
