"""The kitchen's window on a stepped desktop: what it draws of a graph, what it explains, keys and the mouse."""

from __future__ import annotations

import re
import time
from collections.abc import Awaitable, Callable
from time import thread_time  # by name: what the window asks is stepped
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.graph import EndpointKind, Graph, Node
from day6_core.graph.qos import Durability, QoS
from day6_core.ros.programs.day6_kitchen.model import Kitchen
from tests.tui.screens import ToolWindow, is_drawn_in_ascii, screen_lines, step, use_window

TWIST, POSE, STRING, INT = "geometry_msgs/msg/Twist", "turtlesim/msg/Pose", "std_msgs/msg/String", "std_msgs/msg/Int32"


PLATE = "▀███▀"
"""The lower line of a dish with a Twist, where a belt has lines enough."""


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

    def belt(self, topic: str) -> list[str]:
        """The lines of a belt below its words, down to where it runs."""
        lines = self.lines()
        first = next(index for index, line in enumerate(lines) if topic in line) + 1
        last = next(index for index, line in enumerate(lines) if index >= first and ("═" in line or "·" in line))
        return lines[first : last + 1]

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
            assert is_drawn_in_ascii(text)

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
        assert PLATE in window.belt("cmd_vel")[1]
        await window.press("f8")
        await window.after(0.2)
        assert "cmd_vel (T)" in window.text

    use(lab, act, (80, 24))


def test_a_dish_moves_only_when_a_message_has_passed() -> None:
    lab = turtle()
    publisher = lab.graph.endpoints(EndpointKind.PUBLISHER, topic="/turtle1/cmd_vel")[0]

    async def act(window: _Window) -> None:
        for _ in range(5):
            await window.after(0.5)
            assert PLATE not in "".join(window.belt("cmd_vel"))
        publisher.publish(object())
        places = []
        for _ in range(30):
            await window.after(0.1)
            places.append(window.belt("cmd_vel")[1].find(PLATE))
        moving = [place for place in places if place >= 0]
        assert moving == sorted(moving) and moving[0] < moving[-1] and places[-1] == -1
        assert window.belt("cmd_vel")[2].index("►") - moving[-1] <= 8, "it gets as far as the cook who takes it"

    use(lab, act)


def test_with_less_motion_no_dish_moves_and_the_rate_is_told() -> None:
    lab = turtle()
    publisher = lab.graph.endpoints(EndpointKind.PUBLISHER, topic="/turtle1/cmd_vel")[0]

    async def act(window: _Window) -> None:
        for _ in range(30):
            publisher.publish(object())
            await window.after(0.1)
        assert PLATE not in "".join(window.belt("cmd_vel"))
        assert "Twist 10/s" in window.line("cmd_vel"), window.text

    use(lab, act, reduced_motion=True)


def test_a_cook_who_expects_another_shape_visibly_cannot_take_it() -> None:
    async def act(window: _Window) -> None:
        assert "{S} String wrong shape" in window.line("/chatter")
        assert "×[I]" in window.belt("/chatter")[-1] and "►" not in window.belt("/chatter")[-1]
        assert "belts that do not work: 1" in window.text
        await window.press("enter")
        assert "the hatch of /listener only fits [I]: nothing gets in" in window.text
        assert f"/talker publishes {STRING}" in window.text

    use(mismatch(), act, (120, 24))


def test_terms_that_do_not_match_are_marked_too() -> None:
    lab = Lab()
    lab.says("talker", "/map", STRING, QoS(durability=Durability.VOLATILE))
    lab.hears("late", "/map", STRING, QoS(durability=Durability.TRANSIENT_LOCAL))
    lab.hears("early", "/map", STRING)

    async def act(window: _Window) -> None:
        row = window.belt("/map")[-1]
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
        assert "=2=" in window.text and "×=1=" in window.text, "no letter of theirs is one of ours"

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


def looks_left(window: _Window, topic: str) -> int:
    return "".join(window.belt(topic)).count("<P>")


def test_what_nobody_takes_piles_up_at_the_end_of_the_belt_with_its_number() -> None:
    lab = turtle()
    publisher = lab.graph.endpoints(EndpointKind.PUBLISHER, topic="/turtle1/pose")[0]

    async def act(window: _Window) -> None:
        await window.after(1)
        assert not looks_left(window, "/turtle1/pose") and "left" not in window.line("/turtle1/pose")
        for count in (1, 2, 3, 4):
            publisher.publish(object())
            await window.after(1)
            assert f"nobody takes: {count} left" in window.line("/turtle1/pose"), window.text
            assert looks_left(window, "/turtle1/pose") == min(count, 3)
        ear = lab.hears("listener", "/turtle1/pose", POSE)
        await window.after(1)
        await window.after(1)
        assert "left" not in window.line("/turtle1/pose")
        ear.destroy()

    use(lab, act, (120, 24))


