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
from day6_core.virtual.kernel import Kernel
from day6_core.virtual.member import Member
from day6_core.virtual.surroundings import VARIABLE, is_first, is_paced, own_world, remove, socket_of
from day6_core.virtual.told import tell
from day6_core.virtual.watchdog import watch


def begin() -> None:
    """Take part in the world that the environment names, from now on."""
    kernel = Kernel()
    begin_pace: Callable[[], None] | None = None
    try:
        folder = own_world()
        path = socket_of(folder)
        world: Coordinator | Member
        if not is_first(folder):
            world = Member(path)
        elif is_paced(folder):
            from day6_core.virtual import paced

            kernel, world = paced.PacedKernel(), paced.PacedCoordinator(path, tell)
            begin_pace = partial(paced.install, kernel, world)
        else:
            world = Coordinator(path, tell)
    except OSError:
        tell("no_world", os.environ[VARIABLE])
        os._exit(1)
    if isinstance(world, Coordinator):
        atexit.register(_remove, folder)
    else:
        world.enter(kernel)
    kernel.world = world

    def enter_child() -> None:
        nonlocal world
        world.leave()
        kernel.forked()
        world = kernel.world = Member(path)
        world.enter(kernel)
        watch(kernel, tell)

    watch(kernel, tell)
    locks.install(kernel)
    threads.install(kernel)
    clocks.install(kernel)
    descriptors.install(kernel, lambda pid: world.touched(pid))
    children.install(kernel, lambda: world, enter_child)
    signals.install(kernel)
    tracebacks.install()
    chance.install(lambda: world.number)
    if begin_pace is not None:
        begin_pace()


def _remove(world: str) -> None:
    """Remove the world's folder, at the end of its first process; not of a child that was forked.

    Nothing is imported here: a module that evaluates text makes Python forget that a KeyboardInterrupt has ended the program.
    """
    if is_first(world):
        remove(world)
