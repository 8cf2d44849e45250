"""Starts a program that nobody is the parent of: `python -I -m day6_tui.web.orphan DESCRIPTOR,… PROGRAM ARG…`.

What asks for the end with its parent (bwrap does) then ends with nobody: a desktop outlives a server that was killed. The program
begins only when its parent has gone, or it would see it go.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

assert not TYPE_CHECKING or sys.platform != "win32"  # Windows has no keepers


def main(words: list[str]) -> None:
    """Become the program, in a session of its own; the caller sees this process end at once."""
    numbers, *program = words
    reading, writing = os.pipe()
    if os.fork():
        os._exit(0)
    os.close(writing)
    os.read(reading, 1)  # returns when the parent, which holds the other end, has gone
    os.close(reading)
    os.setsid()
    for number in numbers.split(","):
        os.set_inheritable(int(number), True)
    os.execv(program[0] if os.path.isabs(program[0]) else _found(program[0]), program)


def _found(name: str) -> str:
    import shutil

    return shutil.which(name) or name


if __name__ == "__main__":
    main(sys.argv[1:])
