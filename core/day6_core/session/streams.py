"""The streams of a program: the base classes, an in-process pipe, and files.

Writing never blocks, because a cooperative program must not: `write` puts the text somewhere bounded and returns. A program
with unlimited output calls `await stream.drain()` between its writes.
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
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Protocol, TextIO

from day6_core import deep
from day6_core.session.blocking_files import WITHOUT_END, refuse
from day6_core.session.harmless import KEEP_BYTES
from day6_core.session.task import Signal, let_others_run, wait_for

END_OF_INPUT = ""

PIPE_HIGH = 256 * 1024
"""Characters in a pipe from which on `drain` waits."""

PIPE_LIMIT = 4 * 1024 * 1024
"""Characters a pipe holds; writes beyond that without draining are dropped, each as a whole.

One write after draining is always taken as a whole: a message of megabytes is a single write.
"""

CAPTURE_LIMIT = 64 * 1024 * 1024
"""Characters that `$(command)` keeps; bash goes on until memory runs out."""


FILE_BLOCK = 64 * 1024
"""Bytes that are buffered before they are written to a file; the rest is written when the program ends."""


class WriteError(OSError):
    """A program's output could not be written: the disk is full, or a limit was reached. Not raised for a broken pipe."""


DRAINS_IN_A_ROW = 16
"""Writes followed by `drain` after which other programs get their turn even if there is room."""

LONGEST_LINE = 1 << 20
"""The most characters of a file's line that are read at once; /dev/zero has no newline."""


class KeyReceiver(Protocol):
    """A process on a pty: receives keys as they are typed and the size of its window."""

    def keys(self, text: str) -> None:
        """Take keys as the terminal sends them."""

    def resize(self, columns: int, rows: int) -> None:
        """Take the window's new size in cells."""

    def wants_signal_keys(self) -> bool:
        """Return whether Ctrl-C and the like are keys to it (ISIG is off)."""


class TerminalSide(Protocol):
    """The simulated terminal behind a pty, as its process needs to know it."""

    columns: int
    rows: int
    output: OutputStream
    """Takes the text that the pty delivers."""


class InputStream:
    """A program's input. This base class is the empty input (`< /dev/null`)."""

    def isatty(self) -> bool:
        """Return whether it is a terminal."""
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
        """On a terminal: return the input of a job started here, which gets the keys while it has the focus. Else return self."""
        return self

    def focus(self) -> None:
        """On a terminal: take the keys of the input this was forked from (in the background: once that one has them)."""

    def unfocus(self) -> None:
        """On a terminal: give the keys back to the reader this was forked from."""

    def terminal_of(self, *outputs: OutputStream) -> TerminalSide | None:
        """Return the simulated terminal that this stream and at least one of `outputs` belong to, None if there is none."""
        return None

    def pass_keys_to(self, receiver: KeyReceiver | None) -> None:
        """On a terminal: pass every key to `receiver` as it is typed, without echo (None: handle keys here again)."""

    def push_back(self, text: str) -> None:
        """Return what was taken from here for a process that has not read it; the next reader gets it."""

    def close(self) -> None:
        """Close the reading end."""


class OutputStream:
    """A program's output. This base class discards everything (`> /dev/null`)."""

    _drains = 0

    encoding = "utf-8"

    terminal: TerminalSide | None = None
    """The simulated terminal that shows it, None where there is none."""

    @property
    def columns(self) -> int:
        """Width in terminal cells, 80 where there is no terminal."""
        return 80

    def write(self, text: str) -> int:
        """Append text without ever waiting; returns its length.

        Raises:
            BrokenPipeError: the reader is gone.
        """
        return len(text)

    def control(self, sequence: str) -> None:
        """Write an escape sequence (clear the screen, go up a line), which `write` would make harmless on a real terminal."""
        self.write(sequence)

    def flush(self) -> None:
        """Write buffered text; does nothing on unbuffered streams."""

    async def drain(self) -> None:
        """Wait until the reader has caught up, and now and then let other programs run.

        Raises:
            BrokenPipeError: the reader is gone.
        """
        self._drains += 1
        if self._drains % DRAINS_IN_A_ROW == 0:
            await let_others_run()

    def keyboard(self) -> InputStream | None:
        """On a terminal: return the keys of its foreground job, as from /dev/tty; None elsewhere."""
        return None

    def wait_for_room(self) -> None:
        """For a thread that copies into this stream: block it, for a bounded time, while the stream is too full."""

    def isatty(self) -> bool:
        """Return whether it is a terminal."""
        return False

    @property
    def raw(self) -> OutputStream:
        """On a terminal: return what takes text as a pty delivers it, with its newlines done. Else return self."""
        return self

    def fileno(self) -> int | None:
        """The file descriptor a child process may inherit, None if there is none."""
        return None

    def close(self) -> None:
        """Close the writing end."""


