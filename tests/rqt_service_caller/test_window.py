"""The Service Caller's window on a stepped desktop, by keyboard and mouse."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from rich.cells import cell_len
from std_srvs.srv import Empty
from turtlesim.srv import Spawn

from day6_core.ros.programs.rqt_py_common.expressions import NAMES
from day6_core.ros.programs.rqt_py_common.message_form import MessageForm, field_rows
from day6_core.ros.programs.rqt_service_caller.model import convert
from tests.tui.screens import ToolWindow, is_drawn_in_ascii, screen_lines, step, use_window


class Model:
    """A Service Caller whose services and answers the test sets."""

    def __init__(self) -> None:
        self.version = 1
        self.services = (("/clear", "std_srvs/srv/Empty"), ("/spawn", "turtlesim/srv/Spawn"))
        self.service, self.type = "/spawn", "turtlesim/srv/Spawn"
        self.form = MessageForm(Spawn.Request, convert)
        self.response: Any = None
        self.state, self.message, self.waited, self.is_waiting = "", "", 0, False
        self.asked: list[object] = []

    @property
    def request(self) -> Any:
        return self.form.rows(1)

    def set_expression(self, path: str, text: str) -> None:
        self.form.set(path, text)
        self.form.message(NAMES)
        self.version += 1

    def choose(self, name: str) -> None:
        self.asked.append(name)

    def call(self) -> None:
        self.asked.append("call")

    def cancel(self) -> None:
        self.asked.append("cancel")

    def refresh(self) -> None:
        self.asked.append("refresh")

    def be(self, state: str, **values: Any) -> None:
        """Let the last call be in this state."""
        self.state, self.is_waiting = state, state == "waiting"
        for name, value in values.items():
            setattr(self, name, value)
        self.version += 1


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the window in which a text stands."""
        return next((line.strip("┃│ ") for line in screen_lines(self.app)[1:-1] if text in line), "")

    async def click(self, text: str) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y > 1 and text in line)
        await self.pilot.click(offset=(cell_len(lines[y][: lines[y].index(text)]), y))
        await step(self.app, self.pilot)

    async def draw(self) -> None:
        await step(self.app, self.pilot)


def use(act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any) -> Model:
    """Open the Service Caller and do something with it."""
    model = Model()
    use_window(("service_caller", "Service Caller", model), act, size, _Window, **options)
    return model


def test_request_and_response_have_the_columns_of_the_real_one() -> None:
    async def act(window: _Window) -> None:
        assert window.line("Request").split() == ["Request:", "Topic", "Type", "Expression"]
        assert window.line("turtlesim/srv").split() == ["▾", "/spawn", "turtlesim/srv/Spawn"]
        assert window.line("theta").split() == ["theta", "float", "0.0"]
        window.model.be("answered", response=field_rows(Spawn.Response(name="turtle2"), 1))
        await window.draw()
        assert window.line("Response: Field").split() == ["Response:", "Field", "Type", "Value"]
        assert window.line("'turtle2'").split() == ["name", "string", "'turtle2'"]

    use(act)


@pytest.mark.parametrize("by_mouse", [False, True])
def test_the_response_comes_into_sight_where_the_request_fills_the_window(by_mouse: bool) -> None:
    async def act(window: _Window) -> None:
        for name in ("turtle2", "turtle3"):
            await window.press("home", "9", "enter")
            assert f"'{name}'" not in window.text
            await (window.click("Call") if by_mouse else window.press("c"))
            window.model.be("answered", response=field_rows(Spawn.Response(name=name), 1))
            await window.draw()
            await window.draw()
            assert f"'{name}'" in window.text

    use(act, (80, 11))


def test_values_are_typed_one_after_the_other_and_the_service_is_called() -> None:
    async def act(window: _Window) -> None:
        await window.press("1", ".", "0", "tab", "2", "enter")
        await window.press("down", "down", "enter", *"turtle2", "enter", "c")

    model = use(act)
    assert model.form.expressions == {"/x": "1.0", "/y": "2", "/name": "turtle2"} and model.asked == ["call"]


def test_letters_are_text_while_a_value_is_typed_and_keys_before_and_after() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "enter", *"crxs", "enter", "r")

    model = use(act)
    assert model.form.expressions == {"/name": "crxs"} and model.asked == ["refresh"]


def test_the_keys_that_are_named_are_those_that_work() -> None:
    async def act(window: _Window) -> None:
        assert "c Call" in screen_lines(window.app)[-1]
        await window.press("enter")
        assert "c Call" not in screen_lines(window.app)[-1] and "Enter accept" in screen_lines(window.app)[-1]
        await window.press("escape")
        assert "c Call" in screen_lines(window.app)[-1]

    use(act)


