"""Parameter Reconfigure's window on a stepped desktop, by keyboard and mouse."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len

from day6_core.ros.programs.rqt_reconfigure.opened import OpenNode, Parameter
from day6_core.ros.programs.rqt_reconfigure.ranges import Range
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

RED = Parameter("red", 2, 69, "The red of the ground", range=Range(0, 255, 1, True), limits="0 .. 255")
FAST = Parameter("fast", 1, False)
FRAME = Parameter("frame", 4, "map", "Never changes", read_only=True)
WEIGHTS = Parameter("weights", 8, [1.0, 2.0])
SIM = OpenNode("/sim", True, (FAST, FRAME, RED, WEIGHTS), True, None)


class Model:
    """A model whose nodes the test sets; it writes down what the window requests."""

    def __init__(self, *opened: OpenNode, nodes: tuple[str, ...] = ("/robot/arm", "/robot/base", "/sim")) -> None:
        self.nodes, self.opened = nodes, opened
        self.filter = self.message = ""
        self.version = 1
        self.requests: list[tuple[Any, ...]] = []

    def __getattr__(self, name: str) -> Callable[..., object]:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *given: self.requests.append((name, *given))

    def path(self, name: str) -> Path:
        return Path("/nowhere") / name


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        return next((line for line in screen_lines(self.app)[1:-1] if text in line), "")

    async def click(self, text: str, into: int = 0) -> None:
        lines = screen_lines(self.app)
        y = next(y for y, line in enumerate(lines) if y and text in line)
        await self.pilot.click(offset=(cell_len(lines[y][: lines[y].index(text)]) + into, y))
        await step(self.app, self.pilot)

    async def show(self, *opened: OpenNode) -> None:
        self.model.opened = opened
        self.model.version += 1
        await step(self.app, self.pilot)


def use(
    model: Model, act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (100, 30), **options: Any
) -> None:
    use_window(("rqt_reconfigure", "Parameter Reconfigure", model), act, size, _Window, **options)


def test_nodes_are_a_tree_of_their_namespaces_that_folds() -> None:
    async def act(window: _Window) -> None:
        names = [line.strip("┃● ▾▸").split("│")[0].strip() for line in screen_lines(window.app)[2:6]]
        assert names == ["robot", "arm", "base", "sim"]
        await window.press("left")
        assert "arm" not in window.text
        await window.press("right", "down", "enter")
        assert window.model.requests == [("toggle", "/robot/arm")]

    use(Model(), act)


def test_a_click_opens_a_node_and_a_click_on_a_namespace_folds_it() -> None:
    async def act(window: _Window) -> None:
        await window.click("sim", 1)
        assert window.model.requests == [("toggle", "/sim")]
        await window.click("▾ robot", 1)
        assert "arm" not in window.text

    use(Model(), act)


def test_each_type_has_its_editor() -> None:
    async def act(window: _Window) -> None:
        assert "[ ]" in window.line("fast")
        assert "map" in window.line("frame") and "read-only" in window.line("frame")
        assert all(text in window.line("red") for text in ("0 ", "●", " 255", " 69"))
        assert "[1.0, 2.0]" in window.line("weights")

    use(Model(SIM), act)


def test_keys_switch_a_boolean_move_a_slider_and_begin_a_number() -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", "down", "enter")
        assert window.model.requests == [("set", "/sim", "fast", True)]
        window.model.requests.clear()
        await window.press("down", "down", "right", "shift+left", "end", "home")
        moves = [("move", "/sim", "red", 1), ("move", "/sim", "red", -10)]
        assert window.model.requests == [*moves, ("set", "/sim", "red", 255), ("set", "/sim", "red", 0)]
        assert "The red of the ground" in window.text and "integer" in window.text
        window.model.requests.clear()
        await window.press("1", "2", "enter")
        assert window.model.requests == [("set", "/sim", "red", 12)]

    use(Model(SIM), act)


def test_a_value_of_the_wrong_type_is_refused_where_it_is_typed() -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", *["down"] * 4, "enter", "end", "x", "enter")
        assert "Not a value of type double array" in window.text and window.model.requests == []
        await window.press("backspace", "enter")
        assert window.model.requests == [("set", "/sim", "weights", [1.0, 2.0])]

    use(Model(SIM), act)


def test_a_read_only_parameter_cannot_be_edited() -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", "down", "down", "enter", "x")
        assert window.model.requests == [("toggle", "/sim")]

    use(Model(SIM), act)


def test_a_slider_that_the_mouse_drags_sends_its_value_when_it_is_let_go() -> None:
    async def act(window: _Window) -> None:
        lines = screen_lines(window.app)
        y = next(y for y, line in enumerate(lines) if "●─" in line)
        x = cell_len(lines[y][: lines[y].rindex("●")])
        end = cell_len(lines[y][: lines[y].rindex("─")])
        await window.pilot.mouse_down(offset=(x, y))
        await window.pilot.hover(offset=(end, y))
        await step(window.app, window.pilot)
        assert window.model.requests == [] and window.line("red").rstrip("┃ ").endswith("255")
        await window.pilot.mouse_up(offset=(end, y))
        assert window.model.requests == [("set", "/sim", "red", 255)]

    use(Model(SIM), act)


def test_a_refusal_is_shown_below_its_parameter() -> None:
    refused = Parameter("red", 2, 69, range=RED.range, refusal="No\x1b[2J way")

    async def act(window: _Window) -> None:
        lines = screen_lines(window.app)
        at = next(y for y, line in enumerate(lines) if " red " in line)
        assert "No^[[2J way" in lines[at + 1]

    use(Model(OpenNode("/sim", True, (refused, WEIGHTS), True, None)), act)


@pytest.mark.parametrize(
    ("node", "told"),
    [
        (
            OpenNode("/sim", True, (), False, 7, "the target node may not be spinning"),
            "no response for 7 s: the target",
        ),
        (OpenNode("/sim", False, (RED,), True, None), "This node is gone"),
        (OpenNode("/sim", True, (), True, None), "no parameters"),
        (OpenNode("/sim", True, (), False, None), "not read"),
    ],
)
def test_the_truth_about_a_node_is_told(node, told) -> None:
    async def act(window: _Window) -> None:
        assert told in window.text

    use(Model(node), act)


def test_escape_stops_waiting() -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", "escape")
        assert window.model.requests == [("cancel", "/sim")]

    use(Model(OpenNode("/sim", True, (), False, 7, "hm")), act)


def test_the_nodes_and_the_parameters_can_be_filtered() -> None:
    async def act(window: _Window) -> None:
        await window.press("/", "a", "r", "m", "enter")
        assert "base" not in window.text and "arm" in window.text
        await window.press("tab", "/", "R", "E", "D", "enter")
        assert "weights" not in window.text and "red" in window.text

    use(Model(SIM), act)


@pytest.mark.long
@pytest.mark.parametrize("size", [(80, 24), (30, 10), (12, 4), (120, 40)])
@pytest.mark.parametrize("options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}, {"glyphs": "cell"}])
def test_it_is_drawn_at_every_size_with_hostile_and_many_parameters(size, options) -> None:
    hostile = [
        Parameter("\x1b]0;T\x07\u202e" + "名" * 200, 4, "\x1b[2J\nline" + "x" * 100_000, "\x00\x9b31m" * 50, "\t" * 9),
        Parameter("nan", 3, float("nan"), range=Range(-1e300, 1e300, 0, False)),
        Parameter("bytes", 5, [b"\x1b"] * 10_000),
        Parameter("empty", 9, []),
    ]
    many = [Parameter(f"p{number}", 3, 1e-300 * number, range=Range(0.0, 1.0, 0, False)) for number in range(500)]

    async def act(window: _Window) -> None:
        await window.press("tab", *["down"] * 5, "pagedown", "pagedown", "tab", "down")
        assert not [char for line in screen_lines(window.app) for char in line if not char.isprintable()]

    nodes = tuple(f"/ns{number % 7}/node{number}" for number in range(300))
    use(Model(OpenNode("/sim", True, (*hostile, *many), True, None), nodes=nodes), act, size, **options)


@pytest.mark.parametrize(("key", "request_"), [("w", "save"), ("ctrl+s", "save"), ("o", "load"), ("ctrl+o", "load")])
def test_parameters_are_saved_and_loaded_by_the_keys_of_the_other_windows(key: str, request_: str) -> None:
    model = Model(SIM)

    async def act(window: _Window) -> None:
        await window.press("tab", key, "enter")
        assert [asked[:2] for asked in model.requests if asked[0] in ("save", "load")] == [(request_, "/sim")]

    use(model, act)


@pytest.mark.parametrize(("key", "title"), [("w", "把参数保存到文件"), ("o", "从文件读入参数")])
def test_what_is_asked_about_files_is_asked_in_chinese(key: str, title: str) -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", key)
        assert title in window.text

    use(Model(SIM), act, lang="zh")


DURABILITY = Parameter("qos_overrides./parameter_events.publisher.durability", 4, "volatile", read_only=True)
HISTORY = Parameter("qos_overrides./parameter_events.publisher.history", 4, "keep_last", read_only=True)


def test_long_names_keep_their_ends_and_the_chosen_one_is_told_in_full() -> None:
    async def act(window: _Window) -> None:
        assert "publisher.durability" in window.line("volatile") and "publisher.history" in window.line("keep_last")
        await window.press("tab", "down")
        assert DURABILITY.name in screen_lines(window.app)[-2]

    use(Model(OpenNode("/sim", True, (DURABILITY, HISTORY), True, None)), act, size=(80, 24))


def test_in_a_narrow_window_opening_a_node_goes_to_its_parameters_and_closing_back() -> None:
    async def act(window: _Window) -> None:
        await window.press("end", "enter")
        await window.show(SIM)
        assert "fast" in window.text and "arm" not in window.text
        await window.press("down", "down", "down")
        assert "0 .. 255" in screen_lines(window.app)[-2]
        await window.press("x")
        await window.show()
        assert "arm" in window.text

    use(Model(), act, size=(42, 12))


def test_a_long_text_is_below_the_list_where_its_line_has_no_room() -> None:
    async def act(window: _Window) -> None:
        await window.press("tab", "down")
        assert "the end of it" in window.text

    text = Parameter("greeting", 4, "hello " * 12 + "the end of it")
    use(Model(OpenNode("/sim", True, (text,), True, None)), act, size=(80, 24))


def test_no_key_is_promised_for_what_cannot_be_changed() -> None:
    async def act(window: _Window) -> None:
        for node in (OpenNode("/sim", False, (RED,), True, None), OpenNode("/sim", True, (FRAME,), True, None)):
            await window.show(node)
            await window.press("tab", "down", "right", "enter", "5", "home")
            assert window.model.requests == []
            assert "value" not in screen_lines(window.app)[-1] and "x close" in screen_lines(window.app)[-1]
            await window.press("tab")

    use(Model(), act)
