"""Comparing with a screen whose lines break where its width wants, not where words end."""

from __future__ import annotations


def without_blanks(text: str) -> str:
    """Return the text without white space: how long a path is decides where a line breaks, and a break may eat a blank."""
    return "".join(text.split())
