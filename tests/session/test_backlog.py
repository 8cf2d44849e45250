"""What a program writes while its window has the terminal: looked at without colours, printed with them later."""

from __future__ import annotations

from day6_core.session.backlog import MOST_LINES, Backlog
from day6_core.session.streams import Captured

WARNING = "\x1b[33m[WARN] [17.0] [n]: hot\x1b[0m\n"


def test_colours_of_log_lines_are_not_shown_but_printed_in_the_end() -> None:
    backlog, terminal = Backlog(), Captured()
    backlog.write(terminal, WARNING)
    assert backlog.last == "[WARN] [17.0] [n]: hot"
    assert backlog.lines() == [backlog.last]
    backlog.release()
    assert terminal.text == WARNING


def test_lines_of_two_outputs_stay_in_their_order_and_go_where_they_belong() -> None:
    backlog, out, err = Backlog(), Captured(), Captured()
    backlog.write(out, "one\ntw")
    backlog.write(err, "bad\n")
    backlog.write(out, "o\n")
    assert backlog.lines() == ["one", "bad", "two"]
    backlog.release()
    assert (out.text, err.text) == ("one\ntwo\n", "bad\n")


def test_of_too_many_lines_the_oldest_go_and_their_number_is_known() -> None:
    backlog, out = Backlog(), Captured()
    backlog.write(out, "".join(f"{number}\n" for number in range(MOST_LINES + 5)))
    assert (backlog.lines()[0], backlog.last, backlog.dropped) == ("5", f"{MOST_LINES + 4}", 5)
