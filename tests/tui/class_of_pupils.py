"""A teacher's desktop whose pupils come, say something and go when a test has them do so; there is no network."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from day6_core.classroom import note as notes
from day6_core.classroom import order as orders
from day6_core.classroom import shown
from day6_core.classroom.note import Note, PupilScreen
from day6_core.classroom.order import Order
from day6_core.classroom.shown import Shown
from day6_core.link.classroom.teacher import Teacher
from day6_core.link.state import Door, DoorState
from day6_tui.classes.link import TeacherLink
from day6_tui.machine import Machine
from tests.tui.fakes import FakeDesk
from tests.tui.screens import ToolWindow, opened, step

ENDPOINT = "tcp/192.0.2.7:7447"
OPEN = Door(ENDPOINT, listening=True, state=DoorState.OPEN)


class FakeClass(Teacher):
    """The teacher's part: keeps what is sent to pupils, and says what they say."""

    def __init__(self, *, room: bool = False) -> None:
        super().__init__(room=room)
        self.sent: list[tuple[str, Order]] = []
        self.notes: dict[str, Note] = {}
        self.handed: list[tuple[str, bytes]] = []
        self.answers: dict[str, bytes] = {}
        """What pupils answer who are handed a file; the others don't."""
        self.pictures: list[Shown | None] = []
        """What is shown to all; None: its end."""

    def order(self, name: str, order: bytes) -> bool:
        if name in self.notes:
            self.sent.append((name, orders.decode(order)))
        return name in self.notes

    def show(self, picture: bytes) -> None:
        self.pictures.append(shown.decode(picture))

    def hand(self, name: str, message: bytes) -> bytes | None:
        self.handed.append((name, message))
        return self.answers.get(name)

    def come(self, *names: str) -> None:
        for name in names:
            self.notes[name] = Note()
            self.came(name, True)
            self.say(name)

    def say(self, name: str, **what: Any) -> None:
        """Change what a pupil says of itself."""
        self.notes[name] = replace(self.notes[name], **what)
        self.noted(name, notes.encode(self.notes[name]))

    def leave(self, name: str) -> None:
        del self.notes[name]
        self.came(name, False)

    def asked_of(self, name: str, *kinds: str) -> list[Order]:
        """The orders to a pupil, of these kinds only if there are any."""
        return [order for to, order in self.sent if to == name and (not kinds or order.do in kinds)]

    def typed_to(self, name: str) -> str:
        return "".join(order.text for order in self.asked_of(name, "type"))


class ClassDesk(FakeDesk):
    """Opens the window at once: a program without a scheduler."""

    def start_unseen(self, name: str, main: Any) -> None:
        self.display.open(name, name, main.__self__)


class ClassWindow(ToolWindow):
    """The window of the class and what its pupils do."""

    part: FakeClass

    @property
    def link(self) -> TeacherLink:
        link: TeacherLink = self.model
        return link

    def line_with(self, text: str) -> str:
        return next((line for line in self.text.split("\n") if text in line), "")

    async def step(self) -> None:
        await step(self.app, self.pilot)

    async def come(self, *names: str) -> None:
        self.part.come(*names)
        await self.step()

    async def say(self, name: str, **what: Any) -> None:
        self.part.say(name, **what)
        await self.step()

    async def leave(self, name: str) -> None:
        self.part.leave(name)
        await self.step()


def screen_of(text: str, columns: int = 80, rows: int = 24) -> PupilScreen:
    """A screen whose lines begin with a text and their number, and end with an exclamation mark."""
    return PupilScreen(columns, rows, "\n".join(f"{text}{row}".ljust(columns - 1, ".") + "!" for row in range(rows)))


@asynccontextmanager
async def in_class(
    monkeypatch: Any,
    columns: int = 120,
    rows: int = 40,
    *,
    room: bool = False,
    door: Door | None = OPEN,
    home: Path | None = None,
    **options: Any,
) -> AsyncIterator[ClassWindow]:
    """A teacher's desktop with the window of the class, which has the keyboard and the whole of it."""
    monkeypatch.setattr(Machine, "doors", lambda self: () if door is None else (door,))
    part, desk = FakeClass(room=room), ClassDesk()
    desk.home = home or desk.home
    given = {"lang": "en", "scene": "empty", "part": part, "listen": ENDPOINT, "secret": "word", **options}
    async with opened(desk, columns, rows, **given) as (app, pilot):
        await step(app, pilot)
        window = ClassWindow(app, pilot, next(iter(app.desktop.panes)))
        window.part = part
        app.desktop.focus_pane(window.pane)
        await window.step()
        yield window
