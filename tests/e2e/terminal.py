"""A person at a real terminal: types keys, looks at the screen, waits for what should come. Linux and macOS."""

from __future__ import annotations

import os
import re
import select
import signal
import termios
import time
from collections.abc import Callable
from copy import copy
from pathlib import Path
from typing import Any

import pyte

from tests.e2e.keys import KEYS
from tests.perf.screen import Screen, set_window_size
from tests.support.waiting import PATIENCE, Deadline, until

_FRAME = re.compile("[┃│╻║|#]")

_HELD = 1 << 20
"""Bytes, more than a pty holds of what nobody has read yet."""


class _Picture(pyte.Screen):  # type: ignore[misc]
    """pyte's screen, and the second one that programs draw on (mode 1049): after them the first is there as it was."""

    _first: tuple[dict[int, Any], Any] | None = None

    def set_mode(self, *modes: int, **options: Any) -> None:
        if 1049 in modes and options.get("private") and self._first is None:
            self._first = ({row: copy(cells) for row, cells in self.buffer.items()}, copy(self.cursor))
            self.erase_in_display(2)
        super().set_mode(*modes, **options)

    def reset_mode(self, *modes: int, **options: Any) -> None:
        super().reset_mode(*modes, **options)
        if 1049 in modes and options.get("private") and self._first is not None:
            (rows, self.cursor), self._first = self._first, None
            self.buffer.clear()
            self.buffer.update(rows)


class _Stream(pyte.ByteStream):  # type: ignore[misc]
    """pyte's stream, which reads character by character, but whole colours at once: most of what a desktop writes is these."""

    _COLOURS = re.compile(r"\x1b\[([0-9;]*)m")

    def feed(self, data: bytes) -> None:
        text, at = self.utf8_decoder.decode(data), 0
        for found in self._COLOURS.finditer(text):
            self._read(text[at : found.start()])
            if self._taking_plain_text:
                self.listener.select_graphic_rendition(*(min(int(each or 0), 9999) for each in found[1].split(";")))
            else:  # within something else
                self._read(found[0])
            at = found.end()
        self._read(text[at:])

    def _read(self, text: str) -> None:
        pyte.Stream.feed(self, text)


