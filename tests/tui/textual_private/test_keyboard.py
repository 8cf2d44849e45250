"""What a terminal sends, cut wherever reading cuts it."""

from __future__ import annotations

import random
import time
from collections.abc import Callable

import pytest
from textual import events

from day6_tui.textual_private import keyboard
from day6_tui.textual_private.keyboard import InputDecoder, KeyboardParser


@pytest.fixture
def now(monkeypatch: pytest.MonkeyPatch) -> Callable[[float], None]:
    """Moves the parser's clock on."""
    at = [100.0]
    monkeypatch.setattr(keyboard, "get_time", lambda: at[0])

    def move(seconds: float) -> None:
        at[0] += seconds

    return move


def told(parser: KeyboardParser, text: str) -> list[str]:
    """Keys by their names, pastes as their text."""
    return [
        event.key if isinstance(event, events.Key) else f"paste:{event.text}"
        for event in (*parser.feed(text), *parser.tick())
        if isinstance(event, (events.Key, events.Paste))
    ]


def test_a_paste_is_one_event_however_it_is_cut(now: Callable[[float], None]) -> None:
    text = "a\x1b[200~one\rtwo\x1b[20x\x1b[201~b\x1b[A"
    for cut in range(len(text)):
        parser = KeyboardParser()
        seen = [*told(parser, text[:cut]), *told(parser, text[cut:])] if cut else told(parser, text)
        assert seen == ["a", "paste:one\rtwo\x1b[20x", "b", "up"], cut


def test_a_megabyte_is_parsed_in_a_moment() -> None:
    began = time.process_time()
    assert len(told(KeyboardParser(), "\x1b[200~" + "x" * 1_000_000 + "\x1b[201~")[0]) == 1_000_006
    assert time.process_time() - began < 0.5  # character by character it took longer


def test_a_paste_whose_end_was_lost_does_not_keep_the_keyboard(now: Callable[[float], None]) -> None:
    parser = KeyboardParser()
    assert told(parser, "\x1b[200~text") == []
    now(2.0)
    assert told(parser, "\x03") == ["paste:text", "ctrl+c"]
    assert told(parser, "a") == ["a"]


def test_the_beginning_of_a_mark_that_nothing_follows_is_a_key(now: Callable[[float], None]) -> None:
    parser = KeyboardParser()
    assert told(parser, "\x1b[") == []
    now(0.2)
    assert [event.key for event in parser.tick() if isinstance(event, events.Key)] == ["alt+left_square_bracket"]
    assert told(parser, "\x1b") == []
    now(0.2)
    assert [event.key for event in parser.tick() if isinstance(event, events.Key)] == ["escape"]


def test_a_control_sequence_longer_than_any_is_not_typed() -> None:
    parser = KeyboardParser()
    assert told(parser, "a\x1b[" + "1;" * 500) == ["a"]
    assert told(parser, "3;" * 500 + "mb") == ["b"]


def test_nothing_a_terminal_sends_breaks_the_parser() -> None:
    chosen = random.Random(4)
    pieces = [
        "\x1b",
        "[",
        "<",
        "0;",
        "9" * 12,
        "-1",
        ";",
        "u",
        "~",
        "M",
        "m",
        "t",
        "R",
        "$y",
        "48",
        "?",
        ":",
        "\ufffd",
        "a",
    ]
    for _ in range(3000):
        parser = KeyboardParser()
        list(parser.feed("\x1b[48;24;80;0;0t"))  # a window of no pixels, in which a mouse is nowhere
        list(parser.feed("".join(chosen.choices(pieces, k=chosen.randint(1, 30)))))
        list(parser.tick())


@pytest.mark.parametrize(
    ("data", "text", "fault"),
    [
        ("né 中文 🐢".encode(), "né 中文 🐢", ""),
        ("ls 中文".encode("gbk") + b"\n", "ls \ufffd\ufffd\ufffd\ufffd\n", "gbk"),
        (b"n\xe9x", "n\ufffdx", "other"),
        (b"\xe1b", "\ufffdb", "other"),
        (b"\xff", "\ufffd", "other"),
    ],
)
def test_what_is_not_utf_8_is_replaced_and_judged(data: bytes, text: str, fault: str) -> None:
    decoder = InputDecoder()
    assert (decoder.decode(data), decoder.fault) == (text, fault)


def test_a_character_cut_in_two_is_no_fault() -> None:
    decoder = InputDecoder()
    assert [(decoder.decode(bytes([byte])), decoder.fault) for byte in "中".encode()] == [
        ("", ""),
        ("", ""),
        ("中", ""),
    ]


@pytest.mark.parametrize(
    ("data", "key"),
    [
        ("\x1b3", "alt+3"),
        ("\x1b-", "alt+minus"),
        ("\x1b\\", "alt+backslash"),
        ("\x1b.", "alt+full_stop"),
        ("\x1bx", "alt+x"),
        ("\x1b[1;3A", "alt+up"),
        ("\x1b[1;4C", "alt+shift+right"),
        ("\x1b", "escape"),
    ],
)
def test_alt_is_alt_with_every_key(monkeypatch, data: str, key: str) -> None:
    monkeypatch.setattr("textual.constants.ESCAPE_DELAY", -1.0)
    parser = KeyboardParser()
    assert [event.key for event in (*parser.feed(data), *parser.tick())] == [key]
