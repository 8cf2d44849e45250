"""The job table of one shell: pipelines in the background or stopped, with bash's numbers, marks and lines."""

from __future__ import annotations

from day6_core.session.program import Program
from day6_core.session.signals import STOPPED, TEXTS
from day6_core.session.streams import InputStream
from day6_core.session.task import Signal, wait_for


class Job:
    """One pipeline. `number` is 0 while it runs in the foreground and was never stopped."""

    def __init__(self, programs: list[Program], source: str, tty: InputStream) -> None:
        self.programs = programs
        self.source = source
        self.tty = tty
        """The job's own end of the terminal: gets the keys while the job is in the foreground."""
        self.number = 0
        self._interrupted_late = False
        """Ctrl-C arrived after every program had ended but before the shell went on: it is then the shell's."""
        self.changed = Signal()
        """Set whenever one of the programs ended or the job was stopped or goes on."""
        self.stop_is_told = False
        """Whether the user has been told that it is stopped, which a job in the background says before the next prompt."""
        self.outlives_shell = False
        """Whether the end of the shell does not end it, either (`disown -h`)."""
        for program in programs:
            program.watch(self.changed)

    @property
    def pid(self) -> int:
        """The number of its process group: that of its first process."""
        return self.programs[0].pid

    @property
    def finished(self) -> bool:
        return all(program.status is not None for program in self.programs)

    @property
    def stopped(self) -> bool:
        return not self.finished and any(program.stopped for program in self.programs)

    @property
    def stopped_by(self) -> int:
        """The signal that has stopped it, 0 if none has."""
        return next((program.stopped_by for program in self._alive() if program.stopped), 0)

    @property
    def status(self) -> int:
        if self.stopped:
            return 128 + self.stopped_by
        return self.programs[-1].status or 0

    @property
    def killed_by(self) -> int:
        return self.programs[-1].killed_by

    @property
    def interrupted(self) -> bool:
        return self._interrupted_late or any(program.killed_by == 2 for program in self.programs)

    @property
    def state(self) -> str:
        if self.stopped:
            return "Stopped"
        if not self.finished:
            return "Running"
        if self.killed_by:
            return TEXTS.get(self.killed_by, f"Unknown signal {self.killed_by}")
        return f"Exit {self.status}" if self.status else "Done"

    async def wait(self) -> None:
        """Wait until every program has ended or the job was stopped."""
        while not (self.finished or self.stopped):
            self.changed.clear()
            if not (self.finished or self.stopped):
                await wait_for(self.changed)

    async def wait_while_stopped(self) -> None:
        while self.stopped:
            self.changed.clear()
            await wait_for(self.changed)

    def interrupt(self) -> None:
        self._interrupted_late = self.finished
        for program in self._alive():
            program.interrupt()

    def interrupt_behind(self) -> None:
        """Ctrl-C for all but the first program, which reads the keyboard."""
        for program in self._alive():
            if program is not self.programs[0]:
                program.interrupt()

    def send(self, number: int) -> None:
        """Deliver a signal to every program of the job, waking a stopped job so that it can act on it."""
        for program in self._alive():
            program.send(number)
        if number in (1, 2, 3, 9, 15, 18):
            self.resume()
        self.changed.set()

    def stop(self) -> None:
        for program in self._alive():
            program.stop()
        self.changed.set()

    def resume(self) -> None:
        self.stop_is_told = False
        for program in self._alive():
            program.resume()

    def _alive(self) -> list[Program]:
        return [program for program in self.programs if program.status is None]


class JobTable:
    """The jobs of one shell, numbered as `jobs` shows them."""

    def __init__(self) -> None:
        self.jobs: list[Job] = []
        """In the order in which they became current: the last one is `%+`, the one before `%-`."""

    def add(self, job: Job) -> None:
        """Give the job a number (again, if it has none) and make it the current one."""
        if job in self.jobs:
            self.jobs.remove(job)
        if not job.number:
            job.number = max((other.number for other in self.jobs), default=0) + 1
        self.jobs.append(job)

    def remove(self, job: Job) -> None:
        if job in self.jobs:
            self.jobs.remove(job)

    @property
    def any_stopped(self) -> bool:
        return any(job.stopped for job in self.jobs)

    def hang_up(self) -> None:
        """The shell ends, and with it its jobs."""
        for job in self.jobs:
            if not job.outlives_shell:
                job.send(1)

    def take_finished(self) -> list[str]:
        """Remove the jobs that have ended; return their lines, by number."""
        finished = [job for job in self.ordered() if job.finished]
        lines = [self.line(job) for job in finished]
        for job in finished:
            self.jobs.remove(job)
        return lines

    def take_news(self) -> list[str]:
        """Return what is said before a prompt: which jobs were stopped in the background, and which have ended."""
        for job in self.jobs:
            job.stop_is_told = job.stop_is_told and job.stopped  # others than the shell let it go on, too
        stopped = [job for job in self.ordered() if job.stopped and not job.stop_is_told]
        for job in stopped:
            self.add(job)
            job.stop_is_told = True
        return [f"\n{self.line(job)}" for job in stopped] + self.take_finished()

    def ordered(self) -> list[Job]:
        return sorted(self.jobs, key=lambda job: job.number)

    def mark(self, job: Job) -> str:
        current = [other for other in self.jobs if other is not job]
        if job not in self.jobs or self.jobs[-1] is job:
            return "+"
        return "-" if current and len(self.jobs) > 1 and self.jobs[-2] is job else " "

    def line(self, job: Job, pid: int = 0) -> str:
        """`[1]+  Running                 sleep 10 &`, as `jobs` prints it; with a process number as `jobs -l` does."""
        state = STOPPED.get(job.stopped_by, job.state) if pid else job.state
        ampersand = " &" if job.state == "Running" else ""
        return f"[{job.number}]{self.mark(job)} {pid or '':>{5 if pid else 0}} {state:<24}{job.source}{ampersand}"

    def find(self, spec: str) -> Job | None:
        """The job that `%1`, `%+`, `%-`, `%%`, `%text`, `%?text` or a process number means."""
        if not spec.startswith("%"):
            return next((job for job in self.jobs if any(str(p.pid) == spec for p in job.programs)), None)
        name = spec[1:]
        if name in ("", "%", "+"):
            return self.jobs[-1] if self.jobs else None
        if name == "-":
            return self.jobs[-2] if len(self.jobs) > 1 else (self.jobs[-1] if self.jobs else None)
        if name.isdigit():
            return next((job for job in self.jobs if job.number == int(name)), None)
        if name.startswith("?"):
            return next((job for job in reversed(self.jobs) if name[1:] in job.source), None)
        return next((job for job in reversed(self.jobs) if job.source.startswith(name)), None)
