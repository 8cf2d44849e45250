"""Splits what a terminal sends into keys: one character, or one escape sequence."""

from __future__ import annotations

import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O[ -~]|\x1b?\[[0-?]*[ -/]*[@-~]|[^\x1b\[O])", re.DOTALL)


def split_keys(text: str) -> list[str]:
    """Return the keys in `text`: 'a', '\\r', '\\x1b[A', '\\x1bb' (Alt-b). A lone or cut-off escape is a key by itself."""
    keys = []
    at = 0
    while at < len(text):
        match = _SEQUENCE.match(text, at) if text[at] == "\x1b" else None
        end = match.end() if match else at + 1
        keys.append(text[at:end])
        at = end
    return keys
