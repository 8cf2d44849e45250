"""Where every thread of this process is: for the report of a test that failed."""

from __future__ import annotations

import sys
import threading
import traceback


def stacks() -> list[str]:
    """Each thread's name and stack, the innermost call last."""
    names = {thread.ident: thread.name for thread in threading.enumerate()}
    return [
        f"{names.get(number, number)}\n{''.join(traceback.format_stack(frame))}"
        for number, frame in sys._current_frames().items()
    ]
