"""The logger levels: read and set by the services of a node, told where a node has none, and what the window shows."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from rcl_interfaces.srv import GetLoggerLevels

from day6_core.ros.programs.rqt_gui.plugin import PluginPlace
from day6_core.ros.programs.rqt_logger_level.model import Logger
from day6_core.ros.programs.rqt_logger_level.rqt_logger_level import LoggerLevelPlugin
from tests.support.rqt_machine import RqtMachine
from tests.tui.screens import ToolWindow, use_window


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[RqtMachine]:
    found = RqtMachine("rqt_logger_level", tmp_path)
    yield found
    found.end()


def test_nodes_are_listed_with_whether_they_can_be_asked(machine: RqtMachine) -> None:
    machine.other("open", namespace="/robot", enable_logger_service=True)
    machine.other("shut")
    machine.open()
    listed = {"/robot/open": True, machine.own: False, "/shut": False, "/watcher": False}
    assert machine.model.nodes == listed
    machine.do("choose", "/shut")
    assert machine.model.nodes == listed and machine.model.waited is None


def test_a_level_is_read_and_set_and_the_node_logs_by_it(machine: RqtMachine) -> None:
    node = machine.other("open", namespace="/robot", enable_logger_service=True).node
    machine.open()
    machine.do("choose", "/robot/open")
    assert machine.model.loggers[0] == Logger("robot.open", 0)
    machine.do("set", "robot.open", 10)
    assert machine.model.loggers[0] == Logger("robot.open", 10) and machine.model.waited is None
    assert node.get_logger().get_effective_level() == 10
    machine.do("add", "robot.open.child")
    assert machine.model.loggers[-1].name == "robot.open.child"


def test_a_refused_level_is_told_in_the_words_of_the_node(machine: RqtMachine) -> None:
    machine.other("open", enable_logger_service=True)
    machine.open()
    machine.do("choose", "/open")
    machine.do("set", "open", 17)
    assert machine.model.message == "Failed reason: Invalid logger level."
    assert machine.model.loggers[0].level == 0


def test_a_node_that_does_not_answer_is_told_with_the_seconds_and_given_up(machine: RqtMachine) -> None:
    machine.other("stuck", spins=False, enable_logger_service=True)
    machine.open()
    machine.do("choose", "/stuck", seconds=3.5)
    assert machine.model.waited == 3 and machine.model.loggers[0].level is None
    machine.do("cancel")
    assert machine.model.waited is None


def test_a_node_that_vanishes_and_comes_back_is_asked_again(machine: RqtMachine) -> None:
    program = machine.other("open", enable_logger_service=True)
    machine.open()
    machine.do("choose", "/open")
    machine.do("set", "open", 10)
    program.end()
    assert "/open" not in machine.model.nodes and machine.model.waited is None
    machine.do("set", "open", 40)
    assert machine.model.loggers[0] == Logger("open", 10)
    machine.other("open", enable_logger_service=True)
    machine.advance(0.5)
    assert machine.model.loggers[0] == Logger("open", 0)


def test_another_node_leaves_no_client_behind(machine: RqtMachine) -> None:
    machine.other("one", enable_logger_service=True)
    machine.other("two", enable_logger_service=True)
    machine.open()
    machine.do("choose", "/one")
    machine.do("choose", "/two")
    clients = dict(machine.node.get_client_names_and_types_by_node(machine.own[1:], "/"))
    assert sorted(clients) == ["/two/get_logger_levels", "/two/set_logger_levels"]


def test_a_kept_perspective_chooses_its_node_and_survives_nonsense(machine: RqtMachine) -> None:
    machine.other("open", enable_logger_service=True)
    for kept, chosen in (("/open", "/open"), ("not a name", ""), (5, "")):
        place = PluginPlace(machine._programs[0].session, machine.node, settings={"node": kept})
        plugin = LoggerLevelPlugin(place)
        plugin.model.refresh()
        assert plugin.settings() == {"node": chosen}
        plugin.close()


def test_a_lying_node_changes_nothing_else(machine: RqtMachine) -> None:
    node = machine.other("liar").node

    def lie(request: Any, response: Any) -> Any:
        from rcl_interfaces.msg import LoggerLevel

        response.levels = [LoggerLevel(name=f"x{number}", level=2**32 - 1) for number in range(5)]
        return response

    node.create_service(GetLoggerLevels, "liar/get_logger_levels", lie)
    machine.open()
    machine.do("choose", "/liar")
    assert [logger.level for logger in machine.model.loggers] == [None] * 3


class Model:
    """A model that the test sets; it writes down what the window requests."""

    def __init__(self, **given: Any) -> None:
        self.nodes = {"/open": True, "/shut": False}
        self.node, self.message, self.waited, self.version = "", "", None, 1
        self.loggers: tuple[Logger, ...] = ()
        self.requests: list[tuple[Any, ...]] = []
        vars(self).update(given)

    def __getattr__(self, name: str) -> Callable[..., object]:
        if name.startswith("_"):
            raise AttributeError(name)
        return lambda *given: self.requests.append((name, *given))


CHOSEN = {"node": "/open", "loggers": (Logger("open", 20), Logger("rcl", 0))}


def use(
    model: Model, act: Callable[[ToolWindow], Awaitable[None]], size: tuple[int, int] = (80, 24), **options: Any
) -> None:
    use_window(("rqt_logger_level", "Logger Level", model), act, size, ToolWindow, **options)


def test_keys_choose_a_node_a_logger_and_set_a_level() -> None:
    async def act(window: ToolWindow) -> None:
        await window.press("enter", "down", "enter", "down", "down", "enter", "a", "x", "enter")
        assert window.model.requests == [("choose", "/open"), ("set", "rcl", 30), ("add", "x")]

    use(Model(**CHOSEN), act)


def test_the_level_of_the_chosen_logger_is_marked() -> None:
    async def act(window: ToolWindow) -> None:
        assert "● INFO" in window.text and "● DEBUG" not in window.text

    use(Model(**CHOSEN), act)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"node": "/shut", "loggers": (Logger("shut", None),)}, "enable_logger_service=True"),
        ({"node": "/lost", "loggers": ()}, "/lost is gone"),
        ({**CHOSEN, "waited": 7}, "No response for 7 s"),
        ({**CHOSEN, "message": "No\x1b[2J way"}, "No^[[2J way"),
        ({}, "Enter chooses a node"),
    ],
)
def test_the_truth_about_a_node_is_told(given, told) -> None:
    async def act(window: ToolWindow) -> None:
        assert told in window.text

    use(Model(**given), act)


@pytest.mark.parametrize("size", [(80, 24), (24, 8), (120, 40)])
@pytest.mark.parametrize("options", [{}, {"lang": "zh"}, {"glyphs": "ascii"}])
def test_it_is_drawn_at_every_size_with_many_nodes_and_hostile_names(size, options) -> None:
    model = Model(
        nodes={f"/ns/node{number}": number % 2 == 0 for number in range(300)},
        node="/ns/node0",
        loggers=(Logger("\x1b]0;T\x07" + "名" * 99, None), Logger("", 2**32 - 1)),
    )

    async def act(window: ToolWindow) -> None:
        await window.press("end", "pageup", "right", "end", "right", "home")
        assert all(char.isprintable() for line in window.text.splitlines() for char in line)

    use(model, act, size, **options)
