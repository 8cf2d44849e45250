"""The exceptions that end a command line early: `exit`, `break`, `continue`, `return`, words without a value and Ctrl-C."""

from __future__ import annotations


class ExitShell(Exception):
    """`exit`: ends this shell (not the programs around it) with `status`."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


class LoopControl(Exception):
    """`break` and `continue`, `levels` loops up."""

    def __init__(self, levels: int, again: bool) -> None:
        super().__init__(levels)
        self.levels = levels
        self.again = again


class DiscardLine(Exception):
    """A word could not be expanded, and the message about it was printed: the rest of the line is not run."""


class ReturnFromSource(Exception):
    """`return`: ends the file being sourced with `status`."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


class Interrupted(Exception):
    """A foreground command was ended by Ctrl-C: the rest of the line is not run."""
