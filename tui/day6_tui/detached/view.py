"""Shows a kept desktop in this terminal, which gets the desktop's own output and nothing else.

Whatever ends this process, the terminal is restored.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import select
import signal
import struct
import sys
from collections.abc import Callable, Iterator
from types import FrameType
from typing import TYPE_CHECKING

from day6_tui.detached import wire
from day6_tui.detached.wire import Connection
from day6_tui.locale import Texts
from day6_tui.screen.modes import GIVE_BACK

assert not TYPE_CHECKING or sys.platform != "win32"  # Windows has none of this

DESCRIBES_TERMINAL = (
    "TERM", "COLORTERM", "TERM_PROGRAM", "TERM_PROGRAM_VERSION", "TMUX", "STY", "NO_COLOR",
    "LC_ALL", "LC_CTYPE", "LC_MESSAGES", "LANGUAGE", "LANG", "DAY6_LANG",
)  # fmt: skip
"""The variables that the desktop judges a terminal by."""

PIECE = 1024
"""Bytes that are written to the terminal at a time: between two pieces keys are sent."""

MOST_UNWRITTEN = 4096
LAST_SECONDS = 2.0
"""How long a terminal may take nothing while the last output is written."""
RESTORE_SECONDS = 1.0
"""What a terminal gets to take what restores it: one that is stuck never does."""

LONGEST_HEAD = 128
"""Bytes at the end of what was written that may be the beginning of a sequence that matters."""
_KITTY_HEAD = re.compile(rb"\x1b_G([^;\x1b]+)[;\x1b]")
_SECOND_SCREEN = re.compile(rb"\x1b\[\?1049([hl])")


class _Signalled(Exception):
    """A signal that ends or stops this process."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number


def hello(size: list[int] | None) -> bytes:
    """What is said to the keeper first; `size` None without a terminal."""
    environ = {name: os.environ[name] for name in DESCRIBES_TERMINAL if name in os.environ}
    return json.dumps({"size": size, "environ": environ}).encode()


def show(line: Connection, texts: Texts, back: str) -> int | None:
    """Let the desktop have this terminal until one of them leaves; `back` is the command that comes back.

    Returns the exit status, or None when this process goes on after it was stopped: then it has to attach again.
    """
    view = _View(line)
    try:
        view.take()
        line.send(wire.HELLO, hello(view.size()))
        why, data = view.run()
    except _Signalled as order:
        view.restore()
        line.close()
        if order.number == signal.SIGTSTP:
            os.kill(os.getpid(), signal.SIGSTOP)
            return None
        return 128 + order.number
    finally:
        view.restore()
        line.close()
    if why == wire.END:
        return int(data)
    if why == wire.LEFT:
        key = "detached.asked" if data == wire.ASKED else "detached.taken"
        print(f"[{texts(key, command=back)}]", file=sys.stderr)
        return 0
    print(f"day6-tui: {texts('detached.lost')}", file=sys.stderr)
    return 1


