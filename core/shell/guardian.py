"""Ends students' processes when our own process is gone without having been able to do it itself (`kill -9`, a crash).

One tiny shell waits at the end of a pipe that only we hold open. It is told every group that starts and ends; when the
pipe closes, we are gone, and it ends what is left. (Linux alone would have PR_SET_PDEATHSIG, which looks at threads instead
of processes and reaches the child but not its group.)
"""

from __future__ import annotations

import os
import subprocess
import threading

_SCRIPT = """
trap '' INT HUP TERM
targets=" "
while read -r change target; do
  case $change in
    +) targets="$targets$target " ;;
    -) case $targets in *" $target "*) targets="${targets%% $target *} ${targets#* $target }" ;; esac ;;
  esac
done
[ "$targets" = " " ] && exit 0
for target in $targets; do kill -s TERM -- "$target" 2>/dev/null; kill -s CONT -- "$target" 2>/dev/null; done
sleep 1
for target in $targets; do kill -s KILL -- "$target" 2>/dev/null; done
"""

_lock = threading.Lock()
_guardian: subprocess.Popen[bytes] | None = None


def guard(group: int) -> None:
    """End process group `group` when this process dies. Does nothing where there are no process groups."""
    _watch(-group)


def guard_process(pid: int) -> None:
    """The same for one process that is in our own group (launched programs, which Ctrl-C is to reach with us)."""
    _watch(pid)


def release(group: int) -> None:
    """The group has ended: its number may soon be another's."""
    _forget(-group)


def release_process(pid: int) -> None:
    """The process has ended."""
    _forget(pid)


def _watch(target: int) -> None:
    """`target` is a number for `kill`: negative for a group."""
    global _guardian
    if os.name != "posix":
        return
    with _lock:
        if _guardian is None or _guardian.poll() is not None:
            _guardian = subprocess.Popen(
                ["/bin/sh", "-c", _SCRIPT],
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
        _tell(f"+ {target}\n")


def _forget(target: int) -> None:
    with _lock:
        if _guardian is not None:
            _tell(f"- {target}\n")


def _tell(line: str) -> None:
    assert _guardian is not None and _guardian.stdin is not None
    try:
        _guardian.stdin.write(line.encode())
        _guardian.stdin.flush()
    except BrokenPipeError:
        return  # somebody killed it; the next `guard` starts another
