"""Runs programs of ours for a launch, which is a process of its own. The other end, and what is said, is `launch/_host.py`.

They are programs of the desk like all others, with their windows; in `day6-tui exec`, which has no screen, they log.
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

from day6_tui.core.session.program import Program
from day6_tui.core.session.session import Main, Session
from day6_tui.core.session.streams import InputStream, OutputStream

VARIABLE = "DAY6_LAUNCH_HOST"
ROOM = 1024 * 1024
"""Characters of output that wait for the launch at most; what comes then is dropped, whole writes at a time, and counted."""

_log = logging.getLogger(__name__)


class Host:
    """Listens for one launch. `close` ends the programs that run for it."""

    def __init__(self, session: Session) -> None:
        self._session = session
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
            # A folder that only this user can enter; short, because the path of a socket may have 104 characters.
            self._folder = tempfile.mkdtemp(prefix="day6-")
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
        return False  # and what waits for the process hears it too

    # -- the connection, on threads of its own -------------------------------------------------------------------------

    def _serve(self) -> None:
        try:
            connection, _ = self._listener.accept()
        except OSError:
            return  # closed before anybody came
        self._connection = connection
        with connection, connection.makefile("r", encoding="utf-8") as lines:
            if self._secret and not hmac.compare_digest(lines.readline().strip(), self._secret):
                return
            threading.Thread(target=self._write, name="day6-launch-out", daemon=True).start()
            try:
                for line in lines:
                    message = json.loads(line)
                    self._session.scheduler.call_soon_threadsafe(partial(self._obey, message))
            except OSError:
                pass  # as good as its end
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
        """Queue a message; output is not queued (False) while too much is waiting."""
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

    def _obey(self, message: dict[str, Any]) -> None:
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
            status = 0  # a node that is well written ends cleanly on Ctrl-C
        elif program.killed_by:
            status = -program.killed_by
        for stream in (program.session.stdout, program.session.stderr):
            if isinstance(stream, HostedOutput):
                stream.tell_dropped()
        self._send({"is": "ended", "id": number, "code": status})

    def _start(self, number: int, message: dict[str, Any]) -> Program:
        session = self._session
        argv, cwd = message["argv"], Path(message["cwd"])
        main, argv = self._main_of(message["kind"], argv)
        out, err = (HostedOutput(partial(self._tell, number, fd)) for fd in (1, 2))
        desk = session.shell.desk
        from day6_tui.core.shell.language.redirection import Streams

        program: Program = desk.start_program(
            argv, main, Streams(InputStream(), out, err), env=message["env"], cwd=cwd, shell=session.shell
        )
        program.session.background = True
        return program

    def _main_of(self, kind: str, argv: list[str]) -> tuple[Main, list[str]]:
        """Return the program for a request, and its argv. LookupError if there is none."""
        from day6_tui.core.shell.commands import builtin

        if kind == "program":
            from day6_tui.core.ros.programs import load

            package, name = Path(argv[0]).parts[-2:]
            return load(package, name), argv
        if kind == "line":
            argv = ["bash", "-c", argv[0]]
        command = builtin(argv[0].rpartition("/")[2])
        if command is None:
            raise LookupError(f"{argv[0]}: command not found")
        return command, argv

    def _tell(self, number: int, fd: int, text: str) -> bool:
        return self._send({"is": "output", "id": number, "fd": fd, "text": text})

    def _end_programs(self) -> None:
        for program in list(self._programs.values()):
            program.session.terminate()


class HostedOutput(OutputStream):
    """Output of a program that runs for a launch: `tell(text)` sends it there, False when it is full."""

    def __init__(self, tell: Callable[[str], bool]) -> None:
        self._tell = tell
        self._dropped = 0

    def write(self, text: str) -> int:
        if not text:
            return 0
        if self._dropped:
            self.tell_dropped()
        if self._dropped or not self._tell(text):
            self._dropped += text.count("\n")
        return len(text)

    def tell_dropped(self) -> None:
        """Say how much is missing, if that finds room."""
        if self._dropped and self._tell(f"… {self._dropped} lines dropped\n"):
            self._dropped = 0


def _shut(end: socket.socket) -> None:
    try:
        end.shutdown(socket.SHUT_RDWR)
    except OSError:
        _log.debug("a launch's socket was closed already")
    end.close()
