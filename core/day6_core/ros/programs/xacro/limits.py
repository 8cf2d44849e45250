"""The limits of a process of xacro: a file with endless expressions or macros must not bring down the machine.

The limit is CPU time, not wall time, so a slow or busy machine does not stop an honest file. A robot arm with its sensors
takes about a second. Memory is limited if the system can (Linux); elsewhere the time limit ends the process.
"""

from __future__ import annotations

import faulthandler
import os
import sys
from typing import BinaryIO

CPU_SECONDS = 10
MEMORY_BYTES = 1 << 30
OUT_OF_TIME = 1 if sys.platform == "win32" else -1
"""The status with which the watchdog of Windows, which has no such limit, ends the process; xacro itself fails with 2."""

_kept: list[BinaryIO] = []


def run(seconds: int) -> None:
    """Run xacro with limits (seconds of CPU time) and this process's arguments. Ends the process."""
    limit(seconds)
    import xml.parsers.expat  # noqa: F401  # xacro names that module without importing it

    from xacro import main  # type: ignore[import-untyped]

    sys.argv[0] = "xacro"
    try:
        main()
    except SystemExit as end:
        if _is_caused_by(end, MemoryError):
            sys.stderr.write(f"error: xacro was ended: it needed more than {MEMORY_BYTES >> 20} megabytes of memory\n")
        raise


def limit(seconds: int) -> None:
    """Limit this process."""
    if sys.platform == "win32":
        _kept.append(open(os.devnull, "wb"))  # noqa: SIM115  # it must be open when the time is up
        faulthandler.dump_traceback_later(seconds, exit=True, file=_kept[0])
    else:
        import resource

        limits = [(resource.RLIMIT_CORE, 0), (resource.RLIMIT_CPU, seconds)]
        if sys.platform == "linux":
            limits.append((resource.RLIMIT_AS, MEMORY_BYTES))
        for what, wanted in limits:
            _, most = resource.getrlimit(what)
            lower = wanted if most == resource.RLIM_INFINITY else min(wanted, most)
            resource.setrlimit(what, (lower, most))


def _is_caused_by(error: BaseException, kind: type[BaseException]) -> bool:
    """Whether an exception or one of its causes is of a kind; xacro's exceptions hold theirs in `exc`."""
    waiting: list[BaseException | None] = [error]
    seen: set[int] = set()
    while waiting:
        each = waiting.pop()
        if each is None or id(each) in seen:
            continue
        if isinstance(each, kind):
            return True
        seen.add(id(each))
        held = getattr(each, "exc", None)
        waiting += [each.__context__, each.__cause__, held if isinstance(held, BaseException) else None]
    return False
