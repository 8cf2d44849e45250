"""Messages and exit statuses of programs whose output could not be written (a full disk).

GNU programs check their output once more when they end (gnulib, closeout.c); each has its own status for failure. In Python the
error appears while the interpreter ends, with status 120 (CPython, Py_FinalizeEx).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.session.session import Session

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
"""By program name: message and status where they differ from the usual ones."""


def report_write_error(session: Session, error: OSError) -> int:
    """Print the error on the program's standard error; return the program's exit status."""
    text, status = _WORDS.get(session.name, _USUAL)
    session.print_error(text.format(name=session.name, reason=error.strerror, number=error.errno))
    return status
