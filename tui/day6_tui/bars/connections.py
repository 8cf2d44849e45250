"""The state of the connections to other machines (`--listen`, `--connect`), in the few words that fit in the top line."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.panes.cells import clip

if TYPE_CHECKING:
    from day6_core.link.state import Door

_LONGEST_HOST = 20
_FINE = ("open", "joined", "opening", "calling")


def door_words(door: Door, ellipsis: str, *, short: bool = False) -> tuple[str, bool, dict[str, object]]:
    """Return the text for a connection in the top line: its id, whether all is well, its parameters."""
    address = door.endpoint.partition("/")[2]
    host, _, port = address.rpartition(":")
    name = door.state.value.replace(" ", "_")
    if not door.listening:
        name = {"open": "joined", "opening": "calling"}.get(name, name)
    words = {"host": clip(host, _LONGEST_HOST, ellipsis), "port": port, "joined": door.joined}
    return f"bar.door.{name}{'.short' if short and name == 'joined' else ''}", name in _FINE, words
