"""The Message Publisher's window on a stepped desktop, by keyboard and mouse."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from geometry_msgs.msg import Polygon, Twist
from rich.cells import cell_len
from std_msgs.msg import Bool, String

from day6_core.interfaces import get_message
from day6_core.ros.programs.rqt_publisher.model import ShownPublisher, convert
from day6_core.ros.programs.rqt_py_common.expressions import NAMES
from day6_core.ros.programs.rqt_py_common.message_form import MessageForm
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

TYPES = {"/chatter": "std_msgs/msg/String", "/turtle1/cmd_vel": "geometry_msgs/msg/Twist", "/flag": "std_msgs/msg/Bool"}
TYPES["/area"] = "geometry_msgs/msg/Polygon"
CLASSES = {"std_msgs/msg/String": String, "geometry_msgs/msg/Twist": Twist, "std_msgs/msg/Bool": Bool}
CLASSES["geometry_msgs/msg/Polygon"] = Polygon


class Model:
    """A Message Publisher that only notes what it is asked."""

    def __init__(self) -> None:
        self.version = 1
        self.message = ""
        self.publishers: list[list[Any]] = []
        self.asked: list[tuple[object, ...]] = []

    def topics(self) -> list[tuple[str, str]]:
        return sorted(TYPES.items())

    def shown(self) -> list[ShownPublisher]:
        return [
            ShownPublisher(number, topic, kind, rate, on, form.rows(1), 7, "")
            for number, (topic, kind, rate, on, form) in enumerate(self.publishers)
        ]

    def count_of(self, number: int) -> int:
        return 7

    def add(self, topic: str, kind: str) -> None:
        form = MessageForm(CLASSES.get(kind) or get_message(kind), convert)
        self.publishers.append([topic, kind, 1.0, False, form])
        self.version += 1

    def set_expression(self, number: int, path: str, text: str) -> None:
        form = self.publishers[number][4]
        form.set_if_good(path, text, {**NAMES, "i": 0})
        self.version += 1

    def resize(self, number: int, path: str, step: int) -> None:
        self.asked.append(("resize", number, path, step))

    def set_enabled(self, number: int, enabled: bool) -> None:
        self.publishers[number][3] = enabled
        self.version += 1

    def set_rate(self, number: int, text: str) -> None:
        self.publishers[number][2] = float(text)
        self.version += 1

    def publish_once(self, number: int) -> None:
        self.asked.append(("once", number))

    def remove(self, number: int) -> None:
        self.asked.append(("remove", number))

    def clear(self) -> None:
        self.asked.append(("clear",))


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the window in which a text stands."""
        return next((line.strip("┃│ ") for line in screen_lines(self.app)[1:-1] if text in line), "")

    async def click(self, text: str) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y > 1 and text in line)
        await self.pilot.click(offset=(cell_len(lines[y][: lines[y].index(text)]), y))
        await step(self.app, self.pilot)


def use(
    act: Callable[[_Window], Awaitable[None]], *topics: str, size: tuple[int, int] = (80, 24), **options: Any
) -> Model:
    """Open the Message Publisher with publishers of these topics and do something with it."""
    model = Model()
    for topic in topics:
        model.add(topic, TYPES[topic])
    use_window(("publisher", "Message Publisher", model), act, size, _Window, **options)
    return model


def test_a_topic_is_chosen_published_and_filled_in() -> None:
    async def act(window: _Window) -> None:
        assert "No publishers yet" in window.text
        await window.press("a", *"cmd", "enter")
        assert window.line("/turtle1/cmd_vel").split() == ["▾", "[", "]", "/turtle1/cmd_vel", "Twist", "1.00"]
        await window.press("1", "0", "enter", "space", "down", "down", *"2.5", "tab", *"sin", "enter")
        (topic, _, rate, on, form) = window.model.publishers[0]
        assert (topic, rate, on) == ("/turtle1/cmd_vel", 10.0, True)
        assert form.expressions == {"/linear/x": "2.5"}  # "sin" alone is no number

    use(act)


def test_a_new_topic_gets_a_name_and_a_type() -> None:
    async def act(window: _Window) -> None:
        await window.press("n", *"/greeting", "enter")
        await window.press(*"std_msgs/msg/string", "enter")

    assert [each[:2] for each in use(act).publishers] == [["/greeting", "std_msgs/msg/String"]]


