"""Puts in place what of Python's standard library waits or tells the time, so that a process follows its kernel."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import atexit
import os
from collections.abc import Callable
from functools import partial

from day6_core.virtual.coordinator import Coordinator
from day6_core.virtual.follow import chance, children, clocks, descriptors, locks, signals, threads, tracebacks
from day6_core.virtual.kernel import FOR_EVER_NS, Kernel
from day6_core.virtual.limit import Limit
from day6_core.virtual.member import Member
from day6_core.virtual.surroundings import NOBODY, VARIABLE, is_first, is_paced, outside, own_world, remove, socket_of
from day6_core.virtual.told import tell
from day6_core.virtual.watchdog import watch


class _Place:
    """This process's place in a world, which it may only get later."""

    def __init__(self) -> None:
        self.kernel = Kernel()
        self.world: Coordinator | Member
        self._begin_pace: Callable[[], None] = _nothing

    def enter(self, limit: float | None = None) -> None:
        """Take part in the world that the environment names. Raises OSError."""
        folder = own_world()
        path = socket_of(folder)
        if not is_first(folder):
            self.world = Member(path)
            self.world.enter(self.kernel)
        elif is_paced(folder):
            from day6_core.virtual import paced

            self.kernel, self.world = paced.PacedKernel(), paced.PacedCoordinator(path, tell)
            self._begin_pace = partial(paced.install, self.kernel, self.world)
        else:
            self.world = Coordinator(path, tell, None if limit is None else Limit(limit))
        if isinstance(self.world, Coordinator):
            atexit.register(_remove, folder)
        self.kernel.world = self.world
        if outside() != NOBODY:
            watch(self.kernel, tell)

    def enter_or_end(self) -> None:
        """Take part, or end this process."""
        try:
            self.enter()
        except OSError:
            tell("no_world", os.environ[VARIABLE])
            os._exit(1)

    def enter_child(self) -> None:
        """Take part as a process of its own, in the child of a fork."""
        self.world.leave()
        self.kernel.forked()
        self.enter_or_end()

    def install(self) -> None:
        """Have everything follow the kernel from now on."""
        locks.install(self.kernel)
        threads.install(self.kernel)
        clocks.install(self.kernel)
        descriptors.install(self.kernel, lambda pid: self.world.touched(pid), lambda group: self.world.typed(group))
        children.install(self.kernel, lambda: self.world, self.enter_child)
        signals.install(self.kernel)
        tracebacks.install()
        chance.install(lambda: self.world.number if hasattr(self, "world") else Coordinator.number)
        self._begin_pace()


def _nothing() -> None:
    pass


def begin() -> None:
    """Take part in the world that the environment names, from now on."""
    place = _Place()
    place.enter_or_end()
    place.install()


def prepare() -> Callable[[float], None]:
    """Let this process be one of virtual time, without a world so far: it must wait for nothing.

    The returned function is for its children, each made by the real `os.fork`: it makes one the first process of the world that
    its environment names then. Nothing else in that is trusted, and may hold its time for so many seconds. Raises OSError.
    Interpreters that are forked for programs (`ready`) take part in worlds that there are.
    """
    from day6_core.virtual.ready import forks

    place = _Place()
    place.kernel.yield_at = FOR_EVER_NS
    place.install()

    def begin_world(limit: float) -> None:
        place.kernel.forked()
        place.enter(limit)

    def join_world() -> None:
        place.kernel.forked()
        place.enter_or_end()
        chance.begin_again()
        descriptors.follow_stdin()

    forks.join = join_world
    return begin_world


def _remove(world: str) -> None:
    """Remove the world's folder, at the end of its first process; not of a child that was forked.

    Nothing is imported here: a module that evaluates text makes Python forget that a KeyboardInterrupt has ended the program.
    """
    if is_first(world):
        remove(world)
