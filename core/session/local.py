"""A session on the real terminal: for `day6-tui ros2 …` and, as streams, for `day6-tui exec`."""

from __future__ import annotations

import _thread
import codecs
import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from day6_tui.core.session.backlog import Backlog
from day6_tui.core.session.clock import WorldClock
from day6_tui.core.session.display import Display
from day6_tui.core.session.keys import split_keys
from day6_tui.core.session.program import Program
from day6_tui.core.session.scheduler import Scheduler, Signal, wait_for
from day6_tui.core.session.session import KilledBySignal, Main, Session
from day6_tui.core.session.streams import END_OF_INPUT, InputStream, OutputStream

if TYPE_CHECKING:
    from day6_tui.core.graph import Graph


GRACE = 2.0
"""Seconds that a child has to end after SIGTERM."""


class RealOutput(OutputStream):
    """Our own standard output or error. A reader that went away breaks it like a pipe."""

    def __init__(self, file: TextIO) -> None:
        self._file = file
        self._muted = False
        self._backlog: Backlog | None = None
        self._held = False
        self.encoding = file.encoding or "utf-8"
        with contextlib.suppress(AttributeError, ValueError):
            file.reconfigure(errors="replace", line_buffering=True)  # type: ignore[attr-defined]

    @property
    def columns(self) -> int:
        try:
            return os.get_terminal_size(self._file.fileno()).columns
        except (OSError, ValueError):
            return 80

    def write(self, text: str) -> int:
        if self._muted:
            return len(text)
        if self._backlog is not None:
            self._backlog.write(self if self._held else None, text)
            if self._held:
                return len(text)
        try:
            return self._file.write(text)
        except BrokenPipeError:
            self._muted = True
            # Python flushes the file once more at exit; that must not fail a second time.
            with contextlib.suppress(OSError, ValueError):
                os.dup2(os.open(os.devnull, os.O_WRONLY), self._file.fileno())
            raise

    def flush(self) -> None:
        if not self._muted:
            self._file.flush()

    def copy_to(self, backlog: Backlog) -> None:
        """Let `backlog` know everything that is written, if this is a terminal (a file need not be watched)."""
        if self.isatty():
            self._backlog = backlog

    def hold(self, held: bool) -> None:
        """Write nothing for the present: the backlog has it."""
        if self._backlog is not None:
            self.flush_quietly()
            self._held = held

    def mute(self) -> None:
        """Write nothing any more."""
        self.flush_quietly()
        self._muted = True

    def flush_quietly(self) -> None:
        with contextlib.suppress(BrokenPipeError):
            self.flush()

    def isatty(self) -> bool:
        return self._file.isatty()

    def fileno(self) -> int | None:
        try:
            self.flush()
            return self._file.fileno()
        except (OSError, ValueError):
            return None  # a test's capture


