"""Runs our programs for a launch, which is a separate process. `launch/_host.py` is the other end and has the protocol.

They are ordinary programs of the desk, with their windows; in `day6-tui exec`, which has no screen, they log.
"""

from __future__ import annotations

import hmac
import json
import logging
import os
import secrets
import shutil
import socket
import tempfile
import threading
from collections import deque
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from day6_core.link.paths import LONGEST_SOCKET_PATH
from day6_core.session import host
from day6_core.session.display import ProgramDisplay
from day6_core.session.program import Program
from day6_core.session.session import Main, Session
from day6_core.session.streams import OutputStream

VARIABLE = "DAY6_LAUNCH_HOST"
ROOM = 1024 * 1024
"""The most characters of output that wait for the launch; beyond that whole writes are dropped, and counted."""

_log = logging.getLogger(__name__)


class LaunchHost:
    """Serves one launch. `close` ends the programs that run for it."""

    def __init__(self, session: Session, machine: host.Host) -> None:
        self._session = session
        self._machine = machine
        self._programs: dict[int, Program] = {}
        self._connection: socket.socket | None = None
        self._folder: str | None = None
        self._secret = ""
        self._outbox: deque[bytes] = deque()
        self._waiting = 0
        self._changed = threading.Condition()
        self._closed = False
        self._listener = self._listen()
        session.on_interrupt = self._interrupted
        threading.Thread(target=self._serve, name="day6-launch", daemon=True).start()

    def _listen(self) -> socket.socket:
        if hasattr(socket, "AF_UNIX") and os.name == "posix":
            # A folder that only this user can enter; in /tmp if a socket's name would be too long in TMPDIR.
            long = len(os.fsencode(tempfile.gettempdir())) + len("/day6-12345678/launch") > LONGEST_SOCKET_PATH
            self._folder = tempfile.mkdtemp(prefix="day6-", dir="/tmp" if long else None)
            path = os.path.join(self._folder, "launch")
            listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            listener.bind(path)
            self.address = f"unix:{path}"
        else:
            self._secret = secrets.token_hex(16)
            listener = socket.create_server(("127.0.0.1", 0))
            self.address = f"tcp:{listener.getsockname()[1]}:{self._secret}"
        listener.listen(1)
        return listener

    def close(self) -> None:
        """End the programs and the connection. On the scheduler's thread."""
        self._closed = True
        self._session.on_interrupt = None
        for program in list(self._programs.values()):
            program.session.terminate()
        with self._changed:
            self._changed.notify_all()
        for end in (self._listener, self._connection):
            if end is not None:
                _shut(end)
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)

    def _interrupted(self) -> bool:
        self._send({"is": "interrupted"})
        return False  # whatever waits for the process gets the signal too

    # -- connection, on its own threads --------------------------------------------------------------------------------

    def _serve(self) -> None:
        try:
            connection, _ = self._listener.accept()
        except OSError:
            return  # closed before the launch connected
        self._connection = connection
        with connection, connection.makefile("r", encoding="utf-8") as lines:
            if self._secret and not hmac.compare_digest(lines.readline().strip(), self._secret):
                return
            threading.Thread(target=self._write, name="day6-launch-out", daemon=True).start()
            try:
                for line in lines:
                    message = json.loads(line)
                    self._session.scheduler.call_soon_threadsafe(partial(self._handle, message))
            except OSError:
                pass  # the launch is gone: the same as the end of its input
            finally:
                self._session.scheduler.call_soon_threadsafe(self._end_programs)

    def _write(self) -> None:
        while True:
            with self._changed:
                while not self._outbox:
                    if self._closed:
                        return
                    self._changed.wait()
                data = b"".join(self._outbox)
                self._outbox.clear()
                self._waiting = 0
            try:
                assert self._connection is not None
                self._connection.sendall(data)
            except OSError:
                self._closed = True
                return

    def _send(self, message: dict[str, Any]) -> bool:
        """Queue a message; returns False for output that finds the queue full."""
        data = json.dumps(message).encode("utf-8") + b"\n"
        with self._changed:
            if self._closed:
                return True
            if message["is"] == "output" and self._waiting + len(data) > ROOM:
                return False
            self._outbox.append(data)
            self._waiting += len(data)
            self._changed.notify_all()
        return True

    # -- programs, on the scheduler's thread ---------------------------------------------------------------------------

    def _handle(self, message: dict[str, Any]) -> None:
        if self._closed:
            return
        number: int = message["id"]
        if message["do"] == "signal":
            program = self._programs.get(number)
            if program is not None:
                program.send(message["number"])
            return
        try:
            program = self._start(number, message)
        except (LookupError, OSError) as error:
            self._send({"is": "failed", "id": number, "reason": f"{type(error).__name__}: {error}"})
            return
        self._programs[number] = program
        self._send({"is": "started", "id": number, "pid": program.pid})
        self._session.scheduler.spawn(self._wait_for(number, program), f"{program.session.name} (launched)")

    async def _wait_for(self, number: int, program: Program) -> None:
        status = await program.wait()
        self._programs.pop(number, None)
        if program.killed_by == 2:
            status = 0  # a well-written node exits cleanly on Ctrl-C
        elif program.killed_by:
            status = -program.killed_by
        for stream in (program.session.stdout, program.session.stderr):
            if isinstance(stream, HostedOutput):
                stream.report_dropped()
        self._send({"is": "ended", "id": number, "code": status})

    def _start(self, number: int, message: dict[str, Any]) -> Program:
        argv, cwd = message["argv"], Path(message["cwd"])
        main, argv = self._main_of(message["kind"], argv)
        out, err = (HostedOutput(partial(self._send_output, number, fd)) for fd in (1, 2))
        program = self._machine.start_beside(argv, main, out, err, env=message["env"], cwd=cwd)
        if isinstance(program.session.display, ProgramDisplay):
            program.session.display.belong_to(self._session.pid)
        return program

    def _main_of(self, kind: str, argv: list[str]) -> tuple[Main, list[str]]:
        """Return the program for a request, and its argv. Raises LookupError if there is none."""
        if kind == "program":
            from day6_core.ros.programs import load

            package, name = Path(argv[0]).parts[-2:]
            return load(package, name), argv
        if kind == "line":
            argv = ["bash", "-c", argv[0]]
        command = self._machine.command(argv[0].rpartition("/")[2])
        if command is None:
            raise LookupError(f"{argv[0]}: command not found")
        return command, argv

    def _send_output(self, number: int, fd: int, text: str) -> bool:
        return self._send({"is": "output", "id": number, "fd": fd, "text": text})

    def _end_programs(self) -> None:
        for program in list(self._programs.values()):
            program.session.terminate()


class HostedOutput(OutputStream):
    """Output of a program that runs for a launch; `send(text)` sends it there and returns False when the queue is full."""

    def __init__(self, send: Callable[[str], bool]) -> None:
        self._send = send
        self._dropped = 0

    def write(self, text: str) -> int:
        if not text:
            return 0
        if self._dropped:
            self.report_dropped()
        if self._dropped or not self._send(text):
            self._dropped += text.count("\n")
        return len(text)

    def report_dropped(self) -> None:
        """Write how many lines are missing, if the queue has room."""
        if self._dropped and self._send(f"… {self._dropped} lines dropped\n"):
            self._dropped = 0


def _shut(end: socket.socket) -> None:
    try:
        end.shutdown(socket.SHUT_RDWR)
    except OSError:
        _log.debug("a launch's socket was closed already")
    end.close()
