"""A session on the real terminal: for `day6-tui ros2 …` and, as streams, for `day6-tui exec`."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_core.session.backlog import Backlog
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.ending import Ending, EndingStep
from day6_core.session.folder import working_folder
from day6_core.session.program import Program
from day6_core.session.real_streams import RealInput, RealOutput
from day6_core.session.scheduler import STUCK_SECONDS, Scheduler
from day6_core.session.session import KilledBySignal, Main, Session
from day6_core.session.task import Signal, wait_for

if TYPE_CHECKING:
    from day6_core.graph import Graph


GRACE = 2.0
"""Seconds that a child gets to end after SIGTERM."""


INSIST_SECONDS = 0.5
"""Seconds that a program gets to end once its user has insisted; then it is ended by force."""

SIGNALS_TO_INSIST = 3
"""Signals by which a user insists; two are enough for a one-shot command and for a window."""


class Foreground:
    """A program while its window has the terminal to itself."""

    def __init__(
        self, scheduler: Scheduler, program: Program, display: Display, backlog: Backlog, ending: Ending
    ) -> None:
        self.scheduler = scheduler
        """Runs in its own thread during that time."""
        self.program = program
        self.display = display
        self.backlog = backlog
        """The program's output so far; the terminal gets the unwritten part afterwards."""
        self.ending = ending
        """How the process ends by force; the code that draws sets its `restore_terminal`."""

    @property
    def over(self) -> bool:
        """Whether the terminal is free again: the program has ended or closed its last window."""
        return self.program.status is not None or not self.display.windows


Show = Callable[[Foreground], None]
"""Draws the windows of a program until `Foreground.over`; called on the main thread."""


def has_terminal() -> bool:
    """Return whether a window can be drawn: on a terminal, and not by a job in the background (`&`)."""
    if sys.stdin is None or sys.stderr is None or not (sys.stdin.isatty() and sys.stderr.isatty()):
        return False
    if os.environ.get("TERM") == "dumb":
        return False
    if sys.platform == "win32":
        return True
    try:
        return os.tcgetpgrp(sys.stderr.fileno()) == os.getpgrp()
    except OSError:
        return False


def run_local(main: Main, argv: list[str], *, one_shot: bool = False, show: Show | None = None) -> int:
    """Run one program on the real terminal, on this machine's graph, in this thread. Returns its exit status.

    `one_shot` is for a command that queries and ends (see `day6_core.link.join`). With `show` the program has a display, whose
    windows `show` draws on the terminal; otherwise it has no windows.
    Ctrl-C interrupts the program, SIGTERM and SIGHUP terminate it; a third Ctrl-C kills one that ignores the others. Half a
    second after the second signal (with a display or `one_shot`; otherwise the third) the process ends by force.
    """
    from day6_core.graph import graph_for_domain
    from day6_core.graph.domain import domain_from_text
    from day6_core.ros.environment import activate

    activate()
    clock = WorldClock()
    scheduler = Scheduler(clock, may_wait=True)
    joined: list[Graph] = []
    display = Display() if show is not None else None

    def linked_graph() -> Graph:
        graph = graph_for_domain(domain_from_text(os.environ.get("ROS_DOMAIN_ID", "")))
        joined.append(graph)
        if os.environ.get("DAY6_LINK") != "off":
            from day6_core.link import join

            join(graph, one_shot=one_shot, never_wait=display is not None)
        return graph

    stdin, stdout, stderr = RealInput(), RealOutput(sys.stdout), RealOutput(sys.stderr)
    backlog = Backlog()
    if show is not None:
        stdout.copy_to(backlog)
        stderr.copy_to(backlog)
    session = Session(
        scheduler,
        linked_graph,
        argv,
        env=dict(os.environ),
        cwd=working_folder(),
        pid=os.getpid(),
        stdin=stdin,
        stdout=stdout,
        stderr=stderr,
        display=display,
    )
    session.background = display is None
    session.python = _python_in_place
    program = Program(session, main)
    insisting = 2 if one_shot or display is not None else SIGNALS_TO_INSIST
    ending = Ending(
        *[EndingStep(_already_signalled, None)] * (insisting - 1), EndingStep(_already_signalled, INSIST_SECONDS)
    )
    ending.restore_terminal = stdin.restore
    restore = _handle_signals(scheduler, program, ending)
    ending.watch_signals()
    try:
        while program.status is None:
            scheduler.run(lambda: program.status is not None or (display is not None and bool(display.windows)))
            if program.status is None and display is not None and show is not None:
                _show(show, Foreground(scheduler, program, display, backlog, ending), (stdout, stderr))
    finally:
        ending.over()
        stdin.restore()
        stdout.flush_quietly()
        if os.environ.get("DAY6_LINK") != "off":
            from day6_core.link import leave

            for graph in joined:
                leave(graph, ending=True)
        restore()
    return program.status or 0


