"""The corrected way of sending dirty spans against Textual's own, cell by cell."""

from __future__ import annotations

import random

import pyte
import pytest
from rich.console import Console
from rich.segment import Segment
from rich.style import Style
from textual._compositor import ChopsUpdate
from textual.strip import Strip

from day6_tui.textual_private.dirty_spans import pieces_of_chops
from tests.support.folded import folded

WIDTH, HEIGHT = 40, 6
STYLES = [Style(color="red"), Style(bgcolor="blue"), Style(bold=True), None]


def _console() -> Console:
    return Console(force_terminal=True, color_system="truecolor", width=WIDTH, legacy_windows=False)


def _strip(width: int, picker: random.Random) -> Strip:
    segments = []
    left = width
    while left:
        size = picker.randint(1, left)
        text = "".join(picker.choice("abcdefgh ") for _ in range(size))
        if size >= 2 and picker.random() < 0.4:
            text = "海" + text[2:]
        segments.append(Segment(text, picker.choice(STYLES)))
        left -= size
    return Strip(segments, width)


def render_segments(update: ChopsUpdate, console: Console) -> str:
    return "".join(f"\x1b[{y + 1};{x + 1}H{strip.render(console)}" for x, y, strip in pieces_of_chops(update))


def _screen(data: str) -> list[list[object]]:
    screen = pyte.Screen(WIDTH, HEIGHT)
    pyte.Stream(screen).feed("\x1b[2J" + data)
    return [[screen.buffer[y][x] for x in range(WIDTH)] for y in range(HEIGHT)]


@folded("seed", range(30))
def test_exactly_the_dirty_cells_are_sent(seed: int) -> None:
    picker = random.Random(seed)
    lines, ends, whole = [], [], []
    for _ in range(HEIGHT):
        cuts = sorted(picker.sample(range(1, WIDTH), picker.randint(0, 3)))
        starts, stops = [0, *cuts], [*cuts, WIDTH]
        strips = {start: _strip(stop - start, picker) for start, stop in zip(starts, stops, strict=True)}
        lines.append(strips)
        ends.append(stops)
        whole.append(Strip.join(strips.values()))
    spans = []
    for y in sorted(picker.sample(range(HEIGHT), 3)):
        first = picker.randint(0, WIDTH - 1)
        spans.append((y, first, picker.randint(first + 1, WIDTH)))
    console = _console()
    sent = _screen(render_segments(ChopsUpdate(lines, spans, ends), console))
    full = _screen("".join(f"\x1b[{y + 1};1H{line.render(console)}" for y, line in enumerate(whole)))
    blank = _screen("")
    for y in range(HEIGHT):
        for x in range(WIDTH):
            inside = any(line == y and first <= x < end for line, first, end in spans)
            # A wide character at the edge of a span is sent as a whole.
            edge = any(line == y and x in (first - 1, end) for line, first, end in spans)
            expected = full[y][x] if inside else blank[y][x]
            if sent[y][x] != expected:
                assert edge and sent[y][x] == full[y][x] and full[y][x].data in ("海", ""), (seed, y, x)


def test_a_small_change_far_from_the_left_edge_costs_few_bytes() -> None:
    strip = Strip([Segment("x", Style(color=f"color({n})")) for n in range(WIDTH)], WIDTH)
    update = ChopsUpdate([{0: strip}], [(0, 30, 32)], [[WIDTH]])
    assert len(render_segments(update, _console())) < 60


@pytest.mark.parametrize("span", [(1, 2), (2, 5), (3, 6), (0, 3)])
def test_a_chinese_character_at_the_edge_of_a_dirty_span_is_not_lost(span: tuple[int, int]) -> None:
    line = Strip([Segment("a海龟走b "), Segment("来" * 10)], 28)
    whole = "".join(cell.data for cell in _screen(f"\x1b[1;1H{line.text}")[0])
    sent = render_segments(ChopsUpdate([{0: line}], [(0, *span)], [[28]]), _console())
    assert "".join(cell.data for cell in _screen(f"\x1b[1;1H{line.text}{sent}")[0]) == whole
