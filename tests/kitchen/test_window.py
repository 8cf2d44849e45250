"""The kitchen's window on a stepped desktop: what it draws of a graph, what it explains, keys and the mouse."""

from __future__ import annotations

import time
from collections.abc import Awaitable, Callable
from time import thread_time  # by name: what the window asks is stepped
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.graph import EndpointKind, Graph, Node
from day6_core.graph.qos import Durability, QoS
from day6_core.ros.programs.day6_kitchen.model import Kitchen
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

TWIST, POSE, STRING, INT = "geometry_msgs/msg/Twist", "turtlesim/msg/Pose", "std_msgs/msg/String", "std_msgs/msg/Int32"


class Lab:
    """A graph on which a test puts nodes, and the kitchen that shows it."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.node("_day6_kitchen_1")
        self.kitchen = Kitchen(self.graph, "_day6_kitchen_1")
        self.graph.add_listener(self.kitchen.on_change)

    def node(self, name: str) -> Node:
        found = self.graph.find_nodes(name, "/")
        return found[0] if found else self.graph.create_node(name)

    def says(self, node: str, topic: str, kind: str, qos: QoS | None = None) -> Any:
        return self.node(node).create_publisher(topic, kind, "", qos or QoS(), lambda message: message)

    def hears(self, node: str, topic: str, kind: str, qos: QoS | None = None) -> Any:
        return self.node(node).create_subscription(topic, kind, "", qos or QoS())


def turtle() -> Lab:
    lab = Lab()
    lab.says("teleop_turtle", "/turtle1/cmd_vel", TWIST)
    lab.hears("turtlesim", "/turtle1/cmd_vel", TWIST)
    lab.says("turtlesim", "/turtle1/pose", POSE)
    return lab


def mismatch() -> Lab:
    lab = Lab()
    lab.says("talker", "/chatter", STRING)
    lab.hears("listener", "/chatter", INT)
    return lab


class _Window(ToolWindow):
    clock = 0.0
    """Behind the clock by which the desktop's own frames look."""

    async def after(self, seconds: float) -> None:
        """Let the window look again so much later."""
        self.clock = max(self.clock, time.monotonic()) + seconds
        self.pane.pull(self.clock)
        await self.pilot.pause()

    def lines(self) -> list[str]:
        return screen_lines(self.app)[1:-1]

    def line(self, text: str) -> str:
        """The first line in which a text stands."""
        return next((line for line in self.lines() if text in line), "")

    async def click(self, text: str) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y and text in line)
        await self.pilot.click(offset=(cell_len(lines[y][: lines[y].index(text)]) + 1, y))
        await step(self.app, self.pilot)


def use(lab: Lab, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any) -> None:
    use_window(("kitchen", "Kitchen", lab.kitchen), act, size, _Window, **options)


@pytest.mark.long
@pytest.mark.parametrize("size", [(36, 14), (80, 24), (120, 40), (40, 10), (200, 60)])
@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize("glyphs", ["half", "braille", "cell", "ascii"])
def test_the_turtles_kitchen_is_drawn_in_every_size_and_with_every_set_of_characters(size, lang, glyphs) -> None:
    async def look(window: _Window) -> None:
        text = window.text
        assert "turtlesim" in text and "teleop_" in text and "cmd_vel (T)" in text, text
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))
        if glyphs == "ascii":
            assert text.isascii()

    use(turtle(), look, size, lang=lang, glyphs=glyphs)


def test_the_window_changes_its_size_while_dishes_are_moving() -> None:
    lab = turtle()
    for topic in ("/turtle1/color_sensor", "/turtle2/color_sensor"):  # too many for an empty line between all of them
        lab.says("turtlesim", topic, "turtlesim/msg/Color")
    publishers = lab.graph.endpoints(EndpointKind.PUBLISHER)

    async def act(window: _Window) -> None:
        await window.after(1)
        for publisher in publishers:
            publisher.publish(object())
        await window.after(0.2)
        await window.after(0.6)
        assert "(T)" in window.lines()[window.lines().index(window.line("cmd_vel")) + 1]
        await window.press("f8")
        await window.after(0.2)
        assert "cmd_vel (T)" in window.text

    use(lab, act, (80, 24))


def test_a_dish_moves_only_when_a_message_has_passed() -> None:
    lab = turtle()
    publisher = lab.graph.endpoints(EndpointKind.PUBLISHER, topic="/turtle1/cmd_vel")[0]

    async def act(window: _Window) -> None:
        def belt() -> str:
            return window.lines()[window.lines().index(window.line("cmd_vel")) + 1]

        for _ in range(5):
            await window.after(0.5)
            assert "(T)" not in belt()
        publisher.publish(object())
        places = []
        for _ in range(30):
            await window.after(0.1)
            places.append(belt().find("(T)"))
        moving = [place for place in places if place >= 0]
        assert moving == sorted(moving) and moving[0] < moving[-1] and places[-1] == -1
        assert belt().index("►") - moving[-1] <= 8, "it gets as far as the cook who takes it"

    use(lab, act)


def test_with_less_motion_no_dish_moves_and_the_rate_is_told() -> None:
    lab = turtle()
    publisher = lab.graph.endpoints(EndpointKind.PUBLISHER, topic="/turtle1/cmd_vel")[0]

    async def act(window: _Window) -> None:
        for _ in range(30):
            publisher.publish(object())
            await window.after(0.1)
        lines = window.lines()
        head = lines.index(window.line("cmd_vel"))
        assert "(T)" not in lines[head + 1]
        assert "Twist 10/s" in lines[head], lines[head]

    use(lab, act, reduced_motion=True)