def _show(show: Show, foreground: Foreground, outputs: tuple[RealOutput, ...]) -> None:
    """Let the program's windows have the terminal; its output of that time is printed afterwards."""
    for output in outputs:
        output.hold(True)
    foreground.scheduler.start()
    try:
        show(foreground)
    finally:
        foreground.scheduler.stop()
        for output in outputs:
            output.hold(False)
        with contextlib.suppress(BrokenPipeError):
            foreground.backlog.release()


def _already_signalled() -> None:
    """Do nothing: the signal handler has already interrupted or terminated the program."""


def _handle_signals(scheduler: Scheduler, program: Program, ending: Ending) -> Callable[[], None]:
    from day6_core.session.signals import from_system

    presses = 0

    def stuck() -> bool:
        """Whether the program does not reach its next wait; it is then interrupted in the middle, like any Python program."""
        here = threading.get_ident() == scheduler._thread_id
        return here and scheduler.stuck_for > STUCK_SECONDS

    def interrupt(number: int, frame: object) -> None:
        nonlocal presses
        presses += 1
        ending.signal_received(number)
        scheduler.call_soon_threadsafe(program.interrupt if presses < 3 else program.kill)
        if stuck():
            raise KeyboardInterrupt

    def terminate(number: int, frame: object) -> None:
        ending.signal_received(number)
        scheduler.call_soon_threadsafe(lambda: program.send(from_system(number)))
        if stuck():
            raise KilledBySignal(from_system(number))

    wanted = {"SIGINT": interrupt, "SIGTERM": terminate, "SIGHUP": terminate}
    before = {
        getattr(signal, name): signal.signal(getattr(signal, name), handler)
        for name, handler in wanted.items()
        if hasattr(signal, name)
    }

    def restore() -> None:
        for number, handler in before.items():
            signal.signal(number, handler)

    return restore


async def _python_in_place(session: Session, args: list[str]) -> int:
    """Run `python3 ARGS` as a child on the same terminal, whose Ctrl-C reaches it directly; else as `shell.process.run_python`.

    The child stays in our process group, so we have to end it; its guardian does if we are killed.
    """
    from day6_core.guardian import guard_process, release_process
    from day6_core.ros.home_python import python_of_home
    from day6_core.session.signals import from_system, to_system

    done = Signal()
    popen = subprocess.Popen([python_of_home(session.env), *args], env=session.env, cwd=session.cwd)
    guard_process(popen.pid)

    def wait() -> None:
        popen.wait()
        done.set()

    def end() -> None:
        if popen.poll() is None:
            popen.kill()
            popen.wait()
        release_process(popen.pid)

    session.defer(end)
    threading.Thread(target=wait, name="day6-process", daemon=True).start()
    while not done.is_set():
        try:
            await wait_for(done)
        except KeyboardInterrupt:
            continue  # the child got it from the terminal as well, and may have something to finish
        except KilledBySignal as order:
            popen.send_signal(to_system(order.number))
            await session.wait(done, GRACE)
            end()
    if popen.returncode == -signal.SIGINT:
        raise KeyboardInterrupt
    if popen.returncode < 0:
        raise KilledBySignal(from_system(-popen.returncode))
    return popen.returncode
