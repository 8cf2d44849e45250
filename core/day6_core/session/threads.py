"""Runs work that would stall every program in a thread, while its program waits."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TypeVar

from day6_core.session.task import Signal, wait_for

_Result = TypeVar("_Result")


async def in_thread(function: Callable[[], _Result]) -> _Result:
    """Run `function` in a new thread and return its result or raise its exception.

    A program that is interrupted while it waits leaves the thread behind; its result is lost.
    """
    done = Signal()
    results: list[_Result] = []
    errors: list[BaseException] = []

    def run() -> None:
        try:
            results.append(function())
        except BaseException as error:
            errors.append(error)
        finally:
            done.set()

    threading.Thread(target=run, name="day6-work", daemon=True).start()
    await wait_for(done)
    if errors:
        raise errors[0]
    return results[0]
