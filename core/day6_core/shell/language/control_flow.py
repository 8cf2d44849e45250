"""A loop's body, and the exceptions that end a line early: `exit`, `break`, `continue`, `return`, an unset word and Ctrl-C."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams
    from day6_core.shell.language.syntax import Sequence


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


async def run_body(shell: Shell, body: Sequence, streams: Streams) -> tuple[int, bool]:
    """Run the body of a loop once; return its status, and whether the loop goes on. Raises LoopControl for a loop around it."""
    shell.loops += 1
    try:
        return await shell.run_tree(body, streams), True
    except LoopControl as control:
        if control.levels > 1:
            raise LoopControl(control.levels - 1, control.again) from None
        return 0, control.again
    finally:
        shell.loops -= 1
