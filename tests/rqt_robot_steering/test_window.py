"""The window of Robot Steering: what stands in it at which size, and what keys and the mouse request."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest

from day6_core.ros.programs.rqt_robot_steering.model import ANGULAR, LINEAR, MAXIMUM, MINIMUM, Axis
from day6_tui.panes.cells import cell_len
from tests.tui.screens import ToolWindow, use_window


class Model:
    """A model that the test sets; it writes down what the window requests."""

    def __init__(self, **given: Any) -> None:
        self.axes = {LINEAR: Axis(-1000, 1000, 310), ANGULAR: Axis(-3000, 3000, 210)}
        self.topic, self.stamped, self.type = "/turtle1/cmd_vel", False, "geometry_msgs/msg/Twist"
        self.problem, self.heard, self.other_types, self.version = "", 1, (), 1
        self.requests: list[tuple[Any, ...]] = []
        vars(self).update(given)

    def __getattr__(self, name: str) -> Callable[..., object]:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *given: self.requests.append((name, *given))


class SteeringWindow(ToolWindow):
    def at(self, text: str) -> tuple[int, int]:
        """Column and line of the first cell of a text on the screen."""
        lines = self.text.splitlines()
        y = next(y for y, line in enumerate(lines) if text in line)
        return cell_len(lines[y][: lines[y].index(text)]), y

    async def click(self, text: str, into: int = 0) -> None:
        x, y = self.at(text)
        await self.pilot.click(offset=(x + into, y))


def use(
    model: Model, act: Callable[[SteeringWindow], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any
) -> None:
    use_window(("rqt_robot_steering", "Robot Steering", model), act, size, SteeringWindow, **options)


def test_the_keys_are_those_of_the_real_one_and_the_arrows() -> None:
    async def act(window: SteeringWindow) -> None:
        await window.press("w", "s", "a", "d", "W", "S", "A", "D", "x", "z", "X", "Z", "space")
        assert window.model.requests == [
            ("move", LINEAR, 10), ("move", LINEAR, -10), ("move", ANGULAR, 10), ("move", ANGULAR, -10),
            ("move", LINEAR, 100), ("move", LINEAR, -100), ("move", ANGULAR, 100), ("move", ANGULAR, -100),
            ("set", LINEAR, 0), ("set", ANGULAR, 0), ("set", LINEAR, 0), ("set", ANGULAR, 0), ("stop",),
        ]  # fmt: skip
        window.model.requests.clear()
        await window.press("up", "down", "left", "right", "shift+up", "shift+right")
        assert window.model.requests == [
            ("move", LINEAR, 10), ("move", LINEAR, -10), ("move", ANGULAR, 10), ("move", ANGULAR, -10),
            ("move", LINEAR, 100), ("move", ANGULAR, -100),
        ]  # fmt: skip

    use(Model(), act)


def test_topic_and_type_are_set_by_keys() -> None:
    async def act(window: SteeringWindow) -> None:
        await window.press("m", "t", "ctrl+u", *"/cmd", "enter")
        assert window.model.requests == [("set_stamped", True), ("set_topic", "/cmd")]

    use(Model(), act)


def test_tab_chooses_an_end_which_is_typed_or_moved() -> None:
    async def act(window: SteeringWindow) -> None:
        await window.press("tab", "+")
        assert "linear maximum: 1.00" in window.text
        await window.press("tab", "-", "tab", "enter", "ctrl+u", *"12", "enter")
        assert "A number from 0 to 10." in window.text
        await window.press("ctrl+u", *"1.5", "enter", "escape", "+")
        assert window.model.requests == [
            ("set_limit", LINEAR, MAXIMUM, pytest.approx(1.1)),
            ("set_limit", LINEAR, MINIMUM, pytest.approx(-1.1)),
            ("set_limit", ANGULAR, MAXIMUM, 1.5),
        ]

    use(Model(), act)


def test_buttons_and_numbers_can_be_clicked() -> None:
    async def act(window: SteeringWindow) -> None:
        for button in (" w  +", " s  -", " a  <", " d  >", " x  0", " z  0", "Stop", "stamped"):
            await window.click(button, 1)
        assert window.model.requests == [
            ("move", LINEAR, 100), ("move", LINEAR, -100), ("move", ANGULAR, 100), ("move", ANGULAR, -100),
            ("set", LINEAR, 0), ("set", ANGULAR, 0), ("stop",), ("set_stamped", True),
        ]  # fmt: skip
        await window.click("-3.00")
        await window.press("ctrl+u", *"-2", "enter")
        assert window.model.requests[-1] == ("set_limit", ANGULAR, MINIMUM, -2.0)

    use(Model(), act)


def test_sliders_are_dragged_and_what_lies_at_the_left_is_a_turn_to_the_left() -> None:
    async def act(window: SteeringWindow) -> None:
        left, y = window.at("─" * 12)
        await window.pilot.mouse_down(offset=(left, y))
        await window.pilot.hover(offset=(77, y))
        await window.pilot.mouse_up(offset=(77, y))
        requests = window.model.requests
        assert requests[0] == ("set", ANGULAR, 3000) and requests[-1][1] == ANGULAR and requests[-1][2] < -2800
        x, top = window.at("│  1.00")
        await window.pilot.mouse_down(offset=(x, top))
        assert requests[-1] == ("set", LINEAR, 1000)
        await window.pilot.hover(offset=(x, window.at("┼  0.31")[1]))
        assert requests[-1] == ("set", LINEAR, 0)
        await window.pilot.mouse_up(offset=(x, top))

    use(Model(), act)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({}, "subscriptions: 1"),
        ({"heard": 0}, "Nobody subscribes to /turtle1/cmd_vel."),
        ({"topic": ""}, "Nothing is published without a topic."),
        ({"problem": "Invalid topic name: it is\x1b[2J wrong:\n  '/a b'"}, "it is^[[2J wrong"),
        ({"other_types": ("std_msgs/msg/String",)}, "/turtle1/cmd_vel has type std_msgs/msg/String"),
        ({"other_types": ("geometry_msgs/msg/TwistStamped",)}, "m changes that"),
    ],
)
def test_the_truth_about_the_topic_is_told(given, told) -> None:
    async def act(window: SteeringWindow) -> None:
        assert told in window.text

    use(Model(**given), act)


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (24, 8), (10, 4), (40, 12), (120, 40)])
@pytest.mark.parametrize("options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}])
@pytest.mark.parametrize(
    "axes", [{}, {"axes": {LINEAR: Axis(0, 0), ANGULAR: Axis(-10_000, 0, -10_000)}, "topic": "/名" * 99, "heard": 0}]
)
def test_it_is_drawn_at_every_size(size, options, axes) -> None:
    async def act(window: SteeringWindow) -> None:
        await window.press("tab", "tab")
        assert all(char.isprintable() for line in window.text.splitlines() for char in line)
        if size[0] >= 40:
            assert "m/s" in window.text and "rad/s" in window.text

    use(Model(**axes), act, size, **options)
