"""The browsers of message and service types: trees of fields, and the texts that define them."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.graph import Graph
from day6_core.ros.programs.rqt_msg import rqt_msg
from day6_core.ros.programs.rqt_msg.model import MOST_TREES, TypeBrowser
from day6_core.ros.programs.rqt_srv import rqt_srv
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from tests.tui.screens import ToolWindow, screen_lines, step, use_window


def browser(kind: str, *types: str) -> TypeBrowser:
    """A browser with types, `package/Name`."""
    found = TypeBrowser(kind)
    for each in types:
        package, _, name = each.partition("/")
        found.choose_package(package)
        found.add(name)
    return found


def test_a_message_is_one_tree_named_as_in_rqt() -> None:
    (tree,) = browser("msg", "geometry_msgs/Twist").trees
    assert (tree.name, tree.type) == ("Msg Root", "geometry_msgs/Twist")
    assert [row.path for row in tree.rows][:2] == ["/linear", "/linear/x"]


def test_a_service_is_two_trees_and_an_action_three() -> None:
    trees = browser("srv", "turtlesim/Spawn").trees
    assert [(tree.name, tree.type) for tree in trees] == [
        ("Service Request", "turtlesim/Spawn/Request"),
        ("Service Response", "turtlesim/Spawn/Response"),
    ]
    trees = browser("action", "turtlesim/RotateAbsolute").trees
    assert [tree.name for tree in trees] == ["Action Goal", "Action Result", "Action Feedback"]


def test_packages_without_such_types_are_not_offered() -> None:
    assert "turtlesim" in TypeBrowser("srv").packages() and "geometry_msgs" not in TypeBrowser("srv").packages()
    found = browser("srv", "turtlesim/Spawn")
    assert found.types()[:2] == ["Kill", "SetPen"]


@pytest.mark.parametrize(
    ("kind", "root", "type_name", "words"),
    [
        ("msg", "geometry_msgs/Twist", "geometry_msgs/Twist", "Vector3  linear"),
        ("msg", "geometry_msgs/Twist", "geometry_msgs/Vector3", "float64 x"),
        ("msg", "geometry_msgs/Polygon", "sequence<geometry_msgs/Point32>", "float32 x"),
        ("msg", "geometry_msgs/Twist", "double", "double"),
        ("srv", "turtlesim/Spawn", "turtlesim/Spawn/Response", "---"),
        ("action", "turtlesim/RotateAbsolute", "turtlesim/RotateAbsolute/Goal", "---"),
        ("action", "turtlesim/RotateAbsolute", "nowhere_msgs/Lost", "nowhere_msgs"),
    ],
)
def test_the_text_of_the_type_of_a_line_can_be_read(kind: str, root: str, type_name: str, words: str) -> None:
    assert words in browser(kind, root).text(type_name)


@pytest.mark.parametrize("name", ["Nothing", "", "../String", "\x1b[2J"])
def test_a_type_that_there_is_not_is_said(name: str) -> None:
    found = browser("msg", f"std_msgs/{name}")
    assert found.trees == [] and found.message.startswith("Failed to load class std_msgs/msg/")


def test_a_tree_is_removed_and_the_oldest_go_by_themselves() -> None:
    found = browser("msg", *["std_msgs/String"] * (MOST_TREES + 3))
    assert len(found.trees) == MOST_TREES and found.trees[0].number == 4
    found.remove(4)
    assert found.trees[0].number == 5


@pytest.mark.parametrize(("main", "title"), [(rqt_msg.main, "Message"), (rqt_srv.main, "Service")])
def test_the_programs_open_their_windows(main: Any, title: str) -> None:
    scheduler, display = Scheduler(WorldClock(wall=None)), Display()
    program = Program(Session(scheduler, Graph(), ["rqt"], display=display), main)
    scheduler.advance(0.2)
    (window,) = display.windows
    assert window.title == f"{title} Type Browser" and window.model.packages()
    window.close_by_user()
    scheduler.advance(0.2)
    assert program.status is not None


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the window in which a text stands."""
        return next((line.strip("┃│ ") for line in screen_lines(self.app)[1:-1] if text in line), "")


def use(
    model: TypeBrowser, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any
) -> None:
    """Open a type browser and do something with it."""
    use_window(("type_browser", "Message Type Browser", model), act, size, _Window, **options)


