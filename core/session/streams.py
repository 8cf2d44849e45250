"""What a program reads from and writes to: the base classes, an in-process pipe, and files.

Writing never blocks, because a cooperative program must not: `write` puts the text somewhere bounded and returns. A program
that can produce without end calls `await stream.drain()` between its writes.
"""

from __future__ import annotations

import contextlib
import errno
import io
import os
import stat
import threading
import time
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import Protocol, TextIO

from day6_tui.core.session.patient_files import WITHOUT_END, refuse
from day6_tui.core.session.task import Signal, let_others_run, wait_for

END_OF_INPUT = ""

PIPE_HIGH = 256 * 1024
"""Characters in a pipe from which `drain` waits."""

PIPE_LIMIT = 4 * 1024 * 1024
"""Characters a pipe holds; what is written beyond that without draining is dropped, whole writes at a time.

One write after draining is taken whole, however long: a message of megabytes is one.
"""

CAPTURE_LIMIT = 64 * 1024 * 1024
"""Characters that `$(command)` keeps; bash goes on until there is no memory."""


FILE_BLOCK = 64 * 1024
"""Bytes that wait before they are written to a file: what a program says at once is there when it ends anyway."""


class WriteError(OSError):
    """A program's output could not be written: the disk is full, or a limit was reached. BrokenPipeError is none of these."""


DRAINS_IN_A_ROW = 16
"""Writes of a program, each followed by `drain`, after which others have their turn although nothing holds it back."""

LONGEST_LINE = 1 << 20
"""Characters of a file's line that are read in one go; /dev/zero has no other end."""


class KeyReceiver(Protocol):
    """A process on a pty: gets keys as they are typed and the size of its window."""

    def keys(self, text: str) -> None: ...

    def resize(self, columns: int, rows: int) -> None: ...

    def wants_signal_keys(self) -> bool: ...


class TerminalSide(Protocol):
    """What a process on a pty must know of the simulated terminal behind it."""

    columns: int
    rows: int
    output: OutputStream
    """Takes text as a pty delivers it."""


class InputStream:
    """Where a program reads. This base class is the empty input (`< /dev/null`)."""

    def isatty(self) -> bool:
        return False

    def fileno(self) -> int | None:
        """The file descriptor a child process may inherit, None if there is none."""
        return None

    async def read_key(self) -> str:
        """Return the next key as a terminal sends it ('a', '\\r', '\\x1b[A'); '' at the end of the input.

        Outside `raw()` and without a terminal this is simply the next character.
        """
        return END_OF_INPUT

    async def read_line(self) -> str:
        """Return the next line with its newline; '' at the end of the input."""
        return END_OF_INPUT

    async def read_all(self) -> str:
        """Return everything up to the end of the input."""
        parts = []
        while line := await self.read_line():
            parts.append(line)
        return "".join(parts)

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        """Inside, keys arrive one by one and unechoed. With `signals` (as turtlesim's teleop) Ctrl-C still interrupts."""
        yield

    def fork(self) -> InputStream:
        """On a terminal: the end of it for a job started here, which gets the keys while it has the focus. Else the same."""
        return self

    def focus(self) -> None:
        """On a terminal: take the keys of the reader this was forked from (of a job in the background: once that has them)."""

    def unfocus(self) -> None:
        """On a terminal: give the keys back to the reader this was forked from."""

    def terminal_of(self, *outputs: OutputStream) -> TerminalSide | None:
        """The simulated terminal that this stream and at least one of `outputs` belong to, None if there is none."""
        return None

    def pass_keys_to(self, receiver: KeyReceiver | None) -> None:
        """On a terminal: hand every key to `receiver` as it is typed, unechoed (None: handle them here again)."""

    def give_back(self, text: str) -> None:
        """On a terminal: keys that were handed on and not read; whoever reads next gets them."""

    def close(self) -> None:
        """Say that nobody will read from here any more."""


