"""Ends students' processes if our own process dies without being able to do it itself (`kill -9`, a crash).

A tiny shell waits at the end of a pipe that only we hold open. It receives every process group that starts and ends; when the
pipe closes, our process is gone, and it ends the remaining groups. (PR_SET_PDEATHSIG exists only on Linux, watches threads
instead of processes, and reaches the child but not its group.) Processes that have left their group (`setsid`, a daemon) are
found by a mark in their environment, as far as the system shows it (`day6_core/system/processes.py`).
"""

from __future__ import annotations

import os
import secrets
import signal
import subprocess
import sys
import threading

from day6_core.system.processes import marked, shell_marked
from day6_core.virtual.surroundings import VARIABLE as TIME

MARK = "DAY6_JOB"
"""The variable that marks a process as ours: `<our session>.<number of the program>.`"""
_SESSION = secrets.token_hex(8)

_SCRIPT = """
trap '' INT HUP TERM
read -r mark && [ -n "$mark" ] || exit 0  # not a word of the command line: `marked` may look at those, too
end_left() { for pid in $(marked); do kill -s "$1" "$pid" 2>/dev/null; done; }
targets=" "
while read -r change target; do
  case $change in
    +) targets="$targets$target " ;;
    -) case $targets in *" $target "*) targets="${targets%% $target *} ${targets#* $target }" ;; esac ;;
  esac
done
[ "$targets" = " " ] && [ -z "$(marked)" ] && exit 0
for target in $targets; do kill -s TERM -- "$target" 2>/dev/null; kill -s CONT -- "$target" 2>/dev/null; done
end_left TERM
sleep 1
end_left KILL
for target in $targets; do kill -s KILL -- "$target" 2>/dev/null; done
"""


_lock = threading.Lock()
_guardian: subprocess.Popen[bytes] | None = None
_numbers = 0


def new_mark() -> str:
    """Return a value of MARK for a program about to be started; the guardian runs from here on."""
    global _numbers
    with _lock:
        _numbers += 1
        if os.name == "posix":
            _start()
        return f"{_SESSION}.{_numbers}."


def end_marked(mark: str) -> None:
    """Kill the processes a program left running outside its group."""
    if sys.platform == "win32":
        return
    for pid in marked(f"{MARK}={mark}"):
        try:
            os.kill(pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue


def guard(group: int) -> None:
    """End process group `group` when this process dies. Does nothing on systems without process groups."""
    _add(-group)


def guard_process(pid: int) -> None:
    """End one process of our own group when this process dies (launched programs, which Ctrl-C must reach together with us)."""
    _add(pid)


def release(group: int) -> None:
    """Stop guarding a group that has ended: its id may be reused."""
    _remove(-group)


def release_process(pid: int) -> None:
    """Stop guarding a process that has ended."""
    _remove(pid)


def _add(target: int) -> None:
    """Guard `target`, an argument of `kill`: negative for a group."""
    if os.name != "posix":
        return
    with _lock:
        _start()
        _send(f"+ {target}\n")


def _start() -> None:
    global _guardian
    if _guardian is None or _guardian.poll() is not None:
        env = {name: value for name, value in os.environ.items() if name != MARK} | {TIME: ""}
        _guardian = subprocess.Popen(
            ["/bin/sh", "-c", shell_marked() + _SCRIPT, "day6-guardian"],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            env=env,
        )
        _send(f"{MARK}={_SESSION}\n")


def _remove(target: int) -> None:
    with _lock:
        if _guardian is not None:
            _send(f"- {target}\n")


def _send(line: str) -> None:
    assert _guardian is not None and _guardian.stdin is not None
    try:
        _guardian.stdin.write(line.encode())
        _guardian.stdin.flush()
    except BrokenPipeError:
        return  # it was killed; the next `guard` starts another
