"""Interpreters that are ready before there is a program for them: forks of a process that has imported what programs need.

A program that begins in one finds what it would find in a new interpreter, but needs a fifth of the time. `start.py` runs such a
process; a function of its own calls `forks.fork`, before it knows anything that programs must not know. `forks` hands programs
on to them, without those who start programs knowing. `becoming` makes an interpreter the program's, `running` runs it and ends,
`unseen` keeps from it the modules that it hasn't imported itself, and `shown` is what the system shows of it.
"""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _socket import socket

waiting: deque[tuple[int, socket]] = deque()
"""Those that have no program yet: the process number, and the socket through which it gets one."""
wanted: int | None = None
"""How many programs could have begun in one so far; None in a process that has no such interpreters."""
