"""What keeps two functions from spinning one executor at once."""

from __future__ import annotations

from _thread import allocate_lock

from day6_core.ros.differences import value


class OneSpin:
    """A context in which an executor spins. Since Lyrical there is one at a time; before, nobody looks."""

    def __init__(self) -> None:
        self.alone: bool = value("executor.refuses_second_spin")
        self._lock = allocate_lock()
        self.locked = self._lock.locked

    def __enter__(self) -> None:
        if self.alone and not self._lock.acquire(False):
            raise RuntimeError("Executor is already spinning")

    def __exit__(self, *_: object) -> None:
        if self.alone:
            self._lock.release()
