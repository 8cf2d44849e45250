"""Splits a terminal's input into keys: one character, or one escape sequence."""

from __future__ import annotations

import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O[ -~]|\x1b?\[[0-?]*[ -/]*[@-~]|[^\x1b\[O])", re.DOTALL)

LONGEST_SEQUENCE = 256
"""The most characters an escape sequence has; anything longer isn't one, so its end is not searched for again and again."""


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
