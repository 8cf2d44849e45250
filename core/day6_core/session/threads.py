"""Runs work that would stall every program in a thread, while its program waits; and keeps what is older from coming last."""

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


class Newest:
    """Work of threads of which the newest counts, such as writing a state to a file: one at a time, and never an older one last.

    A thread that its program left behind goes on; what it would do then is done already, or of no use.
    """

    def __init__(self) -> None:
        self._one_at_a_time = threading.Lock()
        self._turn = 0

    def of(self, work: Callable[[], object]) -> Callable[[], None]:
        """Return `work` for a thread; it does nothing if it comes after something newer was asked for. One thread asks."""
        self._turn += 1
        turn = self._turn

        def run() -> None:
            with self._one_at_a_time:
                if turn == self._turn:
                    work()

        return run
