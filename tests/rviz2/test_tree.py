"""The lines of the Displays panel without a screen: what is chosen stays chosen, and in sight."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from day6_tui.core.ros.programs.rviz2.model.properties import Property
from day6_tui.tui.windows.rviz.tree import Tree


@pytest.fixture
def rviz() -> SimpleNamespace:
    """Five branches of three leaves each; views and time are none of the lines."""
    root = Property("root")
    for number in range(5):
        branch = root.add(Property(f"branch{number}"))
        for leaf in "abc":
            branch.add(Property(f"{leaf}{number}"))
    nothing = Property("nothing", hidden=True)
    return SimpleNamespace(root=root, views=nothing, time=nothing, tree_version=1)


@pytest.fixture
def tree(rviz) -> Tree:
    made = Tree(rviz)
    made.fit(4)
    made.follow()
    return made


def names(tree: Tree) -> list[str]:
    """What stands in the four rows."""
    return [line.prop.name for row in range(4) if (line := tree.line(row)) is not None]


def test_moving_scrolls_no_farther_than_it_must(tree: Tree) -> None:
    tree.move(3)
    assert names(tree) == ["branch0", "branch1", "branch2", "branch3"]
    tree.move(1)
    assert names(tree) == ["branch1", "branch2", "branch3", "branch4"]
    assert tree.prop is not None and tree.prop.name == "branch4"


def test_moving_ends_at_the_first_and_at_the_last_line(tree: Tree) -> None:
    tree.move(1000)
    assert tree.chosen == 4
    tree.move(-1000)
    assert tree.chosen == 0 and tree.top == 0


def test_scrolling_takes_the_chosen_line_along_at_the_edge(tree: Tree) -> None:
    tree.scroll(1)
    assert (tree.top, tree.chosen) == (1, 1)
    tree.move(3)
    tree.scroll(-1)
    assert (tree.top, tree.chosen) == (0, 3)


def test_what_is_chosen_stays_chosen_when_a_branch_above_it_opens(tree: Tree, rviz) -> None:
    tree.move(2)
    rviz.root.children[0].expanded = True
    tree.follow()
    assert tree.chosen == 2, "the program has not said that the tree is another one"
    rviz.tree_version += 1
    tree.follow()
    assert tree.chosen == 5 and tree.prop is rviz.root.children[2]


def test_choosing_a_leaf_opens_the_branches_above_it(tree: Tree, rviz) -> None:
    leaf = rviz.root.children[4].children[2]
    tree.choose(leaf)
    assert rviz.root.children[4].expanded and tree.prop is leaf
    assert names(tree) == ["branch4", "a4", "b4", "c4"]


def test_rows_below_the_last_line_are_empty(tree: Tree) -> None:
    tree.fit(9)
    assert tree.line(5) is None and tree.line(4) is not None