def test_the_name_of_a_topic_that_is_there_brings_its_type() -> None:
    async def act(window: _Window) -> None:
        await window.press("n", *"chatter", "enter")

    assert [each[:2] for each in use(act).publishers] == [["chatter", "std_msgs/msg/String"]]


def test_a_click_on_the_box_publishes_and_stops() -> None:
    async def act(window: _Window) -> None:
        await window.click("[ ]")
        assert window.line("[x] /chatter")
        await window.click("[x]")
        assert window.line("[ ] /chatter")

    use(act, "/chatter")


def test_space_switches_a_boolean_field() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "space")
        assert window.line("data").split() == ["data", "boolean", "True"]
        await window.press("space")
        assert window.line("data").split() == ["data", "boolean", "False"]
        await window.press("up", "space")
        assert window.line("[x] /flag")

    use(act, "/flag")


def test_a_wrong_expression_is_marked() -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "down", "down", *"1+", "enter", "up")
        assert window.line("1+").endswith("▲ 1+") and window.line("▲ error evaluating as")

    use(act, "/turtle1/cmd_vel", size=(120, 40))


def test_the_buttons_are_about_the_publisher_of_the_chosen_line() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "o", "d", "C")
        await window.click("Publish once")

    asked = use(act, "/chatter", "/flag").asked
    assert asked == [("once", 1), ("remove", 1), ("clear",), ("once", 1)]


def test_the_last_i_and_the_last_complaint_are_said() -> None:
    async def act(window: _Window) -> None:
        assert "i = 7" in screen_lines(window.app)[-2]
        window.model.message = "Invalid topic name: x"
        window.model.version += 1
        await window.press("up")
        assert window.line("Invalid topic name: x")

    use(act, "/chatter")


@pytest.mark.parametrize("size", [(80, 24), (40, 12), (30, 10), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_no_line_is_wider_than_the_window(size: tuple[int, int], lang: str) -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "enter")
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))

    use(act, "/chatter", "/turtle1/cmd_vel", size=size, lang=lang)


def test_in_a_narrow_window_types_and_rate_have_room_too() -> None:
    async def act(window: _Window) -> None:
        assert window.line("/cmd_vel").split()[-3:] == ["Twist", "1.00", "Hz"]
        assert window.line("linear").split() == ["▾", "linear", "Vector3"]
        assert window.line("x  ").split() == ["x", "double", "0.0"]
        await window.press("home", "5", "enter", "down")
        assert window.model.publishers[0][2] == 5.0
        assert "geometry_msgs/Vector3" in screen_lines(window.app)[-2]

    use(act, "/turtle1/cmd_vel", size=(42, 20))


@pytest.mark.parametrize("width", [42, 80, 160])
def test_a_wrong_expression_says_all_that_is_wrong_and_what_is_in_force(width: int) -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "down", "down", *"1+", "enter")
        said = " ".join(" ".join(line.strip("┃│ ") for line in screen_lines(window.app)).split())
        assert 'error evaluating as "float": invalid syntax: invalid syntax' in said and "in force: 0.0" in said

    use(act, "/turtle1/cmd_vel", size=(width, 40))


def test_plus_and_minus_change_how_many_elements_a_list_has() -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "down", "+", "+", "-")
        assert window.model.asked == [("resize", 0, "/points", 1)] * 2 + [("resize", 0, "/points", -1)]

    use(act, "/area")


def test_a_remark_is_never_cut() -> None:
    async def act(window: _Window) -> None:
        said = " ".join(line.strip("┃│ ") for line in screen_lines(window.app)[3:])
        assert "choose its topic, then tick its box." in said

    use(act, size=(38, 20))


def test_deep_fields_keep_their_place_and_a_complaint_below_the_last_line_comes_into_sight() -> None:
    async def act(window: _Window) -> None:
        form = window.model.publishers[0][4]
        form.resize("/points", 1, NAMES)
        window.model.version += 1
        await window.press("end", "end", *"1+", "enter")
        lines = screen_lines(window.app)
        (z,) = (line for line in lines if "1+" in line)
        assert z.index("z") > 6 and "force: 0.0" in lines[-3]

    use(act, "/area", size=(42, 10))
