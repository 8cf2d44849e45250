"""The card of a message over the desktop: F1 and a click open it, Enter types its command, F1 goes on to the manual."""

from __future__ import annotations

import pytest

from day6_tui.overlays.card import CardModal
from day6_tui.overlays.manual import Manual
from tests.tui.screens import screen_lines, screen_text
from tests.tui.test_real_desk import _shows, _type, opened, until

SLIP = "ros2 run turtlesm turtlesim_node"


def line_typed(app) -> str:
    """What stands after the last prompt of the terminal."""
    return app.terminals.current.view.terminal.screen.text.rstrip().rpartition("$")[2].strip()


async def fail(app, pilot, command: str = SLIP, told: str = "not found") -> None:
    await until(app, pilot, _shows(app, "student@day6:~$"))
    app.desktop.focus_pane(app.terminals.current)
    _type(app, f"{command}\r")
    await until(app, pilot, lambda: told in screen_text(app) and app.terminals.current.view.terminal.idle)


async def test_f1_opens_the_card_enter_types_its_command_and_return_is_the_pupils(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await fail(app, pilot)
        await pilot.press("f1")
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, CardModal))
        text = screen_text(app)
        assert "Package 'turtlesm' not found" in text and "ros2 run turtlesim turtlesim_node" in text
        await pilot.press("enter")
        await until(app, pilot, lambda: line_typed(app) == "ros2 run turtlesim turtlesim_node")
        assert app.desktop.overlay is None and not app.terminals.current.view.terminal.busy
        assert len(app.terminals.current.view.terminal.runs.all) == 1  # nothing was run
        assert app.desktop.focused_pane is app.terminals.current


async def test_a_line_that_was_begun_gives_way_to_the_command(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await fail(app, pilot)
        _type(app, "half a li")
        await until(app, pilot, lambda: line_typed(app) == "half a li")
        await pilot.press("f1", "enter")
        await until(app, pilot, lambda: line_typed(app) == "ros2 run turtlesim turtlesim_node")


async def test_f1_again_is_the_manual_and_esc_closes_the_card(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await fail(app, pilot)
        await pilot.press("f1")
        assert isinstance(app.desktop.overlay, CardModal)
        await pilot.press("f1")
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, Manual))
        await pilot.press("f1")
        await until(app, pilot, lambda: app.desktop.overlay is None)
        await pilot.press("f1", "escape")
        await until(app, pilot, lambda: app.desktop.overlay is None)
        await until(app, pilot, lambda: line_typed(app) == "")  # the prompt may come after the message


async def test_f1_is_the_manual_where_the_last_command_went_well(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await fail(app, pilot)
        await fail(app, pilot, "echo all well", "all well")
        await pilot.press("f1")
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, Manual))


async def test_a_selected_line_is_explained_instead_of_the_last_one(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await fail(app, pilot, "clear; ros2 run turtlesm x; ls nothing_here", "cannot access")
        pane = app.terminals.current
        y = next(n for n, line in enumerate(screen_lines(app)) if "Package 'turtlesm'" in line)
        top = pane.region.y
        await pilot.mouse_down(pane, offset=(1, y - top))
        await pilot.hover(pane, offset=(40, y - top))
        await pilot.mouse_up(pane, offset=(40, y - top))
        assert app.desktop.overlay is None and "turtlesm" in app.clipboard  # dragging selects, as ever
        await pilot.press("f1")
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, CardModal))
        assert "turtlesm" in app.desktop.overlay._shown.line


@pytest.mark.parametrize(("told", "opens"), [("Package 'turtlesm'", True), ("student@day6:~$ ros2", False)])
async def test_a_click_opens_the_card_of_the_line_that_has_one(tmp_path, told: str, opens: bool) -> None:
    async with opened(tmp_path, 60, 30) as (app, pilot):
        await fail(app, pilot)
        pane = app.terminals.current
        y = next(n for n, line in enumerate(screen_lines(app)) if told in line)
        await pilot.click(pane, offset=(3, y - pane.region.y))
        await pilot.pause()
        assert isinstance(app.desktop.overlay, CardModal) == opens


async def test_a_line_that_is_wrapped_is_clicked_as_one(tmp_path) -> None:
    async with opened(tmp_path, 50, 40) as (app, pilot):
        text = "Could not find a connection between 'aaaaaaaaaa' and 'bbbbbbbbbb' because they are not part of the same tree. Tf"
        (tmp_path / "told").write_text(text + "\n")
        await fail(app, pilot, "clear; cat told", "same tree")
        pane = app.terminals.current
        lines = screen_lines(app)
        y = max(n for n, line in enumerate(lines) if "the same tree" in line or "tree. Tf" in line)
        await pilot.click(pane, offset=(3, y - pane.region.y))
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, CardModal))
        assert app.desktop.overlay._shown.line.startswith("Could not find a connection between 'aaaaaaaaaa'")


@pytest.mark.parametrize(
    ("error", "means"),
    [
        ("ValueError: invalid method signature", "has no self in its brackets"),
        ("__main__.Boom: signature", "An error that the program didn't handle"),
    ],
)
async def test_a_clicked_error_has_the_card_for_where_it_came_from(tmp_path, error: str, means: str) -> None:
    async with opened(tmp_path, 60, 30) as (app, pilot):
        places = ("/home/me/a.py", "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/timer.py")
        lines = "".join(f'  File "{place}", line 3, in f\n    f()\n' for place in places)
        (tmp_path / "told").write_text(f"Traceback (most recent call last):\n{lines}{error}\n")
        await fail(app, pilot, "clear; cat told", "signature")
        pane = app.terminals.current
        y = next(n for n, line in enumerate(screen_lines(app)) if error in line)
        await pilot.click(pane, offset=(3, y - pane.region.y))
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, CardModal))
        assert means in app.desktop.overlay._shown.means


async def test_a_command_goes_to_another_terminal_while_a_program_runs_in_this_one(tmp_path) -> None:
    async with opened(tmp_path) as (app, pilot):
        await until(app, pilot, _shows(app, "student@day6:~$"))
        pane = app.terminals.current
        app.desktop.focus_pane(pane)
        _type(app, "ros2 run turtlesm x; sleep 1000\r")
        await until(app, pilot, lambda: "not found" in screen_text(app) and pane.view.terminal.busy)
        await pilot.press("f1", "enter")
        await until(app, pilot, lambda: app.terminals.current is not pane and "turtlesim" in line_typed(app))
        assert pane.view.terminal.busy


@pytest.mark.parametrize(("width", "height"), [(80, 24), (120, 40), (40, 12)])
async def test_the_command_stays_in_sight_and_the_text_scrolls(tmp_path, width: int, height: int) -> None:
    async with opened(tmp_path, width, height) as (app, pilot):
        await fail(app, pilot, "ros2 run no_pkg x", "no_pkg")
        await pilot.press("f1")
        await until(app, pilot, lambda: isinstance(app.desktop.overlay, CardModal))
        modal = app.desktop.overlay
        frame = modal.query_one("#frame").region
        assert frame.right <= width and frame.bottom <= height
        assert "Type next" in screen_text(app)
        seen = set()
        for _ in range(30):
            seen.update(screen_lines(app))
            await pilot.press("down")
            await pilot.pause()
        whole = " ".join(seen)
        assert "What it means" in whole and "Why here" in whole and "On a real robot" in whole
