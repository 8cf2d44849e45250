"""What others wrote reaches a terminal as text, and pipes and files as it is."""

from __future__ import annotations

import io
import os
from pathlib import Path

import pytest

from day6_core.session import harmless
from day6_core.session.real_streams import RealOutput

HARMLESS = [
    "plain ASCII [bold]markup[/bold] [@click=app.quit]x[/]",
    "小车 のロボット 로봇",
    "e\u0301 \u0928\u093f \u0e01\u0e33",  # accents, Devanagari, Thai
    "می\u200cخواهم",  # Persian needs the joiner
    "\U0001f468\u200d\U0001f469\u200d\U0001f467 ❤\ufe0f",  # a family, a heart in colour
    "\ue0b0\U000f0001",  # icons of fonts
    "\xa0\u3000",  # blanks
]
WRITTEN = [
    ("\x1b]0;T\x07", "^[]0;T^G"),
    ("\x7f\x00", "^?^@"),
    ("\x9b31m", "\\x9b31m"),
    ("a\u202eb\u2066\u200f\u061c", "a\\u202eb\\u2066\\u200f\\u061c"),
    ("a\u2028b\u2029", "a\\u2028b\\u2029"),
    ("\u200b\ufeff\xad", "\\u200b\\ufeff\\xad"),
    ("\U000e0041\U0010eeee", "\\U000e0041\\U0010eeee"),
    ("\uffff\ufdd0\U0001fffe", "\\uffff\\ufdd0\\U0001fffe"),
    ("\udcff", "\\xff"),
    ("\ud800", "\\ud800"),
]


@pytest.mark.parametrize("text", HARMLESS)
def test_what_people_write_stays_as_it_is(text: str) -> None:
    assert harmless.one_line(text) == harmless.lines(text) == text
    assert harmless.same_length(text, pictures=True) == text


@pytest.mark.parametrize(("text", "written"), WRITTEN)
def test_what_is_no_text_is_written_out(text: str, written: str) -> None:
    assert harmless.one_line(text) == harmless.lines(text) == written
    for pictures in (True, False):
        shown = harmless.same_length(text, pictures=pictures)
        assert len(shown) == len(text) and harmless.one_line(shown) == shown


def test_only_lines_have_newlines_tabs_and_colours() -> None:
    text = "a\tb\r\nc\n\x1b[01;31mred\x1b[0m\x1b[K\rd"
    assert harmless.lines(text) == "a\tb\r\nc\n\x1b[01;31mred\x1b[0m^[[K^Md"
    assert harmless.one_line("a\tb\nc\x1b[m") == "a^Ib^Jc^[[m"


def test_a_colour_that_is_none_is_written_out() -> None:
    assert harmless.lines("\x1b[" + "1" * 65 + "m") == "^[[" + "1" * 65 + "m"
    assert harmless.lines("\x1b[?25m") == "^[[?25m"


def test_one_written_harmless_is_harmless_the_second_time() -> None:
    everything = "".join(
        map(chr, [*range(0x300), *range(0x2000, 0x2100), *range(0xD7F0, 0xE010), *range(0xFD00, 0x10000)])
    )
    once = harmless.one_line(everything)
    assert harmless.one_line(once) == once
    once.encode("utf-8")


class _Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_terminal_gets_harmless_text_and_our_own_sequences() -> None:
    file = _Terminal()
    output = RealOutput(file)
    assert output.write("\x1b]0;T\x07\n") == len("\x1b]0;T\x07\n")
    output.control("\x1b[H\x1b[2J")
    assert file.getvalue() == "^[]0;T^G\n\x1b[H\x1b[2J"


@pytest.mark.skipif(os.name != "posix", reason="no bytes stand for names there")
def test_a_file_gets_every_byte(tmp_path: Path) -> None:
    name = b"a\xff\x1b]0;T\x07\xc2\x9b"
    with (tmp_path / "out").open("w", encoding="utf-8") as file:
        output = RealOutput(file)
        output.write(os.fsdecode(name) + "\ud800")
        output.control("\x1b[H")
    assert (tmp_path / "out").read_bytes() == name + b"?\x1b[H"


def test_a_file_in_a_poor_encoding_gets_question_marks_and_no_error(tmp_path: Path) -> None:
    with (tmp_path / "out").open("w", encoding="ascii") as file:
        RealOutput(file).write("小\udcff")
    assert (tmp_path / "out").read_bytes() == b"?\xff"


@pytest.mark.parametrize(
    ("term", "written"), [("dumb", "red ^[c plain\n"), ("xterm", "\x1b[01;31mred\x1b[0m ^[c plain\n")]
)
def test_a_terminal_without_colours_gets_none(monkeypatch: pytest.MonkeyPatch, term: str, written: str) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setenv("TERM", term)
    file = Terminal()
    output = RealOutput(file)
    output.write("\x1b[01;31mred\x1b[0m \x1bc plain\n")
    output.control("\x1b[7m\x1b[H")
    assert file.getvalue() == written + ("\x1b[H" if term == "dumb" else "\x1b[7m\x1b[H")
