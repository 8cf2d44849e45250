"""The tree of splits: places for every size, what folds where there is no room, and that no change loses a pane."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from day6_tui.panes.placement import OTHER, TERMINAL, PaneNeeds, arranged, best_spot
from day6_tui.panes.splits import SIDES, Extent, Layout, Split, Stack, Tree
from day6_tui.windows import pane_class

SIZES = [(1, 1), (20, 5), (40, 10), (80, 22), (99, 40), (100, 14), (120, 38), (400, 118)]


def needs_of(kind: str) -> PaneNeeds:
    return OTHER if kind == "other" else pane_class(kind).needs


def wish(key: int) -> Extent:
    return Extent(40, 12)


def fills(layout: Layout, width: int, height: int) -> bool:
    cells = [(x, y) for p in layout.places.values() for x in range(p.x, p.right) for y in range(p.y, p.bottom)]
    return len(cells) == len(set(cells)) == width * height


operations = st.lists(
    st.tuples(
        st.sampled_from(["add", "remove", "move", "swap", "front", "drag"]),
        st.integers(0, 40),
        st.integers(0, 40),
        st.sampled_from(SIDES),
    ),
    max_size=40,
)


@pytest.mark.long
@settings(max_examples=200, deadline=None)
@given(operations, st.sampled_from(SIZES))
def test_whatever_is_done_every_pane_is_somewhere_and_the_places_fill_the_desktop(done, size) -> None:
    tree, expected = Tree(), set()
    for number, (what, one, other, side) in enumerate(done):
        keys = sorted(expected)
        a, b = (keys[one % len(keys)], keys[other % len(keys)]) if keys else (None, None)
        if what == "add" or a is None:
            tree.add(number, a if one % 3 else None, side if a is not None and one % 3 else "right")
            expected.add(number)
        elif what == "remove":
            tree.remove(a)
            expected.remove(a)
        elif what == "move":
            tree.move(a, b, side)
        elif what == "swap":
            tree.swap(a, b)
        elif what == "front":
            tree.bring_to_front(a)
        elif borders := tree.lay_out(*size, wish).borders:
            tree.drag(borders[one % len(borders)], other)
        assert sorted(tree.keys) == sorted(expected)
        assert all(stack.front in stack.keys for stack in tree.stacks())
        layout = tree.lay_out(*size, wish, sorted(expected))
        if expected:
            assert fills(layout, *size)
            assert sorted(key for keys in layout.stacks.values() for key in keys) == sorted(expected)
        assert tidy(tree.root)


def tidy(node: Stack | Split | None) -> bool:
    if not isinstance(node, Split):
        return True
    flat = all(not isinstance(part, Split) or part.across != node.across for part in node.parts)
    return len(node.parts) > 1 and flat and all(tidy(part) for part in node.parts)


def test_where_there_is_no_room_parts_become_tabs_with_the_one_used_last_in_front() -> None:
    tree = Tree()
    for key in (1, 2, 3):
        tree.add(key, key - 1 or None, "right")
    assert set(tree.lay_out(120, 20, wish).places) == {1, 2, 3}
    small = tree.lay_out(40, 20, wish, [2, 3, 1])
    assert small.stacks == {2: [1, 2, 3]}
    assert set(tree.lay_out(120, 20, wish).places) == {1, 2, 3}


def test_a_border_that_is_dragged_stays_where_it_was_put() -> None:
    tree = Tree()
    tree.add(1)
    tree.add(2, 1, "right")
    border = tree.lay_out(100, 20, wish).borders[0]
    tree.drag(border, 70)
    assert tree.lay_out(100, 20, wish).places[1].width == 70
    tree.drag(tree.lay_out(100, 20, wish).borders[0], 1000)
    assert tree.lay_out(100, 20, wish).places[2].width >= 20, "never so small that it cannot be dragged back"
    tree.add(3, 2, "right")
    assert tree.lay_out(200, 20, wish).places[3].width > 10


def test_the_neighbour_is_the_pane_beside_and_of_several_the_one_used_last() -> None:
    tree = Tree()
    tree.add(1)
    tree.add(2, 1, "right")
    tree.add(3, 2, "below")
    layout = tree.lay_out(100, 40, wish)
    assert layout.neighbour(1, "right", [1, 3, 2]) == 3 and layout.neighbour(1, "right", [1, 2, 3]) == 2
    assert layout.neighbour(2, "below") == 3 and layout.neighbour(3, "above") == 2 and layout.neighbour(3, "left") == 1
    assert layout.neighbour(1, "left") is None and layout.neighbour(2, "right") is None


def place(size: tuple[int, int], *kinds: str) -> tuple[Layout, list[int]]:
    """Open panes one after the other: terminals (T) take the keyboard, windows do not."""
    tree, recent = Tree(), []
    needs = {number: TERMINAL if kind == "T" else needs_of(kind) for number, kind in enumerate(kinds, 1)}
    for number, kind in enumerate(kinds, 1):
        keyboard = recent[0] if recent else None
        recent.insert(0 if kind == "T" else 1, number)
        spot = best_spot(tree, number, Extent(*size), needs.__getitem__, recent, keyboard=keyboard)
        tree.add(number, *(spot or (None, "right")))
    return tree.lay_out(*size, lambda key: needs[key].good, recent), recent


def test_on_a_small_screen_turtle_teleop_and_echo_are_seen_together() -> None:
    layout, _ = place((80, 22), "T", "turtlesim", "T", "T")
    echo, teleop, turtle = layout.places[3], layout.places[4], layout.places[2]
    assert turtle.width >= 40 and turtle.height == 22
    assert echo.height >= 11 and teleop.height >= 11
    assert layout.stacks[4] == [1, 4], "the terminal in which the node runs is a tab"


def test_on_a_wide_screen_two_terminals_are_beside_each_other_and_a_third_below() -> None:
    layout, _ = place((120, 38), "T", "T", "T")
    first, second, third = (layout.places[key] for key in (1, 2, 3))
    assert first.x == third.x == 0 and second.x == first.width and third.y == first.height


@pytest.mark.parametrize("size", [(80, 22), (120, 38)])
def test_sliders_and_inspector_do_not_push_rviz_off(size) -> None:
    layout, _ = place(size, "T", "T", "rviz2", "T", "joint_state_publisher", "inspector")
    assert 3 in layout.places and layout.places[3].width >= 60


def test_nothing_covers_a_picture_that_matters_more_than_itself() -> None:
    layout, _ = place((80, 22), "T", "rviz2", "T", "T", "joint_state_publisher", "inspector")
    assert 2 in layout.places and 6 in layout.places


@pytest.mark.parametrize("size", SIZES)
def test_thirty_panes_all_have_a_place_and_the_new_one_is_seen(size) -> None:
    layout, _ = place(size, *["T", "turtlesim", "rqt_graph"] * 10)
    assert sum(map(len, layout.stacks.values())) == 30
    assert fills(layout, *size)


def test_a_new_arrangement_has_every_pane_once() -> None:
    needs: dict[int, PaneNeeds] = {1: TERMINAL, 2: needs_of("rviz2"), 3: TERMINAL, 4: OTHER}
    tree = arranged([1, 2, 3, 4], Extent(120, 38), needs.__getitem__, [3, 1, 2, 4])
    assert sorted(tree.keys) == [1, 2, 3, 4]