class Overheard(OutputStream):
    """Another output, of which `keep` is told what was written; what an inherited descriptor takes is not."""

    def __init__(self, target: OutputStream, keep: Callable[[str], None]) -> None:
        self.target = target
        self._keep = keep
        self.encoding = target.encoding
        self.terminal = target.terminal

    @property
    def columns(self) -> int:
        """Width of the other one."""
        return self.target.columns

    @property
    def raw(self) -> OutputStream:
        """The other one's, overheard too."""
        return Overheard(self.target.raw, self._keep)

    def write(self, text: str) -> int:
        """Write to the other one, then tell."""
        written = self.target.write(text)
        self._keep(text)
        return written

    def control(self, sequence: str) -> None:
        """Write an escape sequence to the other one; nobody is told."""
        self.target.control(sequence)

    def flush(self) -> None:
        """Flush the other one."""
        self.target.flush()

    async def drain(self) -> None:
        """Wait for the other one's reader."""
        await self.target.drain()

    def keyboard(self) -> InputStream | None:
        """The keys of the other one's terminal."""
        return self.target.keyboard()

    def wait_for_room(self) -> None:
        """Wait for room in the other one."""
        self.target.wait_for_room()

    def isatty(self) -> bool:
        """Return whether the other one is a terminal."""
        return self.target.isatty()

    def fileno(self) -> int | None:
        """The other one's descriptor."""
        return self.target.fileno()

    def close(self) -> None:
        """Close the other one."""
        self.target.close()


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
        """Number of characters dropped because the pipe was full."""
        self.reader: InputStream = PipeReader(self)
        self.writer: OutputStream = PipeWriter(self)


class PipeReader(InputStream):
    """The reading end of a pipe."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe
        self._rest = ""
        """Text taken from the pipe."""
        self._at = 0
        """Index of its first character that has not been returned."""
        self._begun: list[str] = []
        """What came before `_rest` of a line whose end has not come."""

    async def read_key(self) -> str:
        """Return the next character, waiting for it; '' once the writer is closed and everything is read."""
        if self._begun:
            self.push_back("")
        if self._at == len(self._rest):
            self._rest, self._at = await self._next_chunk(), 0
        self._at += 1
        return self._rest[self._at - 1 : self._at]

    async def read_line(self) -> str:
        """Return the next line, waiting for its newline; '' once the writer is closed and everything is read."""
        while True:
            end = self._rest.find("\n", self._at) + 1
            if end:
                line, self._at = self._rest[self._at : end], end
                return self._from_its_beginning(line)
            self._begun.append(self._rest[self._at :])
            self._rest, self._at = "", 0
            chunk = await self._next_chunk()
            self._rest += chunk
            if not self._rest:
                return self._from_its_beginning("")

    def _from_its_beginning(self, line: str) -> str:
        begun, self._begun = self._begun, []
        return "".join([*begun, line]) if begun else line

    def push_back(self, text: str) -> None:
        """Put `text` before what has not been read yet."""
        self._rest, self._at = self._from_its_beginning(self._rest[self._at :]), 0
        self._rest = text + self._rest

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
        """Break the pipe: drops what is in it, and the writer's next write fails."""
        pipe = self._pipe
        pipe._reader_closed = True
        with pipe._lock:
            pipe._chunks.clear()
            pipe._size = 0
        pipe._drained.set()


class PipeWriter(OutputStream):
    """The writing end of a pipe; it raises BrokenPipeError once the reader has closed its end."""

    def __init__(self, pipe: Pipe) -> None:
        self._pipe = pipe

    def write(self, text: str) -> int:
        """Append text; what exceeds PIPE_LIMIT is dropped.

        Raises:
            BrokenPipeError: when an end is closed.
        """
        pipe = self._pipe
        if pipe._reader_closed or pipe._writer_closed:
            raise BrokenPipeError(32, "Broken pipe")
        if not text:  # to the reader it would be the end
            return 0
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
        """Wait until the pipe has been read, and now and then let other programs run.

        Raises:
            BrokenPipeError: when the reader has gone.
        """
        await wait_for(self._pipe._drained)
        await super().drain()
        if self._pipe._reader_closed:
            raise BrokenPipeError(32, "Broken pipe")

    def wait_for_room(self) -> None:
        """Block the calling thread while PIPE_HIGH characters or more are in the pipe."""
        pipe = self._pipe
        while pipe._size >= PIPE_HIGH and not pipe._reader_closed:
            time.sleep(0.01)  # a copying thread has nothing else to do; the scheduler's thread never gets here

    def close(self) -> None:
        """End the reader's input once it has read what is in the pipe."""
        self._pipe._writer_closed = True
        self._pipe._readable.set()


class TextInput(InputStream):
    """Reads a text that is already there (`<<` here-documents, tests)."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    async def read_key(self) -> str:
        """Return the next character; '' at the end of the text."""
        self._at += 1
        return self._text[self._at - 1 : self._at]

    async def read_line(self) -> str:
        """Return the next line with its newline; '' at the end of the text."""
        end = self._text.find("\n", self._at)
        end = len(self._text) if end < 0 else end + 1
        line, self._at = self._text[self._at : end], end
        return line

    def push_back(self, text: str) -> None:
        """Put `text` before what has not been read yet."""
        self._text, self._at = text + self._text[self._at :], 0


_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


def _for_writing(path: Path) -> Path | int:
    """Return what `FileIO` opens: of a named pipe a descriptor, without waiting for a reader (ENXIO if there is none)."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return path
    if stat.S_ISFIFO(mode):
        return os.open(path, os.O_WRONLY | _AT_ONCE)
    refuse(str(path), mode, writing=True)
    return path


