"""Desktops that do what a test says, behind a real server in this process: they speak a keeper's protocol and run nothing."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from functools import partial
from pathlib import Path

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom.note import Note
from day6_core.classroom.order import Order
from day6_tui.detached import wire
from day6_tui.detached.loop_line import LoopLine

PIECE = 8000


class ScriptedDesktop:
    """One desktop: `notes` go to whoever observes it, `orders` are what it was asked."""

    def __init__(self) -> None:
        self.orders: list[Order] = []
        self.lines: list[LoopLine] = []
        self.obeys: Callable[[Order], Note | None] = lambda order: None
        """What it says after an order; None: nothing."""
        self._observers: list[LoopLine] = []

    def add(self, connection: socket.socket) -> None:
        line = LoopLine(connection)
        self.lines.append(line)
        line.on_readable(partial(self._hear, line))

    def _hear(self, line: LoopLine) -> None:
        for kind, data in line.receive():
            if kind == wire.HELLO:
                line.send(wire.OUTPUT, b"\x1b[2J")
            elif kind == wire.WATCH:
                self._observers.append(line)
                self.tell(Note())
            elif kind == wire.STOP:
                self.end()
            elif kind == wire.ORDER:
                order = orders.decode(data)
                self.orders.append(order)
                if (note := self.obeys(order)) is not None:
                    self.tell(note)
        if line.closed:
            line.close()
            self.lines = [each for each in self.lines if each is not line]
            self._observers = [each for each in self._observers if each is not line]

    def tell(self, note: Note) -> None:
        self.tell_raw(notes.encode(note))

    def tell_raw(self, data: bytes) -> None:
        """What a desktop that was tampered with may say."""
        for line in self._observers:
            line.send(wire.NOTE, data)

    def end(self) -> None:
        """It is gone with its keeper."""
        for line in self.lines:
            line.close()
        self.lines, self._observers = [], []


class ScriptedDesktops:
    """Stands for `meeting.connect`: whoever is looked for runs."""

    def __init__(self) -> None:
        self.by_home: dict[str, ScriptedDesktop] = {}
        self.loop: asyncio.AbstractEventLoop | None = None

    def __getitem__(self, home: str) -> ScriptedDesktop:
        return self.by_home.setdefault(home, ScriptedDesktop())

    def connect(self, home: Path, _: Path | None = None) -> socket.socket:
        """In a thread, as the server does it."""
        assert self.loop is not None
        near, far = socket.socketpair()
        self.loop.call_soon_threadsafe(self[home.name].add, far)
        return near
