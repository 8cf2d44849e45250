"""The day6-tui process that started this launch and runs our own programs for it.

`ros2 launch` is a process, because a launch file is its author's program. But turtlesim, robot_state_publisher or RViz are
parts of day6-tui and have their windows there. So the `ros2 launch` command listens on a socket (its address is in
DAY6_LAUNCH_HOST) and the two send each other lines of JSON:

    here → host    {"do": "start", "id": 1, "kind": "program", "argv": [...], "cwd": "...", "env": {...}}
                   {"do": "signal", "id": 1, "number": 2}
    host → here    {"is": "started", "id": 1, "pid": 1007}     {"is": "output", "id": 1, "fd": 2, "text": "..."}
                   {"is": "ended", "id": 1, "code": 0}         {"is": "failed", "id": 1, "reason": "..."}
                   {"is": "interrupted"}                       (Ctrl-C went to the command, not to this process)

Only this side decides what is launched, when, how its output looks and what follows its end. When the connection ends, either
side ends its programs. The address is `unix:PATH`, or `tcp:PORT:SECRET` where there are no Unix sockets.
"""

from __future__ import annotations

import itertools
import json
import os
import socket
import sys
import threading
from collections.abc import Callable, Container
from typing import Any

VARIABLE = "DAY6_LAUNCH_HOST"


def connect(terminals: Container[str]) -> HostConnection | None:
    """Connect to the host of this launch, which can open these `terminals`; returns None if there is no host.

    The address is removed from the environment: launched programs must not find it.
    """
    address = os.environ.pop(VARIABLE, "")
    return HostConnection(_open(address), terminals) if address else None


def _open(address: str) -> socket.socket:
    kind, _, rest = address.partition(":")
    if sys.platform != "win32" and kind == "unix":
        connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        connection.connect(rest)
        return connection
    port, _, secret = rest.partition(":")
    connection = socket.create_connection(("127.0.0.1", int(port)))
    connection.sendall(f"{secret}\n".encode())
    return connection


class HostedProcess:
    """A program of ours that runs in the host. The callbacks are called on the connection's thread."""

    hosted = True

    def __init__(
        self,
        owner: HostConnection,
        number: int,
        on_started: Callable[[], object],
        on_output: Callable[[int, bytes], object],
        on_ended: Callable[[int], object],
        on_failed: Callable[[str], object],
    ) -> None:
        self.pid = 0
        self._owner = owner
        self._number = number
        self.on_started = on_started
        self.on_output = on_output
        self.on_ended = on_ended
        self.on_failed = on_failed

    def send_signal(self, number: int) -> None:
        """Send a signal, by its number on Linux."""
        self._owner.send({"do": "signal", "id": self._number, "number": int(number)})

    def kill(self) -> None:
        self.send_signal(9)


class HostConnection:
    """The connection to the host. `on_interrupt` is called, on its thread, when the host got a Ctrl-C."""

    def __init__(self, connection: socket.socket, terminals: Container[str]) -> None:
        self.terminals = terminals
        """Names of the commands that open a terminal in the host."""
        self._connection = connection
        self._lock = threading.Lock()
        self._numbers = itertools.count(1)
        self._processes: dict[int, HostedProcess] = {}
        self.on_interrupt: Callable[[], object] | None = None
        threading.Thread(target=self._read, name="launch-host", daemon=True).start()

    def start(
        self,
        kind: str,
        argv: list[str],
        *,
        cwd: str | None,
        env: dict[str, str],
        on_started: Callable[[], object],
        on_output: Callable[[int, bytes], object],
        on_ended: Callable[[int], object],
        on_failed: Callable[[str], object],
    ) -> HostedProcess:
        """Start a program in the host; either `on_started` or `on_failed` will be called."""
        number = next(self._numbers)
        process = HostedProcess(self, number, on_started, on_output, on_ended, on_failed)
        self._processes[number] = process
        folder = os.path.abspath(cwd or os.curdir)
        self.send({"do": "start", "id": number, "kind": kind, "argv": argv, "cwd": folder, "env": env})
        return process

    def send(self, message: dict[str, Any]) -> None:
        """Send one message; a broken connection is ignored."""
        data = json.dumps(message).encode("utf-8") + b"\n"
        with self._lock:
            try:
                self._connection.sendall(data)
            except OSError:
                return  # the reading thread reports the end of the processes

    def _read(self) -> None:
        try:
            with self._connection.makefile("r", encoding="utf-8") as lines:
                for line in lines:
                    self._handle(json.loads(line))
        except OSError:
            pass  # a broken connection has ended too
        finally:
            if self.on_interrupt is not None:
                self.on_interrupt()
            for process in list(self._processes.values()):
                process.on_ended(-9)
            self._processes.clear()

    def _handle(self, message: dict[str, Any]) -> None:
        if message["is"] == "interrupted":
            if self.on_interrupt is not None:
                self.on_interrupt()
            return
        process = self._processes.get(message["id"])
        if process is None:
            return
        if message["is"] == "started":
            process.pid = message["pid"]
            process.on_started()
        elif message["is"] == "output":
            process.on_output(message["fd"], message["text"].encode("utf-8", "surrogateescape"))
        elif message["is"] == "ended":
            del self._processes[message["id"]]
            process.on_ended(message["code"])
        elif message["is"] == "failed":
            del self._processes[message["id"]]
            process.on_failed(message["reason"])
