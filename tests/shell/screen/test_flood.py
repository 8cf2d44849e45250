"""What scrolls by fast looks exactly as if every character had been drawn, and no output can hold the screen up."""

from __future__ import annotations

import re
from random import Random
from time import process_time
from typing import Any
from unittest.mock import patch

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from day6_core.session.harmless import for_emulation
from day6_core.shell.screen import screen as screen_module
from day6_core.shell.screen import text as text_module
from day6_core.shell.screen import whole_lines
from day6_core.shell.screen.rows import Folded
from day6_core.shell.screen.screen import Screen
from day6_core.shell.screen.vt import LINE_DRAWING
from day6_core.width import char_width

WORDS = ["a", " ", "  ", "hello", "x" * 7, "word " * 5, "y" * 33, "z" * 130, "é", "\xa0", "\ufffd", "\u3000"]
CHINESE = ["你", "你好", "机器人操作系统", "a你b好", "温度" * 20, "，", "한글", "🙂"]
MARKS = ["e\u0301", "\u0301", "你\u0301", "a\u200bb", "\u200d", "\ufeff"]
ENDS = ["\r\n", "\r\n", "\r\n", "\n", "\r", "\r\r\n", "\t", "\t\t", "\b", "\x07", "\x00", "\x0b"]
COLOURS = ["\x1b[m", "\x1b[0m", "\x1b[31m", "\x1b[1;44m", "\x1b[7m", "\x1b[38;5;9m", "\x1b[48;2;1;2;3m", "\x1b[K"]
MOVES = [
    *(
        "\x1b[H",
        "\x1b[2J",
        "\x1b[3;2H",
        "\x1b[A",
        "\x1b[2B",
        "\x1b[C",
        "\x1b[3D",
        "\x1b[1K",
        "\x1b[2K",
        "\x1b[J",
        "\x1b[99B",
    ),
    *("\x1b[2P", "\x1b[2@", "\x1b[2X", "\x1b[L", "\x1b[2M", "\x1b[5G", "\x1b[3J", "\x1b7", "\x1b8", "\x1bM", "\x1bD"),
]
MODES = [
    *(
        "\x1b[2;5r",
        "\x1b[r",
        "\x1b[4h",
        "\x1b[4l",
        "\x1b[?7l",
        "\x1b[?7h",
        "\x1b[20h",
        "\x1b[20l",
        "\x1b[?6h",
        "\x1b[?6l",
    ),
    *(
        "\x1b[?1049h",
        "\x1b[?1049l",
        "\x1bH",
        "\x1b[g",
        "\x1b[3g",
        "\x1bc",
        "\x1b[?25l",
        "\x1b]0;t\x07",
    ),
]
LINES = [
    "line\r\n" * 9,
    "\x1b[33m[WARN] \x1b[0mtext\r\n" * 5,
    "a\tb\r\n" * 4,
    "\x1b[1m\x1b[Kgrep\x1b[m\x1b[K\r\n" * 3,
    "\r\n" * 6,
]

printed = st.sampled_from(WORDS + CHINESE + ENDS + COLOURS + LINES + LINES)
anything = st.sampled_from(WORDS + CHINESE + MARKS + ENDS + COLOURS + MOVES + MODES + LINES)
texts = st.one_of(st.lists(printed, max_size=60), st.lists(anything, max_size=60)).map("".join)
sizes = st.tuples(st.integers(1, 12), st.sampled_from([1, 2, 3, 8, 10, 16, 17, 40, 80]))


class DrawnScreen(Screen):
    """A screen without fast ways: fed character by character, every one drawn by itself, every line scrolled when it is full."""

    def feed(self, text: str, until: float = 0.0) -> str:
        for char in for_emulation(text):
            self._parser.feed(char)
        return ""

    def rush(self, text: str, start: int) -> int:
        return start

    def draw(self, data: str) -> None:
        self._last_drawn = data[-1:]
        self._draw_slowly(data.translate(LINE_DRAWING) if self.line_drawing else data)

    def index(self) -> None:
        super().index()
        self._settle()


