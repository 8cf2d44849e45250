"""What a terminal answers becomes an ability, and never a key."""

from __future__ import annotations

import random

import pytest
from textual import events

from day6_tui.pixels.ask import FIRST, ITERM, KITTY, SIXEL, Ability, Answered, Inquiry, may_be_asked
from day6_tui.textual_private import keyboard
from day6_tui.textual_private.keyboard import KeyboardParser
from tests.pixels.pixel_terminal import ANSWERS, PixelTerminal
from tests.support.folded import folded


def asked(kind: str, environ: dict[str, str] | None = None) -> Inquiry:
    """The inquiry after a terminal's answers."""
    inquiry, terminal, parser = Inquiry(environ or {}, (80, 24)), PixelTerminal(kind, 80, 24), KeyboardParser()
    question = FIRST
    while question:
        messages = list(parser.feed(terminal.feed(question)))
        assert all(isinstance(message, Answered) for message in messages)
        question = "".join(inquiry.take(message.text) for message in messages if isinstance(message, Answered))
    return inquiry


@pytest.mark.parametrize(
    ("kind", "ability"),
    [
        ("kitty", Ability(KITTY, (10, 20))),
        ("sixel", Ability(SIXEL, (10, 20))),
        ("iterm", Ability(ITERM, (10, 20))),
        ("plain", None),
    ],
)
def test_each_terminal_gets_the_pictures_that_it_can_show(kind: str, ability: Ability | None) -> None:
    inquiry = asked(kind)
    assert inquiry.done and inquiry.ability == ability


def test_a_terminal_without_a_name_is_never_asked_for_kittys_graphics() -> None:
    inquiry = Inquiry({}, (80, 24))
    assert inquiry.take("\x1b[?62;4c") == "" and inquiry.done


def test_sixel_without_a_known_cell_is_not_used() -> None:
    inquiry = Inquiry({}, (80, 24))
    inquiry.take("\x1b[?62;4c")
    assert inquiry.ability is None
    inquiry.pixels = (800, 480)
    assert inquiry.ability == Ability(SIXEL, (10, 20))


def test_in_a_browser_a_cell_is_no_whole_number_of_pixels() -> None:
    answers = ("\x1b[6;16;8t", "\x1b[4;480;1011t")
    for attributes, exact in (("62;4;9;22", (8.425, 16.0)), ("62;1;4;6;22", None)):
        inquiry = Inquiry({}, (120, 30))
        for answer in (*answers, f"\x1b[?{attributes}c"):
            inquiry.take(answer)
        assert inquiry.ability == Ability(SIXEL, (8, 16), exact)


def test_the_text_area_gives_the_cell_where_the_cell_is_not_told() -> None:
    inquiry = Inquiry({}, (80, 24))
    for answer in ("\x1b[4;432;720t", "\x1b[?62;4c"):
        inquiry.take(answer)
    assert inquiry.ability == Ability(SIXEL, (9, 18))


@pytest.mark.parametrize(
    "environ", [{"TERM": "linux"}, {"TERM": "tmux-256color"}, {"TERM": "xterm", "TMUX": "/tmp/x"}, {"TERM": "dumb"}, {}]
)
def test_questions_that_would_be_printed_are_not_put(environ: dict[str, str]) -> None:
    assert not may_be_asked(environ)
    assert may_be_asked({"TERM": "xterm-256color"})


TALK = "a" + ANSWERS["kitty"][">0q"] + "b\x1b[6;20;10t\x1b[A\x1b[?62;1;2;4;6;9;15;16;17;18;21;22;28;29cc"
TALK += "\x1b_Gi=31;OK\x1b\\\x1b[0nd"


def keys_of(messages: list[object]) -> list[str]:
    return [message.key for message in messages if isinstance(message, events.Key)]


@folded("cut", range(1, len(TALK)))
def test_no_answer_is_typed_wherever_reading_cuts_it(cut: int) -> None:
    parser, messages = KeyboardParser(), []
    for part in (TALK[:cut], TALK[cut:]):
        messages += [*parser.feed(part)]
    assert keys_of(messages) == ["a", "b", "up", "c", "d"]
    assert sum(isinstance(message, Answered) for message in messages) == 5


def test_an_answer_whose_end_is_lost_is_no_key(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [100.0]
    monkeypatch.setattr(keyboard, "get_time", lambda: now[0])
    parser = KeyboardParser()
    messages = list(parser.feed("a\x1b_Gi=31;O"))
    for _ in range(4):
        now[0] += 0.5
        messages += parser.tick()
    messages += parser.feed("b")
    assert keys_of(messages) == ["a", "b"]


@pytest.mark.parametrize(("bytes_", "key"), [("\x1b", "escape"), ("\x1b_", "alt+underscore"), ("\x1bP", "alt+shift+p")])
def test_keys_that_begin_like_an_answer_are_keys_after_a_moment(
    monkeypatch: pytest.MonkeyPatch, bytes_: str, key: str
) -> None:
    now = [100.0]
    monkeypatch.setattr(keyboard, "get_time", lambda: now[0])
    parser = KeyboardParser()
    messages = list(parser.feed(bytes_))
    now[0] += 0.3
    messages += parser.tick()
    assert keys_of(messages) == [key]


def test_random_cuts_lose_no_key() -> None:
    chance = random.Random(5)
    for _ in range(200):
        parser, messages, rest = KeyboardParser(), [], TALK * 3
        while rest:
            size = chance.randint(1, 30)
            messages += [*parser.feed(rest[:size])]
            rest = rest[size:]
        assert keys_of(messages) == ["a", "b", "up", "c", "d"] * 3
