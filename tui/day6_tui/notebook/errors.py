"""Errors of callbacks as IPython shows those of cells, and places in cells as it names them. The pupil's lines only."""

from __future__ import annotations

from pathlib import Path
from types import FrameType, TracebackType

import day6_core
import day6_tui
from day6_tui.notebook.shell import InteractiveShell

_OURS = tuple(f"{Path(path).resolve().as_posix()}/" for package in (day6_core, day6_tui) for path in package.__path__)


def picture(shell: InteractiveShell, error: BaseException) -> str:
    """Return an exception as this notebook shows those of its cells."""
    trace = without_our_frames(error.__traceback__)
    tracebacks = shell.InteractiveTB
    return tracebacks.stb2text(tracebacks.structured_traceback(type(error), error.with_traceback(trace), trace, 0))


def show_interrupt(
    shell: InteractiveShell,
    kind: type[BaseException],
    error: BaseException,
    trace: TracebackType | None,
    tb_offset: int | None = None,
) -> None:
    """Show in which of the pupil's lines a cell was interrupted, for IPython's `set_custom_exc`: not how rclpy waits."""
    kept = without_our_frames(trace)
    shell.showtraceback((kind, error.with_traceback(kept), kept), tb_offset=tb_offset)


def without_our_frames(trace: TracebackType | None) -> TracebackType | None:
    """Leave the calls of rclpy out, unless nothing else is there."""
    found: list[TracebackType] = []
    step = trace
    while step is not None:
        if not Path(step.tb_frame.f_code.co_filename).as_posix().startswith(_OURS):
            found.append(step)
        step = step.tb_next
    kept: TracebackType | None = None
    for each in reversed(found):
        kept = TracebackType(kept, each.tb_frame, each.tb_lasti, each.tb_lineno)
    return kept or trace


def place(shell: InteractiveShell, frame: FrameType | None) -> str:
    """Return the innermost line of a cell on a stack, such as "Cell In[3], line 8"; '' if it runs none."""
    while frame is not None:
        name = shell.compile.format_code_name(frame.f_code.co_filename)
        if name is not None:
            return f"{' '.join(name)}, line {frame.f_lineno}"
        frame = frame.f_back
    return ""