def picture(screen: Screen) -> dict[str, Any]:
    """Everything that can be seen of a screen, and where it goes on."""
    cells = [[screen.buffer[y].get(x, screen.blank) for x in range(screen.columns)] for y in range(screen.lines)]
    return {
        "cells": cells,
        "rows": [screen.row(y) for y in range(screen.lines)],
        "folded": [isinstance(row, Folded) for row in (*screen.scrollback, *map(screen.row, range(screen.lines)))],
        "scrollback": list(screen.scrollback),
        "scrolled": screen.scrolled,
        "cursor": (screen.cursor.x, screen.cursor.y, screen.cursor.attrs, screen.cursor.hidden),
        "mode": screen.mode,
        "margins": screen.margins,
        "tabs": screen.tabstops,
        "alternate": screen.alternate,
    }


@pytest.mark.long
@given(
    st.lists(st.tuples(texts, st.none() | sizes), min_size=1, max_size=4),
    sizes,
    st.sampled_from([0, 4, text_module.MOST_ARRIVING]),
    st.randoms(use_true_random=False),
)
# A tab skips the cells before the fold, inserting takes the last one of a folded row, another width cuts it off.
@example([("aaaaaaaaaaaaaaaaa\t aaa\u3000\u3000\x1b[A\u3000", None)], (2, 8), 512, Random(0))
@example([("\x1b[99;99H 你\x1b[A\u3000\x1b[99C\x1b[@", None)], (4, 10), 512, Random(0))
@example([("\x1b[?1049h\x1b[99;99Ha\u3000", (5, 8))], (6, 10), 512, Random(0))
@settings(max_examples=400, deadline=None)
def test_a_flood_leaves_the_same_picture_as_drawing_every_character(
    parts: Any, size: Any, most: int, random: Any
) -> None:
    lines, columns = size
    fast, drawn = Screen(columns, lines), DrawnScreen(columns, lines)
    for text, other in parts:
        at = 0
        while at < len(text):
            end = at + random.choice([1, 3, 20, 200, 5000])
            with patch.object(screen_module, "MOST_ARRIVING", most):
                fast.feed(text[at:end])
            if random.random() < 0.2:
                assert fast.row(0) is not None  # looking in between changes nothing
            at = end
        drawn.feed(text)
        assert picture(fast) == picture(drawn)
        if other is not None:
            fast.resize(*other)
            drawn.resize(*other)
            assert picture(fast) == picture(drawn)


NOISE = [bytes([code]) for code in (*range(0x20), 0x20, 0x7F, *b"\x1b\x1b\x1b\b\t\r\r\n\n")]
NOISE += [f"\x1b{final}".encode() for final in "0<=>ABDEFGHMNOZ\\acjl78~]P#%(é\x84"]
NOISE += [
    text.encode()
    for text in ("text", "long " * 9, "é", "Ж" * 7, "你", "温度" * 6, "e\u0301", "\u0301", "🙂", "ก็", "\xa0")
]
NOISE += [
    text.encode() for text in ("\x84", "\x85", "\x88", "\x8d", "\x9b3m", "\x1b[4h", "\x1b[4l", "\x1b[20h", "\x1b[20l")
]
NOISE += [
    b"\r\n",
    b"\xff",
    b"\xe4\xbd",
    b"\x80" * 9,
    b"\x1b[m",
    b"\x1b[31m",
    b"line\r\n" * 4,
    b"\x18",
    b"\x07",
]


class LiteralScreen(DrawnScreen):
    """A screen that also gets the control characters that mean nothing."""

    def feed(self, text: str, until: float = 0.0) -> str:
        for char in text:
            self._parser.feed(char if char <= "\x7f" else for_emulation(char))
        return ""


@pytest.mark.parametrize("seed", range(24))
def test_noise_leaves_the_same_picture_as_drawing_every_character(seed: int) -> None:
    random = Random(seed)
    size = random.choice([2, 3, 8, 17, 40]), random.choice([1, 2, 3, 7])
    noise = random.randbytes(600) if seed % 3 == 0 else b"".join(random.choices(NOISE, k=200))
    text = noise.decode("utf-8", "replace")
    fast, drawn = Screen(*size), LiteralScreen(*size)
    while text:
        end = random.choice([1, 2, 3, 20, 100, 999])
        fast.feed(text[:end])
        if random.random() < 0.3:
            drawn.feed(text[:end])
            assert picture(fast) == picture(drawn)
        else:
            drawn.feed(text[:end])
        text = text[end:]
    assert picture(fast) == picture(drawn)
    fast.resize(5, 13)
    drawn.resize(5, 13)
    assert picture(fast) == picture(drawn)