class RealInput(InputStream):
    """Our own standard input; read by a thread that starts with the first read."""

    def __init__(self) -> None:
        self._waiting: deque[str] = deque()
        """Decoded text not yet returned; '' marks the end."""
        self._rest = ""
        self._arrived = Signal()
        self._thread: threading.Thread | None = None
        self._saved: list[object] | None = None
        self._raw_signals = True

    def isatty(self) -> bool:
        return sys.stdin is not None and sys.stdin.isatty()

    def fileno(self) -> int | None:
        try:
            return sys.stdin.fileno()
        except (AttributeError, OSError, ValueError):
            return None

    async def read_key(self) -> str:
        while True:
            keys = split_keys(self._rest)
            if keys:
                self._rest = self._rest[len(keys[0]) :]
                return keys[0]
            if not await self._more():
                return END_OF_INPUT

    async def read_line(self) -> str:
        while True:
            line, newline, rest = self._rest.partition("\n")
            if newline:
                self._rest = rest
                return line + newline
            if not await self._more():
                line, self._rest = self._rest, ""
                return line

    async def _more(self) -> bool:
        """Wait for more text; False at the end of the input."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._read, name="day6-stdin", daemon=True)
            self._thread.start()
        while not self._waiting:
            self._arrived.clear()
            if not self._waiting:
                await wait_for(self._arrived)
        if not self._waiting[0]:
            return False
        self._rest += self._waiting.popleft()
        return True

    def _read(self) -> None:
        if sys.platform == "win32" and self.isatty():
            self._read_windows()
            return
        decoder = codecs.getincrementaldecoder("utf-8")("replace")
        fd = sys.stdin.fileno()
        while True:
            try:
                data = os.read(fd, 4096)
            except OSError:
                data = b""
            text = decoder.decode(data, final=not data)
            if text or not data:
                self._waiting.append(text)
                self._arrived.set()
            if not data:
                return

    def _read_windows(self) -> None:
        if sys.platform != "win32":
            raise NotImplementedError("only there")
        import msvcrt

        arrows = {"H": "\x1b[A", "P": "\x1b[B", "M": "\x1b[C", "K": "\x1b[D"}
        while True:
            char = msvcrt.getwch()
            if char in ("\x00", "\xe0"):
                char = arrows.get(msvcrt.getwch(), "")
            if char == "\x03" and self._raw_signals:
                _thread.interrupt_main()  # while this reads, Ctrl-C is a key there
            elif char:
                self._waiting.append(char)
                self._arrived.set()

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        if sys.platform == "win32" or not self.isatty():
            yield
            return
        import termios

        fd = sys.stdin.fileno()
        before = termios.tcgetattr(fd)
        self._saved = before
        self._raw_signals = signals
        self._set_raw()
        continued = signal.getsignal(signal.SIGCONT)
        with contextlib.suppress(ValueError):  # only the main thread may
            signal.signal(signal.SIGCONT, lambda number, frame: self._set_raw())
        try:
            yield
        finally:
            self.restore()
            with contextlib.suppress(ValueError):
                signal.signal(signal.SIGCONT, continued)

    def _set_raw(self) -> None:
        if sys.platform == "win32":
            raise NotImplementedError("no termios there")
        import termios

        fd = sys.stdin.fileno()
        mode = termios.tcgetattr(fd)
        mode[3] &= ~(termios.ICANON | termios.ECHO)
        if not self._raw_signals:
            mode[3] &= ~termios.ISIG
        termios.tcsetattr(fd, termios.TCSADRAIN, mode)

    def restore(self) -> None:
        """Give the terminal back as it was found. May be called at any time."""
        if sys.platform != "win32" and self._saved is not None:
            import termios

            termios.tcsetattr(sys.stdin.fileno(), termios.TCSADRAIN, self._saved)  # type: ignore[arg-type]
            self._saved = None


class Foreground:
    """A program that has opened a window, while that window has the terminal for itself."""

    def __init__(self, scheduler: Scheduler, program: Program, display: Display, backlog: Backlog) -> None:
        self.scheduler = scheduler
        """Runs in a thread of its own meanwhile."""
        self.program = program
        self.display = display
        self.backlog = backlog
        """What the program has written and writes; the terminal gets afterwards what it has not got yet."""

    @property
    def over(self) -> bool:
        """Whether the terminal is to be given back: the program has ended or closed its last window."""
        return self.program.status is not None or not self.display.windows


Show = Callable[[Foreground], None]
"""Draws the windows of a program until `Foreground.over`; called on the main thread."""


def has_terminal() -> bool:
    """Say whether a window can be drawn: on a terminal, and not by a job in the background (`&`)."""
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

    `one_shot` is for a command that asks and goes (see `core.link.join`). With `show` the program has a display, and that
    draws its windows on the terminal; without it, it does without windows.
    Ctrl-C interrupts it, SIGTERM and SIGHUP terminate it; a third Ctrl-C ends one that does not listen.
    """
    from day6_tui.core.graph import graph_for_domain
    from day6_tui.core.ros.environment import activate

    activate()
    clock = WorldClock()
    scheduler = Scheduler(clock)
    graph = graph_for_domain(_domain())
    display = Display() if show is not None else None

    def linked_graph() -> Graph:
        if os.environ.get("DAY6_LINK") != "off":
            from day6_tui.core.link import join

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
        cwd=Path.cwd(),
        pid=os.getpid(),
        stdin=stdin,
        stdout=stdout,
        stderr=stderr,
        display=display,
    )
    session.python = _python_in_place
    program = Program(session, main)
    restore = _handle_signals(scheduler, program)
    try:
        while program.status is None:
            scheduler.run(lambda: program.status is not None or (display is not None and bool(display.windows)))
            if program.status is None and display is not None and show is not None:
                _show(show, Foreground(scheduler, program, display, backlog), (stdout, stderr))
    finally:
        restore()
        stdin.restore()
        stdout.flush_quietly()
        if os.environ.get("DAY6_LINK") != "off":
            from day6_tui.core.link import leave

            leave(graph)
    return program.status or 0


def _show(show: Show, foreground: Foreground, outputs: tuple[RealOutput, ...]) -> None:
    """Let the program's windows have the terminal; what it writes meanwhile is printed afterwards."""
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


def _domain() -> int:
    text = os.environ.get("ROS_DOMAIN_ID", "").strip()
    return int(text) if text.isdigit() else 0


def _handle_signals(scheduler: Scheduler, program: Program) -> Callable[[], None]:
    presses = 0

    def interrupt(number: int, frame: object) -> None:
        nonlocal presses
        presses += 1
        scheduler.call_soon_threadsafe(program.interrupt if presses < 3 else program.kill)

    def terminate(number: int, frame: object) -> None:
        scheduler.call_soon_threadsafe(program.terminate)

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
    """`python3 ARGS` as a child on the same terminal, whose Ctrl-C reaches it without us; else as `shell.process.run_python`.

    It stays in our process group, so it is ours to end: also by its guardian, when we are killed ourselves.
    """
    from day6_tui.core.shell.guardian import guard_process, release_process
    from day6_tui.core.shell.signals import from_system, to_system

    done = Signal()
    popen = subprocess.Popen([sys.executable, *args], env=session.env, cwd=session.cwd)
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
            continue  # the terminal told it too, and it may have something to finish
        except KilledBySignal as order:
            popen.send_signal(to_system(order.number))
            await session.wait(done, GRACE)
            end()
    if popen.returncode == -signal.SIGINT:
        raise KeyboardInterrupt
    if popen.returncode < 0:
        raise KilledBySignal(from_system(-popen.returncode))
    return popen.returncode
