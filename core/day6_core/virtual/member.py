"""The coordinator, as every process but the first one sees it."""

from __future__ import annotations

import sys

if sys.platform != "linux":
    raise ImportError("there is no virtual time on this system")

import os
import select
import signal
import socket

from day6_core.virtual.kernel import LONGEST_READING_NS, Kernel
from day6_core.virtual.wire import NEVER, SENT_BY_SYSTEM, SIZE, Flag, Kind, packed, unpacked

_poll, _raise_signal = select.poll, signal.raise_signal
_recv, _send, _connect = socket.socket.recv, socket.socket.sendall, socket.socket.connect


def state_of(kernel: Kernel) -> tuple[int, int, int]:
    """Return what a process tells of itself when it is idle: its flags, its time, and until when it waits."""
    flags = Flag.RAN if kernel.ran else 0
    kernel.ran = False
    watches, holds = kernel.watches
    if watches:
        flags |= Flag.WATCHES
        if holds:
            flags |= Flag.HOLDS
    deadline = kernel.deadline
    return flags, kernel.now, NEVER if deadline is None else deadline


def deliver(kernel: Kernel, number: int) -> None:
    """Let a signal take effect that another process of the world has sent."""
    if number == SENT_BY_SYSTEM:
        kernel.attend()
        return
    if number not in kernel.handlers:
        _raise_signal(number)
        return
    if kernel.wakeup_fd >= 0:
        os.write(kernel.wakeup_fd, bytes([number]))
    kernel.deliver(number)


class Member:
    """Raises OSError if the world has ended."""

    number = 0
    """Of this process, in its world."""

    def __init__(self, path: str) -> None:
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        _connect(self._socket, path)
        self._waiting: list[bytes] = []

    def enter(self, kernel: Kernel) -> None:
        """Wait for the first turn."""
        kernel.now = self._until_go(kernel)
        kernel.yield_at = kernel.now + LONGEST_READING_NS

    # -- for the coordinator -------------------------------------------------------------------------------------------

    def spawned(self, pid: int) -> None:
        """A process was started."""
        self._waiting.append(packed(Kind.SPAWNED, 0, pid, 0))

    def touched(self, pid: int) -> None:
        """Something was sent to a process."""
        self._waiting.append(packed(Kind.TOUCHED, 0, pid, 0))

    def killed(self, target: int, number: int) -> None:
        """A signal was sent to a process, or to a group if negative."""
        self._waiting.append(packed(Kind.KILLED, 0, target, number))

    def typed(self, group: int) -> None:
        """It has typed something for a group of processes."""
        self._waiting.append(packed(Kind.TYPED, 0, group, 0))

    def idle(self, kernel: Kernel) -> int:
        """Wait for the next turn; return the time, ns."""
        frame = packed(Kind.IDLE, *state_of(kernel))
        if self._waiting:
            frame = b"".join((*self._waiting, frame))
            self._waiting.clear()
        self._send(frame)
        return self._until_go(kernel)

    def want(self) -> None:
        """Something has come from outside."""
        self._send(packed(Kind.WANTS, 0, 0, 0))

    def leave(self) -> None:
        """Take part no more."""
        self._socket.close()

    def _send(self, frames: bytes) -> None:
        try:
            _send(self._socket, frames)
        except OSError:
            os._exit(1)

    def _until_go(self, kernel: Kernel) -> int:
        while True:
            data = _recv(self._socket, SIZE, socket.MSG_WAITALL)
            if len(data) < SIZE:
                os._exit(1)  # the world has ended
            kind, flags, first, second = unpacked(data)
            if kind == Kind.GO:
                self.number = self.number or second
                kernel.touched = kernel.touched or flags != 0
                return int(first)
            if kind == Kind.SIGNAL:
                deliver(kernel, first)
            elif kind == Kind.SLEEP:
                self._sleep(kernel)

    def _sleep(self, kernel: Kernel) -> None:
        """Wait until there is a frame, or until something comes from outside and the coordinator has been told."""
        poll = _poll()
        poll.register(self._socket, select.POLLIN)
        for watch in kernel.watched:
            for fd, events in watch.fds:
                poll.register(fd, events)
        found = [fd for fd, _ in poll.poll()]
        if self._socket.fileno() not in found:
            self.want()