@pytest.mark.parametrize("text", ["text", "\tx", "你", "a你\a", "e\u0301", "🙂", "\ra\b", "é\x1b>"])
def test_the_last_of_running_text_can_be_repeated(text: str) -> None:
    fast, drawn = Screen(9, 2), DrawnScreen(9, 2)
    for screen in (fast, drawn):
        screen.feed(f"\nold{text}\x1b[3b")
    assert picture(fast) == picture(drawn)


@pytest.mark.long
@given(
    st.lists(st.sampled_from(NOISE) | st.binary(max_size=20), max_size=120).map(b"".join), sizes, st.integers(1, 300)
)
@settings(max_examples=300, deadline=None)
def test_any_noise_cut_anywhere_leaves_the_same_picture(noise: bytes, size: Any, cut: int) -> None:
    text = noise.decode("utf-8", "replace")
    lines, columns = size
    fast, drawn = Screen(columns, lines), LiteralScreen(columns, lines)
    for at in range(0, len(text), cut):
        fast.feed(text[at : at + cut])
    drawn.feed(text)
    assert picture(fast) == picture(drawn)


def test_a_row_keeps_the_blanks_before_a_wide_character_that_did_not_fit() -> None:
    for written in ("a\t你", "a\x1b[8G你", "\r\nb\x1b[Ha\t你"):
        screen = Screen(8, 3)
        screen.feed(written)
        screen.resize(3, 20)
        assert screen.text.split("\n")[0] == "a      你"


def test_deleting_a_line_above_an_empty_one_removes_it() -> None:
    screen = Screen(8, 4)
    screen.feed("one\r\n\r\nthree\x1b[H\x1b[M")
    assert screen.text == "\nthree"


@pytest.mark.parametrize("columns", [1, 2, 5, 80])
@pytest.mark.parametrize(
    "text",
    [
        "x" * 4321 + "\r\n$ ",
        "温度a" * 987 + "\r\n",
        "y\r\n" * 999,
        "\x1b[31m" + "red " * 777 + "\x1b[0m\r\n" * 3,
        "12345678\r\n" * 300,
    ],
)
def test_more_than_the_scrollback_holds_leaves_the_same_end(
    monkeypatch: pytest.MonkeyPatch, columns: int, text: str
) -> None:
    monkeypatch.setattr(text_module, "SCROLLBACK", 50)
    fast, drawn = Screen(columns, 6), DrawnScreen(columns, 6)
    fast.feed(text)
    drawn.feed(text)
    assert picture(fast) == picture(drawn)
    assert len(fast.scrollback) == 50 or len(text) // columns < 60 or text.startswith("1")


def shown(*parts: str) -> str:
    """The first lines of a screen after a program wrote these parts one after the other."""
    screen = Screen(40, 5)
    for part in parts:
        screen.feed(part)
    return screen.text


@pytest.mark.parametrize(
    ("written", "seen"),
    [
        ("a\x7fb\x00c\x01d", "abcd"),  # DEL and the controls that mean nothing
        ("a\x1b\x00[3\x011\x7fmb", "ab"),  # inside a sequence, too
        ("a\x9b31mb", "ab"),  # C1: CSI
        ("a\x9d0;title\x9cb", "ab"),  # C1: OSC … ST
        ("a\x1bPq#0;2;0;0;0\x1b\\b", "ab"),  # DCS (a sixel picture)
        ("a\x1b_Gf=100;AAAA\x1b\\b\x1b^pm\x1b\\\x1bXsos\x1b\\c", "abc"),  # APC, PM, SOS
        ("a\x1b[31\x18b", "ab"),  # CAN ends a sequence
        ("a\x1b]0;title\x1ab", "ab"),  # SUB ends a string
        ("a\x1bPnever ended\x1b[1mb", "ab"),  # ESC too, and begins another
        ("a\x1b[3\x1b[4mb", "ab"),
        ("a\x1b[1\r;1\nmb", "a\nb"),  # controls inside a sequence are obeyed
        ("a\x1b[99999999999999999999Cb".replace("C", "m"), "ab"),
        ("a\x1b[" + "1;" * 5000 + "mb", "ab"),
        ("a\x1b[?2026$pb\x1b[2 qc\x1b[!pd\x1b[>4;2me", "abcde"),  # sequences that are not ours
        ("a\x1b[4:3mb\x1b[38:2::1:2:3mc", "abc"),  # the colours of ITU T.416
        ("a\x1b)0b\x1b(Bc\x1b%Gd", "abcd"),
        ("a\x1b[<5mb", "ab"),
        ("one\x85two", "one\ntwo"),  # C1: NEL
        ("one\x1bEtwo", "one\ntwo"),
    ],
)
def test_odd_sequences_are_read_as_xterm_reads_them_however_they_are_cut(written: str, seen: str) -> None:
    assert shown(written) == seen
    assert shown(*written) == seen


