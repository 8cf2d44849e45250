"""What the three encoders write is read by `pixel_terminal` as the picture that they were given."""

from __future__ import annotations

import numpy as np
import pytest

from day6_tui.pixels.bands import BandPiece
from day6_tui.pixels.iterm import ITerm
from day6_tui.pixels.kitty import Kitty
from day6_tui.pixels.sixel import Palette, Sixel, encoded
from tests.pixels.pixel_terminal import CELL, PixelTerminal, sixel_picture


def picture(columns: int, rows: int, colours: int = 40, seed: int = 1) -> np.ndarray:
    """Blocks of colours, with single pixels among them."""
    random = np.random.default_rng(seed)
    table = random.integers(0, 256, (colours, 3), np.uint8)
    places = random.integers(0, colours, (rows * CELL[1] // 5, columns * CELL[0] // 5)).repeat(5, 0).repeat(5, 1)
    places[random.random(places.shape) < 0.02] = 0
    return table[places]


def whole(columns: int, rows: int, column: int = 3, row: int = 2) -> BandPiece:
    return BandPiece(column, row, 0, 0, columns, rows)


def shown(terminal: PixelTerminal, columns: int, rows: int, column: int = 3, row: int = 2) -> np.ndarray:
    x, y = column * CELL[0], row * CELL[1]
    return terminal.seen()[y : y + rows * CELL[1], x : x + columns * CELL[0]]


@pytest.mark.parametrize("size", [(1, 1), (7, 2), (31, 9)])
@pytest.mark.parametrize(("kind", "off"), [("kitty", 0), ("iterm", 0), ("sixel", 4)])
def test_the_terminal_shows_the_picture(kind: str, off: int, size: tuple[int, int]) -> None:
    writer = {"kitty": Kitty(), "iterm": ITerm(), "sixel": Sixel(CELL)}[kind]
    terminal, pixels = PixelTerminal(kind, 40, 14), picture(*size)
    terminal.feed(writer.draw(0, pixels, CELL, [whole(*size)], True))
    # Sixel's colours are percents, and 32 steps of each part are told apart.
    assert np.abs(shown(terminal, *size).astype(int) - pixels).max() <= off


@pytest.mark.parametrize("kind", ["kitty", "iterm", "sixel"])
def test_a_coarse_picture_fills_the_same_cells(kind: str) -> None:
    writer = {"kitty": Kitty(), "iterm": ITerm(), "sixel": Sixel(CELL)}[kind]
    terminal, pixels = PixelTerminal(kind, 40, 14), picture(8, 4)[::4, ::2]
    terminal.feed(writer.draw(0, pixels, (5, 5), [whole(8, 4)], True))
    assert np.abs(shown(terminal, 8, 4)[::4, ::2].astype(int) - pixels).max() <= 4


@pytest.mark.parametrize("kind", ["kitty", "iterm", "sixel"])
def test_only_the_visible_pieces_are_drawn(kind: str) -> None:
    writer = {"kitty": Kitty(), "iterm": ITerm(), "sixel": Sixel(CELL)}[kind]
    terminal, pixels = PixelTerminal(kind, 40, 14), picture(8, 4) | 64
    terminal.feed(writer.draw(0, pixels, CELL, [BandPiece(3, 2, 0, 0, 8, 1), BandPiece(9, 3, 6, 1, 2, 3)], True))
    place = shown(terminal, 8, 4)
    assert not place[CELL[1] :, : 6 * CELL[0]].any()
    assert np.abs(place[:, 6 * CELL[0] :].astype(int) - pixels[:, 6 * CELL[0] :]).max() <= 4


def test_a_changed_band_of_kitty_replaces_the_old_image_and_keeps_nothing_of_it() -> None:
    writer, terminal = Kitty(), PixelTerminal("kitty", 40, 14)
    for seed in range(5):
        terminal.feed(writer.draw(7, picture(8, 2, seed=seed), CELL, [whole(8, 2)], True))
    assert len(terminal.images) == len(terminal.placements) == 1
    terminal.feed(writer.draw(7, picture(8, 2, seed=4), CELL, [whole(8, 2, 5, 6)], False))
    assert terminal.pictures == 5 and (shown(terminal, 8, 2, 5, 6) == picture(8, 2, seed=4)).all()
    terminal.feed(writer.erase_all())
    assert not terminal.images and not terminal.placements


@pytest.mark.parametrize("changed", [True, False])
def test_wherever_a_drawing_of_kitty_is_cut_short_the_end_leaves_nothing_of_it(changed: bool) -> None:
    writer, terminal = Kitty(), PixelTerminal("kitty", 40, 14)
    first = writer.draw(7, picture(2, 1), CELL, [whole(2, 1)], True)
    text = writer.draw(7, picture(2, 1, seed=2), CELL, [whole(2, 1, 5, 6)], changed)
    end = "\x1b\\" + writer.erase_all()
    terminal.may_break = True
    for cut in range(len(text)):
        terminal.feed(first)
        assert terminal.placements
        terminal.feed(text[:cut] + end)
        assert not terminal.images and not terminal.placements, text[:cut]


def test_a_picture_of_thousands_of_colours_has_the_nearest_of_256() -> None:
    rows, columns = np.mgrid[0:240, 0:320]
    pixels = np.stack([rows, columns * 255 // 319, (rows + columns) // 3], axis=-1).astype(np.uint8)
    found, drawn = sixel_picture(encoded(pixels, Palette())[2:-2])
    assert drawn.all()
    assert np.abs(found.astype(int) - pixels).mean() < 12


def test_a_height_that_is_no_multiple_of_six_leaves_the_rows_below_alone() -> None:
    _, drawn = sixel_picture(encoded(picture(4, 1), Palette())[2:-2].replace("1;1;40;20", "1;1;40;24"))
    assert drawn[:20].all() and not drawn[20:].any()