def test_a_cook_who_expects_another_shape_visibly_cannot_take_it() -> None:
    async def act(window: _Window) -> None:
        lines = window.lines()
        head = next(index for index, line in enumerate(lines) if "/chatter" in line)
        assert "[S] String wrong shape" in lines[head]
        assert "×(I)" in lines[head + 1] and "►" not in lines[head + 1]
        assert "belts that do not work: 1" in window.text
        await window.press("enter")
        assert "the hatch of /listener only fits (I): nothing gets in" in window.text
        assert f"/talker publishes {STRING}" in window.text

    use(mismatch(), act, (120, 24))


def test_terms_that_do_not_match_are_marked_too() -> None:
    lab = Lab()
    lab.says("talker", "/map", STRING, QoS(durability=Durability.VOLATILE))
    lab.hears("late", "/map", STRING, QoS(durability=Durability.TRANSIENT_LOCAL))
    lab.hears("early", "/map", STRING)

    async def act(window: _Window) -> None:
        lines = window.lines()
        row = lines[next(index for index, line in enumerate(lines) if "/map" in line) + 1]
        assert "×QoS" in row and "►" in row, "one of them gets it"
        await window.click("/map")
        assert "the QoS of /talker does not satisfy /late: durability" in window.text

    use(lab, act, (120, 24))


def test_a_belt_nobody_listens_to_and_one_nobody_fills_say_so() -> None:
    lab = Lab()
    lab.says("driver", "/cmd_vle", TWIST)
    lab.hears("robot", "/cmd_vel", TWIST)

    async def act(window: _Window) -> None:
        assert "没人取" in window.line("/cmd_vle ") and "没人放" in window.line("/cmd_vel ")
        await window.click("/cmd_vel ")
        assert "/robot 在传送带 /cmd_vel 旁边等 (T)，但没有人往上放。" in window.text
        assert "发布者（没有人）" in window.text.replace("：", "") or "（没有人）" in window.text

    use(lab, act, (120, 24), lang="zh")


def test_an_empty_kitchen_says_what_to_do() -> None:
    async def act(window: _Window) -> None:
        assert "no node is running" in window.text and "ros2 run turtlesim turtlesim_node" in window.text
        await window.press("up", "down", "left", "right", "enter", "pageup", "escape")
        assert "no node is running" in window.text

    use(Lab(), act)


def test_h_shows_what_is_hidden_but_never_the_kitchen_itself() -> None:
    lab = turtle()
    lab.says("_helper", "/rosout", "rcl_interfaces/msg/Log")

    async def act(window: _Window) -> None:
        assert "hidden: 2" in window.text and "/rosout" not in window.text
        await window.press("h")
        await window.after(1)
        assert "/rosout" in window.text and "_helper" in window.text and "_day6_kitchen" not in window.text
        await window.press("h")
        await window.after(1)
        assert "/rosout" not in window.text

    use(lab, act)


def test_a_click_or_the_keys_explain_a_cook() -> None:
    async def act(window: _Window) -> None:
        await window.click("turtlesim")
        assert "/turtlesim is a cook." in window.text and "ROS: node /turtlesim, publishes 1" in window.text
        await window.press("left")
        assert "/teleop_turtle is a cook. Puts dishes on /turtle1/cmd_vel." in window.text
        await window.press("enter")
        assert "is a cook" not in window.text
        await window.press("enter", "escape")
        assert "is a cook" not in window.text

    use(turtle(), act, (120, 40))


def test_a_large_kitchen_scrolls_to_what_is_chosen() -> None:
    lab = Lab()
    for number in range(12):
        lab.says(f"cook_{number:02}", f"/topic_{number:02}", STRING)
        lab.hears(f"cook_{number + 1:02}", f"/topic_{number:02}", STRING)

    async def act(window: _Window) -> None:
        assert "/topic_00" in window.text and "/topic_11" not in window.text
        await window.press(*["down"] * 12)
        assert "/topic_11" in window.text and "/topic_00" not in window.text
        assert "cook_12" in window.text, "sideways too"
        await window.press(*["left"] * 1, *["left"] * 20)
        assert "cook_00" in window.text
        await window.press("escape", *["pageup"] * 12)
        assert "/topic_00" in window.text

    use(lab, act, (36, 12))


def test_names_are_text_whatever_they_are() -> None:
    lab = Lab()
    lab.says("厨师", "/传送带/很长很长的名字" * 8, "未知/msg/类型")
    lab.hears("x" * 300, "/传送带/很长很长的名字" * 8, "未知/msg/别的")

    async def act(window: _Window) -> None:
        assert all(cell_len(line) <= 60 for line in screen_lines(window.app))
        await window.press("enter")
        assert "[2]" in window.text and "×(1)" in window.text, "no letter of theirs is one of ours"

    use(lab, act, (60, 20))


def test_six_hundred_nodes_hold_nothing_up() -> None:
    lab = Lab()
    for number in range(300):
        lab.says(f"cook_{number}", "/one_for_all", STRING)
        lab.hears(f"guest_{number}", "/one_for_all", INT)
        lab.says(f"cook_{number}", f"/own_{number}", STRING)

    async def act(window: _Window) -> None:
        for _ in range(5):
            began = thread_time()
            await window.after(0.2)
            assert thread_time() - began < 0.5
        await window.press("down", "down", "right", "right")
        assert "cook_" in window.text

    use(lab, act, (120, 40))
