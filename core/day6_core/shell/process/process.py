"""A student's program, or one of the real machine: a process on the streams of the session that started it.

In a terminal the process has a pty as controlling terminal, so line buffering, `input()`, getpass, curses and Ctrl-C are the
system's own. Where its output goes into a pipe or a capture it gets pipes, and where a stream is a real file or our own standard
output it simply inherits that. It leads a session of its own, runs at nice +10, and is ended as a whole group.
"""

from __future__ import annotations

import contextlib
import logging
import os
import shlex
import signal
import subprocess
import sys
import threading
import time
from functools import partial
from pathlib import Path
from typing import IO

from day6_core.advice.fault import LONGEST
from day6_core.guardian import MARK, end_marked, guard, new_mark, release
from day6_core.ros.executables import python_words
from day6_core.session.folder import LOST
from day6_core.session.harmless import KEEP_BYTES
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import KilledBySignal, Session
from day6_core.session.signals import NUMBERS, from_system, to_system
from day6_core.session.streams import InputStream, OutputStream, TerminalSide
from day6_core.session.task import Signal, TaskCancelled, wait_for
from day6_core.session.threads import in_thread
from day6_core.shell.process.feeder import Feeder
from day6_core.shell.process.memory_watch import MemoryWatch
from day6_core.shell.process.output_copy import READ_SIZE, OutputCopy, read_at_once, read_waiting
from day6_core.shell.process.prepared import prepared
from day6_core.shell.process.pty_keys import PtyKeys
from day6_core.shell.process.readiness import has_output

LAST_OUTPUT = 0.5
"""Seconds for which a program that stopped is not reported because its output is behind."""
_ENDED_BY_CTRL_C = 0xC000013A
"""The exit status of a program on Windows that Ctrl-C or Ctrl-Break ended (STATUS_CONTROL_C_EXIT)."""

_log = logging.getLogger(__name__)

_running: set[Process] = set()
_running_lock = threading.Lock()


def _all_running() -> list[Process]:
    with _running_lock:
        return list(_running)


_memory = MemoryWatch(_all_running)


def running_processes(scheduler: Scheduler) -> list[Process]:
    """The students' processes that are running or being started in the world of this scheduler."""
    return [process for process in _all_running() if process.session.scheduler is scheduler]


async def run_python(session: Session, args: list[str]) -> int:
    """Run `python3 ARGS…` for a program until it ends, as `run_process` does; a hint follows an error on the terminal."""
    process = Process(session, python_words(args, session.env))
    status = await _run(session, process)
    launch = session.argv[:2] == ["ros2", "launch"]
    silent = not status and not process.recent and len(session.argv) == 2 and session.argv[1].endswith(".py")
    explained = process.recent and (status or launch)
    if not (explained or silent) or not session.stderr.isatty():
        return status
    if hint := await in_thread(partial(_hint, process.recent, session, launch)):
        session.print_error(hint)
    return status


def _hint(output: str, session: Session, launch: bool) -> str:
    from day6_core.advice.below import first_line_below  # most programs need none
    from day6_core.advice.rules import Surroundings, dimmed, hint_about_silence, hint_below

    around = Surroundings(session.env, session.cwd, launch)
    if not output:
        hint = hint_about_silence(Path(session.argv[-1]), around)
    else:
        hint = hint_below(output, around) or first_line_below(output, around, command=shlex.join(session.argv))
    return dimmed(hint) if hint else ""


async def run_process(session: Session, argv: list[str], name: str = "", *, may_leave_others: bool = True) -> int:
    """Run a process for a program until it ends; returns its exit status. `argv` begins with a path, the program is told `name`.

    Ctrl-C becomes SIGINT, SIGTERM SIGTERM, and SIGKILL SIGKILL of its group. What it leaves outside its group is looked for if it
    `may_leave_others`. Raises KilledBySignal (KeyboardInterrupt for SIGINT) when a signal ended it, and OSError when it could not
    be started.
    """
    return await _run(session, Process(session, argv, name, may_leave_others=may_leave_others))