def test_a_package_and_a_type_are_chosen_and_its_fields_shown() -> None:
    async def act(window: _Window) -> None:
        assert "p chooses a package" in window.text
        await window.press("p", *"geometry", "enter")
        await window.press(*"twiststamped", "enter")
        assert window.line("Msg Root").split() == ["▾", "Msg", "Root", "TwistStamped", "geometry_msgs/TwistStamped"]
        assert window.line("frame_id").split() == ["frame_id", "string", "geometry_msgs/TwistStamped/heade…"]

    use(TypeBrowser("msg"), act)


def test_enter_shows_the_text_and_d_removes_the_tree() -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "down", "enter")
        assert "float64 x" in window.text
        await window.press("escape", "d")
        assert window.line("Msg Root") == ""

    use(browser("msg", "geometry_msgs/Twist"), act, (120, 40))


def test_an_array_is_one_line_until_it_is_opened() -> None:
    async def act(window: _Window) -> None:
        await window.press("end")
        assert window.pane.list.chosen.cells == ("covariance", "double[36]", "nav_msgs/Odometry/twist/covariance")
        await window.press("right", "end")
        assert window.pane.list.chosen.cells[2] == "nav_msgs/Odometry/twist/covariance[35]"

    use(browser("msg", "nav_msgs/Odometry"), act, (120, 40))


def test_the_text_and_the_removal_have_buttons_where_there_is_a_tree() -> None:
    async def click(window: _Window, text: str) -> None:
        line = screen_lines(window.app)[2]
        await window.pilot.click(offset=(line.index(text), 2))
        await step(window.app, window.pilot)

    async def act(window: _Window) -> None:
        await click(window, "view text")
        assert "Vector3  linear" in window.text
        await window.press("escape")
        await click(window, "remove")
        assert window.line("Msg Root") == "" and "view text" not in screen_lines(window.app)[2]

    use(browser("msg", "geometry_msgs/Twist"), act)


def test_a_plain_field_is_explained_by_the_text_of_the_type_that_has_it() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "v")
        assert "━ geometry_msgs/Vector3 ━" in window.text and "float64 z" in window.text

    use(browser("msg", "geometry_msgs/Twist"), act)


def test_the_text_of_a_type_can_be_copied_and_only_keys_that_do_something_are_named() -> None:
    async def act(window: _Window) -> None:
        copied: list[str] = []
        window.app.copy_to_clipboard = copied.append  # type: ignore[method-assign]
        await window.press("home", "v")
        assert "Tab" not in window.text.split("\n")[-2] and "c copy" in window.text
        await window.press("c")
        assert "Vector3  linear" in copied[0] and "copied" in window.text
        await window.press("escape")
        assert "Msg Root" in window.text

    use(browser("msg", "geometry_msgs/Twist"), act)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_type_that_is_added_is_seen_and_chosen_however_many_there_are(lang: str) -> None:
    async def act(window: _Window) -> None:
        await window.press("a", *"twist", "enter")
        await step(window.app, window.pilot)
        assert window.pane.list.chosen.cells[1:] == ("geometry_msgs/Twist",) * 2
        assert "geometry_msgs/Twist/angular/z" in window.text

    model = browser("msg", "geometry_msgs/AccelWithCovarianceStamped")
    model.add("PoseWithCovarianceStamped")
    use(model, act, lang=lang)


def test_the_whole_path_and_type_of_a_field_are_told_where_the_columns_are_too_narrow() -> None:
    async def act(window: _Window) -> None:
        await window.press("end")
        told = screen_lines(window.app)[-2]
        assert "trajectory_msgs/MultiDOFJointTrajectory/points" in told
        assert "sequence<trajectory_msgs/MultiDOFJointTrajectoryPoint>" in told

    use(browser("msg", "trajectory_msgs/MultiDOFJointTrajectory"), act, (120, 24))


def test_left_goes_from_a_field_to_its_message_and_right_brings_its_fields_into_sight() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "left")
        assert window.pane.list.chosen.cells[0] == "angular"
        await window.press("left")
        assert not window.line("angular/z")
        await window.press("left", "left")  # the root is closed, too
        await window.press("right")
        await window.press("down", "left", "down", "right")
        await step(window.app, window.pilot)
        assert window.line("Twist/angular/z")

    use(browser("msg", "geometry_msgs/Twist"), act, (80, 10))


def test_a_complaint_is_shown() -> None:
    async def act(window: _Window) -> None:
        assert window.line("Failed to load class")

    use(browser("msg", "std_msgs/Nothing"), act)


@pytest.mark.parametrize("size", [(80, 24), (40, 12), (30, 10), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_no_line_is_wider_than_the_window(size: tuple[int, int], lang: str) -> None:
    async def act(window: _Window) -> None:
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))

    use(browser("srv", "rcl_interfaces/SetParameters"), act, size, lang=lang)
