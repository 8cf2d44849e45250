"""The topic monitor's window on a stepped desktop: a tree with columns, by keyboard and mouse."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import ParameterEvent
from rich.cells import cell_len
from std_msgs.msg import Float64MultiArray, String

from day6_core.ros.programs.rqt_topic import fields as reading
from day6_core.ros.programs.rqt_topic.model import MonitoredEndpoint, Topic
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

TALKER = (MonitoredEndpoint("/talker", "RELIABLE VOLATILE KEEP_LAST (10)"),)


def topic(name: str, kind: str = "std_msgs/msg/String", **more: Any) -> Topic:
    return Topic(name, (kind,), TALKER, (), **more)


class Model:
    """A topic monitor whose topics and messages the test sets."""

    def __init__(self, *topics: Topic) -> None:
        self.version = 1
        self.topics = topics
        self.messages: dict[str, Any] = {}
        self.read: list[str] = []
        self.toggled: list[str] = []

    def set(self, *topics: Topic) -> None:
        self.topics = topics
        self.version += 1

    def last_message(self, name: str) -> Any:
        self.read.append(name)
        return self.messages.get(name)

    def toggle(self, name: str) -> None:
        self.toggled.append(name)


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the window in which a text stands."""
        return next((line for line in screen_lines(self.app)[1:-1] if text in line), "")

    def order(self) -> list[str]:
        """The names of the topics, from above."""
        return [line.split("] ")[1].split()[0] for line in screen_lines(self.app) if "] /" in line]

    async def click(self, text: str, into: int = 0) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y and text in line)
        x = cell_len(lines[y][: lines[y].index(text)]) + into
        await self.pilot.click(offset=(x, y))
        await step(self.app, self.pilot)

    async def change(self, *topics: Topic) -> None:
        self.model.set(*topics)
        await step(self.app, self.pilot)


def use(
    model: Model, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (120, 40), **options: Any
) -> None:
    """Open the topic monitor and do something with it."""
    use_window(("topics", "Topic Monitor", model), act, size, _Window, **options)


def heard() -> Model:
    """A model with a String and a Twist, both listened to, and a topic that is not."""
    model = Model(
        topic("/chatter", monitored=True, count=3, rate=2.0, bandwidth=60.0),
        topic("/cmd_vel", "geometry_msgs/msg/Twist", monitored=True, count=9, rate=62.5, bandwidth=3250.0),
        topic("/rosout", "rcl_interfaces/msg/Log"),
    )
    twist = Twist()
    twist.linear.x, twist.angular.z = 2.0, -0.5
    model.messages = {"/chatter": String(data="Hello 7"), "/cmd_vel": twist}
    return model


def test_the_columns_are_those_of_rqt_topic() -> None:
    async def act(window: _Window) -> None:
        assert window.line("Bandwidth").strip("┃").split() == ["Topic", "▲", "Type", "Bandwidth", "Hz", "Value"]
        row = window.line("/chatter").strip("┃ ")
        assert row.split() == [
            "▸",
            "[x]",
            "/chatter",
            "std_msgs/msg/String",
            "60",
            "B/s",
            "2.00",
            "data:",
            "Hello",
            "7",
        ]
        assert "3.25 kB/s" in window.line("/cmd_vel") and "62.50" in window.line("/cmd_vel")
        assert "not monitored" in window.line("/rosout")

    use(heard(), act)


def test_the_whole_line_of_the_cursor_is_marked() -> None:
    async def act(window: _Window) -> None:
        tree = window.pane.focus_target
        assert window.app.screen.focused is tree
        choice = window.app.look.colours.choice
        for line, marked in ((0, True), (1, False)):
            seen = tree.render_line(line).crop(0, tree.scrollable_content_region.width)
            styles = {(each.style.color, each.style.bgcolor) for each in seen}
            assert (styles == {(choice.color, choice.bgcolor)}) is marked

    use(heard(), act)


@pytest.mark.parametrize(("size", "kind"), [((40, 10), False), ((60, 12), True), ((80, 24), True), ((120, 40), True)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_value_is_seen_at_every_size(size: tuple[int, int], kind: bool, lang: str) -> None:
    async def act(window: _Window) -> None:
        assert "data: Hello" in window.line("/chatter") and "2.00" in window.line("/chatter")
        assert ("String" in window.line("/chatter")) is kind
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))

    use(heard(), act, size, lang=lang)


