"""A terminal of the simulated machine: keys go in, the output of programs comes out, a shell runs in it.

Threads: `send`, `paste`, `resize`, `update`, `screen` belong to the thread that draws. Programs write on the scheduler's thread,
processes on threads of their own; both only append to a bounded ring. The view pulls: `update()` feeds the ring to the screen.
"""

from __future__ import annotations

import re
import threading
from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from day6_core.session.clock import nanoseconds
from day6_core.session.program import Program
from day6_core.session.streams import OutputStream
from day6_core.session.task import Signal, let_others_run, sleep_until, wait_for
from day6_core.shell.byte_text import joined
from day6_core.shell.language.redirection import Streams
from day6_core.shell.line.discipline import Discipline
from day6_core.shell.runs import Runs

if TYPE_CHECKING:
    from day6_core.session.streams import InputStream
    from day6_core.shell.desk import Desk
    from day6_core.shell.screen.rows import Scrollback
    from day6_core.shell.screen.screen import Screen

RING = 256 * 1024
"""Characters that may wait to be shown; beyond that the oldest lines are dropped."""

CROWDED = 128 * 1024
"""Waiting characters at which programs pause until the view has caught up, at most `PAUSE` seconds."""

PAUSE = 0.1

TYPED_AT_ONCE = 16 * 1024
"""Characters of a long text that are typed at once."""

SLICE = 0.005
"""Seconds one `update` takes at most: keys and frames come in between."""

PIECE = 16 * 1024
"""Characters that are fed to the screen at a time; each is a few milliseconds of work at most."""

SHARE = 4 * 1024
"""Characters a program on the scheduler's thread writes before other programs get a turn."""

LONGEST_END = 256
"""Characters in which the sequences at the end of a text are looked for."""

_SEQUENCES_AT_END = re.compile(r"(?:\x1b\[[0-?]*[@-~])+\Z")


