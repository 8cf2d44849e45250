"""What was run in a terminal: the lines, the simple commands of each, how they ended, and the end of what they printed."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.streams import OutputStream, Overheard

if TYPE_CHECKING:
    from day6_core.shell.language.syntax import SimpleCommand

MOST_RUNS = 200
LONGEST_OUTPUT = 32 * 1024
"""Characters that are kept of what one line printed, and one command: its end."""

LONGEST_OLD_OUTPUT = 4 * 1024
"""Characters that are kept of it once the next line was run."""

MOST_COMMANDS = 100
"""Commands of one line that are kept: so many of its first, and of its last."""


class Kept:
    """The end of a text that goes on. Any thread adds to it."""

    def __init__(self) -> None:
        self.written = 0
        """How many characters there were in all."""
        self._parts: deque[str] = deque()
        self._size = 0

    @property
    def text(self) -> str:
        return "".join(list(self._parts))

    def keep(self, text: str) -> None:
        """Add to it."""
        self.written += len(text)
        self._parts.append(text[-LONGEST_OUTPUT:])
        self._size += min(len(text), LONGEST_OUTPUT)
        while self._size > LONGEST_OUTPUT and len(self._parts) > 1:
            self._size -= len(self._parts.popleft())

    def forget_most(self, longest: int) -> None:
        """Keep the very end only."""
        if self._size > longest:
            text = self.text[-longest:]
            self._parts, self._size = deque([text]), len(text)


class Ran:
    """A simple command as the shell ran it, or still runs it: then `status` and `ended_ns` are None.

    That may be one of many in a line: in a pipe, a loop, a function, a script of bash, or behind `timeout`, `env`, `xargs`.
    """

    __slots__ = ("_command", "_elsewhere", "_screen", "argv", "began_ns", "cwd", "ended_ns", "is_function", "status")

    def __init__(
        self, argv: Sequence[str], command: SimpleCommand | None, cwd: Path, began_ns: int, is_function: bool = False
    ) -> None:
        self.argv = argv
        """Its words after all expansions."""
        self.cwd = cwd
        self.began_ns = began_ns
        self.ended_ns: int | None = None
        self.status: int | None = None
        self.is_function = is_function
        """Whether it called a function; what that ran has records of its own."""
        self._command = command
        self._screen: Kept | None = None
        self._elsewhere: Kept | None = None

    @property
    def source(self) -> str:
        """As it was typed, before any expansion."""
        return self._command.source if self._command is not None else ""

    @property
    def screen(self) -> str:
        """The end of what it printed to a terminal, with what commands printed that it ran itself; a function, `eval`, `source`
        print nothing: the shell runs their commands.
        """
        return self._screen.text if self._screen is not None else ""

    @property
    def elsewhere(self) -> str:
        """The end of what it printed into a pipe, a file, a `$(…)`."""
        return self._elsewhere.text if self._elsewhere is not None else ""

    def keep(self, text: str) -> None:
        """Add to what it printed to a terminal. Any thread."""
        if self._screen is None:
            self._screen = Kept()
        self._screen.keep(text)

    def keep_elsewhere(self, text: str) -> None:
        """Add to what it printed elsewhere. Any thread."""
        if self._elsewhere is None:
            self._elsewhere = Kept()
        self._elsewhere.keep(text)

    def forget_most(self, longest: int) -> None:
        """Keep the very end of both only."""
        for kept in (self._screen, self._elsewhere):
            if kept is not None:
                kept.forget_most(longest)

    def end(self, status: int | None, now_ns: int) -> None:
        """Note how it ended."""
        self.status, self.ended_ns = status, now_ns

    def overhear(self, stdout: OutputStream, stderr: OutputStream) -> tuple[OutputStream, OutputStream]:
        """Return its streams as it is to write to them, so that what it prints is kept."""
        first = self._overheard(stdout)
        return first, first if stderr is stdout else self._overheard(stderr)

    def _overheard(self, stream: OutputStream) -> OutputStream:
        if type(stream) is OutputStream:
            return stream
        return Overheard(stream, self.keep if stream.isatty() else self.keep_elsewhere)


class Run:
    """One line that was run, or still runs: then `status` and `ended_ns` are None. Times are epoch nanoseconds."""

    def __init__(self, number: int, source: str, cwd: Path, began_ns: int) -> None:
        self.number = number
        self.source = source
        self.cwd = cwd
        self.began_ns = began_ns
        self.ended_ns: int | None = None
        self.status: int | None = None
        self.commands: list[Ran] = []
        """The simple commands that it ran, the first ones and the last ones if there were very many."""
        self._over_ns: int | None = None
        self._explained = 0
        """How much had been printed when it last explained some itself (`ls x; why`)."""
        self._output = Kept()

    @property
    def output(self) -> str:
        """The end of what the terminal was given while this ran, with its control sequences."""
        return self._output.text

    @property
    def written(self) -> int:
        """Characters it printed, with those that are not kept any more."""
        return self._output.written

    @property
    def unexplained(self) -> str:
        """What of the output came after its last explanation."""
        count = self.written - self._explained
        return self.output[-count:] if count else ""

    def explained(self) -> None:
        """Note that what it printed so far was explained, and that the explanation is among it."""
        self._explained = self.written

    @property
    def over_ns(self) -> int | None:
        """When it and everything that it left in the background had ended, None as long as something goes on."""
        if self._over_ns is None and self.ended_ns is not None:
            ends = [ran.ended_ns for ran in list(self.commands) if ran.ended_ns is not None]
            if len(ends) == len(self.commands):
                self._over_ns = max([self.ended_ns, *ends])
        return self._over_ns

    def keep(self, text: str) -> None:
        """Add to the output. Any thread."""
        self._output.keep(text)

    def note(self, ran: Ran) -> None:
        """Note that one of its commands runs now."""
        if len(self.commands) == 2 * MOST_COMMANDS:
            del self.commands[MOST_COMMANDS]
        self.commands.append(ran)

    def forget_most(self) -> None:
        """Keep the very end of the output only, and of each command's a share of as much."""
        self._output.forget_most(LONGEST_OLD_OUTPUT)
        share = min(LONGEST_OLD_OUTPUT, LONGEST_OUTPUT // max(1, len(self.commands)))
        for ran in list(self.commands):
            ran.forget_most(share)


class Runs:
    """The last lines that were run in one terminal, oldest first. Written on the scheduler's thread, read by any."""

    def __init__(self) -> None:
        self._runs: deque[Run] = deque(maxlen=MOST_RUNS)
        self.count = 0
        """How many there were in all."""
        self.running: Run | None = None

    @property
    def all(self) -> list[Run]:
        return list(self._runs)

    def begin(self, source: str, cwd: Path, now_ns: int) -> Run:
        """Note that a line is run now."""
        if self._runs:
            self._runs[-1].forget_most()
        self.count += 1
        run = self.running = Run(self.count, source, cwd, now_ns)
        self._runs.append(run)
        return run

    def end(self, status: int, now_ns: int) -> None:
        """Note how it ended."""
        run, self.running = self.running, None
        if run is not None:
            run.status, run.ended_ns = status, now_ns
