"""Finds the uncaught exception in what a program wrote to its terminal."""

from __future__ import annotations

import re
from dataclasses import dataclass

from day6_core.session.plain import without_sequences

LONGEST = 16 * 1024
"""Characters at the end of an output in which a traceback is looked for."""

_LAUNCHED = re.compile(r"^\[[\w.-]+-\d+\] ", re.MULTILINE)
"""What launch puts before each line of a node."""
_ERROR = re.compile(
    r"^(?: - )?(?:[\w.]+\.)?(\w*(?:Error|Exception)): (.+)$|^(?:[\w.]+\.)?(\w+(?:Error|Exception))$", re.MULTILINE
)
PLACE = re.compile(r'^ *File "([^"]+)", line (\d+)', re.MULTILINE)
"""A place in a traceback: file and line."""

_IN_LAUNCH = re.compile(r" \((\S+), line (\d+)\)$")
"""How an exception itself names the place of a syntax error."""


@dataclass(frozen=True)
class Fault:
    """One exception: its class without the module, its message, and the last place of its traceback ('' and 0: none)."""

    kind: str
    message: str
    file: str = ""
    line: int = 0


def fault_in(output: str) -> Fault | None:
    """Return the last exception that a program did not catch, None if its output does not end with one."""
    text = _LAUNCHED.sub("", without_sequences(output[-LONGEST:]))
    begin = max(text.rfind("Traceback (most recent call last):"), text.rfind("Caught exception in launch"))
    if begin < 0:  # a syntax error of the program itself has no traceback, only its place
        places = list(PLACE.finditer(text))
        if not places or not re.search(r"^(?:Syntax|Indentation|Tab)Error: ", text[places[-1].end() :], re.MULTILINE):
            return None
        begin = places[-1].start()
    text = text[begin:]
    found = _ERROR.search(text)
    if found is None:
        return None
    places = list(PLACE.finditer(text, 0, found.start()))
    file, line = (places[-1][1], int(places[-1][2])) if places else ("", 0)
    message = found[2] or ""
    inner = _IN_LAUNCH.search(message)
    if inner is not None and not places:
        message, file, line = message[: inner.start()], inner[1], int(inner[2])
    return Fault(found[1] or found[3], message, file, line)
