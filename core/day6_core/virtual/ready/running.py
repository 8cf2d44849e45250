"""Runs a program's file or folder as Python does: CPython's Modules/main.c and Python/pythonrun.c.

At the end, Python takes all modules apart, those that were imported last first. When it has done so with the program's own, only
those are left that all forks share, for which it would need as much time as a small program needs in all: there the process ends.
"""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import atexit
import ctypes
import gc
import io
import os
import signal
import weakref
from collections.abc import Callable
from functools import partial
from importlib.machinery import SourceFileLoader
from types import ModuleType, TracebackType
from typing import Any

from day6_core.virtual.ready import unseen

_FILE_INPUT = 257
"""Py_file_input."""
_INTERRUPTED = -1
"""In place of a status."""
_python: Any = ctypes.pythonapi
_libc: Any = ctypes.CDLL(None)
_libc.fopen.restype = ctypes.c_void_p
_python.PyRun_FileExFlags.restype = ctypes.py_object
_kill, _exit, _signal = os.kill, os._exit, signal.signal
_FILES = (io.TextIOWrapper, io.BufferedWriter, io.BufferedRandom)


def runner_of(path: str) -> Callable[[], int]:
    """Make a new `__main__`; return what runs a program, and returns the exit status."""
    last = unseen.last_seen()
    main: Any = ModuleType("__main__")
    main.__builtins__ = sys.modules["builtins"]
    main.__loader__ = main.__builtins__.__loader__
    if sys.version_info < (3, 14):
        main.__annotations__ = {}
    sys.modules["__main__"] = main
    run = _run_folder
    if not os.path.isdir(path):
        name = os.path.abspath(path)
        main.__file__, main.__cached__, main.__loader__ = name, None, SourceFileLoader("__main__", name)
        run = partial(_run_file, name)
    end = _End(main)
    atexit.register(_look, weakref.ref(end))
    vars(last)["_end"] = end
    _python.Py_IncRef(ctypes.py_object(last))
    return partial(_run, run, weakref.ref(end))


def _run(run: Callable[[], None], end: weakref.ref[_End]) -> int:
    status = _status_of(run)
    if (there := end()) is not None:
        there.status = status
    if status != _INTERRUPTED:
        return status
    return 0 if run is not _run_folder else 128 + signal.SIGINT  # Python remembers that a file was interrupted


def _run_folder() -> None:
    import runpy

    module: Any = runpy
    module._run_module_as_main("__main__", False)


def _run_file(path: str) -> None:
    file = ctypes.c_void_p(_libc.fopen(os.fsencode(path), b"r"))
    if not file:  # it was there a moment ago
        sys.stderr.write(f"{sys.executable}: can't open file {path!r}\n")
        raise SystemExit(2)
    names = ctypes.py_object(vars(sys.modules["__main__"]))
    try:
        _python.PyRun_FileExFlags(file, os.fsencode(path), _FILE_INPUT, names, names, 1, None)
    finally:
        vars(sys.modules["__main__"]).pop("__file__", None)


def _status_of(run: Callable[[], None]) -> int:
    """The exit status; what is to be printed of an error has been."""
    try:
        run()
    except SystemExit as end:
        return _code_of(end)
    except BaseException as error:
        error.__traceback__ = _without_ours(error.__traceback__)
        try:
            _print(error)
        except SystemExit as end:
            return _code_of(end)
        return _INTERRUPTED if type(error) is KeyboardInterrupt else 1
    return 0


def _code_of(end: SystemExit) -> int:
    if end.code is None:
        return 0
    if isinstance(end.code, int):
        return end.code & 0xFF if -(2**63) <= end.code < 2**63 else 0xFF
    if sys.stderr is not None:
        sys.stderr.write(f"{end.code}\n")
    return 1


def _without_ours(traceback: TracebackType | None) -> TracebackType | None:
    while traceback is not None and traceback.tb_frame.f_code.co_filename == __file__:
        traceback = traceback.tb_next
    return traceback


def _print(error: BaseException) -> None:
    """Have it printed, as PyErr_Print does."""
    system: Any = sys
    system.last_type, system.last_value, system.last_traceback = type(error), error, error.__traceback__
    if sys.version_info >= (3, 12):
        system.last_exc = error
    hook = getattr(sys, "excepthook", None)
    if hook is None:
        sys.stderr.write("sys.excepthook is missing\n")
        hook = sys.__excepthook__
    try:
        hook(type(error), error, error.__traceback__)
    except SystemExit:
        raise
    except BaseException as second:
        second.__traceback__ = _without_ours(second.__traceback__)
        second.__context__ = None
        sys.stderr.write("Error in sys.excepthook:\n")
        sys.__excepthook__(type(second), second, second.__traceback__)
        sys.stderr.write("\nOriginal exception was:\n")
        sys.__excepthook__(type(error), error, error.__traceback__)


def _look(end: weakref.ref[_End]) -> None:
    """The last of what is called at the end. If this doesn't work, Python will say so and end with another status."""
    try:
        for stream in (sys.stdout, sys.stderr):
            if stream is not None and not stream.closed:
                stream.flush()
    except Exception:
        if (there := end()) is not None:
            there.status = None
        return
    unseen.forget()


class _End:
    """Put into the last module that all forks share, it goes when Python begins with these, and ends the process.

    Not if something of the program is still held by what is left: then Python goes on.
    """

    def __init__(self, main: ModuleType) -> None:
        self.main = weakref.ref(main)
        self.status: int | None = None
        """The exit status, once it is known."""

    def __del__(self) -> None:
        if self.status is None or self.main() is not None:
            return
        try:
            for each in gc.get_objects():
                if issubclass(type(each), _FILES) and not each.closed and each.writable():
                    each.flush()
        except Exception:  # Python has more to say then, or has taken apart what is needed here
            return
        _libc.fflush(None)
        if self.status == _INTERRUPTED:
            _signal(signal.SIGINT, signal.SIG_DFL)
            _kill(os.getpid(), signal.SIGINT)
        _exit(self.status)
