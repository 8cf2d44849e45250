"""Processes packages in parallel, each after those it depends on, and stops as colcon does when one fails."""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import IO

from day6_core.guardian import guard, release
from day6_core.reason import fault, reason_and_name
from day6_core.session.cores import join
from day6_core.workspace.events import INTERRUPTED, BuildEvent, Events, Result

TICK = 0.1
"""Seconds between two updates of the status line."""

GRACE = 2.0
"""Seconds a command has to end after Ctrl-C before it is killed."""


class OnError(Enum):
    """What happens to the other packages when one fails."""

    INTERRUPT = "running ones are aborted, waiting ones are not started"
    SKIP_DOWNSTREAM = "only those that depend on it are not started"
    CONTINUE = "nothing"


class JobFailure(Exception):
    """A package failed before any of its commands ran; the text is shown again at the very end."""


@dataclass
class Job:
    """One package to process. `run` does the work in a thread and returns an exit status."""

    name: str
    needs: set[str]
    run: Callable[[Work], int]
    kind: str = ""
    """The package's type."""


@dataclass
class Work:
    """The services a running job uses: emitting events, and running commands that Ctrl-C ends."""

    job: str
    events: Events
    _processes: list[subprocess.Popen[bytes]] = field(default_factory=list)
    _stopped: threading.Event = field(default_factory=threading.Event)

    @property
    def stopped(self) -> bool:
        """Whether this job must end now."""
        return self._stopped.is_set()

    def stdout(self, text: str) -> None:
        """Emit a line of standard output."""
        self.events.emit(BuildEvent("stdout", self.job, text))

    def stderr(self, text: str) -> None:
        """Emit a line of standard error."""
        self.events.emit(BuildEvent("stderr", self.job, text))

    def run(
        self, command: list[str], cwd: Path, env: Mapping[str, str], *, shown: str = "", one_stream: bool = False
    ) -> int:
        """Run a command and emit its output; returns its exit status, negative for a signal.

        With `one_stream` all it writes is its standard output.

        Raises:
            OSError: the command cannot be started.
        """
        process = self.start(command, cwd, env)
        assert process.stdin is not None
        process.stdin.close()
        shown = shown or " ".join(command)
        self.log_command(cwd, shown)
        errors = self.stdout if one_stream else self.stderr
        readers = [self.copy(process.stdout, self.stdout), self.copy(process.stderr, errors)]
        return self.finish(process, readers, cwd, shown)

    def log_command(self, cwd: Path, shown: str) -> None:
        """Emit the start of a command, for the logs."""
        self.events.emit(BuildEvent("command", self.job, f"Invoking command in '{cwd}': {shown}\n"))

    def report_test_failure(self) -> None:
        """Emit that a test of this package failed."""
        self.events.emit(BuildEvent("test_failure", self.job))

    def start(self, command: list[str], cwd: Path, env: Mapping[str, str]) -> subprocess.Popen[bytes]:
        """Start a command in its own process group, with pipes."""
        flags = 0
        if sys.platform == "win32":
            flags = subprocess.CREATE_NEW_PROCESS_GROUP
        process = subprocess.Popen(
            command,
            cwd=cwd,
            env=dict(env),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=sys.platform != "win32",
            creationflags=flags,
        )
        guard(process.pid)
        self._processes.append(process)
        if self.stopped:
            self.stop()
        return process

    def copy(
        self,
        source: IO[bytes] | None,
        target: Callable[[str], None],
        at_end: Callable[[None], object] | None = None,
    ) -> threading.Thread:
        """Pass the lines of a pipe to `target`, on a thread, until its end; then call `at_end(None)`."""
        assert source is not None
        pipe = source

        def read() -> None:
            try:
                with pipe:
                    for line in pipe:
                        target(line.decode("utf-8", "replace").replace("\r\n", "\n"))
            finally:
                if at_end is not None:
                    at_end(None)

        thread = threading.Thread(target=read, name="day6-build-output", daemon=True)
        thread.start()
        return thread

    def finish(self, process: subprocess.Popen[bytes], readers: list[threading.Thread], cwd: Path, shown: str) -> int:
        """Wait for a command and its last line, and emit its end; returns its exit status."""
        status = self.reap(process, readers)
        self.events.emit(
            BuildEvent("command_ended", self.job, f"Invoked command in '{cwd}' returned '{status}': {shown}\n")
        )
        return status

    def reap(self, process: subprocess.Popen[bytes], readers: list[threading.Thread]) -> int:
        """Wait until a command has ended and its last line is read; returns its exit status. May be called again."""
        status = process.wait()
        for reader in readers:
            join(reader, 1.0)
        if process in self._processes:
            self._processes.remove(process)
            release(process.pid)
        return status

    def stop(self) -> None:
        """End the commands of this job, as Ctrl-C does."""
        self._stopped.set()
        for process in list(self._processes):
            _end(process)


