"""Ends students' processes when our own process is gone without having been able to do it itself (`kill -9`, a crash).

One tiny shell waits at the end of a pipe that only we hold open. It is told every group that starts and ends; when the
pipe closes, we are gone, and it ends what is left. (Linux alone would have PR_SET_PDEATHSIG, which looks at threads instead
of processes and reaches the child but not its group.) What left its group (`setsid`, a daemon) is known on Linux by a mark
in its environment.
"""

from __future__ import annotations

import os
import secrets
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator

MARK = "DAY6_JOB"
"""The variable that says whose a process is: `<our seat>.<number of the program>`."""
_SEAT = secrets.token_hex(8)

_SCRIPT = """
trap '' INT HUP TERM
mark=$1
left() { grep -ls "$mark" /proc/[0-9]*/environ 2>/dev/null; }
end_left() { for file in $(left); do pid=${file#/proc/}; kill -s "$1" "${pid%/environ}" 2>/dev/null; done; }
targets=" "
while read -r change target; do
  case $change in
    +) targets="$targets$target " ;;
    -) case $targets in *" $target "*) targets="${targets%% $target *} ${targets#* $target }" ;; esac ;;
  esac
done
[ "$targets" = " " ] && [ -z "$(left)" ] && exit 0
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
    """A value of MARK for a program that is about to be started; from here on it is looked after."""
    global _numbers
    with _lock:
        _numbers += 1
        if os.name == "posix":
            _start()
        return f"{_SEAT}.{_numbers}."


def end_marked(mark: str) -> None:
    """End what a program left running outside its group (Linux only)."""
    if sys.platform == "win32":
        return
    for pid in _marked(mark):
        try:
            os.kill(pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            continue


def _marked(mark: str) -> Iterator[int]:
    if sys.platform != "linux":
        return
    wanted = f"{MARK}={mark}".encode()
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                with open(f"/proc/{name}/environ", "rb") as file:
                    variables = file.read()
            except OSError:
                continue  # another user's, or gone
            if wanted in variables.split(b"\0"):
                yield int(name)


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
    if os.name != "posix":
        return
    with _lock:
        _start()
        _tell(f"+ {target}\n")


def _start() -> None:
    global _guardian
    if _guardian is None or _guardian.poll() is not None:
        env = {name: value for name, value in os.environ.items() if name != MARK}
        _guardian = subprocess.Popen(
            ["/bin/sh", "-c", _SCRIPT, "day6-guardian", f"{MARK}={_SEAT}"],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            env=env,
        )


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