_POSITION = (1 << 64) - 1
"""The part of a text file's position that is one in its bytes (the rest is about the decoder)."""


def _text(file: io.BufferedReader) -> TextIO:
    """Return the text of a file: FileOutput writes every byte back unchanged, and only a newline ends a line."""
    return io.TextIOWrapper(file, encoding="utf-8", errors="surrogateescape", newline="\n")


class FileInput(InputStream):
    """Reads a file (`< FILE`). The constructor raises OSError as `open` does."""

    def __init__(self, path: Path) -> None:
        mode = deep.status(path, follow=True).st_mode
        if str(path) not in WITHOUT_END:  # those are read a line at a time, and other programs get their turn
            refuse(str(path), mode, writing=False)
        number = deep.open_file(path, os.O_RDONLY | _AT_ONCE)
        self._file: TextIO = _text(os.fdopen(number, "rb"))

    def fileno(self) -> int | None:
        """The descriptor of the open file; whoever inherits it goes on where reading has stopped, and so do we after it."""
        if self._file.seekable():
            place = self._file.tell() & _POSITION
            file = os.fdopen(os.dup(self._file.fileno()), "rb")
            self._file.close()
            file.seek(place)
            self._file = _text(file)
        return self._file.fileno()

    async def read_key(self) -> str:
        """Return the next character; '' at the end of the file."""
        return self._file.read(1)

    async def read_line(self) -> str:
        """Return the next line with its newline, at most LONGEST_LINE characters; '' at the end of the file."""
        return self._file.readline(LONGEST_LINE)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


class FileOutput(OutputStream):
    """Writes a file (`> FILE`, `>> FILE`). The constructor raises OSError as `open` does.

    Bytes that cannot be written are dropped and the error is kept, as in C's stdio: `write` and `close` never raise, `flush` and
    `drain` do, once. Any thread may write.
    """

    def __init__(self, path: Path, *, append: bool = False) -> None:
        self._file = io.FileIO(_for_writing(path), "a" if append else "w")
        self._waiting = bytearray()
        self._problem: OSError | None = None
        self._lock = threading.Lock()

    def fileno(self) -> int | None:
        """The descriptor of the open file, after everything waiting has been written to it."""
        with self._lock:
            self._put()
        return self._file.fileno()

    def write(self, text: str) -> int:
        """Keep `text`, and write blocks of FILE_BLOCK bytes to the file. Never raises."""
        with self._lock:
            self._waiting += text.encode("utf-8", KEEP_BYTES)
            if len(self._waiting) >= FILE_BLOCK:
                self._put()
        return len(text)

    def flush(self) -> None:
        """Write the buffer. Raises the first WriteError (or BrokenPipeError) since the last time."""
        with self._lock:
            self._put()
        self._raise_problem()

    async def drain(self) -> None:
        """Let other programs run now and then. Raises the first WriteError (or BrokenPipeError) since the last time."""
        await super().drain()
        self._raise_problem()

    def close(self) -> None:
        """Write what waits and close the file. Never raises."""
        with (
            self._lock,
            contextlib.suppress(OSError),
        ):  # errors are raised by `flush`, which comes first where they matter
            self._put()
            self._file.close()

    def _raise_problem(self) -> None:
        problem, self._problem = self._problem, None
        if problem is not None:
            raise problem

    def _put(self) -> None:
        """Write the buffer; as much of it as fits ends up in the file, as with the system's own programs."""
        data, self._waiting = memoryview(self._waiting), bytearray()
        try:
            while data and not self._file.closed:
                written = self._file.write(data)
                if written is None:  # a pipe that is full
                    raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
                data = data[written:]
        except BrokenPipeError as error:
            self._problem = self._problem or error
        except OSError as error:
            self._problem = self._problem or WriteError(error.errno, error.strerror)


class Captured(OutputStream):
    """Keeps its text (`$(command)`, tests). Beyond CAPTURE_LIMIT it breaks like a pipe and `is_cut` is set."""

    def __init__(self) -> None:
        self._parts: list[str] = []
        self._size = 0
        self.is_cut = False

    def write(self, text: str) -> int:
        """Keep `text`.

        Raises:
            BrokenPipeError: beyond CAPTURE_LIMIT.
        """
        if self._size + len(text) > CAPTURE_LIMIT:
            self.is_cut = True
            raise BrokenPipeError(32, "Broken pipe")
        self._parts.append(text)
        self._size += len(text)
        return len(text)

    async def drain(self) -> None:
        """Let other programs run."""
        await let_others_run()  # no reader has to catch up, but an endless program must not hold up the others

    @property
    def text(self) -> str:
        """Everything that was written."""
        return "".join(self._parts)