class OutputStream:
    """Where a program writes. This base class is the bottomless output (`> /dev/null`)."""

    _drains = 0

    encoding = "utf-8"

    @property
    def columns(self) -> int:
        """Width in terminal cells, 80 where there is no terminal."""
        return 80

    def write(self, text: str) -> int:
        """Append text, never waiting. Raises BrokenPipeError when nobody can ever read it."""
        return len(text)

    def control(self, sequence: str) -> None:
        """Write what steers a terminal (clear it, go up a line): where `write` lets only text pass, this is for the rest."""
        self.write(sequence)

    def flush(self) -> None:
        """Does nothing where nothing is held back."""

    async def drain(self) -> None:
        """Wait until the reader has caught up, and now and then for others. Raises BrokenPipeError when it is gone."""
        self._drains += 1
        if self._drains % DRAINS_IN_A_ROW == 0:
            await let_others_run()

    def keyboard(self) -> InputStream | None:
        """On a terminal: the keys of the job in front there, as /dev/tty gives them; None elsewhere."""
        return None

    def wait_for_room(self) -> None:
        """For a thread that copies into this stream: block it, for a bounded time, while too much is waiting here."""

    def isatty(self) -> bool:
        return False

    def fileno(self) -> int | None:
        """The file descriptor a child process may inherit, None if there is none."""
        return None

    def close(self) -> None:
        """Say that nothing more will be written."""


class Pipe:
    """Text from one program to another: `writer` is the standard output of one, `reader` the standard input of the other.

    Any thread may write. A closed reader breaks the pipe: the next write raises BrokenPipeError.
    """

    def __init__(self) -> None:
        self._chunks: deque[str] = deque()
        self._size = 0
        self._readable = Signal()
        self._drained = Signal()
        self._drained.set()
        self._writer_closed = False
        self._reader_closed = False
        self._lock = threading.Lock()
        self.dropped = 0
        """Characters that did not fit."""
        self.reader: InputStream = PipeReader(self)
        self.writer: OutputStream = PipeWriter(self)


class PipeReader(InputStream):
    """The end of a pipe from which a program reads."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe
        self._rest = ""
        """Text taken from the pipe."""
        self._at = 0
        """How much of that was returned."""

    async def read_key(self) -> str:
        if self._at == len(self._rest):
            self._rest, self._at = await self._next_chunk(), 0
        self._at += 1
        return self._rest[self._at - 1 : self._at]

    async def read_line(self) -> str:
        parts: list[str] = []
        while True:
            end = self._rest.find("\n", self._at) + 1
            if end:
                line, self._at = self._rest[self._at : end], end
                return "".join([*parts, line]) if parts else line
            parts.append(self._rest[self._at :])
            self._rest, self._at = await self._next_chunk(), 0
            if not self._rest:
                return "".join(parts)

    async def _next_chunk(self) -> str:
        pipe = self._pipe
        while True:
            if pipe._chunks:
                with pipe._lock:
                    text = "".join(pipe._chunks)
                    pipe._chunks.clear()
                    pipe._size = 0
                pipe._drained.set()
                return text
            if pipe._writer_closed:
                return END_OF_INPUT
            pipe._readable.clear()
            if not pipe._chunks and not pipe._writer_closed:
                await wait_for(pipe._readable)

    def close(self) -> None:
        pipe = self._pipe
        pipe._reader_closed = True
        with pipe._lock:
            pipe._chunks.clear()
            pipe._size = 0
        pipe._drained.set()


class PipeWriter(OutputStream):
    """The end of a pipe into which a program writes; BrokenPipeError when nobody reads any more."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe

    def write(self, text: str) -> int:
        pipe = self._pipe
        if pipe._reader_closed or pipe._writer_closed:
            raise BrokenPipeError(32, "Broken pipe")
        with pipe._lock:
            if pipe._size >= PIPE_HIGH and pipe._size + len(text) > PIPE_LIMIT:
                pipe.dropped += len(text)
                return len(text)
            pipe._chunks.append(text)
            pipe._size += len(text)
            if pipe._size >= PIPE_HIGH:
                pipe._drained.clear()
        pipe._readable.set()
        return len(text)

    async def drain(self) -> None:
        await wait_for(self._pipe._drained)
        if self._pipe._reader_closed:
            raise BrokenPipeError(32, "Broken pipe")

    def wait_for_room(self) -> None:
        pipe = self._pipe
        while pipe._size >= PIPE_HIGH and not pipe._reader_closed:
            time.sleep(0.01)  # a copying thread has nothing else to do; the scheduler never comes here

    def close(self) -> None:
        self._pipe._writer_closed = True
        self._pipe._readable.set()


