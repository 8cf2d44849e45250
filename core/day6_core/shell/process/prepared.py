"""What a process is started by: sh where that is enough, else Python."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from day6_core.shell.process.launch_process import leave_no_core, lower_limit
from day6_core.shell.process.memory import is_held_by_system, memory_limit

NICE = 10
_LAUNCHER = Path(__file__).with_name("launch_process.py")
_OF_THE_SYSTEM = ("/bin/", "/usr/")
"""Where programs are certainly such as the system can start; what is wrong with others `launch_process.py` says as bash does."""

_SCRIPT = """\
: <>"$0"
ulimit -S -c 0
[ "$1" = 0 ] || ulimit -S -d "$1" 2>/dev/null
shift
exec "$@"
"""
"""What `launch_process.py` does, in a tenth of its time: on Linux a terminal that a session's leader opens becomes its own."""


def prepared(argv: Sequence[str], name: str = "", tty: int | None = None) -> Sequence[str]:
    """Return what is to be started so that it becomes the program `argv[0]`, which is told `name`, on the terminal `tty`."""
    if sys.platform == "win32":
        return argv
    path, *arguments = argv
    memory = memory_limit() if is_held_by_system() else 0
    if (nice := _nice()) and (_is_python(path) or path.startswith(_OF_THE_SYSTEM)):
        own = os.devnull if tty is None else os.ttyname(tty)
        limit = str(lower_limit(memory) // 1024)
        return ["/bin/sh", "-c", _SCRIPT, own, limit, nice, "-n", str(NICE), name or path, *arguments]
    mode = "no-tty" if tty is None else "tty"
    launcher = [sys.executable, "-I", "-S", str(_LAUNCHER), mode, str(NICE), str(memory)]
    return [*launcher, path, name or path, *arguments]


def parted(words: list[str]) -> tuple[list[str], list[str]]:
    """Return what `_SCRIPT` is told, for `settle`, and the words of the program; nothing and all words without it."""
    return (words[3:8], words[8:]) if words[:3] == ["/bin/sh", "-c", _SCRIPT] else ([], words)


def settle(own: str, limit: str, _path: str, _option: str, nice: str) -> None:
    """Do in this process, which leads a session, what `_SCRIPT` does. Raises OSError, ValueError."""
    if sys.platform == "win32":
        raise NotImplementedError("not there")
    import resource

    os.close(os.open(own, os.O_RDWR))
    leave_no_core()
    if kilobytes := int(limit):
        hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
        resource.setrlimit(resource.RLIMIT_DATA, (kilobytes * 1024, hard))
    os.nice(int(nice))


def _nice() -> str:
    """Return the path of `nice` where `_SCRIPT` does as much as `launch_process.py`, else ''."""
    if sys.platform != "linux":
        return ""
    numbers = (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP)
    ignored = any(signal.getsignal(number) is signal.SIG_IGN for number in numbers)  # they stay so behind sh
    return "" if ignored else _path_of_nice()


def _is_python(path: str) -> bool:
    """Whether it is the Python that runs us, also by the name that it has in an environment."""
    return path == sys.executable or os.path.realpath(path) == os.path.realpath(sys.executable)


@cache
def _path_of_nice() -> str:
    return shutil.which("nice") or ""
