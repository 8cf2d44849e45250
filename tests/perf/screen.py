"""Runs a terminal program on a pty and measures it: first frame, bytes, CPU time, memory, key to echo. Usage is Linux only."""

from __future__ import annotations

import contextlib
import fcntl
import os
import pty
import select
import signal
import struct
import termios
import time
from collections.abc import Callable
from dataclasses import dataclass

QUIET_SECONDS = 0.12
"""The first frame is complete when nothing more was written for this long."""


@dataclass
class Usage:
    """What a program used during `seconds` of wall time."""

    seconds: float
    cpu_seconds: float
    bytes_written: int

    @property
    def cpu_percent(self) -> float:
        """CPU time as a share of one core."""
        return 100 * self.cpu_seconds / self.seconds


class Screen:
    """One program on a pty of its own; use as a context manager, which ends it."""

    def __init__(
        self,
        command: list[str],
        columns: int,
        rows: int,
        cpus: set[int] | None = None,
        cwd: str | None = None,
        **env: str | None,
    ) -> None:
        """`env` is added to this process's variables; None takes one away."""
        self._started = time.perf_counter()
        self.output = bytearray()
        self.pid, self._fd = pty.fork()
        if self.pid == 0:
            if cpus is not None:
                os.sched_setaffinity(0, cpus)
            if cwd is not None:
                os.chdir(cwd)
            set_window_size(0, columns, rows)
            variables = {**os.environ, "TERM": "xterm-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8", **env}
            self.become(command, {name: value for name, value in variables.items() if value is not None})

    def become(self, command: list[str], env: dict[str, str]) -> None:
        """Go on as the command, in the new process; does not return."""
        os.execvpe(command[0], command, env)

    def __enter__(self) -> Screen:
        return self

    def __exit__(self, *_: object) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGTERM)
        deadline = time.perf_counter() + 5
        while time.perf_counter() < deadline:
            self.read(0.05)
            if os.waitpid(self.pid, os.WNOHANG)[0]:
                break
        else:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self._fd)

    def read(self, seconds: float) -> int:
        """Take what is written within `seconds`; returns the number of bytes."""
        deadline = time.perf_counter() + seconds
        before = len(self.output)
        while (left := deadline - time.perf_counter()) > 0:
            if select.select([self._fd], [], [], left)[0]:
                try:
                    self.output += os.read(self._fd, 65536)
                except OSError:
                    break
        return len(self.output) - before

    def first_frame(self, limit: float = 20.0) -> float:
        """Wait for the first complete frame and return the seconds from the start of the program to its last byte."""
        last = 0.0
        while time.perf_counter() - self._started < limit:
            if select.select([self._fd], [], [], QUIET_SECONDS)[0]:
                self.output += os.read(self._fd, 65536)
                last = time.perf_counter() - self._started
            elif len(self.output) > 1500:
                return last
        raise TimeoutError(f"no first frame within {limit} s; got {bytes(self.output[-500:])!r}")

    def send(self, keys: str) -> None:
        """Type."""
        os.write(self._fd, keys.encode())

    def paste(self, text: str) -> None:
        """Paste, as a terminal with bracketed paste does; what the program writes meanwhile is read."""
        left = memoryview(f"\x1b[200~{text}\x1b[201~".encode())
        os.set_blocking(self._fd, False)
        while left:
            readable, writable, _ = select.select([self._fd], [self._fd], [], 5)
            if not (readable or writable):
                raise TimeoutError("the program takes no more of what is pasted")
            if readable:
                self.output += os.read(self._fd, 65536)
            if writable:
                with contextlib.suppress(BlockingIOError):
                    left = left[os.write(self._fd, left) :]
        os.set_blocking(self._fd, True)

    def wait_for(self, condition: Callable[[bytes], bool], limit: float = 20.0) -> None:
        """Read until `condition(all output so far)` holds."""
        deadline = time.perf_counter() + limit
        while not condition(bytes(self.output)):
            if time.perf_counter() > deadline:
                raise TimeoutError(f"got {bytes(self.output[-500:])!r}")
            self.read(0.02)

    def echo_time(self, key: str) -> float:
        """Type one key and return the seconds until the program writes something containing it."""
        self.read(0.05)
        start = len(self.output)
        began = time.perf_counter()
        self.send(key)
        while key.encode() not in self.output[start:]:
            if time.perf_counter() - began > 5:
                raise TimeoutError(f"no echo of {key!r}")
            if select.select([self._fd], [], [], 1)[0]:
                self.output += os.read(self._fd, 65536)
        return time.perf_counter() - began

    def use(self, seconds: float) -> Usage:
        """Let the program run and return what it used (its own process, not its children)."""
        cpu, began = self._cpu_seconds(), time.perf_counter()
        written = self.read(seconds)
        return Usage(time.perf_counter() - began, self._cpu_seconds() - cpu, written)

    def _cpu_seconds(self) -> float:
        total = 0
        for task in os.listdir(f"/proc/{self.pid}/task"):
            with contextlib.suppress(OSError), open(f"/proc/{self.pid}/task/{task}/schedstat") as file:
                total += int(file.read().split()[0])
        return total / 1e9

    def pss_mb(self) -> float:
        """Memory of the process in MB, what it shares with others counted by halves, thirds and so on."""
        with open(f"/proc/{self.pid}/smaps_rollup") as file:
            return next(int(line.split()[1]) / 1024 for line in file if line.startswith("Pss:"))

    def rss_mb(self) -> float:
        """Resident memory of the process in MB."""
        return rss_mb(self.pid)


def set_window_size(fd: int, columns: int, rows: int) -> None:
    """Tell the pty how large its window is; the programs on it hear of a change."""
    fcntl.ioctl(fd, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))


def rss_mb(pid: int) -> float:
    """Resident memory of a process in MB."""
    with open(f"/proc/{pid}/status") as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmRSS"))
