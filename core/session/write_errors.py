"""What a program says, and with which status it ends, when its output could not be written (a full disk).

GNU's programs check their output once more when they end (gnulib, closeout.c); each has its status for trouble. A Python
program learns of it while the interpreter ends, which is status 120 (CPython, Py_FinalizeEx).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

_USUAL = ("{name}: write error: {reason}", 1)

_IGNORED = "Exception ignored in: <_io.TextIOWrapper name='<stdout>' mode='w' encoding='utf-8'>\n"
_PYTHON = (_IGNORED + "OSError: [Errno {number}] {reason}", 120)

_WORDS: dict[str, tuple[str, int]] = {
    "diff": ("diff: standard output: {reason}", 2),
    "env": ("env: write error: {reason}", 125),
    "find": ("find: ‘standard output’: {reason}\nfind: write error", 1),
    "ls": ("ls: write error: {reason}", 2),
    "printenv": ("printenv: write error: {reason}", 2),
    "sed": ("sed: couldn't flush stdout: {reason}", 4),
    "sort": ("sort: fflush failed: 'standard output': {reason}\nsort: write error", 2),
    "tee": ("tee: 'standard output': {reason}", 1),
    "wc": ("wc: write error", 1),
    **dict.fromkeys(("grep", "egrep", "fgrep"), ("grep: write error: {reason}", 2)),
    **dict.fromkeys(("ros2", "colcon", "xacro", "rosdep", "pip", "pip3"), _PYTHON),
}
"""By the name of the program: text and status where they are not the usual ones."""


def told(session: Session, error: OSError) -> int:
    """Say on the program's standard error what could not be written; returns the status it ends with."""
    text, status = _WORDS.get(session.name, _USUAL)
    session.print_error(text.format(name=session.name, reason=error.strerror, number=error.errno))
    return status