def _end(process: subprocess.Popen[bytes]) -> None:
    if process.poll() is not None:
        return
    if sys.platform == "win32":
        process.terminate()
        return
    try:
        os.killpg(process.pid, signal.SIGINT)
    except (ProcessLookupError, PermissionError):
        return

    def kill() -> None:
        if process.poll() is None:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except (ProcessLookupError, PermissionError):
                return

    timer = threading.Timer(GRACE, kill)
    timer.daemon = True
    timer.start()


class Executor:
    """Runs jobs, at most `workers` at once (0: no limit)."""

    def __init__(self, events: Events, workers: int, on_error: OnError) -> None:
        self._events = events
        self._workers = workers
        self._on_error = on_error
        self._running: dict[str, Work] = {}
        self._ended: queue.Queue[tuple[str, Result | Exception] | None] = queue.Queue()
        self._interrupted = False

    def interrupt(self) -> None:
        """Stop all jobs, as Ctrl-C does. Callable from any thread."""
        self._interrupted = True
        self._ended.put(None)

    def run(self, jobs: list[Job]) -> Result | Exception:
        """Run all and return 0, the first other result, INTERRUPTED, or the exception that ended a job."""
        for job in jobs:
            self._events.emit(BuildEvent("queued", job.name, job.kind))
        self._events.emit(BuildEvent("tick"))
        outcome: Result | Exception = 0
        waiting = {job.name: job for job in jobs}
        while waiting or self._running:
            if self._interrupted:
                outcome = INTERRUPTED
                waiting.clear()
                self._stop_all()
            self._start_ready(waiting)
            if not self._running:
                break
            try:
                message = self._ended.get(timeout=TICK)
            except queue.Empty:
                self._events.emit(BuildEvent("tick"))
                continue
            if message is None:
                continue
            name, result = message
            del self._running[name]
            if result and (not outcome or result == INTERRUPTED):
                outcome = outcome or result
            if result and self._on_error is OnError.INTERRUPT:
                waiting.clear()
                self._stop_all()
            elif result and self._on_error is OnError.SKIP_DOWNSTREAM:
                for pending in [job for job in waiting.values() if name in job.needs]:
                    del waiting[pending.name]
        return outcome

    def _start_ready(self, waiting: dict[str, Job]) -> None:
        dependents = {name: sum(name in job.needs for job in waiting.values()) for name in waiting}
        ready = [
            job for job in waiting.values() if not (job.needs - {job.name}) & (waiting.keys() | self._running.keys())
        ]
        ready.sort(key=lambda job: -dependents[job.name])
        for job in ready:
            if self._workers and len(self._running) >= self._workers:
                return
            del waiting[job.name]
            work = self._running[job.name] = Work(job.name, self._events)
            # Emitted here, so that packages start in order whatever the threads do.
            self._events.emit(BuildEvent("started", job.name))
            threading.Thread(target=self._run_job, args=(job, work), name=f"day6-{job.name}", daemon=True).start()

    def _run_job(self, job: Job, work: Work) -> None:
        result: Result | Exception
        try:
            result = job.run(work)
        except JobFailure as error:
            result = error
        except OSError as error:
            # A full disk, a read-only folder: the file's name is more useful than our traceback.
            work.stderr(f"error: {reason_and_name(error)}\n")
            result = 1
        except Exception as error:
            work.stderr(traceback.format_exc())
            result = error
        except BaseException as error:  # the build waits until every job has ended
            work.stderr(f"error: {fault(error)}\n")
            result = 1
        if work.stopped and result:
            result = INTERRUPTED
        status = result if isinstance(result, (int, str)) else 1
        try:
            self._events.emit(BuildEvent("ended", job.name, result=status))
        finally:
            self._ended.put((job.name, result))

    def _stop_all(self) -> None:
        for work in list(self._running.values()):
            work.stop()
