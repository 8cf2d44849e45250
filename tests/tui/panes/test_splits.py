"""The tree of splits: places for every size, what folds where there is no room, and that no change loses a pane."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from day6_tui.panes.placement import OTHER, TERMINAL, PaneNeeds, Room, arranged, put
from day6_tui.panes.splits import SIDES, Extent, Layout, Split, Stack, Tree
from day6_tui.windows import pane_class

SIZES = [(1, 1), (20, 5), (40, 10), (80, 22), (99, 40), (100, 14), (120, 38), (400, 118)]


def needs_of(kind: str) -> PaneNeeds:
    return OTHER if kind == "other" else pane_class(kind).needs


def wish(key: int) -> PaneNeeds:
    return TERMINAL


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


def place(
    size: tuple[int, int],
    *kinds: str,
    launch: dict[int, int] | None = None,
    look: Callable[[Layout], None] = lambda layout: None,
) -> tuple[Layout, list[int]]:
    """Open panes one after the other: terminals (T, D if keys drive) take the keyboard, windows do not.

    `launch` says which windows came with which launch; `look` sees the layout after each.
    """
    tree, recent = Tree(), []
    needs = {number: TERMINAL if kind in "TD" else needs_of(kind) for number, kind in enumerate(kinds, 1)}
    driven = {number for number, kind in enumerate(kinds, 1) if kind == "D"}

    def family(key: int) -> list[object]:
        kind = kinds[key - 1]
        about = "" if kind in ("T", "D", "other") else pane_class(kind).about
        return [each for each in (about, (launch or {}).get(key)) if each]

    for number, kind in enumerate(kinds, 1):
        keyboard = recent[0] if recent else None
        recent.insert(0 if kind in "TD" else 1, number)
        tree = put(tree, number, Room(Extent(*size), needs.__getitem__, recent, keyboard, family, driven & set(recent)))
        layout = tree.lay_out(*size, needs.__getitem__, recent)
        look(layout)
    return layout, recent


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


def test_windows_of_one_launch_are_never_tabs_of_one_place() -> None:
    for kinds in (
        ("T", "turtlesim", "T", "T", "rviz2", "joint_state_publisher"),
        ("T", "turtlesim", "T", "T", "joint_state_publisher", "rviz2"),
        ("T", "rqt_graph", "turtlesim", "T", "turtlesim", "turtlesim"),
    ):
        launched = dict.fromkeys((len(kinds) - 1, len(kinds)), 7)
        for size in ((80, 22), (120, 38)):
            layout, _ = place(size, *kinds, launch=launched)
            assert set(launched) <= layout.places.keys(), (kinds, size)
            assert layout.places.keys() & {1, 3, 4}, "and the terminal is seen, too"


def test_a_window_takes_the_place_of_what_was_used_least_recently() -> None:
    layout, recent = place((80, 22), "T", "turtlesim", "T", "T", "rqt_graph", "rqt_graph")
    assert layout.places.keys() >= {recent[0], 6}
    for size in ((80, 22), (120, 38)):
        layout, recent = place(size, *"TTTTTTTT", "turtlesim", "rqt_graph", "rviz2")
        hidden = [key for key in recent if key not in layout.places and key <= 8]
        assert hidden == sorted(hidden, key=recent.index) == recent[-len(hidden) :]


def test_an_idle_turtle_yields_to_rviz_and_the_sliders_cover_neither_rviz_nor_the_keyboard() -> None:
    layout, recent = place((80, 22), "T", "turtlesim", "T", "T", "T", "rviz2", "T", "T", "joint_state_publisher")
    assert {6, 9, recent[0]} == layout.places.keys()
    assert (layout.places[6].width, layout.places[6].height) == (80, 14)


@pytest.mark.parametrize("size", [(80, 22), (100, 28), (120, 38), (200, 58)])
def test_no_window_that_opens_leaves_a_pane_too_small_to_be_used(size) -> None:
    kinds = ("turtlesim", "rviz2", "rqt_graph", "joint_state_publisher", "kitchen", "inspector", "car", "rqt_bag")
    chance = random.Random(17)
    for _ in range(40):
        opened = ["T", *(chance.choice(["T", *kinds]) for _ in range(9))]

        def look(layout: Layout, opened: list[str] = opened) -> None:
            for key, there in layout.places.items():
                least = (TERMINAL if opened[key - 1] == "T" else needs_of(opened[key - 1])).least
                assert there.width >= least.columns and there.height >= least.rows, (opened, key, there)

        place(size, *opened, look=look)


def test_the_kitchen_opens_large_and_the_inspector_is_no_strip() -> None:
    layout, _ = place((80, 22), "T", "turtlesim", "T", "T", "kitchen")
    assert layout.places[5].width >= 56 and layout.places[5].height >= 14 and 4 in layout.places
    for window in ("inspector", "joint_state_publisher"):
        layout, _ = place((80, 22), "T", "turtlesim", "T", "T", "T", window)
        assert layout.places[6].height >= 7 and layout.places.keys() >= {2, 5}


@pytest.mark.parametrize(("width", "lesson"), [(80, 39), (120, 46), (200, 66)])
def test_a_lesson_takes_no_more_columns_than_it_needs(width: int, lesson: int) -> None:
    layout, _ = place((width, 38), "T", "lesson")
    assert layout.places[2].width <= lesson


def test_beside_a_lesson_an_echo_covers_the_turtle_rather_than_the_remote_control() -> None:
    layout, _ = place((80, 22), "D", "lesson", "turtlesim", "T")
    assert layout.places.keys() == {1, 2, 4} and layout.places[1].height >= 10 and layout.places[4].height >= 11
    layout, _ = place((80, 22), "T", "lesson", "turtlesim", "T")
    assert layout.places.keys() == {4, 2, 3}, "a terminal in which nothing drives is a tab, as ever"


def test_no_window_covers_a_lesson_that_is_read() -> None:
    for kind in ("turtlesim", "rqt_graph", "rqt_bag", "car"):
        layout, _ = place((80, 22), "T", "lesson", "T", "T", kind, "inspector")
        assert 2 in layout.places, kind


def test_fifty_windows_at_once_all_have_a_place_and_those_seen_can_be_used() -> None:
    for size in ((80, 22), (200, 58)):
        layout, recent = place(size, "T", "T", *["turtlesim", "rqt_graph", "rviz2", "inspector", "T"] * 10)
        assert sum(map(len, layout.stacks.values())) == 52 and recent[0] in layout.places
        assert min(there.height for there in layout.places.values()) >= 8


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
    tree = arranged([1, 2, 3, 4], Room(Extent(120, 38), needs.__getitem__, [3, 1, 2, 4]))
    assert sorted(tree.keys) == [1, 2, 3, 4]
