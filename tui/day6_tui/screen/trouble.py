"""News of the terminal that the user should know of."""

from __future__ import annotations

from textual.message import Message


class TerminalTrouble(Message):
    """The terminal sent bytes that are not UTF-8, or is too slow for what it is sent."""

    def __init__(self, key: str) -> None:
        super().__init__()
        self.key = key
        """The catalogue key of the text that says what to do about it."""
