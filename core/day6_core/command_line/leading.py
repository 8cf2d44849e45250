"""Options before words that belong to somebody else: `day6-tui --lang zh COMMAND …`, `day6-tui python --lang zh FILE …`."""

from __future__ import annotations

from collections.abc import Container

LANGUAGE, DISTRIBUTION = "--lang", "--distro"
BEFORE_A_PROGRAM = ("-h", "--help", LANGUAGE)


def leading(words: list[str], options: Container[str]) -> tuple[list[str], list[str]]:
    """Return the words that are such options with their values, and the rest."""
    at = 0
    while at < len(words) and words[at].partition("=")[0] in options:
        at += 2 if words[at] in (LANGUAGE, DISTRIBUTION) else 1
    return words[:at], words[at:]