def test_escape_leaves_the_old_value_and_delete_brings_back_the_default() -> None:
    async def act(window: _Window) -> None:
        await window.press("5", "enter", "9", "escape")
        assert window.line("x  ").split() == ["x", "float", "5"]
        await window.press("delete")
        assert window.line("x  ").split() == ["x", "float", "0.0"]

    use(act)


def test_what_does_not_fit_is_marked_and_explained_below() -> None:
    async def act(window: _Window) -> None:
        await window.press(*"'fast", "enter")
        assert "▲ failed to evaluate" in window.line("x  ")
        assert "failed to evaluate expression: 'fast" in window.text

    use(act, (120, 40))


def test_a_click_on_a_value_types_over_it_and_one_elsewhere_takes_it() -> None:
    async def act(window: _Window) -> None:
        await window.click("''")
        await window.press(*"bob")
        await window.click("theta")
        assert window.model.form.expressions == {"/name": "bob"}

    use(act)


def test_a_double_click_on_a_value_replaces_all_of_it() -> None:
    async def act(window: _Window) -> None:
        lines = screen_lines(window.app)
        y = next(y for y, line in enumerate(lines) if "name" in line)
        x = cell_len(lines[y][: lines[y].index("''")])
        await window.pilot.double_click(offset=(x + 1, y))
        await window.draw()
        await window.press(*"'turtle2'", "enter")
        assert window.model.form.expressions == {"/name": "'turtle2'"}

    use(act)


def test_the_buttons_do_what_their_keys_do() -> None:
    async def act(window: _Window) -> None:
        await window.click("Call")
        await window.click("Refresh")
        window.model.be("waiting", waited=4)
        await window.draw()
        assert "No response for 4 s." in window.text
        await window.click("Cancel")
        await window.press("x")

    assert use(act).asked == ["call", "refresh", "cancel", "cancel"]


def test_the_service_is_chosen_from_a_list_that_typing_narrows() -> None:
    async def act(window: _Window) -> None:
        await window.press("s", *"cle", "enter")

    assert use(act).asked == ["/clear"]


@pytest.mark.parametrize("state", ["waiting", "cancelled", "gone"])
def test_every_state_is_told(state: str) -> None:
    async def act(window: _Window) -> None:
        before = len(window.text.split())
        window.model.be(state)
        await window.draw()
        assert len(window.text.split()) > before + 2

    use(act)


def test_a_failed_call_is_told_in_the_words_of_rqt() -> None:
    async def act(window: _Window) -> None:
        window.model.be("failed", message='Service "/spawn" is no longer available. Refresh the list of services')
        await window.draw()
        assert window.line("no longer available")

    use(act)


def test_a_branch_is_closed_and_opened() -> None:
    async def act(window: _Window) -> None:
        await window.press("home", "left")
        assert window.line("▸ /spawn") and not window.line("theta")
        await window.press("right")
        assert window.line("theta")
        await window.click("▾ /spawn")
        assert not window.line("theta")

    use(act)


def test_control_characters_in_an_answer_are_written_out() -> None:
    async def act(window: _Window) -> None:
        window.model.be("answered", response=field_rows(Spawn.Response(name="a\x1b[2Jb\nc"), 1))
        await window.draw()
        assert window.line("'a\\x1b[2Jb\\nc'")

    use(act)


@pytest.mark.parametrize("size", [(80, 24), (40, 12), (30, 10), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_no_line_is_wider_than_the_window(size: tuple[int, int], lang: str) -> None:
    async def act(window: _Window) -> None:
        window.model.be("waiting", waited=100)
        await window.press("enter")
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))
        assert "theta" in window.text

    use(act, size, lang=lang)


def test_in_ascii_nothing_else_is_drawn() -> None:
    async def act(window: _Window) -> None:
        assert is_drawn_in_ascii(window.text) and "- /spawn" in window.text

    use(act, glyphs="ascii")


def test_in_a_narrow_window_the_type_is_in_its_column_and_where_it_is_cut_below() -> None:
    async def act(window: _Window) -> None:
        assert window.line("theta").split() == ["theta", "float", "0.0"]
        assert window.line("name").split() == ["name", "string", "''"]
        await window.press("home")
        assert "turtlesim/srv/Spawn" in screen_lines(window.app)[-2]
        window.model.be("", service="/a_robot/with_a_long_name/spawn")
        await window.draw()
        assert window.line("name").split() == ["name", "string", "''"]

    use(act, (38, 20))


def test_the_keys_are_those_of_the_chosen_line() -> None:
    async def act(window: _Window) -> None:
        assert "Enter change" in screen_lines(window.app)[-1]
        await window.press("home")
        assert "change" not in screen_lines(window.app)[-1]
        window.model.be("", service="/clear", form=MessageForm(Empty.Request, convert))
        await window.draw()
        assert "Enter" not in screen_lines(window.app)[-1]

    use(act)