def test_the_echo_of_ctrl_c_behind_half_a_sequence_hides_no_more_than_its_line() -> None:
    """At Ctrl-C a kernel throws away what a program has written and nobody has read: the end of a colour, for instance."""
    for half in ("a\x1b", "a\x1bX"):
        written = f"{half}^Cb\r\nKeyboardInterrupt\r\n$ "
        assert shown(written) == shown(*written) == "a\nKeyboardInterrupt\n$"


def test_what_never_ends_is_bounded_and_the_next_prompt_ends_it() -> None:
    for beginning in ("\x1b]0;", "\x1bP", "\x1b_", "\x1b[", "\x1b[1 "):
        screen = Screen(40, 5)
        for _ in range(50):
            screen.feed(beginning + "1" * 100_000)
        parser = screen._parser
        assert len(parser._rest) + sum(map(len, parser._kept)) < 5000
        screen.feed("\x1b[32mpupil$ \x1b[0m")
        assert screen.text.endswith("pupil$")


def test_a_program_that_saves_the_cursor_all_the_time_takes_no_memory() -> None:
    screen = Screen(40, 5)
    screen.feed("\x1b[3;4H\x1b7" * 1000 + "\x1b[H\x1b8\x1b8here")
    assert screen.saved is not None
    assert screen.text == "\n\n   here"


def test_colours_in_groups_are_what_the_older_way_says() -> None:
    screen = Screen(40, 3)
    screen.feed("\x1b[38:2::1:2:3ma\x1b[38;5;1mb\x1b[38:5:1mc\x1b[0;4:3md\x1b[4:0me")
    looks = [(text, style.fg, style.underscore) for text, style in screen.row(0)]
    assert looks == [
        ("a", "010203", False),
        ("bc", looks[1][1], False),
        ("d", "default", True),
        ("e", "default", False),
    ]


def test_a_command_substitution_keeps_all_of_ten_megabytes(machine: Any) -> None:
    text = "x" * 999 + "\n"
    (machine.desk.home / "big.txt").write_text(text * 10_000, encoding="utf-8", newline="")
    assert machine.run("x=$(cat big.txt); echo ${#x}").out == "9999999\n"


