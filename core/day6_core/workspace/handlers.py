"""The event handlers of `colcon build --event-handlers`, which print while packages are processed and afterwards."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Callable
from typing import NamedTuple

from day6_core.session.harmless import one_line
from day6_core.workspace.events import INTERRUPTED, BuildEvent, Console, Handler, Result, duration
from day6_core.workspace.logs import EventLog, JobLogs, LogFolder
from day6_core.workspace.style import Style


class ConsoleDirect:
    """Prints every line at once, to the stream it came from."""

    def __init__(self, console: Console) -> None:
        self._console = console

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "stdout":
            self._console.out(event.text)
        elif event.kind == "stderr":
            self._console.err(event.text)


class ConsoleCohesion:
    """Prints all output of a package together when it has ended."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._lines: dict[str, list[str]] = defaultdict(list)

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind in ("stdout", "stderr"):
            self._lines[event.job].append(event.text)
        elif event.kind == "ended":
            lines = self._lines.pop(event.job, [])
            if lines and event.result != INTERRUPTED:
                self._console.out(f"--- output: {event.job}\n{''.join(lines)}---\n")


class ConsoleStderr:
    """Prints everything a package wrote to standard error, when it has ended."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._lines: dict[str, list[str]] = defaultdict(list)

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "stderr":
            self._lines[event.job].append(event.text)
        elif event.kind == "ended":
            lines = self._lines.pop(event.job, [])
            if lines and event.result != INTERRUPTED:
                style = Style.ERROR if event.result else Style.WARNING
                head, end = (self._console.err_style(style, text) for text in (f"--- stderr: {event.job}", "---"))
                self._console.err(f"{head}\n{''.join(lines)}{end}\n")


class ConsoleStartEnd:
    """Prints `Starting >>> name` and `Finished <<< name [0.52s]`."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._began: dict[str, float] = {}
        self._test_failures: set[str] = set()

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "started":
            self._began[event.job] = time.monotonic()
            self._console.out(f"Starting >>> {event.job}\n")
        elif event.kind == "test_failure":
            self._test_failures.add(event.job)
        elif event.kind == "ended":
            took = duration(time.monotonic() - self._began[event.job])
            out_style, err_style = self._console.out_style, self._console.err_style
            if event.result == INTERRUPTED:
                self._console.out(f"{out_style(Style.WARNING, 'Aborted')}  <<< {event.job} [{took}]\n")
            elif event.result:
                code = err_style(Style.ERROR, f"exited with code {event.result}")
                self._console.err(f"{err_style(Style.CRITICAL, 'Failed')}   <<< {event.job} [{took}, {code}]\n")
            else:
                failures = out_style(Style.WARNING, "\t[ with test failures ]")
                note = failures if event.job in self._test_failures else ""
                self._console.out(f"Finished <<< {event.job} [{took}]{note}\n")


class ConsolePackageList:
    """Prints the names of all packages before the first one starts."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._queued: list[str] = []

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "queued":
            self._queued.append(f"- {event.job} ({event.text})\n")
        elif event.kind in ("started", "end") and self._queued:
            self._console.out("".join(["Topological order\n", *self._queued]))
            self._queued = []


class Summary:
    """Prints how many packages finished, failed, were aborted, wrote to standard error, or were not reached."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._began = time.monotonic()
        self._queued: set[str] = set()
        self._with_stderr: set[str] = set()
        self._with_test_failures: set[str] = set()
        self._results: dict[str, Result] = {}

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "queued":
            self._queued.add(event.job)
        elif event.kind == "stderr":
            self._with_stderr.add(event.job)
        elif event.kind == "test_failure":
            self._with_test_failures.add(event.job)
        elif event.kind == "ended":
            self._results[event.job] = event.result
        elif event.kind == "end":
            self._print()

    def _print(self) -> None:
        ended = self._results.items()
        interrupted = {job for job, result in ended if result == INTERRUPTED}
        failed = {job for job, result in ended if result and result != INTERRUPTED}
        finished = self._results.keys() - interrupted - failed
        style = self._console.out_style
        took = duration(time.monotonic() - self._began)
        lines = [f"\nSummary: {_count(len(finished))} finished [{took}]"]
        for jobs, what, kind in (
            (failed, "failed", Style.ERROR),
            (interrupted, "aborted", Style.WARNING),
            (self._with_stderr, "had stderr output", Style.WARNING),
            (self._with_test_failures, "had test failures", Style.ERROR),
        ):
            if jobs:
                lines.append(style(kind, f"  {_count(len(jobs))} {what}: ") + " ".join(sorted(jobs)))
        blocked = self._queued - self._results.keys()
        if blocked:
            lines.append(f"  {_count(len(blocked))} not processed")
        self._console.out("\n".join(lines) + "\n")


def _count(number: int) -> str:
    return f"{number} package" if number == 1 else f"{number} packages"


