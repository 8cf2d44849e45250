"""How the RViz window shares its room: the Displays panel with its buttons, the edge that folds it, the offer to look closer."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

import pytest
from textual import events

from day6_core.lessons.catalogue import days
from day6_tui.windows.rviz.buttons import ADD
from day6_tui.windows.rviz.drawer import LOWEST_VIEW, NARROWEST_PANEL, NARROWEST_VIEW, divide
from day6_tui.windows.rviz.hints import panel_hints
from day6_urdf import shipped_model
from tests.rviz2.rviz_walk import Walk, mouse, run, walking
from tests.support.folded import folded

if TYPE_CHECKING:
    from tests.rviz2.rviz_machine import RVizMachine

HALF_OF_120 = (62, 20)
"""A desktop in which the enlarged window is as wide as half of one of 120 columns."""


# -- the panel and the view --------------------------------------------------------------------------------------------


@folded("width, height, is_open", product(range(1, 160, 3), [1, 2, 8, 16, 40], [True, False]))
def test_panel_edge_and_view_share_all_cells_and_the_view_never_starves(width: int, height: int, is_open: bool) -> None:
    parts = divide(width, height, panel_open=is_open)
    assert sum(part.area for part in parts) == width * height and (bool(parts.panel) is is_open or width < 3)
    assert not any(parts[a].overlaps(parts[b]) for a, b in ((0, 1), (0, 2), (1, 2)))
    assert parts.view.area or width < 3
    beside = parts.panel.height == height and width >= NARROWEST_PANEL + 1 + NARROWEST_VIEW
    if is_open and beside:
        assert parts.panel.width >= NARROWEST_PANEL and parts.view.width >= NARROWEST_VIEW
    elif is_open and height >= 16:
        assert parts.view.width == width and parts.view.height >= LOWEST_VIEW
    elif not is_open and width > 1:
        assert (parts.view.width, parts.view.height) == (width - 1, height)


def test_a_key_and_a_click_fold_the_panel_and_bring_it_back(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 80, 24) as at:
            assert "Cell" not in at.screen() and "Frame Rate" in at.screen() and at.pane.view.columns >= 46
            await at.press("d")
            assert "Frame Rate" not in at.screen() and at.pane.view.columns == 77
            await at.press("tab")
            assert "Frame Rate" in at.screen() and at.pane.on_panel
            middle = at.pane.body_height // 2 + 1
            assert at.screen().count("◂") == 1
            await at.pilot.click(at.pane, offset=(at.pane.division.panel.width + 1, middle))
            await at.settle()
            assert "Frame Rate" not in at.screen() and "▸ Displays" in at.screen()
            await at.pilot.click(at.pane, offset=(1, middle))
            await at.settle()
            assert "Frame Rate" in at.screen() and "▸ Displays" not in at.screen()

    run(walk())


def test_in_a_narrow_window_the_view_gets_all_of_it_while_it_is_used(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, *HALF_OF_120) as at:
            assert "Frame Rate" in at.screen() and at.pane.view.columns == 60 - 1 - at.pane.division.panel.width
            await at.press("tab")
            assert "Frame Rate" not in at.screen() and at.pane.view.columns == 59
            line = at.screen().split("\n")[at.pane.region.y]
            await at.pilot.click(offset=(line.index("▸ Displays") + 2, at.pane.region.y))
            await at.settle()
            assert "Frame Rate" in at.screen() and at.pane.on_panel

    run(walk())


def test_in_a_very_narrow_window_the_panel_is_above_the_view(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 46, 24) as at:
            assert "Global Options" in at.screen() and (at.pane.view.columns, at.pane.view.rows) == (44, 8)
            edge = at.pane.top + at.pane.division.edge.y + 1
            assert "─ ▴ ─" in at.screen().splitlines()[edge + 1]
            await at.press("tab")
            assert "Global Options" not in at.screen() and (at.pane.view.columns, at.pane.view.rows) == (43, 16)
            await at.press("escape")
            assert "Global Options" in at.screen()
            await at.pilot.click(at.pane, offset=(20, edge))
            await at.settle()
            assert "Global Options" not in at.screen()

    run(walk())


# -- the buttons -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("width", "height"), [(120, 40), (80, 24), HALF_OF_120])
@pytest.mark.parametrize("glyphs", ["half", "ascii"])
def test_the_four_buttons_are_at_the_lower_left(machine: RVizMachine, width: int, height: int, glyphs: str) -> None:
    async def walk() -> None:
        async with walking(machine, width, height, glyphs=glyphs) as at:
            row = at.line("Duplicate")[1:].split("│")[0].split("|")[0].split("<")[0].split("◂")[0]
            assert [word for word in row.split() if "^" not in word and word != "a"] == [
                "Add",
                "Duplicate",
                "Remove",
                "Rename",
            ]
            assert ("^X" in row) is (width == 120)
            assert at.screen().splitlines().index(at.line("Duplicate")) == at.pane.top + at.pane.body_height + 1

    run(walk())


def test_the_lesson_the_button_and_the_key_bar_name_the_same_key(machine: RVizMachine) -> None:
    (step,) = [step for step in days()[-1].steps if "(Add)" in step.pages["en"].do + step.pages["en"].body]
    for page in step.pages.values():
        assert f"`{ADD.shown}`" in page.do + page.body

    async def walk() -> None:
        async with walking(machine, 120, 40) as at:
            assert f"Add {ADD.shown} " in at.line("Duplicate")
            assert (ADD.shown, "rviz.key.add") in panel_hints()
            for key in (ADD.key, "ctrl+n"):
                await at.press(key)
                assert at.app.desktop.overlay is not None
                await at.press("escape")

    run(walk())


async def _click_button(at: Walk, name: str) -> None:
    row = at.line("Duplicate")
    await at.pilot.click(at.pane, offset=(row.index(name) + 1, at.pane.top + at.pane.body_height))
    await at.settle()


def test_the_buttons_are_clicked(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            names = lambda: [display.name for display in machine.rviz.displays]  # noqa: E731
            await _click_button(at, "Remove")  # nothing to remove: Global Options is chosen
            assert names() == ["Grid"]
            await _click_button(at, "Add")
            await at.type("axes")
            await at.press("enter")
            await at.settle()
            assert names() == ["Grid", "Axes"] and at.pane.panel.properties.chosen_display is machine.rviz.displays[1]
            await _click_button(at, "Duplicate")
            assert names() == ["Grid", "Axes", "Axes"]
            await _click_button(at, "Rename")
            await at.press("ctrl+u")
            await at.type("mine")
            await at.press("enter")
            assert names() == ["Grid", "mine", "Axes"]
            await _click_button(at, "Remove")
            assert names() == ["Grid", "Axes"]

    run(walk())


def test_the_buttons_are_below_the_last_line_for_keys(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            machine.add("Axes")
            await at.settle()
            await at.press("end", "down")
            assert at.pane.panel.buttons.chosen.id == "add"
            await at.press("enter")
            assert "by topic" in at.screen() or "RobotModel" in at.screen()
            await at.press("escape")
            await at.press("up")
            assert at.pane.panel.buttons.chosen is None
            at.pane.choose(machine.rviz.displays[1])
            await at.press("left", "end", "down", "right", "right")
            assert at.pane.panel.buttons.chosen.id == "add"  # the last line belongs to no display: nothing to remove
            await at.press("up")
            assert at.pane.panel.buttons.chosen is None

    run(walk())


def test_shift_tab_goes_to_the_buttons_and_the_arrows_from_one_to_the_next(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            names = lambda: [display.name for display in machine.rviz.displays]  # noqa: E731
            at.pane.choose(machine.rviz.displays[0])
            await at.press("shift+tab", "right", "enter")
            assert names() == ["Grid", "Grid"] and at.pane.panel.buttons.chosen.id == "duplicate"
            await at.press("right", "space")
            assert names() == ["Grid"]
            await at.press("shift+tab")
            assert at.pane.panel.properties.has_focus
            await at.press("tab", "shift+tab")
            assert at.pane.panel.buttons.chosen.id == "add"
            await at.press("tab", "left")
            assert not at.pane.on_panel and machine.rviz.view.child("Yaw").value > 0.785398

    run(walk())


def test_a_click_on_a_button_leaves_the_keyboard_with_the_tree(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            at.pane.choose(machine.rviz.displays[0])
            await at.press("tab")
            await _click_button(at, "Duplicate")
            assert len(machine.rviz.displays) == 2 and at.pane.panel.properties.has_focus
            await at.press("ctrl+x")
            assert len(machine.rviz.displays) == 1

    run(walk())


# -- typing a value in its place ---------------------------------------------------------------------------------------


async def _type_cell_size(at: Walk, machine: RVizMachine) -> Any:
    size = machine.rviz.displays[0].child("Cell Size")
    at.pane.choose(size)
    await at.press("enter")
    return size


def _row_of_the_line(at: Walk) -> str:
    return at.screen().splitlines()[at.pane.panel.value_line.region.y]


def test_a_value_is_typed_where_it_stands(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            size = await _type_cell_size(at, machine)
            await at.type(".5")
            assert "Cell Size         1.5 " in _row_of_the_line(at) and size.value == 1.0
            await at.press("enter")
            assert size.value == 1.5 and at.pane.panel.value_line is None and at.pane.panel.properties.has_focus
            await at.press("enter", "9", "escape")
            assert size.value == 1.5 and at.pane.panel.value_line is None and at.pane.panel.properties.has_focus

    run(walk())


@pytest.mark.parametrize("how", ["tab", "f3", "click", "palette"])
def test_what_was_typed_is_taken_over_when_the_keyboard_goes_elsewhere(machine: RVizMachine, how: str) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            pane, size = at.pane, await _type_cell_size(at, machine)
            await at.press("backspace", "3")
            if how == "click":
                await at.pilot.click(pane, offset=(80, 10))
            else:
                await at.press({"palette": "f7"}.get(how, how))
            await at.settle()
            assert size.value == 3.0 and pane.panel.value_line is None

    run(walk())


def test_keys_that_come_faster_than_the_line_are_not_lost(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            size = machine.rviz.displays[0].child("Cell Size")
            at.pane.choose(size)
            for key in ("enter", "backspace", "4", "2", "enter", "down", "enter"):
                at.app.post_message(events.Key(key, key if len(key) == 1 else None))
            await at.until(lambda: size.value == 42.0)
            assert at.pane.panel.value_line is None or at.pane.panel.value_line.prop is not size
            assert at.pane.panel.properties.prop.name == "Line Style" and "━ Choose" in at.screen()

    run(walk())


def test_a_value_line_closes_with_its_panel_and_with_its_property(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await _type_cell_size(at, machine)
            machine.rviz.request(lambda: machine.rviz.remove_display(machine.rviz.displays[0]))
            await at.settle()
            assert at.pane.panel.value_line is None and at.pane.panel.properties.has_focus
            machine.add("Grid")
            await at.settle()
            await _type_cell_size(at, machine)
            await at.pilot.click(at.pane, offset=(at.pane.division.panel.width + 1, at.pane.body_height // 2 + 1))
            await at.settle()
            assert at.pane.panel.value_line is None and at.pane.has_focus and "Cell Size" not in at.screen()
            await at.press("left")
            assert machine.rviz.view.child("Yaw").value > 0.785398

    run(walk())


# -- the Add dialog ----------------------------------------------------------------------------------------------------


@pytest.mark.long
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("typed", ["robot", "robotmodel", "model", "Robot"])
def test_robot_means_a_robot_model(machine: RVizMachine, lang: str, typed: str) -> None:
    async def walk() -> None:
        from nav_msgs.msg import Odometry

        machine.node.create_publisher(Odometry, "/robot/odom", 10)
        machine.describe(shipped_model().read_text(encoding="utf-8"))
        async with walking(machine, lang=lang) as at:
            await at.press("ctrl+n")
            await at.type(typed)
            await at.press("enter")
            await at.settle()
            assert [display.type for display in machine.rviz.displays] == ["Grid", "RobotModel"]

    run(walk())


# -- the mouse on the tree ---------------------------------------------------------------------------------------------


def test_the_wheel_scrolls_the_tree_and_leaves_the_view_alone(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 80, 24) as at:
            machine.add("RobotModel")
            machine.add("TF")
            for display in machine.rviz.displays:
                display.expanded = True
            at.pane.panel.properties.refill()
            await at.settle()
            tree, distance = at.pane.panel.properties, machine.rviz.view.child("Distance").value
            assert tree.show_vertical_scrollbar and "Fixed Frame" in at.screen().splitlines()[4]
            for _ in range(30):  # also where there is nothing more to scroll
                tree.post_message(mouse(tree, events.MouseScrollDown, 5, 5, 0, False, False))
            await at.until(lambda: tree.scroll_offset.y == tree.max_scroll_y)
            assert "▸ Time" in at.screen().splitlines()[at.pane.top + at.pane.body_height]
            assert tree.cursor_line == 0 and machine.rviz.view.child("Distance").value == distance
            await at.press("down")
            assert tree.cursor_line == 1 and "Fixed Frame" in at.screen().splitlines()[3]

    run(walk())


def test_a_click_on_a_value_lets_it_be_changed_and_one_on_a_name_chooses_it(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            pane, tree = at.pane, at.pane.panel.properties
            await at.press("tab")
            rate = machine.rviz.options.child("Frame Rate")
            row = tree.node_of(rate).line + 1 + pane.top
            await at.pilot.click(pane, offset=(6, row))
            await at.settle()
            assert tree.prop is rate and pane.panel.value_line is None and pane.on_panel
            await at.pilot.click(pane, offset=(24, row))
            await at.settle()
            assert pane.panel.value_line is not None
            await at.press("backspace", "5", "enter")
            assert rate.value == 35
            await at.pilot.click(
                pane, offset=(24, row - 2)
            )  # Fixed Frame, for which there are no frames to choose from
            await at.settle()
            assert pane.panel.value_line is not None and pane.panel.value_line.prop is machine.rviz.fixed

    run(walk())


# -- finding a property ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("typed", ["cell si", "Grid cell size"])
def test_a_property_is_found_in_a_closed_branch(machine: RVizMachine, typed: str) -> None:
    async def walk() -> None:
        async with walking(machine, *HALF_OF_120) as at:
            await at.press("tab", "slash")
            assert "━ Find a property" in at.screen()
            await at.type(typed)
            await at.press("enter")
            size = machine.rviz.displays[0].child("Cell Size")
            assert at.pane.panel.properties.prop is size and "Cell Size" in at.screen() and at.pane.on_panel

    run(walk())


# -- the keyboard ------------------------------------------------------------------------------------------------------


def test_the_keyboard_follows_the_panel_when_the_window_becomes_narrow_and_wide(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine, 100, 30) as at:
            machine.add("RobotModel")
            at.pane.drawer.empty = False
            await at.press("down", "down")
            chosen = at.pane.panel.properties.prop
            await at.pilot.resize_terminal(*HALF_OF_120)
            await at.settle()
            assert at.app.screen.focused is at.pane
            await at.press("left")
            assert machine.rviz.view.child("Yaw").value > 0.785398
            await at.pilot.resize_terminal(100, 30)
            await at.settle()
            assert at.app.screen.focused is at.pane.panel.properties and at.pane.panel.properties.prop is chosen
            await at.press("shift+tab")
            await at.pilot.resize_terminal(*HALF_OF_120)
            await at.settle()
            assert at.app.screen.focused is at.pane

    run(walk())


def test_the_frame_shows_who_has_the_keyboard_also_while_something_is_open_over_it(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            assert {line[0] for line in at.screen().splitlines()[3:-2]} == {"┃"}
            await at.press("ctrl+n")
            assert {line[0] for line in at.screen().splitlines()[3:-2]} == {"│"}
            await at.press("escape")
            assert {line[0] for line in at.screen().splitlines()[3:-2]} == {"┃"}

    run(walk())


# -- closing -----------------------------------------------------------------------------------------------------------


@pytest.fixture
def changed(machine: RVizMachine, tmp_path: Any) -> Any:
    """What RViz keeps by default is in a folder of the test; `await changed(at)` changes the view."""

    async def change(at: Walk) -> Any:
        machine.rviz.default_file = tmp_path / "default.rviz"
        at.pane.set(machine.rviz.fixed, "odom")
        await at.settle()
        assert "*" in at.screen().splitlines()[1]
        return machine.rviz.default_file

    return change


async def _close(at: Walk) -> None:
    row = at.screen().splitlines()[1]
    await at.pilot.click(at.pane, offset=(row.rindex("×"), 0))
    await at.settle()


def test_a_window_without_changes_closes_at_once(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            await _close(at)
            assert not machine.display.windows

    run(walk())


@pytest.mark.long
@pytest.mark.parametrize(
    ("answer", "open_then", "saved"), [("save", False, True), ("discard", False, False), ("cancel", True, False)]
)
def test_a_changed_view_asks_before_it_closes(
    machine: RVizMachine, changed: Any, answer: str, open_then: bool, saved: bool
) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            file = await changed(at)
            await _close(at)
            assert (
                "There are unsaved changes" in at.screen() and "default.rviz" in at.screen() and machine.display.windows
            )
            await at.type(answer)
            await at.press("enter")
            await at.settle()
            assert bool(machine.display.windows) is open_then
            assert file.is_file() is saved
            if saved:
                assert "Fixed Frame: odom" in file.read_text(encoding="utf-8")

    run(walk())


def test_what_cannot_be_saved_keeps_the_window_open(machine: RVizMachine, changed: Any) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            file = await changed(at)
            file.mkdir()
            await _close(at)
            await at.press("enter")
            await at.settle()
            assert machine.display.windows and "default.rviz could not be saved" in at.screen()

    run(walk())


def test_the_desktop_asks_before_it_ends_with_a_changed_view(machine: RVizMachine, changed: Any) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            assert at.app.leaving.lost() == []
            await changed(at)
            await at.press("ctrl+q")
            assert "You have unsaved work" in at.screen() and "RViz" in at.screen()
            at.app.look.texts.language = "zh"
            await at.press("escape", "ctrl+q")
            assert "RViz 的设置还没保存，退出就没有了" in at.screen()
            await at.press("escape", "ctrl+s")
            await at.settle()
            assert at.app.leaving.lost() == []

    run(walk())


def test_the_mouse_turns_the_view_beside_the_edge_and_the_edge_turns_nothing(machine: RVizMachine) -> None:
    async def walk() -> None:
        async with walking(machine) as at:
            edge = at.pane.division.panel.width + 1
            for x, turned in ((edge, False), (edge + 1, True)):
                yaw = machine.rviz.view.child("Yaw").value
                for kind, column in ((events.MouseDown, x), (events.MouseMove, x + 8), (events.MouseUp, x + 8)):
                    at.pane.post_message(mouse(at.pane, kind, column, 5, 1, False, False))
                    await at.pilot.pause()
                assert (machine.rviz.view.child("Yaw").value != yaw) is turned

    run(walk())
