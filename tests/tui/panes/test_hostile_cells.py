"""Where texts become cells: whatever a window, a title or a bar hands on, a line has its width and holds text only."""

from __future__ import annotations

from itertools import product

import pytest
from rich.cells import cell_len as cells_on_the_terminal
from rich.segment import Segment
from textual.geometry import Size

from day6_core.session.harmless import one_line
from day6_tui.app import make_look
from day6_tui.bars.bars import Bar
from day6_tui.options import Options
from day6_tui.panes.cells import cell_len, clip, fit, wrap
from day6_tui.panes.pane import Pane, Piece
from tests.support.folded import folded
from tests.tui.screens import UTF8

HOSTILE = [
    "\x1b]0;T\x07",
    "\x1b]52;c;b3duZWQ=\x07",
    "a\nb\tc\rd",
    "\x9b2J\x9d0;T\x9c",
    "\u202eabc\u2066",
    "\u2028\u2029",
    "x\u200b\ufeff\U000e0041",
    "\udcff\ud800\uffff",
    "小\x1b小\u202e小",
    "[bold][@click=app.quit]",
]


class Evil(Pane):
    """Hands the text on as it is, everywhere a window can."""

    def __init__(self, text: str, glyphs: str, locale: str = "C.UTF-8") -> None:
        super().__init__(make_look(Options(glyphs=glyphs), {**UTF8, "LANG": locale}))
        self.text = text
        self.extent = Size(30, 5)

    def title(self) -> list[Piece]:
        return [Piece(self.text, self.background)]

    title_right = status = status_right = title

    def content_line(self, y: int, width: int) -> list[Segment]:
        return [Segment(self.text, self.background), Segment("x" * y, self.background)]


@pytest.mark.parametrize(("glyphs", "locale"), [("half", "C.UTF-8"), ("ascii", "C.UTF-8"), ("ascii", "C")])
@pytest.mark.parametrize("text", HOSTILE)
def test_every_line_of_a_pane_has_its_width_and_holds_text_only(text: str, glyphs: str, locale: str) -> None:
    pane = Evil(text, glyphs, locale)
    for framed in (True, False):
        pane.framed = framed
        for y in range(5):
            line = pane._make_strip(y).text
            assert one_line(line) == line and line.isprintable()
            assert cells_on_the_terminal(line) == 30
            assert locale != "C" or line.isascii()


@pytest.mark.parametrize("text", HOSTILE)
def test_every_bar_has_its_width_and_holds_text_only(text: str) -> None:
    pane = Evil(text, "half")
    bar = Bar(pane.look, lambda width: (pane.title(), pane.title()), name="bar")
    bar.extent = Size(30, 1)
    line = bar._make_strip(0).text
    assert one_line(line) == line
    assert cells_on_the_terminal(line) == 30


@folded("text, width", product(HOSTILE, [2, 5, 40]))
def test_what_is_measured_is_what_is_shown(text: str, width: int) -> None:
    assert cell_len(text) == cells_on_the_terminal(one_line(text))
    assert cells_on_the_terminal(clip(text, width)) <= width
    assert cells_on_the_terminal(fit(text, width)) == width
    for line in (clip(text, width), fit(text, width), *wrap(text, width)):
        assert one_line(line) == line and cells_on_the_terminal(line) <= width