class BuildStatus:
    """On a terminal: a status line, updated ten times a second."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._began = time.monotonic()
        self._queued = 0
        self._running: dict[str, float] = {}
        self._results: list[Result] = []

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind == "queued":
            self._queued += 1
        elif event.kind == "started":
            self._running[event.job] = time.monotonic()
        elif event.kind == "ended":
            self._running.pop(event.job, None)
            self._results.append(event.result)
        elif event.kind == "tick":
            self._console.show_status(self._line())
        elif event.kind == "end":
            self._console.wipe()

    def _line(self) -> str:
        now = time.monotonic()
        failed = sum(1 for result in self._results if result and result != INTERRUPTED)
        blocks = [f"[{now - self._began:.1f}s]", f"[{len(self._results)}/{self._queued} complete]"]
        if failed:
            blocks.append(f"[{failed} failed]")
        if len(self._running) > 1:
            blocks.append(f"[{len(self._running)} ongoing]")
        blocks += [f"[{job} - {now - began:.1f}s]" for job, began in self._running.items()]
        line = " ".join(blocks)
        room = (self._console.stdout.columns or 80) - 1  # a terminal may not know its size
        return line if len(line) <= room else line[: room - 4] + " ..."


class TerminalTitle:
    """On a terminal: the progress in the window's title."""

    def __init__(self, console: Console, verb: str) -> None:
        self._console = console
        self._verb = verb
        self._counts = {"queued": 0, "started": 0, "ended": 0}

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        if event.kind not in self._counts:
            return
        self._counts[event.kind] += 1
        if event.kind == "queued":
            return
        ended, queued = self._counts["ended"], self._counts["queued"]
        ongoing = self._counts["started"] - ended
        text = f"colcon {self._verb} [{ended}/{queued} done] [{ongoing} ongoing]"
        self._console.stdout.control(f"\x1b]0;{one_line(text)}\x07")


class NoHandler:
    """Stands for handlers of the real colcon that work outside a terminal (desktop notifications) or for C++."""

    def handle(self, event: BuildEvent) -> None:
        """See Handler."""
        return None


class HandlerSpec(NamedTuple):
    """A handler that can be switched on and off. `enabled` may depend on whether standard output is a terminal."""

    summary: str
    enabled: bool | None
    """None: on a terminal only."""
    priority: int
    """Higher ones receive an event first."""
    make: Callable[[Console, str, LogFolder], Handler]


HANDLERS: dict[str, HandlerSpec] = {
    "compile_commands": HandlerSpec(
        "Generate a `compile_commands.json` file for the whole workspace", True, 100, lambda c, v, f: NoHandler()
    ),
    "console_cohesion": HandlerSpec(
        "Pass task output at once to stdout", False, 130, lambda c, v, f: ConsoleCohesion(c)
    ),
    "console_direct": HandlerSpec("Pass output directly to stdout/err", False, 100, lambda c, v, f: ConsoleDirect(c)),
    "console_package_list": HandlerSpec(
        "Output list of queued job names", False, 100, lambda c, v, f: ConsolePackageList(c)
    ),
    "console_start_end": HandlerSpec("Output task name on start/end", True, 100, lambda c, v, f: ConsoleStartEnd(c)),
    "console_stderr": HandlerSpec("Output all stderr of a task at once", True, 110, lambda c, v, f: ConsoleStderr(c)),
    "desktop_notification": HandlerSpec("Desktop notification of the summary", True, 50, lambda c, v, f: NoHandler()),
    "event_log": HandlerSpec("Log all events to a global log file", True, 200, lambda c, v, f: EventLog(f)),
    "log": HandlerSpec("Output task specific log files", True, 150, lambda c, v, f: JobLogs(f)),
    "log_command": HandlerSpec("Log a 'debug' message for each command", True, 50, lambda c, v, f: NoHandler()),
    "parallel_status": HandlerSpec(
        "Periodically print a reminder of the currently executing jobs", False, 50, lambda c, v, f: NoHandler()
    ),
    "status": HandlerSpec("Continuously update a status line", None, 50, lambda c, v, f: BuildStatus(c)),
    "store_result": HandlerSpec(
        "Persist the result of a job in a file in its build directory", True, 50, lambda c, v, f: NoHandler()
    ),
    "summary": HandlerSpec("Output summary of all tasks", True, 50, lambda c, v, f: Summary(c)),
    "terminal_title": HandlerSpec("Show status in the terminal title", None, 50, lambda c, v, f: TerminalTitle(c, v)),
}


def chosen_handlers(switches: list[str], console: Console, verb: str, folder: LogFolder) -> list[Handler]:
    """Return the enabled handlers by priority; `switches` are like 'console_direct+' and 'log-'."""
    on_terminal = console.stdout.isatty()
    enabled = {name: on_terminal if each.enabled is None else each.enabled for name, each in HANDLERS.items()}
    for switch in switches:
        enabled[switch[:-1]] = switch.endswith("+")
    names = sorted((name for name in HANDLERS if enabled[name]), key=lambda name: -HANDLERS[name].priority)
    return [HANDLERS[name].make(console, verb, folder) for name in names]