class Terminal:
    """One terminal with its own shell. Made by `Desk.open_terminal`."""

    def __init__(
        self,
        desk: Desk,
        columns: int,
        rows: int,
        *,
        cwd: Path | None = None,
        env: Mapping[str, str] | None = None,
        command: str = "",
        text: str = "",
    ) -> None:
        from day6_core.shell.login import login, run_command

        self.desk = desk
        self.columns = columns
        self.rows = rows
        self.version = 0
        """Incremented at every write, so that a view sees at once whether there is anything to `update`."""
        self.at_line_start = True
        """Whether the last thing written ended a line."""
        self.output: OutputStream = RawTtyOutput(self)
        """Takes text as a pty delivers it (with \\r\\n)."""
        self.waiting_at_prompt = False
        """Whether the line editor waits for a key and its line is empty; set by the line editor."""
        self.unfinished = ""
        """The lines of a command that goes on at the prompt `> `, '' at the ordinary one."""
        self.runs = Runs()
        """The lines that were run here."""
        self._unhandled = 0
        """Calls of `send` that the scheduler has not handled yet."""
        self._typed: deque[str] = deque()
        """The rest of a long text that is being typed, and what came after it."""
        self._screen: Screen | None = None
        self.on_crowded: Callable[[], None] | None = None
        """Called, on any thread, when programs begin to pause for a view that had read everything and waits itself."""
        self._is_read = True
        """Whether the view has read everything since the last such call."""
        self._ring: deque[str] = deque()
        self._size = 0
        self._dropped_lines = 0
        self._unshared = 0
        """Characters written since a program last let others run."""
        self._seen = 0
        self._lock = threading.Lock()
        self._room = threading.Event()
        self._room.set()
        self._drained = Signal()
        """Set while there is room, for programs on the scheduler's thread."""
        self._drained.set()
        if text:
            from day6_core.shell.screen.transcript import shown_again

            self.write(shown_again(text))
        self.shell = desk.shell(interactive=True, cwd=cwd, env=env)
        self.discipline = Discipline(self)
        stdin = self.discipline.root
        stdout = TtyOutput(self)
        self.streams = Streams(stdin, stdout, stdout)
        self.program: Program = desk.start_program(
            ["bash"],
            lambda session: run_command(session, self, command) if command else login(session, self),
            self.streams,
            env=self.shell.environment,
            cwd=self.shell.cwd,
            shell=self.shell,
            pid=self.shell.pid,
        )

    # -- for the view --------------------------------------------------------------------------------------------------

    @property
    def screen(self) -> Screen:
        """The picture as of the last `update`, in the size that the window has now: nobody waits for one that is hidden."""
        if self._screen is None:
            # Not at the top: a terminal exists before its first frame is drawn.
            from day6_core.shell.screen.screen import Screen

            self._screen = Screen(self.columns, self.rows)
        elif (self._screen.columns, self._screen.lines) != (self.columns, self.rows):
            self._screen.resize(self.rows, self.columns)
        return self._screen

    def update(self) -> set[int]:
        """Bring the screen up to date with what was written; return the numbers of the lines that this changed.

        May leave part of a flood for the next call (`has_more`). `screen.dirty` collects the same until the view clears it.
        """
        screen = self.screen
        if not self._ring and not self._dropped_lines:
            return set()
        before = set(screen.dirty)
        screen.dirty.clear()
        until = perf_counter() + SLICE
        while text := self._take():
            if rest := screen.feed(text, until):
                self._give_back(rest)
            if perf_counter() > until:
                break
        if self._size <= CROWDED and not self._room.is_set():
            self._room.set()
            self._drained.set()
        if screen.answers:
            answers, screen.answers = "".join(screen.answers), []
            self.send(answers)
        changed = set(screen.dirty)
        screen.dirty.update(before)
        with self._lock:
            self._is_read |= not self._ring
        if self._ring:
            self.desk.scheduler.announce_activity()
        return changed

    @property
    def history(self) -> Scrollback:
        """The lines above the screen, oldest first, as rows of cells."""
        from day6_core.shell.screen.rows import Scrollback

        return Scrollback(self.screen.scrollback)

    @property
    def application_cursor(self) -> bool:
        """Whether arrow keys are to be sent as ESC O A."""
        return self.screen.application_cursor_keys

    @property
    def bracketed_paste(self) -> bool:
        """Whether pasted text is to be sent between marks."""
        return self.screen.bracketed_paste

    @property
    def has_more(self) -> bool:
        """Whether there is text the screen does not show yet."""
        return bool(self._ring)

    @property
    def is_flooded(self) -> bool:
        """Whether so much of it waits that it should not wait for the next frame."""
        return self._size > PIECE

    @property
    def is_crowded(self) -> bool:
        """Whether so much waits to be shown that programs pause."""
        return self._size > CROWDED

    @property
    def has_news(self) -> bool:
        """Whether something was written since the last `mark_seen`."""
        return self.version != self._seen

    def mark_seen(self) -> None:
        self._seen = self.version

    @property
    def busy(self) -> bool:
        """Whether a command runs in the foreground."""
        return self.shell.front is not None

    @property
    def running(self) -> list[str]:
        """The commands that have not ended: the one in the foreground, then those in the background and the stopped ones."""
        front = self.shell.front
        jobs = [job for job in list(self.shell.jobs.jobs) if job is not front and not job.finished]
        return [job.source for job in ([front] if front is not None else []) + jobs]

    @property
    def idle(self) -> bool:
        """Whether the prompt waits and nothing has been typed after it."""
        return (
            self.waiting_at_prompt
            and not self._unhandled
            and not self._typed
            and not self.discipline.has_pending
            and not self.closed
        )

    @property
    def reading_keys(self) -> bool:
        """Whether a program in the foreground reads single keys (turtlesim's teleop), or a process all of them."""
        return self.busy and self.discipline.front.is_raw

    @property
    def is_stubborn(self) -> bool:
        """Whether the foreground program still runs although Ctrl-C was pressed three times, and could hear it."""
        return self.busy and self.discipline.interrupts >= 3 and not self.desk.processes_stopped

    @property
    def closed(self) -> bool:
        """Whether its shell has ended (`exit`, Ctrl-D)."""
        return self.program.status is not None

    @property
    def title(self) -> str:
        """What runs in the foreground, otherwise the working directory as in the prompt."""
        front = self.shell.front
        return front.source if front is not None else self.shell.short_cwd

    def send(self, text: str) -> None:
        """Type `text`, which is what a real terminal sends for the keys. During a long text other programs get their turn."""
        text = joined(text)  # a terminal can name half of a pair (`CSI 57343 u`)
        self._unhandled += 1
        self.desk.scheduler.give_way()
        self.desk.scheduler.call_soon_threadsafe(lambda: self._type(text))
        if "\x03" in text:
            self.desk.scheduler.insist()

    def type_again(self, text: str) -> None:
        """Type again what a program has not read, before what is still on its way here (on the scheduler's thread)."""
        self._unhandled += 1

        def type_first() -> None:
            if self._typed:
                self._typed.appendleft(text)
                self._unhandled -= 1
            else:
                self._type(text)

        self.desk.scheduler.call(type_first)

    def _type(self, text: str) -> None:
        if self._typed or len(text) > TYPED_AT_ONCE:
            parts = [text[at : at + TYPED_AT_ONCE] for at in range(0, len(text), TYPED_AT_ONCE)]
            if not self._typed:
                self.desk.scheduler.spawn(self._type_on(), "typing")
            self._typed.extend(parts)
        else:
            self.discipline.type(text)
        self._unhandled -= 1

    async def _type_on(self) -> None:
        while self._typed:
            self.discipline.type(self._typed[0])
            self._typed.popleft()
            # A timer that is due, unlike a place at the end of the queue, also lets other due timers run.
            await sleep_until(self.desk.clock.steady_ns())

    def paste(self, text: str) -> None:
        """Insert text from the clipboard: marked as such for programs that asked for it, otherwise as if typed."""
        text = text.replace("\r\n", "\n").replace("\n", "\r").replace("\x1b", "")
        if self.screen.bracketed_paste:
            text = f"\x1b[200~{text}\x1b[201~"
        self.send(text)

    def run_line(self, line: str) -> None:
        """Type a command and Enter."""
        self.send(line + "\r")

    def resize(self, columns: int, rows: int) -> None:
        """Handle a new size of the window: notify the process and the line editor. The picture follows when it is looked at."""
        columns, rows = max(columns, 2), max(rows, 1)
        if (columns, rows) == (self.columns, self.rows):
            return
        if self._ring and not self.busy:
            self.update()  # what the line editor drew for the size before
        self.columns, self.rows = columns, rows
        self.desk.scheduler.call_soon_threadsafe(self.discipline.resized)

    # -- for programs --------------------------------------------------------------------------------------------------

    def write(self, text: str) -> None:
        """Append text as a terminal understands it (lines end with \\r\\n). Any thread."""
        if not text:
            return
        with self._lock:
            self._ring.append(text)
            self._size += len(text)
            self._unshared += len(text)
            if (run := self.runs.running) is not None:
                run.keep(text)
            while self._size > RING and len(self._ring) > 1:
                gone = self._ring.popleft()
                self._size -= len(gone)
                self._dropped_lines += gone.count("\n")
            if self._size > RING:  # one giant write
                kept = self._ring[0][-RING:]
                self._dropped_lines += self._ring[0][: -len(kept)].count("\n")
                self._ring[0] = kept
                self._size = len(kept)
            if self._size > CROWDED:
                self._drained.clear()
                self._room.clear()
            self.at_line_start = _ends_line(text, self.at_line_start)
            self.version += 1
            waits = self._is_read and self._size > CROWDED
            self._is_read &= not waits
        self.desk.scheduler.announce_activity()
        if waits and self.on_crowded is not None:
            self.on_crowded()

    def wait_for_room(self) -> None:
        """Block a copying thread while the view is far behind, at most a moment: a hidden terminal must not stop its programs."""
        if self._size > CROWDED:
            self._room.wait(PAUSE)

    async def drain(self) -> None:
        """Have a program on the scheduler's thread wait for the view, at most a moment, and let others run now and then."""
        if self._size > CROWDED:
            await wait_for(self._drained, self.desk.scheduler.clock.steady_ns() + nanoseconds(PAUSE))
        if self._unshared > SHARE:
            self._unshared = 0
            await let_others_run()

    def _take(self) -> str:
        """Remove and return the next piece of what waits."""
        with self._lock:
            if self._dropped_lines:
                mark = f"\r\n… {self._dropped_lines} lines dropped\r\n"
                self._dropped_lines = 0
                first = self._ring[0] if self._ring else ""
                newline = first.find("\n")
                if newline >= 0 and len(self._ring) > 0:  # begin with a whole line
                    self._size -= newline + 1
                    self._ring[0] = first[newline + 1 :]
                return mark
            parts: list[str] = []
            size = 0
            while self._ring and size < PIECE:
                parts.append(self._ring.popleft())
                size += len(parts[-1])
            text = "".join(parts)
            if size > 2 * PIECE:
                self._ring.appendleft(text[PIECE:])
                text = text[:PIECE]
            self._size -= len(text)
            return text

    def _give_back(self, text: str) -> None:
        with self._lock:
            self._ring.appendleft(text)
            self._size += len(text)

    # -- the end -------------------------------------------------------------------------------------------------------

    def hang_up(self) -> None:
        """The window is being closed: the shell reads the end of its input."""
        self.desk.scheduler.call_soon_threadsafe(self.discipline.hang_up)

    def close(self) -> None:
        """Take the terminal off the desk and end what runs in it (blocking at most a few seconds; see `Desk.end_programs`)."""
        self.hang_up()
        mine = [program for program in list(self.desk.programs.values()) if program.session.stdin.terminal_of() is self]
        self.desk.end_programs([*mine, self.program])
        if self in self.desk.terminals:
            self.desk.terminals.remove(self)
            self.desk.closed_runs.append(self.runs)