def many() -> Lab:
    lab = Lab()
    for number in range(12):
        lab.says(f"cook_{number:02}", f"/topic_{number:02}", STRING)
        lab.hears(f"cook_{number + 1:02}", f"/topic_{number:02}", STRING)
    return lab


@pytest.mark.parametrize("size", [(80, 24), (40, 24), (40, 12)])
@pytest.mark.parametrize("glyphs", ["half", "ascii"])
def test_cooks_and_belts_that_have_no_room_are_counted_with_the_key_that_shows_them(size, glyphs) -> None:
    async def act(window: _Window) -> None:
        await window.after(1)
        right, left = ("→", "←") if glyphs == "half" else ("Right", "Left")
        told = re.search(rf" {right} +\+(\d+) cooks +PgDn +\+\d+ belts", window.line("PgDn"))
        assert told, window.text
        seen = window.line("cook_").count("cook_")
        assert seen and int(told[1]) == 13 - seen, window.text
        await window.press(
            *["right"] * 13, "enter"
        )  # without the explanation, which has the last lines of a small window
        assert f" {left} " in window.line(" cooks") and f" {right} " not in window.text, window.text

    use(many(), act, size, glyphs=glyphs)


def test_a_click_on_what_is_not_seen_is_the_key_and_goes_on_from_what_is_seen() -> None:
    async def act(window: _Window) -> None:
        await window.click(" PgDn ")
        assert " PgUp " in window.text
        for _ in range(13):
            if " → " in window.text:
                await window.click(" → ")
        assert " → " not in window.text and "cook_12" in window.text
        await window.press("escape", "left")
        assert "/cook_12 is a cook" in window.text
        await window.press(*["left"] * 6, "escape", "right")
        assert "/cook_06 is a cook" in window.text, "the first one that is seen"

    use(many(), act, (80, 24))


@pytest.mark.parametrize(
    ("size", "rows"), [((80, 24), 8), ((80, 15), 5), ((80, 10), 3), ((80, 9), 2), ((40, 24), 8), ((22, 7), 0)]
)
def test_cooks_are_figures_as_large_as_the_room_allows_and_never_cut(size: tuple[int, int], rows: int) -> None:
    lab = Lab()
    lab.says("talker", "/chatter", STRING)
    lab.hears("listener", "/chatter", STRING)

    async def act(window: _Window) -> None:
        figure = window.pane._plan.figure
        assert len(figure.rows) == rows, window.text
        for line in figure.rows:
            assert window.text.count(line.strip()) >= 2, window.text
        for cook in ("talker", "listener"):
            assert cook in window.text, window.text

    use(lab, act, size)


def test_a_command_typed_by_hand_is_named_as_it_was_typed() -> None:
    lab = turtle()
    lab.kitchen._command_of = {1004: ["ros2", "topic", "hz", "/turtle1/pose"]}.get  # type: ignore[assignment]
    lab.hears("_ros2cli_1004", "/turtle1/pose", POSE)

    async def act(window: _Window) -> None:
        await window.after(1)
        assert "ros2 topic hz" in window.text and "_ros2cli" not in window.text
        await window.click("ros2 topic hz")
        assert "ros2 topic hz is a cook" in window.text and "ROS: node /_ros2cli_1004" in window.text
        await window.click("/turtle1/pose")
        assert "from /turtlesim to ros2 topic hz." in window.text and "subscribers: /_ros2cli_1004" in window.text

    use(lab, act, (120, 40))


@pytest.mark.parametrize("size", [(20, 7), (40, 12), (80, 24), (120, 40)])
@pytest.mark.parametrize("glyphs", ["half", "ascii"])
@pytest.mark.parametrize("terminal", [{}, {"NO_COLOR": "1"}, {"TERM": "linux"}], ids=["colours", "none", "sixteen"])
def test_fifty_nodes_with_names_of_any_length_and_a_hundred_topics_are_drawn(
    size: tuple[int, int], glyphs: str, terminal: dict[str, str]
) -> None:
    lab = Lab()
    for number in range(50):
        name = (f"n{number}_{'x' * 200}", f"节点_{number}_很长很长的名字", f"n{number}")[number % 3]
        lab.says(name, f"/话题/{number}", f"包_msgs/msg/类型{number}")
        lab.says(name, f"/{'t' * 200}_{number}", STRING)
        lab.hears("listener", f"/话题/{number}", STRING if number % 5 == 0 else f"包_msgs/msg/类型{number}")

    async def act(window: _Window) -> None:
        for publisher in lab.graph.endpoints(EndpointKind.PUBLISHER):
            publisher.publish(object())
        await window.after(1)
        for key in ("enter", "down", "right", "pagedown", "left", "up", "pageup", "h", "escape"):
            await window.press(key)
            await window.after(0.3)
            assert all(cell_len(line) <= size[0] for line in screen_lines(window.app)), window.text
        assert type(window.pane).__name__ == "KitchenPane" and not window.pane._failed

    use(lab, act, size, glyphs=glyphs, environ={"LANG": "C.UTF-8", **terminal})