def test_a_command_substitution_without_end_is_ended_and_says_so(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("day6_core.session.streams.CAPTURE_LIMIT", 100_000)
    result = machine.run("x=$(seq 1000000); echo ${#x}")
    assert result.out.strip().isdigit() and 90_000 < int(result.out) <= 100_000
    assert "command substitution" in result.err and "Traceback" not in result.err


def test_a_long_line_that_begins_above_overwrites_what_stands_in_the_last_line() -> None:
    screen = Screen(2, 2)
    screen.feed("\r\n a\x1b[Hhello")
    assert screen.text == "ll\no"


FLOODS = {
    "lines": "y" * 78 + "\r\n",
    "one line": "x" * 80,
    "chinese": "机器人操作系统" * 5 + "\r\n",
    "colours": "\x1b[33m[WARN] [1.2] [talker]: Publishing: 'Hello'\x1b[0m\r\n",
    "moves": "\x1b[2;3Habc\x1b[1A\x1b[4Pdef\r\n",
    "grep": "abc \x1b[01;31m\x1b[Kmatch\x1b[m\x1b[K rest\r\n",
    "progress": "\r50% [====    ]",
    "returns": "a\rb\r\n",
    "never ended": "\x1b]0;" + "t" * 76,
    "parameters": "1;" * 40,
    "marks": "e\u0301" * 40,
    "binary": "\x00\x01\x08abc\ufffd\ufffd\x1b\x02\x9b\x7f\x1a",
}


def seconds_for(text: str) -> float:
    """The CPU time to show a text that comes in pieces; the best of three."""
    best = 1e9
    for _ in range(3):
        screen = Screen(100, 30)
        screen.feed("\x1b[" if text.startswith("1;") else "")
        began = process_time()
        for at in range(0, len(text), 16384):
            screen.feed(text[at : at + 16384])
        best = min(best, process_time() - began)
    return best


@pytest.mark.long
@pytest.mark.parametrize("kind", FLOODS)
def test_eight_times_as_much_output_takes_eight_times_as_long(kind: str) -> None:
    piece = FLOODS[kind]
    short = piece * (8_000 // len(piece))
    assert seconds_for(short * 8) < 40 * seconds_for(short) + 0.05


def test_characters_taken_for_one_cell_or_for_no_mark_are_that() -> None:
    every = [chr(code) for code in range(32, 0x20000) if not 0xD800 <= code < 0xE000]
    narrow = [char for char in every if not whole_lines.NOT_NARROW.search(char)]
    common = [char for char in every if not whole_lines.NOT_COMMON.search(char)]
    assert len(narrow) > 1000 and {char_width(char) for char in narrow} == {1}
    assert len(common) > 30_000 and {char_width(char) for char in common} == {1, 2}
    wide = [char for char in every if re.match(f"[{whole_lines.WIDE}]", char)]
    assert len(wide) > 30_000 and {char_width(char) for char in wide} == {2}


def test_a_single_line_of_a_megabyte_scrolls_by_like_lines_do() -> None:
    lines, line = "x" * 78 + "\r\n", "x" * 80
    assert seconds_for(line * 5_000) < 6 * seconds_for(lines * 5_000) + 0.05


def test_looking_at_a_part_of_a_flood_stops_when_the_time_is_over() -> None:
    screen = Screen(80, 24)
    text = "\x1b[2J\x1b[Hframe" * 1000
    rest = screen.feed(text, until=0.0)
    assert 0 < len(text) - len(rest) < 100
    while rest:
        rest = screen.feed(rest, until=0.0)
    assert screen.text == "frame"


@given(st.lists(st.binary(max_size=30) | st.sampled_from([b"\x1b[", b"\x1b]", b"\x9b", b"\x1bP", b"\x18", b"99999"])))
@settings(max_examples=300, deadline=None)
def test_no_bytes_break_the_screen(parts: list[bytes]) -> None:
    text = b"".join(parts).decode("utf-8", "replace")
    screen = Screen(20, 4)
    screen.feed(text)
    screen.feed("\x18\x1b\\\x1bcalive")
    assert screen.text == "alive"


@pytest.mark.parametrize("style", ["31", "1", "4;7", "44", "1;4;42"])
@pytest.mark.parametrize("line", ["\x1b[K", "grep\x1b[K", "a\x1b[K\tb", "\x1b[K\r", "中文\x1b[K", "\tx\x1b[m\x1b[K"])
def test_an_erased_end_of_a_line_that_scrolls_by_has_the_background_alone(style: str, line: str) -> None:
    text = f"\x1b[{style}m" + f"{line}\r\n" * 9
    fast, drawn = Screen(12, 3), DrawnScreen(12, 3)
    fast.feed(text)
    drawn.feed(text)
    assert picture(fast) == picture(drawn)


@pytest.mark.parametrize("text", ["\x1b[K\r\n\r\n", "\x1b[Kb\r\n", "\x1b[1m\x1b[K\r\nb\r\n", "b\x1b[K\r\n"])
@pytest.mark.parametrize("lines", [1, 2, 5])
def test_an_erased_line_ends_the_one_that_went_on_in_it(text: str, lines: int) -> None:
    fast, drawn = Screen(3, lines), DrawnScreen(3, lines)
    for screen in (fast, drawn):
        screen.feed("\r\n" * (lines - 1) + "aa")
        screen.resize(lines, 2)
        screen.feed(text)
    assert picture(fast) == picture(drawn)