class _View:
    """This terminal, while the desktop has it."""

    def __init__(self, line: Connection) -> None:
        import termios

        self._line = line
        self._before = termios.tcgetattr(0)
        self._handlers: dict[signal.Signals, Callable[[int, FrameType | None], object] | int | None] = {}
        self._wakes, self._wake = os.pipe()
        self._is_over = False
        """Whether the terminal is being restored: no signal may disturb that."""
        self._unwritten = bytearray()
        self._seen = b""
        """The end of what was written: a sequence may come in two parts."""
        self._is_taken = False
        """Whether the desktop is on the terminal's second screen."""
        self._pictures: set[bytes] = set()
        """The numbers of its pictures in Kitty's protocol; other pictures go with the second screen."""

    def size(self) -> list[int]:
        """Rows, columns, width and height in pixels."""
        import fcntl
        import termios

        with contextlib.suppress(OSError):
            return list(struct.unpack("HHHH", fcntl.ioctl(2, termios.TIOCGWINSZ, b"\0" * 8)))
        return [24, 80, 0, 0]

    def take(self) -> None:
        """Hand every key on as it comes, and attend to signals."""
        import termios
        import tty

        def end(number: int, frame: object) -> None:
            if not self._is_over:
                self._is_over = True
                raise _Signalled(number)

        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGTSTP):
            if signal.getsignal(number) != signal.SIG_IGN:
                self._handlers[number] = signal.signal(number, end)
        self._handlers[signal.SIGWINCH] = signal.signal(signal.SIGWINCH, lambda number, frame: None)
        os.set_blocking(self._wakes, False)
        os.set_blocking(self._wake, False)
        signal.set_wakeup_fd(self._wake, warn_on_full_buffer=False)
        tty.setraw(0, termios.TCSANOW)  # what was typed meanwhile is not lost

    def run(self) -> tuple[bytes, bytes]:
        """Carry bytes to and fro; the message with which that ended, b'' if the keeper is gone."""
        last = (b"", b"")
        while not (over := self._line.closed or bool(last[0])) or self._unwritten:
            readers: list[int] = [self._wakes, 0]
            if len(self._unwritten) < MOST_UNWRITTEN and not over:
                readers.append(self._line.fileno())
            writers = [self._line.fileno()] if self._line.unsent and not self._line.closed else []
            writers += [2] if self._unwritten else []
            readable, writable, _ = select.select(readers, writers, [], LAST_SECONDS if over else None)
            if not (readable or writable):
                break
            if self._wakes in readable:
                os.read(self._wakes, 64)
                self._line.send(wire.SIZE, struct.pack("HHHH", *self.size()))
            if 2 in writable:
                self._write()
            if self._line.fileno() in writable:
                self._line.flush()
            if 0 in readable:
                self._line.send(wire.INPUT, self._keys())
            if self._line.fileno() in readable:
                for kind, data in self._line.receive():
                    if kind == wire.OUTPUT:
                        self._unwritten += data
                    else:
                        last = (kind, data)
        return last

    def _keys(self) -> bytes:
        try:
            if keys := os.read(0, wire.READ_SIZE):
                return keys
        except BlockingIOError:
            return b""
        except OSError:
            pass
        raise self._hung_up()

    def _hung_up(self) -> _Signalled:
        self._is_over = True
        return _Signalled(signal.SIGHUP)

    def _write(self) -> None:
        piece = bytes(self._unwritten[:PIECE])
        # A signal may end this right after the terminal took the piece: what is begun in it counts as written before.
        seen = self._seen + piece
        self._is_taken = self._is_taken or any(each[1] == b"h" for each in _SECOND_SCREEN.finditer(seen))
        self._pictures |= {number for number, there in _pictures_in(seen) if there}
        try:
            piece = piece[: os.write(2, piece)]
        except BlockingIOError:
            return
        except OSError:
            raise self._hung_up() from None
        del self._unwritten[: len(piece)]
        seen = self._seen + piece
        for screen in _SECOND_SCREEN.finditer(seen):
            self._is_taken = screen[1] == b"h"
        for number, there in _pictures_in(seen):
            (self._pictures.add if there else self._pictures.discard)(number)
        self._seen = seen[-LONGEST_HEAD:]

    def restore(self) -> None:
        """Leave the terminal as it was; nothing is done twice."""
        import termios

        self._is_over = True
        if not self._handlers:
            return
        handlers, self._handlers = self._handlers, {}
        signal.set_wakeup_fd(-1)
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGTSTP):
            signal.signal(number, signal.SIG_IGN)
        with contextlib.suppress(termios.error, OSError):
            if self._is_taken:
                termios.tcflush(0, termios.TCOFLUSH)
                erased = "".join(f"\x1b_Ga=d,d=I,i={int(each)},q=2\x1b\\" for each in self._pictures if each.isdigit())
                # What was flushed may have been the end of a sequence that carries a text, such as a picture.
                _write_in_time("\x1b\\" + erased + GIVE_BACK)
            termios.tcflush(0, termios.TCIFLUSH)
            termios.tcsetattr(0, termios.TCSANOW, self._before)
        for number, handler in handlers.items():
            signal.signal(number, handler)
        os.close(self._wakes)
        os.close(self._wake)


def _pictures_in(seen: bytes) -> Iterator[tuple[bytes, bool]]:
    """The numbers of pictures that are sent or removed there, in order, and whether it is there then (Kitty's protocol)."""
    for head in _KITTY_HEAD.finditer(seen):
        keys = dict(each.partition(b"=")[::2] for each in head[1].split(b","))
        if keys.get(b"a") == b"t":
            yield keys.get(b"i", b""), True
        elif keys.get(b"a") == b"d" and keys.get(b"d") == b"I":
            yield keys.get(b"i", b""), False


def _write_in_time(text: str) -> None:
    """Write to the terminal, which may be stuck."""

    def give_up(number: int, frame: object) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, give_up)
    signal.setitimer(signal.ITIMER_REAL, RESTORE_SECONDS)
    try:
        rest = text.encode()
        while rest:
            rest = rest[os.write(2, rest) :]
    except OSError:  # stuck, or gone
        return
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
