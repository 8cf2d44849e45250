r"""The prompt that PS1 describes: `\u@\h:\w\$ ` and the other escapes of bash, then `$NAME` and `$(…)` in it."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.shell.language.expansion import expand_text
from day6_core.shell.language.lexer import single_word
from day6_core.shell.language.words import SyntaxProblem

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

UBUNTU = r"${debian_chroot:+($debian_chroot)}\[\033[01;32m\]\u@\h\[\033[00m\]:\[\033[01;34m\]\w\[\033[00m\]\$ "
"""What Ubuntu's .bashrc sets in a terminal with colours."""

_ESCAPE = re.compile(r"\\([0-7]{1,3}|D\{[^}]*\}|.)", re.DOTALL)


async def prompt(shell: Shell, streams: Streams) -> str:
    """Return the prompt as it is shown; one that cannot be expanded is shown unexpanded."""
    form = shell.variables.get("PS1", "")
    status = shell.status
    # The result of an escape is not expanded again: a folder may be called `$x`.
    given: list[str] = []

    def hold(match: re.Match[str]) -> str:
        given.append(_meaning(match[1], shell))
        return f"\x00{len(given) - 1}\x00"

    held = _ESCAPE.sub(hold, form)
    try:
        held = await expand_text(single_word(held, quoted=True), shell, streams)
    except SyntaxProblem:
        return form
    finally:
        shell.status = status
    return re.sub("\x00(\\d+)\x00", lambda match: given[int(match[1])], held)


def _meaning(escape: str, shell: Shell) -> str:
    from day6_core.shell.desk import HOST

    if escape[0] in "01234567":
        return chr(int(escape, 8) & 0xFF)
    if escape.startswith("D{"):
        return time.strftime(escape[2:-1] or "%X")
    meanings: dict[str, Callable[[], str]] = {
        "u": lambda: shell.desk.user,
        "h": lambda: HOST,
        "H": lambda: HOST,
        "w": lambda: shell.short_cwd,
        "W": lambda: "~" if shell.short_cwd == "~" else shell.cwd.name or "/",
        "$": lambda: "$",
        "#": lambda: str(len(shell.history) + 1),
        "!": lambda: str(len(shell.history) + 1),
        "j": lambda: str(len(shell.jobs.jobs)),
        "s": lambda: shell.name,
        "v": lambda: "5.2",
        "n": lambda: "\n",
        "r": lambda: "\r",
        "a": lambda: "\a",
        "e": lambda: "\x1b",
        "t": lambda: time.strftime("%H:%M:%S"),
        "T": lambda: time.strftime("%I:%M:%S"),
        "@": lambda: time.strftime("%I:%M %p"),
        "A": lambda: time.strftime("%H:%M"),
        "d": lambda: time.strftime("%a %b %d"),
        "[": lambda: "",
        "]": lambda: "",
        "\\": lambda: "\\",
    }
    return meanings[escape]() if escape in meanings else f"\\{escape}"
