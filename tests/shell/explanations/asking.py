"""What a terminal answers to a line."""

from __future__ import annotations

from typing import Any


def said(seat: Any, line: str) -> str:
    """What a command prints, without line breaks of the screen."""
    seat.line("clear")
    seat.line(line)
    return " ".join(seat.wait_prompt().split())