def test_the_keyboard_opens_a_message_to_its_numbers_and_closes_it() -> None:
    async def act(window: _Window) -> None:
        await window.press("down", "right")
        assert "geometry_msgs/Vector3" in window.line("linear  ") and "x: 2.0, y: 0.0" in window.line("linear  ")
        await window.press("down", "right")
        assert window.line(" x ").split()[1:] == ["x", "double", "2.0", "┃"]
        await window.press("left")
        assert not window.line(" x ")
        await window.press("left", "left")
        assert not window.line("linear  ")

    use(heard(), act)


def test_an_open_field_follows_the_messages() -> None:
    async def act(window: _Window) -> None:
        await window.press("right")
        assert "Hello 7" in window.line("data  ")
        window.model.messages["/chatter"] = String(data="Hello 8")
        await window.change(topic("/chatter", monitored=True, count=4))
        assert "Hello 8" in window.line("data  ") and "Hello 8" in window.line("/chatter")

    use(heard(), act)


def test_an_open_topic_tells_who_is_at_its_ends() -> None:
    async def act(window: _Window) -> None:
        await window.press("right")
        assert "1" in window.line("publishers") and "0" in window.line("subscriptions")
        await window.click("▸ publishers")
        assert "RELIABLE VOLATILE KEEP_LAST (10)" in window.line("/talker")

    use(heard(), act, (140, 40))


def test_a_topic_nobody_listens_to_shows_its_fields_without_values() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "right")
        assert window.line("level").split()[1:] == ["level", "uint8", "┃"]

    use(heard(), act)


def test_enter_and_a_click_on_the_box_listen_and_a_click_on_the_name_only_chooses() -> None:
    async def act(window: _Window) -> None:
        await window.press("enter")
        assert window.model.toggled == ["/chatter"]
        await window.click("[ ] /rosout", 1)
        assert window.model.toggled == ["/chatter", "/rosout"]
        await window.click("/cmd_vel", 2)
        assert window.model.toggled == ["/chatter", "/rosout"]
        assert "2/3" in window.text

    use(heard(), act)


def test_a_click_on_the_opener_opens() -> None:
    async def act(window: _Window) -> None:
        await window.click("▸ [x] /cmd_vel")
        assert window.line("linear") and window.line("angular") and window.model.toggled == []

    use(heard(), act)


def test_s_and_a_click_on_a_head_sort() -> None:
    async def act(window: _Window) -> None:
        assert window.order() == ["/chatter", "/cmd_vel", "/rosout"]
        await window.click("Hz")
        assert window.order() == ["/cmd_vel", "/chatter", "/rosout"] and "Hz ▼" in window.text
        await window.click("Hz")
        assert window.order() == ["/rosout", "/chatter", "/cmd_vel"] and "Hz ▲" in window.text
        await window.press("s")
        assert window.order() == ["/chatter", "/cmd_vel", "/rosout"]
        await window.press("S")
        assert window.order() == ["/rosout", "/cmd_vel", "/chatter"]
        await window.press("s")
        assert window.order() == ["/cmd_vel", "/rosout", "/chatter"] and "Type ▲" in window.text

    use(heard(), act)


def test_the_cursor_stays_with_its_topic_when_the_order_changes() -> None:
    async def act(window: _Window) -> None:
        await window.press("down", "S", "enter")
        assert window.model.toggled == ["/cmd_vel"]

    use(heard(), act)


def test_a_filter_leaves_topics_out_until_escape() -> None:
    async def act(window: _Window) -> None:
        await window.press("slash", *"twist", "enter")
        assert window.order() == ["/cmd_vel"] and "1/1 of 3, filter: twist" in window.text
        await window.press("slash", *"zzz", "enter")
        assert window.order() == [] and "No topic matches" in window.text
        await window.press("escape")
        assert len(window.order()) == 3

    use(heard(), act)