class TextInput(InputStream):
    """Reads a text that is already there (`<<` here-documents, tests)."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    async def read_key(self) -> str:
        self._at += 1
        return self._text[self._at - 1 : self._at]

    async def read_line(self) -> str:
        end = self._text.find("\n", self._at)
        end = len(self._text) if end < 0 else end + 1
        line, self._at = self._text[self._at : end], end
        return line


_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


def _pipe(path: Path) -> int | None:
    """Open a named pipe for writing if `path` is one: without waiting for its reader, there has to be one (ENXIO)."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return None
    if stat.S_ISFIFO(mode):
        return os.open(path, os.O_WRONLY | _AT_ONCE)
    refuse(str(path), mode, writing=True)
    return None


class FileInput(InputStream):
    """Reads a file (`< FILE`). The constructor raises OSError as `open` does."""

    def __init__(self, path: Path) -> None:
        mode = path.stat().st_mode
        if str(path) not in WITHOUT_END:  # those are read a line at a time, and others have their turn
            refuse(str(path), mode, writing=False)
        number = os.open(path, os.O_RDONLY | _AT_ONCE)
        # Every byte gets out again as it was (FileOutput), and only a newline ends a line.
        self._file: TextIO = os.fdopen(number, encoding="utf-8", errors="surrogateescape", newline="\n")

    def fileno(self) -> int | None:
        return self._file.fileno()

    async def read_key(self) -> str:
        return self._file.read(1)

    async def read_line(self) -> str:
        return self._file.readline(LONGEST_LINE)

    def close(self) -> None:
        self._file.close()


class FileOutput(OutputStream):
    """Writes a file (`> FILE`, `>> FILE`). The constructor raises OSError as `open` does.

    What cannot be written is dropped and remembered as an error, as C's stdio does it: `write` and `close` never raise, `flush`
    and `drain` do, once. Any thread may write.
    """

    def __init__(self, path: Path, *, append: bool = False) -> None:
        self._file = io.FileIO(_pipe(path) or path, "a" if append else "w")
        self._waiting = bytearray()
        self._problem: OSError | None = None
        self._lock = threading.Lock()

    def fileno(self) -> int | None:
        with self._lock:
            self._put()
        return self._file.fileno()

    def write(self, text: str) -> int:
        with self._lock:
            self._waiting += text.encode("utf-8", "surrogateescape")
            if len(self._waiting) >= FILE_BLOCK:
                self._put()
        return len(text)

    def flush(self) -> None:
        """Write what waits. Raises the first WriteError (or BrokenPipeError) since the last time."""
        with self._lock:
            self._put()
        self._raise_problem()

    async def drain(self) -> None:
        self._raise_problem()

    def close(self) -> None:
        with self._lock, contextlib.suppress(OSError):  # whoever wants to know has flushed
            self._put()
            self._file.close()

    def _raise_problem(self) -> None:
        problem, self._problem = self._problem, None
        if problem is not None:
            raise problem

    def _put(self) -> None:
        """Write what waits; as much of it as fits is in the file afterwards, as with the system's own programs."""
        data, self._waiting = memoryview(self._waiting), bytearray()
        try:
            while data and not self._file.closed:
                written = self._file.write(data)
                if written is None:  # a pipe whose reader is slower
                    raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
                data = data[written:]
        except BrokenPipeError as error:
            self._problem = self._problem or error
        except OSError as error:
            self._problem = self._problem or WriteError(error.errno, error.strerror)


class Captured(OutputStream):
    """Keeps what is written (`$(command)`, tests). Beyond CAPTURE_LIMIT it breaks like a pipe, and `is_cut` says so."""

    def __init__(self) -> None:
        self._parts: list[str] = []
        self._size = 0
        self.is_cut = False

    def write(self, text: str) -> int:
        if self._size + len(text) > CAPTURE_LIMIT:
            self.is_cut = True
            raise BrokenPipeError(32, "Broken pipe")
        self._parts.append(text)
        self._size += len(text)
        return len(text)

    async def drain(self) -> None:
        await let_others_run()  # nobody has to catch up, but a program without end must not stop the others

    @property
    def text(self) -> str:
        return "".join(self._parts)
