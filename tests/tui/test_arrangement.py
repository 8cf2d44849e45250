"""Where panes stand, for every size."""

from __future__ import annotations

import pytest

from day6_tui.tui.arrangement import arrange


def _cells(arrangement) -> list[tuple[int, int]]:
    places = [place for place in (arrangement.terminal, *arrangement.windows.values()) if place is not None]
    return [(x, y) for p in places for x in range(p.x, p.x + p.width) for y in range(p.y, p.y + p.height)]


@pytest.mark.parametrize("size", [(1, 1), (20, 5), (40, 8), (80, 22), (99, 40), (100, 14), (120, 38), (300, 98)])
@pytest.mark.parametrize("windows", [[], [1], [1, 2, 3], list(range(1, 12))])
@pytest.mark.parametrize("focused", [True, False])
@pytest.mark.parametrize("enlarged", [None, "terminal", "window"])
def test_the_panes_fill_the_desktop_without_overlapping(size, windows, focused, enlarged) -> None:
    found = arrange(*size, windows, windows[-1] if windows else None, enlarged=enlarged, terminal_focused=focused)
    cells = _cells(found)
    assert len(cells) == len(set(cells)) == size[0] * size[1]


def test_a_small_terminal_shows_the_active_window_above_the_terminals() -> None:
    found = arrange(80, 22, [1, 2], 1)
    assert list(found.windows) == [1]
    assert found.windows[1].y == 0 and found.terminal is not None and found.terminal.y == found.windows[1].height


def test_a_wide_one_shows_terminals_left_and_windows_stacked_right() -> None:
    found = arrange(120, 48, [1, 2, 3], 1)
    assert found.terminal is not None and found.terminal.x == 0
    assert [place.x for place in found.windows.values()] == [found.terminal.width] * 3
    assert list(found.windows) == [1, 2, 3]


def test_the_active_window_is_never_the_one_without_room() -> None:
    found = arrange(120, 38, [1, 2, 3, 4], 1)
    assert 1 in found.windows and 4 in found.windows and 2 not in found.windows


def test_a_tiny_terminal_shows_what_has_the_keyboard() -> None:
    assert arrange(40, 8, [1], 1, terminal_focused=True).windows == {}
    assert arrange(40, 8, [1], 1, terminal_focused=False).terminal is None