def test_a_topic_that_vanishes_while_it_is_chosen_leaves_the_cursor_beside_it() -> None:
    async def act(window: _Window) -> None:
        await window.press("down", "right", "down", "down")
        await window.change(topic("/chatter"), topic("/rosout"))
        assert "linear" not in window.text
        await window.press("enter")
        assert window.model.toggled == ["/rosout"]
        await window.change()
        assert "There are no topics yet" in window.text
        await window.press("enter", "down", "right")
        await window.change(topic("/new"))
        assert window.order() == ["/new"]
        await window.press("enter")
        assert window.model.toggled == ["/rosout", "/new"]

    use(heard(), act)


def test_what_was_open_is_open_again_when_a_topic_comes_back() -> None:
    async def act(window: _Window) -> None:
        await window.press("down", "right")
        await window.change(topic("/chatter"))
        await window.change(topic("/chatter"), topic("/cmd_vel", "geometry_msgs/msg/Twist"))
        assert window.line("linear")

    use(heard(), act)


def test_of_two_hundred_topics_only_those_in_sight_are_read() -> None:
    names = [f"/topic_{number:03}" for number in range(200)]

    async def act(window: _Window) -> None:
        assert set(window.model.read) == set(names[: len(window.order())])
        await window.press("end")
        assert "200/200" in window.text and window.order()[-1] == names[-1]
        assert "data: 199" in window.line(names[-1])
        assert names[100] not in window.model.read

    model = Model(*(topic(name, monitored=True, count=1) for name in names))
    model.messages = {name: String(data=str(number)) for number, name in enumerate(names)}
    use(model, act, (80, 24))


