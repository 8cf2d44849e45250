"""A pupil's desktop, as the server has it: the line to its keeper, and the tabs that look at it."""

from __future__ import annotations

import json
import socket
import struct
import time
from collections.abc import Callable

from day6_core.isolation.cell import Cell
from day6_tui.detached import wire
from day6_tui.detached.loop_line import LoopLine
from day6_tui.web import starting
from day6_tui.web.viewer import Viewer

LEAST, MOST = (20, 5), (500, 200)
"""Columns and rows of a desktop."""

MOST_PIXELS = 16384

MOST_UNTYPED = 4 << 20
"""Bytes of keys that wait for a desktop at most: a pasted book."""

ANY_SIZE = (80, 24, 0, 0)
"""Of a desktop that is only watched."""


def clamped(columns: int, rows: int, width: int = 0, height: int = 0) -> tuple[int, int, int, int]:
    """A size that a desktop can have."""
    columns, rows = (max(low, min(n, high)) for n, low, high in zip((columns, rows), LEAST, MOST, strict=True))
    width, height = (max(0, min(n, MOST_PIXELS)) for n in (width, height))
    return columns, rows, width, height


class WebSession:
    """One running desktop. `ended` is called once, when the keeper says so or is gone."""

    def __init__(self, name: str, cell: Cell, domain: int, ended: Callable[[WebSession], None]) -> None:
        self.name = name
        self.cell = cell
        self.domain = domain
        """The ROS_DOMAIN_ID of its terminals."""
        self.writer: Viewer | None = None
        """The tab that types."""
        self.watchers: list[Viewer] = []
        self.typed_at = time.monotonic()
        """When somebody typed last."""
        self.is_over = False
        """Whether it has ended or is being ended."""
        self.is_observed = False
        """Whether the teacher hears of it."""
        self.is_over_disk = False
        """Whether its home is larger than it may be."""
        self._ended = ended
        self._line: LoopLine | None = None
        self._is_read = False
        self.on_drawn: Callable[[], None] | None = None
        """Called once, when the desktop has begun to draw, or nobody waits for that any more."""
        self._early: bytearray | None = None
        """Keys that came before the desktop draws on the present line: the keeper takes none from a client that waits."""

    @property
    def size(self) -> tuple[int, int, int, int]:
        """Columns, rows, and pixels of the screen."""
        if self.writer is not None:
            return self.writer.size
        return self.watchers[0].size if self.watchers else ANY_SIZE

    @property
    def is_watched(self) -> bool:
        """Whether anybody looks."""
        return self.writer is not None or bool(self.watchers)

    def greet(self, connection: socket.socket) -> None:
        """Have the desktop draw its whole screen on this line, and no longer on the last one."""
        self.let_go()
        columns, rows, width, height = self.size
        self._line = LoopLine(connection)
        self._early = bytearray()
        self._read(True)
        self._send(
            wire.HELLO, json.dumps({"size": [rows, columns, width, height], "environ": starting.TERMINAL}).encode()
        )
        self._tell_watchers()

    def type(self, keys: bytes) -> None:
        """Keys of the tab that types. Raises BlockingIOError if the desktop has not taken the last ones by far."""
        waiting = len(self._early or b"") + (0 if self._line is None else self._line.unsent)
        if waiting > MOST_UNTYPED:
            raise BlockingIOError
        self.typed_at = time.monotonic()
        if self._early is None:
            self._send(wire.INPUT, keys)
        else:
            self._early += keys

    def resize(self) -> None:
        """The tab that types, or the first that watches where none does, has another size."""
        columns, rows, width, height = self.size
        self._send(wire.SIZE, struct.pack("HHHH", rows, columns, width, height))
        self._tell_watchers()

    def _tell_watchers(self) -> None:
        columns, rows, _, _ = self.size
        for watcher in self.watchers:
            watcher.follow(columns, rows)

    def say_bye(self, why: str) -> None:
        """To all tabs."""
        for viewer in (self.writer, *self.watchers):
            if viewer is not None:
                viewer.bye(why)

    # -- the line ------------------------------------------------------------------------------------------------------

    def let_go(self) -> None:
        """Take nothing from the desktop any more: it goes on without a terminal, or with the next line."""
        if self._line is not None:
            self._line.close()
            self._line = None
        self._is_read = False
        self._drawn()

    def _drawn(self) -> None:
        told, self.on_drawn = self.on_drawn, None
        if told is not None:
            told()

    def _read(self, on: bool) -> None:
        if self._line is None or on == self._is_read:
            return
        self._is_read = on
        self._line.on_readable(self._hear if on else None)

    def has_room(self) -> None:
        """The tab that types takes output again."""
        self._read(True)

    def _send(self, kind: bytes, data: bytes) -> None:
        if self._line is not None:
            self._line.send(kind, data)

    def _hear(self) -> None:
        line = self._line
        assert line is not None
        for kind, data in line.receive():
            if kind == wire.OUTPUT:
                self._type_early()
                self._show(data)
                self._drawn()
            elif kind == wire.END:
                self._over("ended")
                return
            elif kind == wire.LEFT and self._line is line:
                self._over("taken" if data == wire.TAKEN else "left")
                return
        if line.closed and self._line is line:
            self._over("server")

    def _type_early(self) -> None:
        early, self._early = self._early, None
        for begin in range(0, len(early or b""), wire.READ_SIZE):
            self._send(wire.INPUT, bytes((early or b"")[begin : begin + wire.READ_SIZE]))

    def _show(self, data: bytes) -> None:
        for viewer in (self.writer, *self.watchers):
            if viewer is not None:
                viewer.put(data)
        for watcher in self.watchers:
            if watcher.is_lost:
                watcher.bye("lost")  # its page comes again, and sees the screen as it is then
        if self.writer is not None and self.writer.is_full:
            self._read(False)

    def _over(self, why: str) -> None:
        self.let_go()
        self.say_bye(why)
        if why in ("ended", "server") and not self.is_over:
            self.is_over = True
            self._ended(self)
