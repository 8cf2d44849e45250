"""The objects that own a part of the desktop, without the desktop around them."""

from __future__ import annotations

import time

from textual import events

from day6_tui.bars.notices import Notices
from day6_tui.options import Options
from day6_tui.terminals.held_keys import HeldKeys
from day6_tui.terminals.view import TerminalView
from tests.tui.fakes import FakeTerminal
from tests.tui.screens import UTF8, make_look


def key(name: str) -> events.Key:
    return events.Key(name, name if len(name) == 1 else None)


def view() -> TerminalView:
    return TerminalView(FakeTerminal(20, 5))


def test_without_a_scene_no_key_is_held() -> None:
    held = HeldKeys()
    assert not held.take(key("a"), None) and not held.take(key("a"), view())


def test_before_a_scene_has_chosen_its_terminal_every_key_waits() -> None:
    held = HeldKeys()
    held.begin()
    assert held.take(key("a"), None) and held.take(key("b"), view())
    assert [event.key for event in held.keys] == ["a", "b"]


def test_a_scene_holds_the_keys_of_its_own_terminal_only() -> None:
    held, here, elsewhere = HeldKeys(), view(), view()
    held.begin()
    held.view = here
    assert held.take(key("a"), here) and not held.take(key("b"), elsewhere)
    assert [event.key for event in held.keys] == ["a"]


def test_esc_stops_the_scene_forgets_what_was_held_and_the_next_key_goes_through() -> None:
    held = HeldKeys()
    held.begin()
    held.take(key("a"), None)
    assert held.take(key("escape"), None)
    assert not held.holding and held.keys == [] and not held.take(key("b"), None)


def test_a_notice_wakes_the_frames_and_is_forgotten_after_its_time() -> None:
    look = make_look(Options(lang="en"), UTF8)
    woken: list[bool] = []
    look.wake = lambda: woken.append(True)
    told: list[tuple[str, float]] = []
    notices = Notices(look, lambda: 20, lambda *notice: told.append(notice))
    assert not notices.expire(time.monotonic())
    notices.show("saved", 5.0)
    now = time.monotonic()
    assert woken and notices.expire(now + 4.0) and notices.text == "saved"
    assert not notices.expire(now + 6.0) and notices.text == "" and told == []
    notices.show("more than the line has room for", 5.0)
    assert told == [("more than the line has room for", 5.0)] and notices.text == ""


def test_only_listening_and_calling_are_doors_to_other_machines() -> None:
    assert Options(listen="tcp/0.0.0.0:7447").has_doors and Options(connect="tcp/10.0.0.2:7447").has_doors
    assert not Options(secret="word", scene="turtle").has_doors