def _ends_line(text: str, before: bool) -> bool:
    """Whether the cursor is at the beginning of a line after `text`; `before`: whether it was before it."""
    text = text[-LONGEST_END:]
    shown = _SEQUENCES_AT_END.sub("", text)
    if shown == text or shown:
        return shown.endswith(("\n", "\r"))
    return before or "\x1b[H" in text


class TtyOutput(OutputStream):
    """Standard output and error of a program in a terminal."""

    terminal: Terminal

    def __init__(self, terminal: Terminal) -> None:
        self.terminal = terminal

    @property
    def columns(self) -> int:
        return self.terminal.columns

    def write(self, text: str) -> int:
        self.terminal.write(text.replace("\n", "\r\n"))
        return len(text)

    def keyboard(self) -> InputStream | None:
        front = self.terminal.discipline.front
        return front if front.parent is not None else None  # the shell's own keys belong to no other program

    async def drain(self) -> None:
        await self.terminal.drain()

    def wait_for_room(self) -> None:
        self.terminal.wait_for_room()

    def isatty(self) -> bool:
        return True

    @property
    def raw(self) -> OutputStream:
        return self.terminal.output


class RawTtyOutput(TtyOutput):
    """The output of a program on a pty, whose kernel has done the newlines."""

    def write(self, text: str) -> int:
        self.terminal.write(text)
        return len(text)