def test_of_a_large_message_only_what_is_seen_becomes_text(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[int] = []
    real = reading.summary
    monkeypatch.setattr(reading, "summary", lambda *given: made.append(len(real(*given))) or real(*given))

    async def act(window: _Window) -> None:
        assert "layout: {dim: []" in window.line("/big")
        await window.press("right", "down", "down", "right")
        assert "0.5" in window.line("[0]")
        await window.press("end")
        assert "[100] ... [124999]" in window.text
        assert 0 < sum(made) < 20_000

    model = Model(topic("/big", "std_msgs/msg/Float64MultiArray", monitored=True, count=1))
    model.messages = {"/big": Float64MultiArray(data=[0.5] * 125_000)}
    use(model, act)


@pytest.mark.parametrize("glyphs", ["half", "ascii"])
def test_hostile_bytes_and_chinese_stay_in_their_columns(glyphs: str) -> None:
    text = "海龟\x1b]0;owned\x07\u202e小车" * 40

    async def act(window: _Window) -> None:
        assert not set("\x1b\x07\u202e") & set(window.text)
        row = window.line("/chatter")
        assert cell_len(row) == 80 and ("…" if glyphs == "half" else "~") in row
        assert "海龟^[]0;" in row and (glyphs == "half" or not set("…·▸▾│") & set(row))

    model = Model(topic("/chatter", monitored=True, count=1))
    model.messages = {"/chatter": String(data=text)}
    use(model, act, (80, 24), glyphs=glyphs)


def test_a_message_that_cannot_be_read_says_why() -> None:
    async def act(window: _Window) -> None:
        assert "no such message" in window.line("/chatter")
        await window.press("right")
        assert "string" in window.line("data")

    use(Model(topic("/chatter", monitored=True, count=1, problem="11 bytes are no such message")), act)


def test_a_type_that_is_unknown_here_can_be_opened_all_the_same() -> None:
    async def act(window: _Window) -> None:
        await window.press("right")
        assert window.line("publishers")

    use(Model(topic("/strange", "strange_msgs/msg/Thing")), act)


def test_a_click_on_the_first_topic_is_none_on_the_cross_of_the_frame() -> None:
    async def act(window: _Window) -> None:
        cross = screen_lines(window.app)[1].index("×")
        first = next(y for y, line in enumerate(screen_lines(window.app)) if "] /" in line)
        for x in (cross, cross - 1, cross + 1):
            await window.pilot.click(offset=(x, first))
            await step(window.app, window.pilot)
        assert "/chatter" in window.text

    use(heard(), act)


def test_a_sequence_in_a_narrow_column_keeps_its_brackets() -> None:
    model = Model(topic("/parameter_events", "rcl_interfaces/msg/ParameterEvent", monitored=True, count=1))
    model.messages = {"/parameter_events": ParameterEvent()}

    async def act(window: _Window) -> None:
        await window.press("right")
        assert window.line("new_parameters").split()[2].startswith("sequence<Par")

    use(model, act, (80, 24))


def test_the_feedback_of_an_action_can_be_opened_to_its_fields_with_a_message_and_without() -> None:
    from example_interfaces.action import Fibonacci

    kind = "example_interfaces/action/Fibonacci_FeedbackMessage"
    model = Model(topic("/one", kind, monitored=True, count=1), topic("/two", kind))
    message = Fibonacci.Impl.FeedbackMessage()
    message.feedback.sequence = [0, 1, 1, 2]
    model.messages = {"/one": message}

    async def act(window: _Window) -> None:
        await window.press("end", "right", "down", "down", "right")
        assert window.line("sequence").split()[:3] == ["┃", "sequence", "sequence<int32>"]
        await window.press("home", "right", "down", "down", "right")
        assert "[0, 1, 1, 2]" in window.line("sequence")

    use(model, act)


def test_where_names_are_long_they_get_the_room_that_values_can_spare() -> None:
    async def act(window: _Window) -> None:
        assert "/fibonacci/_action/status " in window.text and "not monitored" in window.text

    use(Model(topic("/fibonacci/_action/status", "action_msgs/msg/GoalStatusArray")), act, (80, 24))


def test_the_full_name_and_type_of_the_chosen_line_are_told_below() -> None:
    name = "/a_robot/of_the_school/with/a/camera/on/its/left"

    async def act(window: _Window) -> None:
        assert f"1/1 {name} sensor_msgs/msg/Image" in screen_lines(window.app)[-2]
        await window.press("right", "down")
        assert f"{name}/header std_msgs/Header" in screen_lines(window.app)[-2]

    use(Model(topic(name, "sensor_msgs/msg/Image")), act, (80, 24))


def test_v_shows_the_whole_value_or_else_what_the_type_is() -> None:
    text = "千里之行，始于足下。" * 20

    async def act(window: _Window) -> None:
        copied: list[str] = []
        window.app.copy_to_clipboard = copied.append  # type: ignore[method-assign]
        await window.press("v", "c")
        assert copied[-1].strip() == f"data: {text}"
        assert sum(line.count("千") for line in screen_lines(window.app)) == 20
        await window.press("escape", "right", "down", "v", "c")
        assert copied[-1] == text and "━ /chatter/data ━" in window.text
        await window.press("escape", "end", "v")
        assert "━ action_msgs/msg/GoalInfo ━" in window.text and "builtin_interfaces/Time stamp" in window.text
        await window.press("escape")
        assert "/quiet" in window.text

    model = Model(topic("/chatter", monitored=True, count=1), topic("/quiet", "action_msgs/msg/GoalInfo"))
    model.messages = {"/chatter": String(data=text)}
    use(model, act, (80, 24))


@pytest.mark.parametrize("width", [44, 80])
def test_what_is_opened_on_the_last_line_in_sight_comes_into_sight(width: int) -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "right")
        await step(window.app, window.pilot)
        assert window.line("data") and window.line("subscriptions")

    use(Model(*(topic(f"/topic{number:02}") for number in range(40))), act, (width, 24))


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("size", [(80, 24), (120, 40)])
def test_the_mouse_can_do_what_the_keys_can(lang: str, size: tuple[int, int]) -> None:
    async def act(window: _Window) -> None:
        texts = window.app.look.texts
        await window.click(f" {texts('topics.sort')}", into=2)
        assert window.line("▲").index("▲") > window.line("/chatter").index("/chatter") + 10
        await window.click(f" {texts('topics.view')}", into=2)
        assert "data: Hello 7" in window.text
        await window.press("escape")
        await window.click(f" {texts('topics.filter')}", into=2)
        await window.press(*"cmd", "enter")
        assert window.order() == ["/cmd_vel"]

    use(heard(), act, size, lang=lang)


def test_a_low_window_has_its_lines_for_topics() -> None:
    async def act(window: _Window) -> None:
        assert "Topic ▲" in screen_lines(window.app)[2] and "/chatter" in screen_lines(window.app)[3]

    use(heard(), act, (80, 10))
