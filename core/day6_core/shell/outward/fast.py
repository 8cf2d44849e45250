"""`--fast` and `--virtual-time`: a command and all that it starts, in virtual time."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.command_line.parser import CommandParser


def begin_anew_or_say(parser: CommandParser, argv: list[str], env: Mapping[str, str], *, paced: bool = False) -> int:
    """Become a program in virtual time; where that can't be, say why and return the exit status."""
    from day6_core.reason import reason
    from day6_core.virtual.surroundings import NotHere, begin_anew

    try:
        begin_anew(argv, env, paced=paced)
    except NotHere:
        why = parser.texts("cli.fast.not.here")
    except OSError as error:
        why = reason(error)
    print(f"{parser.prog}: {'--virtual-time' if paced else '--fast'}: {why}", file=sys.stderr)
    return 1
