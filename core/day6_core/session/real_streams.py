"""The real standard streams of this process as streams of a session."""

from __future__ import annotations

import _thread
import codecs
import contextlib
import os
import signal
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from typing import TextIO, TypeVar

from day6_core.session.backlog import Backlog
from day6_core.session.harmless import TerminalText, guarded
from day6_core.session.streams import END_OF_INPUT, InputStream, OutputStream, WriteError
from day6_core.session.task import Signal, wait_for
from day6_core.session.typed_text import TypedText

T = TypeVar("T")


class RealOutput(OutputStream):
    """Our own standard output or error. It breaks like a pipe when its reader is gone.

    Text for a terminal is made harmless (`harmless`), as `ls` and `git` do; pipes and files get it unchanged.
    """

    def __init__(self, file: TextIO) -> None:
        self._file = guarded(file)
        self._muted = False
        self._backlog: Backlog | None = None
        self._held = False
        self.encoding = file.encoding or "utf-8"

    @property
    def columns(self) -> int:
        """Width of the real terminal in cells, 80 without one."""
        try:
            return os.get_terminal_size(self._file.fileno()).columns
        except (OSError, ValueError):
            return 80

    def write(self, text: str) -> int:
        """Write `text` now, or to the backlog while it is held. Raises BrokenPipeError and WriteError."""
        if self._muted:
            return len(text)
        if self._backlog is not None:
            self._backlog.write(self if self._held else None, text)
            if self._held:
                return len(text)
        return self._try(self._file.write, text)

    def control(self, sequence: str) -> None:
        """Write `sequence` unfiltered; dropped while a window has the terminal."""
        if isinstance(self._file, TerminalText):
            if not self._muted and not self._held:
                self._try(self._file.control, sequence)
        else:
            self.write(sequence)

    def _try(self, write: Callable[[str], T], text: str) -> T:
        with self._failing():
            return write(text)
        raise AssertionError("either written or raised")

    def flush(self) -> None:
        """Hand everything to the system. Raises BrokenPipeError and WriteError."""
        if not self._muted:
            with self._failing():
                self._file.flush()

    @contextlib.contextmanager
    def _failing(self) -> Iterator[None]:
        """Inside, a missing reader mutes this stream, and output that a full disk does not take is dropped (WriteError)."""
        try:
            yield
        except BrokenPipeError:
            self._muted = True
            # Python flushes the file once more at exit; that must not fail a second time.
            with contextlib.suppress(OSError, ValueError), open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), self._file.fileno())
            raise
        except OSError as error:
            with contextlib.suppress(OSError, ValueError):
                self._drop_waiting()
            raise WriteError(error.errno, error.strerror) from None

    def _drop_waiting(self) -> None:
        """Empty the file's buffer, which Python would otherwise try to write again each time and at exit."""
        number = self._file.fileno()
        kept = os.dup(number)
        try:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), number)
            self._file.flush()
        finally:
            os.dup2(kept, number)
            os.close(kept)

    def copy_to(self, backlog: Backlog) -> None:
        """Copy everything that is written to `backlog`, if this is a terminal (a file needs no copy)."""
        if self.isatty():
            self._backlog = backlog

    def hold(self, held: bool) -> None:
        """While `held`, write only to the backlog."""
        if self._backlog is not None:
            self.flush_quietly()
            self._held = held

    def mute(self) -> None:
        """Discard everything written from now on."""
        self.flush_quietly()
        self._muted = True

    def flush_quietly(self) -> None:
        """Flush; a reader that has gone and a full disk are ignored."""
        with contextlib.suppress(BrokenPipeError, WriteError):
            self.flush()

    def isatty(self) -> bool:
        """Return whether it is a terminal."""
        return self._file.isatty()

    def fileno(self) -> int | None:
        """The file descriptor, after a flush; None if the stream has none."""
        try:
            self.flush()
            return self._file.fileno()
        except (OSError, ValueError):
            return None  # captured by a test


