"""`%ros2 LINE`: a ros2 command whose output comes into the cell as text, and which the kernel's interrupt ends as Ctrl-C does.

`!ros2` gives commands a terminal, into which those that have a window draw it; here they have none, as in a pipe. With `&` at its
end the line goes on in the background until the kernel ends.
"""

from __future__ import annotations

import atexit
import codecs
import math
import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from contextvars import copy_context
from typing import IO

from day6_core.guardian import guard, release
from day6_tui.locale import Texts

READ_SIZE = 1 << 16
LOOK_SECONDS = 0.5
"""On Windows no signal interrupts a wait."""
REST_SECONDS = 0.5
"""For the last output to come."""
END_SECONDS = 3.0
"""What Ctrl-C gives a command to end."""


class Ros2Line:
    """The magic, and what it has running in the background."""

    def __init__(self, texts: Texts) -> None:
        self._texts = texts
        self._running: list[_Command] = []
        atexit.register(self.close)

    def run(self, line: str) -> None:
        """Run a ros2 command; with & at the end in the background."""
        line = line.strip()
        command = _Command(line.removesuffix("&").rstrip())
        if line.endswith("&"):
            self._running = [each for each in self._running if not each.wait(0)]
            self._running.append(command)
            print(self._texts("notebook.ros2.background", end=command.end_line))
            return
        self._wait(command)

    @staticmethod
    def _wait(command: _Command) -> None:
        ended, latest = False, math.inf
        while not ended:
            try:
                ended = command.wait(LOOK_SECONDS)
                if time.monotonic() > latest:
                    command.kill()
            except KeyboardInterrupt:
                print("^C")
                command.interrupt()
                latest = time.monotonic() + END_SECONDS

    def close(self) -> None:
        """End what runs in the background."""
        atexit.unregister(self.close)
        for command in self._running:
            command.interrupt()
        for command in self._running:
            if not command.wait(END_SECONDS):
                command.kill()


class _Command:
    """A line that runs: its process, and the thread that brings its output into the cell in which it was started."""

    def __init__(self, line: str) -> None:
        flags = 0
        if sys.platform == "win32":
            flags = subprocess.CREATE_NEW_PROCESS_GROUP
        self._process = subprocess.Popen(
            f"ros2 {line}",
            shell=True,  # as after !, with | and > and quotes
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env={"PYTHONUNBUFFERED": "1", "PYTHONIOENCODING": "utf-8", **os.environ},
            start_new_session=sys.platform != "win32",
            creationflags=flags,
        )
        guard(self._process.pid)
        assert self._process.stdout is not None
        # A thread has no variables of its own, and by those of the cell ipykernel 7 knows where output belongs.
        self._reader = threading.Thread(
            target=copy_context().run, args=(self._show, self._process.stdout), name="day6 ros2", daemon=True
        )
        self._reader.start()

    @property
    def end_line(self) -> str:
        """What to run in a cell to end it."""
        pid = self._process.pid
        return f"!taskkill /T /F /PID {pid}" if sys.platform == "win32" else f"!kill -INT -- -{pid}"

    def wait(self, seconds: float) -> bool:
        """Wait for its end; False if these seconds were over before."""
        try:
            self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        self._reader.join(REST_SECONDS)  # a daemon that it has started may hold the pipe open
        return True

    def interrupt(self) -> None:
        """End it as Ctrl-C does."""
        if sys.platform == "win32":
            self._process.send_signal(signal.CTRL_BREAK_EVENT)
        else:
            self._send(signal.SIGINT)

    def kill(self) -> None:
        """End it whether it wants or not."""
        if sys.platform == "win32":
            self._process.kill()
        else:
            self._send(signal.SIGKILL)

    def _send(self, number: int) -> None:
        if sys.platform != "win32" and self._process.poll() is None:
            with suppress(ProcessLookupError, PermissionError):  # it has just ended
                os.killpg(self._process.pid, number)

    def _show(self, pipe: IO[bytes]) -> None:
        decoder = codecs.getincrementaldecoder("utf-8")("replace")
        with pipe:
            while data := os.read(pipe.fileno(), READ_SIZE):
                sys.stdout.write(decoder.decode(data))
        self._process.wait()
        release(self._process.pid)