async def _run(session: Session, process: Process) -> int:
    if not session.cwd.is_dir():
        session.print_error(f"{session.name}: {LOST}")
        return 1
    session.on_stop = process.pause
    session.defer(process.kill)
    process.start()
    while not process.ended.is_set():
        try:
            await wait_for(process.ended)
        except KeyboardInterrupt:
            process.interrupt()
        except TaskCancelled:
            process.kill()
        except KilledBySignal as order:
            process.send(order.number)
    if process.problem is not None:
        raise process.problem
    code = process.returncode
    if code == -2 or code == _ENDED_BY_CTRL_C:
        raise KeyboardInterrupt
    if code < 0:
        raise KilledBySignal(from_system(-code))
    return code


class Process:
    """One child process. `ended` is set when it is gone and its output has been read; then `returncode` is as in subprocess."""

    def __init__(self, session: Session, argv: list[str], name: str = "", *, may_leave_others: bool = True) -> None:
        self.session = session
        self.argv = argv
        self._name = name
        """What the program is told as its name; its path without one."""
        self.ended = Signal()
        self.recent = ""
        """The end of what it wrote to the terminal."""
        self.returncode = 0
        self.problem: Exception | None = None
        self._popen: subprocess.Popen[bytes] | None = None
        self._master: int | None = None
        self._slave: int | None = None
        """Our own descriptor of the program's side of the pty, so that keys it has not read outlive it."""
        self._keys: PtyKeys | None = None
        """What is typed, on its way to the program."""
        self._master_lock = threading.Lock()
        self._feeder: Feeder | None = None
        self._feed_end = -1
        """Our own descriptor of the program's end of the pipe that is fed, so that what it has not read outlives it."""
        self._copies: list[OutputCopy] = []
        """Of its output."""
        self._dropped = False
        """Whether a signal came when it had ended: nobody waits any more for who reads its output."""
        self._early: list[int] | None = []
        """Signals from before there was a process; None once there is one."""
        self._early_lock = threading.Lock()
        self._mark = ""
        self._may_leave_others = may_leave_others
        self._stopped_for: set[str] = set()
        self._orders = 0
        """How often it was told to stop or to go on."""

    @property
    def pid(self) -> int:
        """The system's process number, 0 while it is being started."""
        return self._popen.pid if self._popen is not None else 0

    def start(self) -> None:
        """Start it, on a thread of its own: starting takes milliseconds in which other programs' ticks are due."""
        threading.Thread(target=self._live, name="day6-process", daemon=True).start()

    # -- signals -------------------------------------------------------------------------------------------------------

    def interrupt(self) -> None:
        """Ctrl-C from outside the terminal (`kill -INT`, `timeout`, closing)."""
        self.send(2)

    def kill(self) -> None:
        self.send(9)

    def pause(self, stopped: bool, reason: str = "job") -> None:
        """Stop it or let it go on, where the system can; it stays stopped as long as any reason ('job', 'world') holds."""
        before = bool(self._stopped_for)
        if stopped:
            self._stopped_for.add(reason)
        else:
            self._stopped_for.discard(reason)
        if sys.platform != "win32" and bool(self._stopped_for) != before:
            self._orders += 1
            self.send(NUMBERS["STOP" if self._stopped_for else "CONT"])

    def send(self, number: int) -> None:
        """Deliver a signal to the whole group once it has started; no effect after it has ended.

        On Windows every signal but Ctrl-C just ends it.
        """
        with self._early_lock:
            if self._early is not None:
                self._early.append(number)
                return
        popen = self._popen
        if popen is None or self.ended.is_set():
            return
        if popen.returncode is not None:
            self._dropped = True
        if sys.platform != "win32":
            try:
                os.killpg(popen.pid, to_system(number))
            except (ProcessLookupError, PermissionError):
                return  # gone already (macOS says "not permitted" for a group of zombies)
        elif number == 2:
            popen.send_signal(signal.CTRL_BREAK_EVENT)
        else:
            popen.kill()

    def end_for_memory(self, pid: int, limit: int) -> None:
        """Kill one of its processes, which has more memory than it may, and say so where that is seen."""
        said = f"MemoryError: {self.session.name} was ended: process {pid} had more than {limit / 1e6:.0f} MB"
        hint = _hint(said, self.session, launch=False) if self.session.stderr.isatty() else ""
        for line in filter(None, (said, hint)):
            self.session.scheduler.call_soon_threadsafe(partial(self.session.print_error, line))
        if sys.platform != "win32":
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(pid, signal.SIGKILL)

    # -- the terminal's side -------------------------------------------------------------------------------------------

    def keys(self, text: str) -> None:
        """Send typed keys to the pty, whose line discipline does the echo and the signals."""
        keys = self._keys
        if keys is not None and not keys.put(text.encode("utf-8", KEEP_BYTES)):
            terminal = self.session.stdin.terminal_of()
            if terminal is not None:
                terminal.output.write("\a")  # it does not read, and more than a person types is waiting already

    def resize(self, columns: int, rows: int) -> None:
        with self._master_lock:
            if self._master is not None:
                _set_window_size(self._master, columns, rows)

    def wants_signal_keys(self) -> bool:
        """Whether Ctrl-Z means "stop" to it now, rather than being a key it reads itself."""
        if sys.platform == "win32":
            return False
        import termios

        with self._master_lock:
            if self._master is None:
                return False
            try:
                return bool(termios.tcgetattr(self._master)[3] & termios.ISIG)
            except termios.error:
                return False

    # -- its life, on a thread of its own ------------------------------------------------------------------------------

    def _live(self) -> None:
        with _running_lock:
            _running.add(self)  # now: what it prints may be seen before this thread is back from launching it
        try:
            self._launch()
        except Exception as error:
            # This thread has nobody to tell; `run_python` raises it where the program waits.
            self.problem = error
            self._close_master()
            with _running_lock:
                _running.discard(self)
            self.ended.set()
            return
        popen = self._popen
        assert popen is not None
        try:
            guard(popen.pid)
            _memory.begin()
            self._deliver_early_signals()
            self.returncode = self._wait(popen)
            self._clear_up(popen.pid)
        except Exception as error:
            self.problem = error
        finally:
            with _running_lock:
                _running.discard(self)
            self.ended.set()  # whatever failed: the terminal waits for this

    def _wait(self, popen: subprocess.Popen[bytes]) -> int:
        """Wait for its end; return its status. Meanwhile announce when it stops or goes on and nobody here told it to."""
        if sys.platform == "win32":
            return popen.wait()
        while True:
            orders = self._orders
            try:
                _, status = os.waitpid(popen.pid, os.WUNTRACED | os.WCONTINUED)
            except ChildProcessError:
                return popen.wait()  # somebody else has waited for it
            if os.WIFEXITED(status) or os.WIFSIGNALED(status):
                popen.returncode = os.waitstatus_to_exitcode(status)
                return popen.returncode
            number = from_system(os.WSTOPSIG(status)) if os.WIFSTOPPED(status) else 0
            end = time.monotonic() + LAST_OUTPUT
            for copy in self._copies:  # what it wrote before it stopped comes before the news
                while copy.is_behind() and time.monotonic() < end:
                    copy.join(0.005)
            self.session.scheduler.call_soon_threadsafe(partial(self._changed_itself, number, orders))

    def _changed_itself(self, number: int, orders: int) -> None:
        """It stopped by this signal, or (0) goes on, after so many orders: if none has come since, it is not what we told it."""
        if orders != self._orders or bool(number) == bool(self._stopped_for):
            return
        if number:
            self._stopped_for.add("job")
        else:
            self._stopped_for.discard("job")
        if self.session.on_own_stop is not None and bool(number) == bool(self._stopped_for):
            self.session.on_own_stop(number)

    def _clear_up(self, pid: int) -> None:
        """Clean up after it ended: end what it left running, and pass the keys it has not read to the next reader."""
        typed_ahead = self._take_unread()
        # What the process started in the background may hold its output open; that must not hold up the prompt.
        for copy in self._copies:
            copy.join(0.5)
        with _running_lock:
            _running.discard(self)
        release(pid)
        _end_group(pid)
        if self._mark:
            end_marked(self._mark)
        # What it wrote itself arrives, however long the machine or the reader of a pipe takes.
        for copy in self._copies:
            while copy.is_behind() and not self._dropped:
                copy.join(0.02)
        self._close_master(typed_ahead or self._take_unfed())

    def _deliver_early_signals(self) -> None:
        with self._early_lock:
            early, self._early = self._early, None
        for number in early or ():
            self.send(number)

    def _launch(self) -> None:
        session = self.session
        terminal = session.stdin.terminal_of(session.stdout, session.stderr)
        env = dict(session.env)
        if self._may_leave_others:
            self._mark = env[MARK] = new_mark()
        if terminal is not None and sys.platform != "win32":
            self._launch_on_pty(env, terminal)
        else:
            self._launch_with_pipes(env)

    def _launch_on_pty(self, env: dict[str, str], terminal: TerminalSide) -> None:
        if sys.platform == "win32":
            raise NotImplementedError("no ptys there")
        import pty

        session = self.session
        master, slave = pty.openpty()
        self._master, self._slave = master, slave
        self._keys = PtyKeys(master, slave)
        try:
            _set_window_size(master, terminal.columns, terminal.rows)
            _let_any_key_go_on(slave)
            for name in ("COLUMNS", "LINES"):
                env.pop(name, None)  # programs ask the pty, whose size follows the window; fixed numbers would lie
            self._popen = subprocess.Popen(
                prepared(self.argv, self._name, slave),
                stdin=slave,
                stdout=slave if session.stdout.isatty() else self._child_end(session.stdout),
                stderr=slave if session.stderr.isatty() else self._child_end(session.stderr),
                cwd=session.cwd,
                env=env,
                start_new_session=True,
            )
        except BaseException:
            self._take_unread()
            raise
        session.stdin.pass_keys_to(self)  # before anything of it is seen, to which somebody could type an answer
        shown = session.stdout if session.stdout.terminal is terminal else session.stderr
        self._read(master, shown.raw)
        self._read_pipes()

    def _launch_with_pipes(self, env: dict[str, str]) -> None:
        session = self.session
        # Ctrl-C would cut off the end of block-buffered output.
        env.setdefault("PYTHONUNBUFFERED", "1")
        flags = 0
        if sys.platform == "win32":
            flags = subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.BELOW_NORMAL_PRIORITY_CLASS
            env.setdefault("PYTHONIOENCODING", "utf-8")  # a pipe has the old code page there
        stdin = session.stdin.fileno()
        feeds = stdin is None and type(session.stdin) is not InputStream
        session.stdout.flush()
        session.stderr.flush()
        shown = session.stdout if session.stdout.terminal is not None else session.stderr
        if shown.terminal is not None:
            self._open_screen(shown.terminal)
        feed: int | None = None
        source = subprocess.PIPE if feeds else subprocess.DEVNULL if stdin is None else stdin
        if feeds and sys.platform != "win32":
            source, feed = os.pipe()
            self._feed_end = source
        try:
            self._popen = subprocess.Popen(
                prepared(self.argv, self._name),
                stdin=source,
                stdout=self._child_end(session.stdout),
                stderr=self._child_end(session.stderr),
                cwd=session.cwd,
                env=env,
                start_new_session=sys.platform != "win32",
                creationflags=flags,
            )
        except BaseException:
            for number in (source, feed) if feed is not None else ():
                os.close(number)
            raise
        finally:
            if self._slave is not None:
                os.close(self._slave)
                self._slave = None
        if self._master is not None:
            self._read(self._master, shown.raw)
        self._read_pipes()
        pipe = self._popen.stdin if feed is None else os.fdopen(feed, "wb")
        if pipe is not None:
            self._feeder = Feeder(pipe)
            session.scheduler.call_soon_threadsafe(partial(_spawn_feeding, session, self._feeder))

    def _open_screen(self, terminal: TerminalSide) -> None:
        """Let what it writes to the terminal go through a pty whatever it reads: so it colours and keeps its lines."""
        if sys.platform != "win32":
            import pty

            self._master, self._slave = pty.openpty()
            os.set_blocking(self._master, False)
            _set_window_size(self._master, terminal.columns, terminal.rows)

    def _child_end(self, stream: OutputStream) -> int:
        if self._slave is not None and stream.isatty():
            return self._slave
        inherited = stream.fileno()
        return subprocess.PIPE if inherited is None else inherited

    def _take_unfed(self) -> str:
        """Return what was fed to it but not read: `while read …` reads on there."""
        if self._feeder is None or self._feed_end < 0:
            return ""
        try:
            return self._feeder.take_back(self._feed_end).decode("utf-8", "surrogateescape")
        finally:
            os.close(self._feed_end)

    def _read_pipes(self) -> None:
        popen = self._popen
        assert popen is not None
        if popen.stdout is not None:
            self._read(popen.stdout, self.session.stdout)
        if popen.stderr is not None:
            self._read(popen.stderr, self.session.stderr)

    def _read(self, source: int | IO[bytes], target: OutputStream) -> None:
        seen = self._remember if target.isatty() else None
        copy = OutputCopy(source, target, seen, self._read_master if isinstance(source, int) else read_at_once)
        self._copies.append(copy)
        copy.start()

    def _read_master(self, fd: int) -> bytes:
        """Read what waits in the pty; b'' once our end is closed, when the number may be another program's."""
        with self._master_lock:
            return read_waiting(fd) if self._master == fd else b""

    def _remember(self, text: str) -> None:
        self.recent = (self.recent + text)[-LONGEST:]

    def _take_unread(self) -> str:
        """Close our end of the program's side; return the keys that are still in it, as they were typed."""
        slave, self._slave = self._slave, None
        if slave is None or sys.platform == "win32":
            return ""
        import termios

        unsent = self._keys.close() if self._keys is not None else b""
        data = b""
        try:
            # Linux handles what was typed on a thread of its own, for which this waits: the Ctrl-C that ended the program may not
            # have been echoed, and never would be in the mode below.
            has_output(slave, 0.0)
            mode = termios.tcgetattr(slave)
            mode[3] &= ~(termios.ICANON | termios.ECHO)
            mode[6][termios.VMIN], mode[6][termios.VTIME] = 0, 0
            termios.tcsetattr(slave, termios.TCSANOW, mode)
            while part := os.read(slave, READ_SIZE):  # the kernel hands on what it held back, piece by piece
                data += part
        except (OSError, termios.error) as error:
            _log.debug("what was typed ahead could not be read: %s", error)
        finally:
            os.close(slave)
        data += unsent
        # Ctrl-D is in there as a NUL: it was meant for the program that is gone.
        return data.replace(b"\0", b"").decode("utf-8", "surrogateescape").replace("\n", "\r")

    def _close_master(self, typed_ahead: str = "") -> None:
        with self._master_lock:
            master, self._master = self._master, None
        if master is not None:
            os.close(master)
        # On that thread, because keys may still be on their way there.
        self.session.scheduler.call_soon_threadsafe(lambda: self._hand_on(typed_ahead))

    def _hand_on(self, typed_ahead: str) -> None:
        """Give what was typed, also between the program's end and that of its output, to whoever reads next, in its order."""
        late = self._keys.close() if self._keys is not None else b""
        self.session.stdin.pass_keys_to(None)
        if text := typed_ahead + late.decode("utf-8", "surrogateescape"):
            self.session.stdin.push_back(text)


