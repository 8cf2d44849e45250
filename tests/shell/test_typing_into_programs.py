"""Keys typed to a program that reads lines: what the terminal shows and what the program gets, as a kernel's terminal does it."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.shell import terminal as terminal_module
from day6_core.shell.line import discipline as discipline_module
from day6_core.shell.terminal import LONGEST_END
from tests.shell.conftest import show_all

PROMPT = "student@day6:~$"


@pytest.mark.parametrize(
    ("keys", "shown", "read"),
    [
        ("abc\r", ["abc"], "abc\n"),
        ("abc\n", ["abc"], "abc\n"),
        ("abx\x7fc\r", ["abc"], "abc\n"),
        ("abx\bc\r", ["abc"], "abc\n"),
        ("\x7f\x7fa\r", ["a"], "a\n"),
        ("你好\x7fx\r", ["你x"], "你x\n"),
        ("a\x01b\r", ["a^Ab"], "a\x01b\n"),
        ("a\x01\x7fb\r", ["ab"], "ab\n"),
        ("one two\x17x\r", ["one x"], "one x\n"),
        ("one two  \x17x\r", ["one x"], "one x\n"),
        ("one\x17x\r", ["x"], "x\n"),
        ("one two\x15x\r", ["x"], "x\n"),
        ("a\tb\r", ["a       b"], "a\tb\n"),
        ("\x1b[A\r", ["^[[A"], "\x1b[A\n"),
        ("a\r\rb\r", ["a", "", "b"], "a\n\nb\n"),
        ("no end\x04", ["no end"], "no end"),
    ],
)
def test_a_line_can_be_edited_before_enter(seat: Any, keys: str, shown: list[str], read: str) -> None:
    seat.line("clear")
    seat.line("cat > f")
    assert seat.type(keys).splitlines()[1 : 1 + len(shown)] == shown
    seat.type("\x04")
    assert (seat.desk.home / "f").read_text(encoding="utf-8") == read


def test_ctrl_d_behind_text_hands_it_over_and_ctrl_d_alone_ends_the_input(seat: Any) -> None:
    seat.line("cat")
    assert seat.type("ab\x04").endswith("\nabab")
    assert seat.terminal.busy
    seat.type("\x04")
    assert not seat.terminal.busy


def test_ctrl_c_drops_what_was_typed_ahead(seat: Any) -> None:
    seat.line("sleep 50")
    seat.type("echo never\rhalf a line")
    assert seat.type("\x03").splitlines()[-2:] == ["half a line^C", PROMPT]
    assert "never\nnever" not in seat.look()


def test_what_was_typed_ahead_can_still_be_edited_at_the_prompt(seat: Any) -> None:
    seat.line("sleep 5")
    seat.type("echo ax")
    seat.settle(6)
    assert seat.type("\x7fb\r").splitlines()[-2:] == ["ab", PROMPT]


def test_more_than_the_terminal_holds_is_refused_with_a_beep(seat: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(discipline_module, "MOST_TYPED_AHEAD", 10)
    seat.line("sleep 5")
    seat.type("12345678901")
    seat.type("more")
    seat.settle(6)
    assert seat.look().splitlines()[-1] == f"{PROMPT} 12345678901"


def test_a_program_that_does_not_end_after_three_ctrl_c_is_stubborn(seat: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    async def deaf(session: Any) -> int:
        session.on_interrupt = lambda: True
        await session.sleep(100)
        return 0

    from day6_core.shell.builtins import programs

    monkeypatch.setattr(programs, "ros_program", deaf)
    seat.line("rqt_graph")
    for times in range(3):
        assert not seat.terminal.is_stubborn, times
        seat.type("\x03")
    assert seat.terminal.is_stubborn
    seat.settle(200)
    assert not seat.terminal.is_stubborn


def test_a_terminal_is_idle_only_when_its_prompt_waits_with_nothing_typed(seat: Any) -> None:
    terminal = seat.terminal
    assert terminal.idle and not terminal.busy and not terminal.reading_keys
    seat.type("e")
    assert not terminal.idle
    seat.type("\x7f")
    assert terminal.idle
    seat.line("sleep 5")
    assert not terminal.idle and terminal.busy and terminal.title == "sleep 5"
    seat.settle(6)
    assert terminal.idle
    terminal.send("x")
    assert not terminal.idle  # it has not arrived yet
    seat.settle()
    seat.type("\x7f")
    seat.line("exit")
    assert terminal.closed and not terminal.idle


@pytest.mark.parametrize(
    ("pasted", "typed"),
    [("a\nb", "a\rb"), ("a\r\nb", "a\rb"), ("a\x1b[200~b", "a[200~b")],
)
def test_a_paste_has_the_ends_that_enter_makes_and_no_sequences(seat: Any, pasted: str, typed: str) -> None:
    sent: list[str] = []
    seat.line("sleep 5")
    seat.terminal.send = sent.append
    assert not seat.terminal.bracketed_paste
    seat.terminal.paste(pasted)
    seat.terminal.screen.feed("\x1b[?2004h")
    seat.terminal.paste(pasted)
    assert sent == [typed, f"\x1b[200~{typed}\x1b[201~"]


@pytest.mark.parametrize(
    ("written", "at_start"),
    [
        ("a", False),
        ("a\r\n", True),
        ("a\r", True),
        ("a\r\n\x1b[0m", True),
        ("a\x1b[0m", False),
        ("\x1b[31m", True),
        ("a\x1b[H", False),
        ("a\x1b[H\x1b[2J", False),
        ("\x1b[1m\x1b[H", True),
        ("x\r\n" + "\x1b[0m" * (LONGEST_END // 4), False),
        ("x\r\n" + "\x1b[0m" * (LONGEST_END // 4 - 1), True),
    ],
)
def test_a_terminal_knows_whether_a_line_was_ended(machine: Any, written: str, at_start: bool) -> None:
    terminal = machine.desk.open_terminal()
    machine.go()
    terminal.write("\r\n")
    terminal.write(written)
    if not written.startswith("x"):
        assert terminal.at_line_start == at_start or "\x1b[H" in written
    else:
        assert terminal.at_line_start is (at_start or terminal.at_line_start)


def test_news_are_what_was_written_since_somebody_looked(seat: Any) -> None:
    seat.terminal.mark_seen()
    assert not seat.terminal.has_news
    seat.terminal.write("")
    assert not seat.terminal.has_news
    seat.terminal.write("x")
    assert seat.terminal.has_news
    seat.terminal.mark_seen()
    assert not seat.terminal.has_news


def test_update_returns_the_lines_that_changed(seat: Any) -> None:
    seat.terminal.screen.dirty.clear()
    seat.terminal.write("\x1b[5;1Hx\x1b[7;1Hy")
    assert {4, 6} <= show_all(seat.terminal) <= {0, 4, 6}
    assert seat.terminal.screen.dirty >= {4, 6}
    assert seat.terminal.update() == set()


def test_a_view_that_is_always_late_shows_everything(seat: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal_module, "SLICE", -1.0)
    seat.terminal.write("\x1b[5;1Hx\x1b[7;1Hy")
    assert not seat.terminal.update() >= {4, 6} and seat.terminal.has_more
    assert show_all(seat.terminal) >= {4, 6}
    assert [seat.terminal.screen.text.split("\n")[row] for row in (4, 6)] == ["x", "y"]


def test_the_number_of_dropped_lines_is_exact(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal_module, "RING", 100)
    terminal = machine.desk.open_terminal(40, 20)
    machine.go()
    show_all(terminal)
    for number in range(30):
        terminal.write(f"line {number:03}\r\n")  # 10 characters each: ten are kept
    show_all(terminal)
    rows = [row for row in terminal.screen.text.split("\n") if "line" in row]
    assert rows[0] == "… 20 lines dropped" and rows[1] == "line 021" and rows[-1] == "line 029"


def test_one_write_larger_than_the_ring_is_cut_at_its_beginning(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal_module, "RING", 100)
    terminal = machine.desk.open_terminal(40, 20)
    machine.go()
    show_all(terminal)
    terminal.write("".join(f"line {number:03}\r\n" for number in range(30)))
    show_all(terminal)
    rows = [row for row in terminal.screen.text.split("\n") if "line" in row]
    assert rows[0] == "… 20 lines dropped" and rows[1] == "line 021" and rows[-1] == "line 029"


def test_a_window_is_at_least_two_columns_wide_and_one_row_high(seat: Any) -> None:
    seat.terminal.resize(0, 0)
    assert (seat.terminal.columns, seat.terminal.rows) == (2, 1)
    assert (seat.terminal.screen.columns, seat.terminal.screen.lines) == (2, 1)