class RealInput(InputStream):
    """Our own standard input, read by a thread that starts at the first read."""

    def __init__(self) -> None:
        self._waiting: deque[str] = deque()
        """Decoded text not yet returned; '' marks the end."""
        self._rest = TypedText()
        self._line: list[str] = []
        """The parts of a line that is not complete."""
        self._arrived = Signal()
        self._thread: threading.Thread | None = None
        self._saved: list[object] | None = None
        self._raw_signals = True

    def isatty(self) -> bool:
        """Return whether it is a terminal; False where the process was started without standard input."""
        return sys.stdin is not None and sys.stdin.isatty()

    def fileno(self) -> int | None:
        """The file descriptor, None if there is none."""
        try:
            return sys.stdin.fileno()
        except (AttributeError, OSError, ValueError):
            return None

    async def read_key(self) -> str:
        """Return the next key; '' at the end of the input."""
        while (key := self._rest.take_key()) is None:
            if not await self._more():
                return END_OF_INPUT
        return key

    async def read_line(self) -> str:
        """Return the next line with its newline; '' at the end of the input."""
        while True:
            line, ended = self._rest.take_up_to("\n")
            self._line.append(line)
            if ended or not await self._more():
                parts, self._line = self._line, []
                return "".join(parts) + "\n" * ended

    async def _more(self) -> bool:
        """Wait for more text; False at the end of the input."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._read, name="day6-stdin", daemon=True)
            self._thread.start()
        while not self._waiting:
            self._arrived.clear()
            if not self._waiting:
                await wait_for(self._arrived)
        if not self._waiting[0]:
            return False
        self._rest.add(self._waiting.popleft())
        return True

    def _read(self) -> None:
        if sys.platform == "win32" and self.isatty():
            self._read_windows()
            return
        try:
            self._read_bytes()
        finally:
            self._waiting.append("")  # the end, also after a failed read: a task may be waiting for it
            self._arrived.set()

    def _read_bytes(self) -> None:
        decoder = codecs.getincrementaldecoder("utf-8")("surrogateescape")
        fd = sys.stdin.fileno()
        while True:
            try:
                data = os.read(fd, 4096)
            except OSError:
                data = b""
            text = decoder.decode(data, final=not data)
            if text:
                self._waiting.append(text)
                self._arrived.set()
            if not data:
                return

    def _read_windows(self) -> None:
        if sys.platform != "win32":
            raise NotImplementedError("only for Windows")
        import msvcrt

        arrows = {"H": "\x1b[A", "P": "\x1b[B", "M": "\x1b[C", "K": "\x1b[D"}
        while True:
            char = msvcrt.getwch()
            if char in ("\x00", "\xe0"):
                char = arrows.get(msvcrt.getwch(), "")
            if char == "\x03" and self._raw_signals:
                _thread.interrupt_main()  # while getwch reads, Ctrl-C arrives as a key
            elif char:
                self._waiting.append(char)
                self._arrived.set()

    @contextlib.contextmanager
    def raw(self, *, signals: bool = True) -> Iterator[None]:
        """Switch the terminal to unbuffered input without echo inside (also after SIGCONT), and restore it afterwards."""
        if sys.platform == "win32" or not self.isatty():
            yield
            return
        import termios

        fd = sys.stdin.fileno()
        before = termios.tcgetattr(fd)
        self._saved = before
        self._raw_signals = signals
        self._set_raw()
        continued = signal.getsignal(signal.SIGCONT)
        with contextlib.suppress(ValueError):  # only allowed in the main thread
            signal.signal(signal.SIGCONT, lambda number, frame: self._set_raw())
        try:
            yield
        finally:
            self.restore()
            with contextlib.suppress(ValueError):
                signal.signal(signal.SIGCONT, continued)

    def _set_raw(self) -> None:
        if sys.platform == "win32":
            raise NotImplementedError("Windows has no termios")
        import termios

        fd = sys.stdin.fileno()
        mode = termios.tcgetattr(fd)
        mode[3] &= ~(termios.ICANON | termios.ECHO)
        if not self._raw_signals:
            mode[3] &= ~termios.ISIG
        termios.tcsetattr(fd, termios.TCSADRAIN, mode)

    def restore(self) -> None:
        """Restore the terminal's mode from before `raw`. May be called at any time."""
        if sys.platform != "win32" and self._saved is not None:
            import termios

            termios.tcsetattr(sys.stdin.fileno(), termios.TCSADRAIN, self._saved)  # type: ignore[arg-type]
            self._saved = None
