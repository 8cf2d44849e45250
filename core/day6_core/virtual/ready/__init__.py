"""Interpreters that are ready before there is a program for them: forks of a process that has imported what programs need.

A program that begins in one finds what it would find in a new interpreter, but needs a fifth of the time. `start.py` runs such a
process; a function of its own calls `forks.fork`, before it knows anything that programs must not know. `forks` hands programs
on to them, without those who start programs knowing. `becoming` makes an interpreter the program's, `running` runs it and ends,
`unseen` keeps from it the modules that it hasn't imported itself, and `shown` is what the system shows of it.
"""

from __future__ import annotations

from collections import deque
from typing import Any

waiting: deque[tuple[int, Any]] = deque()
"""Those that have no program yet: the process's number, and the socket by which it gets one."""
wanted: int | None = None
"""How many programs there were so far for such as these; None in a process that has none."""
