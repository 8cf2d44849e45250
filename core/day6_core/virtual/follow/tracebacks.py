"""Tracebacks without the frames of this package, which no program has called as far as it knows."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import threading
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Any

from day6_core.virtual.follow.imports import when_imported

_FOLDER = __file__.rpartition("follow")[0]


def install() -> None:
    """Have what Python prints of an error, and what the module traceback makes of one, leave them out."""
    excepthook, of_threads = sys.excepthook, threading.excepthook

    def hook(cls: Any, value: BaseException, traceback: TracebackType | None, /) -> None:
        excepthook(cls, _pruned(value), value.__traceback__)

    def thread_hook(args: Any, /) -> None:
        error = args.exc_value
        traceback = error and _pruned(error).__traceback__
        of_threads(threading.ExceptHookArgs((args.exc_type, error, traceback, args.thread)))

    sys.excepthook = sys.__excepthook__ = hook
    threading.excepthook = threading.__excepthook__ = thread_hook
    when_imported("traceback", _follow_traceback)


def _pruned(error: BaseException) -> BaseException:
    """The same error without our frames, also in those that it comes of."""
    waiting, seen = [error], {id(error)}
    while waiting:
        each = waiting.pop()
        each.__traceback__ = _without_ours(each.__traceback__)
        for other in (each.__cause__, each.__context__):
            if other is not None and id(other) not in seen:
                seen.add(id(other))
                waiting.append(other)
    return error


def _without_ours(traceback: TracebackType | None) -> TracebackType | None:
    kept = []
    while traceback is not None:
        if not traceback.tb_frame.f_code.co_filename.startswith(_FOLDER):
            kept.append(traceback)
        traceback = traceback.tb_next
    result = None
    for each in reversed(kept):
        if each.tb_next is not result:
            each = TracebackType(result, each.tb_frame, each.tb_lasti, each.tb_lineno)
        result = each
    return result


def _follow_traceback(module: Any) -> None:
    def walking(original: Callable[[Any], Iterator[Any]]) -> Callable[[Any], Iterator[Any]]:
        return lambda tb: original(_without_ours(tb))

    for name in ("walk_tb", "_walk_tb_with_full_positions"):
        if hasattr(module, name):
            setattr(module, name, walking(getattr(module, name)))
    walk_stack = module.walk_stack

    def of_program(f: Any) -> Iterator[Any]:
        f = f if f is not None else sys._getframe(1)
        return (each for each in walk_stack(f) if not each[0].f_code.co_filename.startswith(_FOLDER))

    module.walk_stack = of_program
