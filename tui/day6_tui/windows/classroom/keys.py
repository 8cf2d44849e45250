"""The keys of the teacher's window as the key line and the help name them, those that are used most first."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from day6_tui.appearance.look import Look

Key = tuple[str, str]
"""The key, and what it does: the text `teacher.key.<what>`."""

KEYS: Mapping[str, tuple[Key, ...]] = {
    "empty": (("i", "invite"), ("f", "freeze")),
    "table": (
        ("Enter", "large"),
        ("s", "say"),
        ("f", "freeze"),
        ("t", "type"),
        ("o", "open"),
        ("v", "preview"),
        ("c", "compare"),
        ("i", "invite"),
    ),
    "large": (
        ("Esc", "back"),
        ("n p", "next"),
        ("s", "say"),
        ("t", "type"),
        ("f", "freeze"),
        ("o", "open"),
        ("c", "compare"),
        ("↑↓←→", "scroll"),
    ),
    "typing": (("^]", "end_typing"),),
    "over": (("Esc", "acknowledge"),),
    "more": (
        ("S O", "all"),
        ("a A", "ask"),
        ("w", "settle"),
        ("l L", "link"),
        ("g G", "file"),
        ("m M", "show_mine"),
        ("r R", "show"),
        ("h", "lower"),
        ("PgUp PgDn", "page"),
        ("Home End", "ends"),
        ("d Del", "forget"),
        ("e", "csv"),
        ("x", "end"),
    ),
}
"""By what the window shows; `more` are named by the help alone."""


def hints(keys: Iterable[Key], look: Look, *, is_frozen: bool) -> list[tuple[str, str]]:
    """Return keys with what they do, in the language of the desktop."""
    found = []
    for key, what in keys:
        name = "thaw" if what == "freeze" and is_frozen else what
        label = key if look.glyphs.unicode or key.isascii() else "Arrows"
        found.append((label, look.texts(f"teacher.key.{name}")))
    return found