def _spawn_feeding(session: Session, feeder: Feeder) -> None:
    session.spawn(_feed(session.stdin, feeder))


async def _feed(source: InputStream, feeder: Feeder) -> None:
    """Copy a session's input into its process."""
    try:
        while not feeder.broken and (line := await source.read_line()):
            if not feeder.put(line.encode("utf-8", KEEP_BYTES)):
                source.push_back(line)
            while feeder.is_full:
                feeder.has_room.clear()
                if feeder.is_full:
                    await wait_for(feeder.has_room)
    finally:
        feeder.put(b"")


def _let_any_key_go_on(slave: int) -> None:
    """After Ctrl-S, which people press to save: Ctrl-Q, which lets the output go on elsewhere, is the desktop's."""
    if sys.platform != "win32":
        import termios

        mode = termios.tcgetattr(slave)
        mode[0] |= termios.IXANY
        termios.tcsetattr(slave, termios.TCSANOW, mode)


def _set_window_size(fd: int, columns: int, rows: int) -> None:
    if sys.platform == "win32":
        raise NotImplementedError("no ptys there")
    import fcntl
    import struct
    import termios

    fcntl.ioctl(fd, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))


def _end_group(group: int) -> None:
    """End what the process left running in its own group, if the system has process groups."""
    if sys.platform == "win32":
        return
    for number in (15, 9):
        try:
            os.killpg(group, number)
        except (ProcessLookupError, PermissionError):
            return
        if number == 15:
            time.sleep(0.05)