class Terminal(Screen):
    """One program in a terminal window of its own. Waiting raises AssertionError with the screen as it was.

    `status` is the program's exit status once it has ended, minus the signal that ended it.
    """

    def __init__(self, command: list[str], columns: int, rows: int, *, cwd: Path, env: dict[str, str | None]) -> None:
        super().__init__(command, columns, rows, cwd=str(cwd), **env)
        self.status: int | None = None
        self._picture: Any = _Picture(columns, rows)
        self._stream: Any = _Stream(self._picture)
        self._fed = 0

    def __exit__(self, *exception: object) -> None:
        if self.status is None:
            super().__exit__(*exception)
        else:
            os.close(self._fd)

    # -- typing --------------------------------------------------------------------------------------------------------

    def press(self, *keys: str) -> None:
        """Press keys, by their names in KEYS or as themselves."""
        for key in keys:
            self.send(KEYS.get(key, key))

    def quit(self) -> None:
        """Ctrl-Q, and once more for the question whether to end what runs."""
        self.send("\x11\x11")

    def send_bytes(self, data: bytes) -> None:
        """Send what no well-behaved terminal would."""
        while data:
            data = data[os.write(self._fd, data[:4000]) :]
            self._take(0.0)

    def hang_up(self) -> None:
        """Close the terminal window; reading is over."""
        os.close(self._fd)
        self._fd = os.open(os.devnull, os.O_RDWR)

    def line(self, text: str) -> None:
        """Type a command and Enter."""
        self.send(text + "\r")

    def resize(self, columns: int, rows: int) -> None:
        """Drag the window to another size."""
        self._picture.resize(rows, columns)
        set_window_size(self._fd, columns, rows)

    # -- looking -------------------------------------------------------------------------------------------------------

    def look(self, seconds: float = 0.0) -> str:
        """The screen as text, after reading what comes within `seconds`, without blanks at the ends of lines."""
        self._take(seconds)
        return "\n".join(self._row(row).rstrip() for row in range(self._picture.lines))

    def _row(self, row: int) -> str:
        """Not pyte's `display`, which cannot read half of a wide character: what is written comes in pieces."""
        return "".join(self._picture.buffer[row][column].data for column in range(self._picture.columns))

    @property
    def rows(self) -> int:
        return int(self._picture.lines)

    @property
    def columns(self) -> int:
        return int(self._picture.columns)

    def row(self, row: int) -> str:
        """One row of the screen."""
        return self._row(row)

    def columns_of(self, row: int) -> list[int]:
        """The column in which each character of a row stands."""
        cells = self._picture.buffer[row]
        return [column for column in range(self.columns) for _ in cells[column].data]

    def colours(self, column: int, row: int) -> tuple[str, str]:
        """Foreground and background of a cell, in six hexadecimal digits where the program chose them so."""
        cell = self._picture.buffer[row][column]
        return (cell.bg, cell.fg) if cell.reverse else (cell.fg, cell.bg)

    def find(self, text: str, title: str = "") -> tuple[int, int] | None:
        """Column and row in which a text begins, None where it is not on the screen (inside the pane with this `title`)."""
        left, top, right, bottom = self.inside(title) if title else (0, 0, self.columns, self.rows)
        for row in range(top, bottom):
            columns = [column for column in self.columns_of(row) if left <= column < right]
            at = "".join(self._picture.buffer[row][column].data[:1] for column in dict.fromkeys(columns)).find(text)
            if at >= 0:
                return columns[at], row
        return None

    def pane(self, title: str) -> list[str]:
        """The lines inside the pane whose title contains this, in their whole width; [] where there is none."""
        left, top, right, bottom = self.inside(title)
        rows = [self._picture.buffer[row] for row in range(top, bottom)]
        return ["".join(cells[column].data for column in range(left, right)) for cells in rows]

    def cells(self, title: str) -> list[tuple[str, str, str]]:
        """Text, foreground and background of every cell inside a pane."""
        left, top, right, bottom = self.inside(title)
        rows = [self._picture.buffer[row] for row in range(top, bottom)]
        return [
            (cells[column].data, cells[column].fg, cells[column].bg) for cells in rows for column in range(left, right)
        ]

    def inside(self, title: str) -> tuple[int, int, int, int]:
        """The first column and row inside the frame of a pane, and those behind the last; all 0 where there is no such pane."""
        rows = [
            "".join(self._picture.buffer[row][x].data or "\0" for x in range(self.columns)) for row in range(self.rows)
        ]
        for top, line in enumerate(rows):
            for frame in re.finditer(r"[╭┏][^╮┓]*[╮┓]", line):
                if title in frame[0].replace("\0", ""):
                    below = (row for row in range(top + 1, self.rows) if rows[row][frame.start()] in "╰┗")
                    return frame.start() + 1, top + 1, frame.end() - 1, next(below, self.rows)
        return 0, 0, 0, 0

    def pieces(self) -> list[str]:
        """What stands between the frames of the panes, line by line, without the blanks around it."""
        return [piece.strip() for line in self.look().split("\n") for piece in _FRAME.split(line)]

    def wait(self, *wanted: str | Callable[[str], Any], limit: float = PATIENCE) -> str:
        """Look until every wanted text is on the screen (or every function of the screen is true); returns the screen."""
        deadline = Deadline(limit)
        while True:
            has_ended = self.status is not None
            seen = self.look(0.03)
            missing = [one for one in wanted if not (one in seen if isinstance(one, str) else one(seen))]
            if not missing:
                return seen
            if deadline.is_over() or has_ended:
                raise AssertionError(f"waited for {missing}, but the screen shows\n{seen}")
            self._reap()

    def wait_lines(self, *wanted: str, limit: float = PATIENCE) -> str:
        """Look until each of the wanted texts fills a line of some pane."""
        return self.wait(lambda seen: set(wanted) <= set(self.pieces()), limit=limit)

    def wait_gone(self, *unwanted: str, limit: float = PATIENCE) -> str:
        """Look until none of the texts is on the screen."""
        return self.wait(lambda seen: not any(text in seen for text in unwanted), limit=limit)

    # -- ending --------------------------------------------------------------------------------------------------------

    def wait_end(self, limit: float = PATIENCE) -> int:
        """Wait until the program has ended by itself; returns its exit status, or minus the signal."""

        def step() -> None:
            self.look(0.02)
            self._reap()

        until(lambda: self.status is not None, limit, every=0, meanwhile=step, told=self.look)
        self.look()
        assert self.status is not None
        return self.status

    def kill(self, number: int = signal.SIGKILL) -> None:
        """Send a signal to the program alone."""
        os.kill(self.pid, number)

    def attributes(self) -> list[Any]:
        """How the system treats keys and output of this terminal now (echo, line editing, signals)."""
        return termios.tcgetattr(self._fd)

    # -- reading -------------------------------------------------------------------------------------------------------

    def _more(self, seconds: float) -> bool:
        return bool(select.select([self._fd], [], [], seconds)[0])

    def _take(self, seconds: float) -> None:
        """Read what comes within `seconds`, and all that had been written by then."""
        end = time.monotonic() + seconds
        last = None  # what was read when the time was over
        while self._more(max(0.0, end - time.monotonic())):
            try:
                data = os.read(self._fd, 65536)
            except OSError:
                data = b""  # Linux: nobody is on the terminal any more
            if not data:
                time.sleep(max(0.0, min(0.02, end - time.monotonic())))
                break
            self.output += data
            if last is None and time.monotonic() > end:
                last = len(self.output)
            if last is not None and len(self.output) > last + _HELD:
                break  # a flood
        fresh, self._fed = bytes(self.output[self._fed :]), len(self.output)
        self._stream.feed(_without_foreign(fresh))

    def _reap(self) -> None:
        if self.status is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.status = os.waitstatus_to_exitcode(status)


# Modes of newer terminals that pyte would show as text; an unfinished one at the end of a read does not matter.
_FOREIGN = re.compile(rb"\x1b\[[<>=?][0-9;]*(?:\$p|[uqcmn])")


def _without_foreign(data: bytes) -> bytes:
    return _FOREIGN.sub(b"", data)
