"""The tree of the Displays panel by itself: what is chosen stays chosen, and in sight."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import Any

import pytest
from textual.app import App

from day6_core.ros.programs.rviz2.model.properties import BOOL, Property
from day6_tui.app import make_look
from day6_tui.options import Options
from day6_tui.windows.rviz import tree as module
from day6_tui.windows.rviz.tree import PropertyTree
from tests.tui.screens import running

ENVIRONMENT = {"LANG": "C.UTF-8", "TERM": "xterm-256color", "COLORTERM": "truecolor"}


class Tree:
    """What the widget knows of an RViz: the lines of its panels."""

    tree_version = 1

    def __init__(self, root: Property, nothing: Property) -> None:
        self.root, self._nothing = root, nothing

    @property
    def panels(self) -> list[Property]:
        return [*self.root.children, self._nothing]


@pytest.fixture
def rviz() -> Tree:
    """Five branches of three leaves each; views and time are none of the lines."""
    root = Property("root")
    for number in range(5):
        branch = root.add(Property(f"branch{number}"))
        for leaf in "abc":
            branch.add(Property(f"{leaf}{number}", BOOL, True))
    nothing = Property("nothing", hidden=True)
    return Tree(root, nothing)


@asynccontextmanager
async def shown(rviz: Any, height: int = 4) -> AsyncIterator[tuple[PropertyTree, Any]]:
    """The tree on a screen of its own; what it tells is heard by nobody."""
    tree = PropertyTree(rviz, make_look(Options(), ENVIRONMENT))
    app: App[None] = App()
    async with running(app, 30, height) as pilot:
        await app.mount(tree)
        tree.follow(active=True)
        await pilot.pause()
        yield tree, pilot


def on(rviz: Any, walk: Callable[[PropertyTree, Any], Awaitable[None]], height: int = 4) -> None:
    async def run() -> None:
        async with shown(rviz, height) as (tree, pilot):
            await walk(tree, pilot)

    asyncio.run(run())


def rows(tree: PropertyTree) -> list[str]:
    """The rows of the screen, without the openers and values."""
    return [tree.render_line(y).text.split("[")[0].strip("▸▾ ") for y in range(tree.size.height)]


def test_moving_scrolls_no_farther_than_it_must(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        tree.move(3)
        await pilot.pause()
        assert rows(tree) == ["branch0", "branch1", "branch2", "branch3"]
        tree.move(1)
        await pilot.pause()
        assert rows(tree) == ["branch1", "branch2", "branch3", "branch4"]
        assert tree.prop is rviz.root.children[4]

    on(rviz, walk)


def test_moving_ends_at_the_first_and_at_the_last_line(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        tree.move(1000)
        assert tree.cursor_line == 4 and tree.at_the_end
        tree.move(-1000)
        await pilot.pause()
        assert tree.cursor_line == 0 and tree.scroll_offset.y == 0

    on(rviz, walk)


def test_what_is_chosen_stays_chosen_and_in_sight_when_a_branch_above_it_opens(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        tree.move(2)
        rviz.root.children[0].expanded = True
        tree.follow(active=True)
        assert tree.cursor_line == 2, "the program has not said that the tree is another one"
        rviz.tree_version += 1
        tree.follow(active=True)
        await pilot.pause()
        assert tree.cursor_line == 5 and tree.prop is rviz.root.children[2]
        assert rows(tree)[-1] == "branch2"

    on(rviz, walk)


def test_a_line_that_goes_leaves_the_cursor_where_it_was(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        tree.move(1)
        rviz.root.remove(rviz.root.children[1])
        rviz.tree_version += 1
        tree.follow(active=True)
        assert tree.prop is rviz.root.children[1] and tree.prop.name == "branch2"
        for gone in list(rviz.root.children):
            rviz.root.remove(gone)
        rviz.tree_version += 1
        tree.follow(active=True)
        await pilot.pause()
        assert tree.prop is None and rows(tree) == [""] * 4
        tree.move(1)
        assert tree.prop is None

    on(rviz, walk)


def test_choosing_a_leaf_opens_the_branches_above_it(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        leaf = rviz.root.children[4].children[2]
        tree.choose(leaf)
        await pilot.pause()
        assert rviz.root.children[4].expanded and tree.prop is leaf
        assert rows(tree) == ["branch4", "a4", "b4", "c4"]

    on(rviz, walk)


def test_textuals_own_key_opens_all_and_the_program_learns_it(rviz: Any) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        tree.focus()
        await pilot.press("shift+space")
        assert all(branch.expanded for branch in rviz.root.children) and tree.last_line == 19
        await pilot.press("shift+space")
        assert not any(branch.expanded for branch in rviz.root.children) and tree.last_line == 4

    on(rviz, walk)


def test_only_a_line_that_changed_is_drawn(rviz: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    async def walk(tree: PropertyTree, pilot: Any) -> None:
        rviz.root.children[0].expanded = True
        rviz.tree_version += 1
        tree.follow(active=True)
        await pilot.pause()
        drawn: list[int] = []
        draw = PropertyTree.render_line
        monkeypatch.setattr(PropertyTree, "render_line", lambda self, y: drawn.append(y) or draw(self, y))
        tree.follow(active=True)
        await pilot.pause()
        assert drawn == []
        rviz.root.children[0].children[1].value = False
        tree.follow(active=True)
        await pilot.pause()
        assert drawn == [2]

    on(rviz, walk, 9)


def test_rows_below_the_last_line_are_empty_and_thousands_of_lines_are_cut(rviz: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(module, "MOST_LINES", 7)

    async def walk(tree: PropertyTree, pilot: Any) -> None:
        assert rows(tree)[4:] == ["branch4"] + [""] * 4
        rviz.root.children[4].expanded = True
        rviz.tree_version += 1
        tree.follow(active=True)
        await pilot.pause()
        assert rows(tree)[4:] == ["branch4", "a4", "b4", "", ""]

    on(rviz, walk, 9)
