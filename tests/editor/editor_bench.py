"""An editor on a desktop whose frames the test draws."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from textual import events

from day6_core.shell.editing.model import Editor
from tests.tui.fakes import FakeDesk
from tests.tui.screens import opened, screen_text, step

KEYS = {"\n": "enter", " ": "space", ")": "right_parenthesis", "]": "right_square_bracket", "}": "right_curly_bracket"}


class Bench:
    """An editor on a file of `tmp_path`; `act` gets it with the desktop around it."""

    def __init__(self, folder: Path, name: str = "nano", file: str = "talker.py") -> None:
        self.path = folder / file
        self.state = folder / "state"
        self.name = name
        self.app: Any = None
        self.pilot: Any = None
        self.pane: Any = None
        self.window: Any = None

    def run(self, act: Callable[[Bench], Awaitable[None]], width: int = 80, height: int = 24, **options: Any) -> Bench:
        async def play() -> None:
            desk = FakeDesk()
            editor = Editor(self.path.parent, self.state, self.name)
            editor.open(self.path)
            self.window = desk.display.open("editor", self.name, editor)
            async with opened(desk, width, height, scene="empty", **{"lang": "en", **options}) as (
                self.app,
                self.pilot,
            ):
                await self.step()
                self.pane = self.app.query_one("EditorPane")
                self.app.desktop.focus_pane(self.pane)
                await self.step()
                await act(self)

        asyncio.run(play())
        return self

    async def step(self) -> None:
        await step(self.app, self.pilot)

    async def slowly(self, key: str) -> None:
        """Press a key so long after the last one that it cannot be a paste."""
        self.pane.area._last_key = -1.0
        await self.press(key)

    async def press(self, *keys: str) -> str:
        """Press keys as a person does, one after the other; return the screen."""
        await self.pilot.press(*keys)
        await self.step()
        return screen_text(self.app)

    async def type(self, text: str) -> None:
        """Type a text as a person does, each key a second after the last."""
        at = max(0.0, self.pane.area._last_key)
        for char in text:
            key = events.Key(KEYS.get(char, char), "\r" if char == "\n" else char)
            at = key.time = at + 1.0
            self.app.screen.focused.post_message(key)
        await self.step()

    async def burst(self, text: str) -> None:
        """Keys as fast as a terminal without bracketed paste sends a pasted text."""
        for char in text:
            key = {"\n": "enter", "\t": "tab"}.get(char, char)
            self.app.screen.focused.post_message(events.Key(key, "\r" if char == "\n" else char))
        await self.step()

    async def paste(self, text: str) -> None:
        self.pane.area.post_message(events.Paste(text))
        await self.step()

    @property
    def text(self) -> str:
        return str(self.pane.area.text)

    @property
    def saved(self) -> str:
        return self.path.read_text(encoding="utf-8")

    @property
    def open(self) -> bool:
        return not self.window.closed
