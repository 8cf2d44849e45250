"""Starts desktops by forking a process that has imported everything: five times as fast, and they share memory.

Only where a process can go into a cell by itself (`Mode.plan`), and on Linux. `starting.start` starts them singly where this says
that it cannot.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from typing import Any

LARGEST = 64 << 10
"""Bytes of what is asked for."""

MOST_DESCRIPTORS = 8
READY = b"r"
BEAR_SECONDS = 15.0
"""What a fork may take; the first one waits for all imports."""

_END_SECONDS = 5.0


class Nursery:
    """The process, which is started anew if it was killed. Usable by several threads."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        """`environment` is what all desktops see."""
        self._environment = dict(environment)
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._control: socket.socket | None = None

    def begin(self) -> socket.socket:
        """Have the process, and return the line to it. Raises OSError."""
        if sys.platform != "linux":
            raise OSError(errno.ENOSYS, os.strerror(errno.ENOSYS))
        with self._lock:
            if self._process is not None and self._control is not None:
                if self._process.poll() is None:
                    return self._control
                self._control.close()
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            with theirs:
                self._process = subprocess.Popen(
                    [sys.executable, "-I", "-m", "day6_tui.web.born", str(theirs.fileno()), "-" * LARGEST],
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    env=self._environment,
                    pass_fds=(theirs.fileno(),),
                    cwd="/",
                    start_new_session=True,  # Ctrl-C ends the server, which ends this
                )
            ours.settimeout(BEAR_SECONDS)
            self._control = ours
            return ours

    def bear(self, order: Mapping[str, Any], descriptors: Sequence[int]) -> bool:
        """Have a desktop forked that keeps these descriptors; False if that is not to be had: then nothing has begun."""
        if sys.platform != "linux":
            return False
        data = json.dumps({**order, "descriptors": list(descriptors)}).encode()
        if len(data) > LARGEST:
            return False
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with ours:
            ours.settimeout(BEAR_SECONDS)
            try:
                with theirs:
                    socket.send_fds(self.begin(), [b"1"], [theirs.fileno()])
                if ours.recv(1) != READY:
                    return False
                socket.send_fds(ours, [data], list(descriptors))
            except OSError:  # it was killed, or it is stuck
                return False
        return True

    def close(self) -> None:
        """Let it end; the desktops go on."""
        with self._lock:
            if self._process is None or self._control is None:
                return
            self._control.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(_END_SECONDS)
                return
            self._process.kill()
            self._process.wait()
