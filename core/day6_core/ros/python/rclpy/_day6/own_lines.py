"""Which lines are the student's own, and where a callback is written: for what a program tells the inspector."""

from __future__ import annotations

import linecache
import os
import sysconfig
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from types import FrameType, TracebackType
from typing import Any

_OURS = tuple(
    str(Path(each).resolve()) + os.sep
    for each in (Path(__file__).parents[2], Path(__file__).parents[4], sysconfig.get_paths()["stdlib"])
)
_INSTALLED = f"{os.sep}install{os.sep}"
"""What colcon has built is the student's, though its folders are called as Python's."""
_LIBRARIES = tuple(f"{os.sep}{folder}{os.sep}" for folder in ("site-packages", "dist-packages"))


@lru_cache(maxsize=5000)
def is_own(file: str) -> bool:
    """Return whether a file is the student's: none of ours, of Python's library or of an installed package."""
    if file.startswith("<"):
        return False
    path = os.path.abspath(file)
    return _INSTALLED in path or not (path.startswith(_OURS) or any(folder in path for folder in _LIBRARIES))


def place_in(frames: Iterable[FrameType]) -> dict[str, Any]:
    """Return the first line, of frames, that is the student's."""
    frame = next((each for each in frames if is_own(each.f_code.co_filename)), None)
    return line_of(frame.f_code.co_filename, frame.f_lineno) if frame is not None else line_of("", 0)


def line_of(file: str, line: int) -> dict[str, Any]:
    """Return a line as answers tell it."""
    text = linecache.getline(file, line).strip() if file else ""
    return {"file": os.path.abspath(file) if file else "", "line": line, "text": text}


def code_of(callback: object) -> Any:
    """Return the code of a function, method or partial; None for anything else."""
    while (inner := getattr(callback, "func", None) or getattr(callback, "__func__", None)) is not None:
        callback = inner
    return getattr(callback, "__code__", None)


def name_of(callback: object) -> str:
    """Return the name of a callback, '' for one that has none."""
    code = code_of(callback)
    return code.co_name if code is not None else ""


def place_of(callback: object) -> dict[str, Any]:
    """Return where a callback of the student's begins."""
    code = code_of(callback)
    own = code is not None and is_own(code.co_filename)
    return line_of(code.co_filename, code.co_firstlineno) if own else line_of("", 0)


def said(error: BaseException) -> str:
    """Return an exception as the last line of its traceback has it."""
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def raised_at(trace: TracebackType | None) -> dict[str, Any]:
    """Return the last line of the student's through which an exception went."""
    place = line_of("", 0)
    while trace is not None:
        file = trace.tb_frame.f_code.co_filename
        if is_own(file):
            place = line_of(file, trace.tb_lineno)
        trace = trace.tb_next
    return place
