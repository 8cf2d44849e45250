"""Splits what a terminal sends into keys: one character, or one escape sequence."""

from __future__ import annotations

import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O[ -~]|\x1b?\[[0-?]*[ -/]*[@-~]|[^\x1b\[O])", re.DOTALL)

LONGEST_SEQUENCE = 256
"""Characters an escape sequence can have; what goes on for longer is none, and nobody shall look for its end again and again."""


def key_end(text: str, at: int) -> int:
    """Return where the key that begins at `at` ends."""
    match = _SEQUENCE.match(text, at, at + LONGEST_SEQUENCE) if text[at] == "\x1b" else None
    return match.end() if match else at + 1


def split_keys(text: str) -> list[str]:
    """Return the keys in `text`: 'a', '\\r', '\\x1b[A', '\\x1bb' (Alt-b). A lone or cut-off escape is a key by itself."""
    keys = []
    at = 0
    while at < len(text):
        end = key_end(text, at)
        keys.append(text[at:end])
        at = end
    return keys
