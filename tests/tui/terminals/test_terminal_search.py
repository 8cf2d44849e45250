"""Finding a text in a terminal: where it stands, over wrapped lines, up and down."""

from __future__ import annotations

import pytest

from day6_tui.terminals.search import TerminalSearch
from day6_tui.terminals.view import TerminalView
from tests.tui.fakes import FakeTerminal

TEXT = "[INFO] Talker: one\n[WARN] 你好机器人 talker\nnothing here\n[INFO] TALKER three, which goes on for long\n$ "


@pytest.fixture
def view() -> TerminalView:
    terminal = FakeTerminal(20, 4)
    terminal.write(TEXT)
    made = TerminalView(terminal)
    made.changes()
    return made


def texts(search: TerminalSearch) -> list[str]:
    """What the view would copy of every place that was found."""
    found = []
    for place in search.found():
        search.view.selection = place
        found.append(search.view.selected_text())
    return found


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        ("talker", ["Talker", "talker", "TALKER"]),
        ("Talker", ["Talker"]),
        ("机器人", ["机器人"]),
        ("好机器人 talker", ["好机器人 talker"]),
        ("which goes on", ["which goes on"]),
        ("[info]", ["[INFO]", "[INFO]"]),
        (".*", []),
        ("", []),
        ("nothing here\n", []),
    ],
)
def test_a_text_is_found_wherever_its_line_was_wrapped(view: TerminalView, wanted: str, found: list[str]) -> None:
    for columns in (20, 7, 60, 13):
        view.terminal.resize(columns, 4)
        assert texts(TerminalSearch(view, wanted)) == found


def test_next_and_previous_go_round(view: TerminalView) -> None:
    search = TerminalSearch(view, "info")
    first, second = search.found()
    assert search.previous() == second and search.next() == first
    assert search.next(first) == second and search.next(second) == first
    assert search.previous(second) == first and search.previous(first) == second
    nowhere = TerminalSearch(view, "nowhere")
    assert nowhere.next() is None and nowhere.previous(first) is None


def test_a_place_that_is_shown_is_in_sight_and_selected(view: TerminalView) -> None:
    search = TerminalSearch(view, "one")
    place = search.next()
    assert place == ((0, 15), (0, 18))
    search.show(place)
    view.changes()
    assert view.selected_text() == "one"
    top = view.history - view.scroll
    assert top <= 0 < top + view.lines
    below = TerminalSearch(view, "on for")
    found = below.previous(place)
    assert found is not None
    below.show(found)
    top = view.history - view.scroll
    assert top <= found[0][0] < top + view.lines
    assert view.selected_text() == "on for"


def test_combining_marks_belong_to_what_is_found(view: TerminalView) -> None:
    view.terminal.write("x\u0323y")
    search = TerminalSearch(view, "x")
    assert texts(search)[-1] == "x\u0323"
