"""Keys that come faster than they are worked off go to what those before them have given the keyboard to."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import cast

import pytest
from textual import events
from textual.app import App, ComposeResult
from textual.containers import Vertical
from textual.message import Message
from textual.widgets import Static

from day6_tui.screen import key_order
from day6_tui.screen.key_order import PATIENCE, KeyOrder, is_letter
from tests.tui.stepped_time import stepped_time


class Slow(Static):
    """Takes a while for each key, and stays while one is `held`; Enter leads to the last widget, Backspace removes this one."""

    can_focus = True
    letters_stay = False

    def keeps_keyboard(self, event: events.Event) -> bool:
        return self.letters_stay and is_letter(event)

    class Took(Message):
        """It has dealt with a key."""

        def __init__(self, key: str) -> None:
            super().__init__()
            self.key = key

    def __init__(self) -> None:
        super().__init__()
        self.taken: list[str] = []
        self.held: asyncio.Event | None = None
        self.work = 0.0
        """Seconds of a core that the next key costs; another key comes at the end of them."""

    async def on_key(self, event: events.Key) -> None:
        await asyncio.sleep(0.005)
        self.taken.append(event.key)
        if self.work:
            end, self.work = time.thread_time() + self.work, 0.0
            while time.thread_time() < end:
                pass
            self.app.post_message(events.Key("late", None))
        self.post_message(self.Took(event.key))
        if self.held is not None:
            await self.held.wait()

    def on_paste(self, event: events.Paste) -> None:
        self.taken.append(event.text)


class Two(App[None]):
    """What a widget does not stop comes to its box, which acts on it."""

    def compose(self) -> ComposeResult:
        with Box():
            yield Slow()
            yield Slow()

    def on_mount(self) -> None:
        self.key_order = KeyOrder(lambda: self.focused or self.screen, self.hand_over)
        self.first, self.last = self.query(Slow)
        self.first.focus()

    async def on_event(self, event: events.Event) -> None:
        if isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded:
            await self.key_order.take(event)
        else:
            await super().on_event(event)

    async def hand_over(self, event: events.Event) -> None:
        await super().on_event(event)

    def burst(self, *typed: str) -> None:
        for each in typed:
            key = events.Key(each, each if len(each) == 1 else None)
            self.post_message(events.Paste("pasted") if each == "paste" else key)

    async def see(self, taken: list[str]) -> None:
        for _ in range(400):
            if self.last.taken == taken:
                return
            await asyncio.sleep(0.005)
        raise AssertionError((self.first.taken, self.last.taken))


class Box(Vertical):
    async def on_slow_took(self, event: Slow.Took) -> None:
        await asyncio.sleep(0.005)
        first, last = self.app.query(Slow) if len(self.children) == 2 else (None, self.app.query_one(Slow))
        if event.key in ("enter", "backspace"):
            self.screen.set_focus(last)
        if event.key == "backspace" and first is not None:
            first.remove()


@asynccontextmanager
async def two() -> AsyncIterator[Two]:
    with stepped_time():
        async with Two().run_test() as pilot:
            yield cast(Two, pilot.app)


@pytest.mark.parametrize("letters_stay", [False, True])
@pytest.mark.parametrize("key", ["enter", "backspace"])
async def test_keys_behind_one_that_moves_the_keyboard_go_where_it_went(
    key: str, letters_stay: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Slow, "letters_stay", letters_stay)
    async with two() as app:
        app.burst("a", key, "b", "paste", "c", "d")
        await app.see(["b", "pasted", "c", "d"])
        assert app.first.taken == ["a", key]


async def test_a_key_that_is_never_done_holds_up_the_others_for_a_while_only() -> None:
    async with two() as app:
        app.first.held = asyncio.Event()
        app.burst("a", "b")
        await asyncio.sleep(PATIENCE / 2)
        assert app.first.taken == ["a"]
        app.last.focus()
        await asyncio.sleep(PATIENCE / 4)
        assert app.last.taken == []
        await asyncio.sleep(PATIENCE / 2)
        app.burst("c")
        await app.see(["b", "c"])
        app.first.held.set()
        app.burst("d")
        await app.see(["b", "c", "d"])
        await asyncio.sleep(PATIENCE)  # the held key is still on its way to the application, which must not be gone


async def test_a_key_that_a_slow_machine_works_on_holds_up_the_others_for_as_long_as_it_takes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(key_order, "PATIENCE", 0.3)
    async with Two().run_test() as pilot:
        app = cast(Two, pilot.app)
        app.first.work = 0.5
        app.burst("enter", "b")
        await app.see(["b", "late"])
        assert app.first.taken == ["enter"]
