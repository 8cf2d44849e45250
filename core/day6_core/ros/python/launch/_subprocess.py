"""A launched process on this machine: started here, read by threads, in the launch's process group.

So a Ctrl-C reaches it as it reaches the launch. If the launch itself is killed, the guardian ends it.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Callable
from functools import partial
from typing import Any

READ_SIZE = 65536
DRAIN_SECONDS = 0.5
"""How long output is read after a process has ended: its own children may keep the pipe open."""

_POSIX = os.name == "posix"
_running: set[LocalProcess] = set()


class LocalProcess:
    """One process. `on_output(fd, data)` and `on_ended(code)` are called on threads. Raises OSError if it can't start."""

    hosted = False

    def __init__(
        self,
        args: str | list[str],
        *,
        shell: bool,
        cwd: str | None,
        env: dict[str, str],
        emulate_tty: bool,
        on_output: Callable[[int, bytes], object],
        on_ended: Callable[[int], object],
    ) -> None:
        self._on_output = on_output
        self._on_ended = on_ended
        self._readers: list[threading.Thread] = []
        options: dict[str, Any] = {"shell": shell, "cwd": cwd, "env": env, "stdin": subprocess.PIPE}
        if emulate_tty and _POSIX:
            self._start_on_ptys(args, options)
        else:
            self._popen = subprocess.Popen(args, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
            for number, stream in ((1, self._popen.stdout), (2, self._popen.stderr)):
                assert stream is not None
                self._read(number, stream.fileno(), stream.close)
        self.pid = self._popen.pid
        _running.add(self)
        _guard(self.pid)

    def watch(self) -> None:
        """Start the threads that call back."""
        for reader in self._readers:
            reader.start()
        threading.Thread(target=self._wait, name="launch-wait", daemon=True).start()

    def send_signal(self, number: int) -> None:
        """Send a signal. Raises ProcessLookupError if the process has ended."""
        if self._popen.returncode is not None:
            raise ProcessLookupError
        self._popen.send_signal(number)

    def kill(self) -> None:
        self._popen.kill()

    def _start_on_ptys(self, args: str | list[str], options: dict[str, Any]) -> None:
        if sys.platform == "win32":
            raise OSError("there are no ptys on this system")
        import pty
        import termios

        ends = [pty.openpty(), pty.openpty()]
        try:
            for _, slave in ends:
                mode = termios.tcgetattr(slave)
                mode[1] &= ~termios.ONLCR  # lines are assembled here, a \r would stay in them
                termios.tcsetattr(slave, termios.TCSANOW, mode)
            self._popen = subprocess.Popen(args, stdout=ends[0][1], stderr=ends[1][1], **options)
        except BaseException:
            for master, _ in ends:
                os.close(master)
            raise
        finally:
            for _, slave in ends:
                os.close(slave)
        for number, (master, _) in enumerate(ends, 1):
            self._read(number, master, partial(os.close, master))

    def _read(self, number: int, fd: int, close: Callable[[], object]) -> None:
        def pump() -> None:
            try:
                while data := _bytes_from(fd):
                    self._on_output(number, data)
            finally:
                close()

        self._readers.append(threading.Thread(target=pump, name="launch-output", daemon=True))

    def _wait(self) -> None:
        code = self._popen.wait()
        for reader in self._readers:
            reader.join(DRAIN_SECONDS)
        if self._popen.stdin is not None:
            self._popen.stdin.close()
        _running.discard(self)
        _release(self.pid)
        self._on_ended(code)


def _bytes_from(fd: int) -> bytes:
    try:
        return os.read(fd, READ_SIZE)
    except OSError:
        return b""  # on Linux, when the last process has closed the pty


def end_all(grace: float = 2.0) -> None:
    """Terminate all running processes, and kill those that still run after `grace` seconds."""
    left = list(_running)
    for process in left:
        process._popen.terminate()
    for process in left:
        try:
            process._popen.wait(grace)
        except subprocess.TimeoutExpired:
            process._popen.kill()


def _guard(pid: int) -> None:
    from day6_core.guardian import guard_process

    guard_process(pid)


def _release(pid: int) -> None:
    from day6_core.guardian import release_process

    release_process(pid)
