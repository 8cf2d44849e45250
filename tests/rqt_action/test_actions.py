"""The action browser: live actions with their goals, one sent and cancelled, on a clock that the test moves."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator
from typing import Any

import pytest
from example_interfaces.action import Fibonacci
from rich.cells import cell_len

from day6_core.graph import Graph
from day6_core.ros.programs.rqt_action import rqt_action
from day6_core.ros.programs.rqt_action.model import MOST_GOALS, ActionBrowser, ActionEntry, Goal
from day6_core.ros.programs.rqt_msg.model import TypeBrowser
from day6_core.ros.programs.rqt_py_common.message_form import FieldRow
from day6_core.ros.programs.turtlesim import turtlesim_node
from day6_core.session.clock import WorldClock
from day6_core.session.display import Display
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Session
from day6_core.session.streams import Captured
from rclpy.action import ActionClient, ActionServer, GoalResponse
from tests.tui.screens import ToolWindow, screen_lines, step, use_window

ROTATE = "/turtle1/rotate_absolute"


class _World:
    """A machine with turtlesim and the action browser."""

    def __init__(self) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=1_700_000_000 * 10**9))
        self.graph = Graph()
        self.display = Display()
        self.other = Session(self.scheduler, self.graph, ["other"])
        self.node = self.other.create_node("other")
        self.other.spawn(self.other.spin(self.node))
        self.turtlesim = self.start(turtlesim_node.main, Display())
        self.program = self.start(rqt_action.main, self.display)
        self.wait(0.3)
        self.model: ActionBrowser = self.display.windows[0].model  # type: ignore[assignment]

    def start(self, main: Any, display: Display) -> Program:
        output = Captured()
        return Program(
            Session(self.scheduler, self.graph, ["program"], stdout=output, stderr=output, display=display), main
        )

    def wait(self, seconds: float) -> None:
        self.scheduler.advance(seconds)

    def action(self, name: str = ROTATE) -> ActionEntry:
        return next(action for action in self.model.shown() if action.name == name)


@pytest.fixture
def world() -> Iterator[_World]:
    found = _World()
    yield found
    for program in (found.program, found.turtlesim):
        if program.status is None:
            program.interrupt()
    found.wait(0.1)
    found.other.close()


def test_an_action_is_listed_with_its_type_and_ends(world) -> None:
    action = world.action()
    assert action.type == "turtlesim/action/RotateAbsolute"
    assert (action.servers, action.clients, action.watched) == (("/turtlesim",), (), False)


def test_only_while_it_is_watched_this_node_is_a_client(world) -> None:
    world.model.watch(ROTATE, True)
    world.wait(0.3)
    (client,) = world.action().clients
    assert client.startswith("/rqt_gui_py_node_") and world.action().watched
    world.model.watch(ROTATE, False)
    world.wait(0.3)
    assert world.action().clients == ()


def test_a_goal_is_filled_in_sent_and_followed_to_its_result(world) -> None:
    world.model.watch(ROTATE, True)
    world.model.set_expression(ROTATE, "/theta", "pi / 4")
    world.model.send(ROTATE)
    world.wait(0.4)
    (goal,) = world.action().goals
    assert goal.is_own and goal.status == "EXECUTING" and len(goal.id) == 32
    assert goal.feedback[0].name == "remaining" and 0 < float(goal.feedback[0].text) < 0.8
    world.wait(2.0)
    (goal,) = world.action().goals
    assert goal.status == "SUCCEEDED" and goal.result[0].name == "delta"


def test_a_goal_is_cancelled(world) -> None:
    world.model.watch(ROTATE, True)
    world.model.set_expression(ROTATE, "/theta", "3")
    world.model.send(ROTATE)
    world.wait(0.4)
    (goal,) = world.action().goals
    world.model.cancel(ROTATE, goal.id)
    world.wait(0.5)
    assert [each.status for each in world.action().goals] == ["CANCELED"]


def test_goals_of_others_are_seen_and_are_theirs(world) -> None:
    world.model.watch(ROTATE, True)
    world.wait(0.2)
    from turtlesim.action import RotateAbsolute

    client = ActionClient(world.node, RotateAbsolute, ROTATE)
    client.send_goal_async(RotateAbsolute.Goal(theta=2.0))
    world.wait(0.5)
    (goal,) = world.action().goals
    assert not goal.is_own and goal.status == "EXECUTING" and goal.feedback
    world.model.cancel(ROTATE, goal.id)  # not ours
    world.wait(0.2)
    assert world.action().goals[0].status == "EXECUTING"


def _serve(world: _World, **options: Any) -> ActionServer:
    def execute(handle: Any) -> Any:
        handle.succeed()
        return Fibonacci.Result(sequence=[0, 1, 1])

    return ActionServer(world.node, Fibonacci, "fibonacci", execute, **options)


def test_a_rejected_goal_is_said_to_be(world) -> None:
    _serve(world, goal_callback=lambda request: GoalResponse.REJECT)
    world.wait(0.2)
    world.model.watch("/fibonacci", True)
    world.wait(0.2)
    world.model.send("/fibonacci")
    world.wait(0.2)
    assert world.action("/fibonacci").state == "rejected" and world.action("/fibonacci").goals == []


def test_a_server_that_never_answers_keeps_nothing_waiting(world) -> None:
    mute = Session(world.scheduler, world.graph, ["mute"])
    node = mute.create_node("mute")  # is not spun
    ActionServer(node, Fibonacci, "mute", lambda handle: Fibonacci.Result())
    world.wait(0.2)
    world.model.watch("/mute", True)
    world.wait(0.2)
    world.model.send("/mute")
    world.wait(5.0)
    assert world.action("/mute").state == "sent"
    world.model.watch("/mute", False)
    world.wait(0.2)
    assert world.action("/mute").state == ""
    mute.close()


def test_without_a_server_nothing_is_sent(world) -> None:
    server = _serve(world)
    world.wait(0.2)
    world.model.watch("/fibonacci", True)
    world.wait(0.2)
    server.destroy()
    world.model.send("/fibonacci")
    world.wait(0.2)
    assert world.action("/fibonacci").state == "no_server"


def test_a_wrong_expression_is_said_in_its_line(world) -> None:
    world.model.watch(ROTATE, True)
    world.model.set_expression(ROTATE, "/theta", "north")
    world.wait(0.2)
    assert world.action().request[0].problem == "failed to evaluate expression: north"


def test_only_the_newest_goals_are_kept(world) -> None:
    _serve(world)
    world.wait(0.2)
    world.model.watch("/fibonacci", True)
    world.wait(0.2)
    for _ in range(MOST_GOALS + 5):
        world.model.send("/fibonacci")
        world.wait(0.1)
    goals = world.action("/fibonacci").goals
    assert len(goals) == MOST_GOALS and {goal.status for goal in goals} == {"SUCCEEDED"}


def test_an_action_that_goes_is_watched_no_longer(world) -> None:
    server = _serve(world)
    world.wait(0.2)
    world.model.watch("/fibonacci", True)
    world.wait(0.2)
    server.destroy()
    world.model.watch("/fibonacci", False)
    world.wait(0.3)
    assert [action.name for action in world.model.shown()] == [ROTATE]


def test_nothing_is_left_on_the_node_after_closing(world) -> None:
    world.model.watch(ROTATE, True)
    world.model.send(ROTATE)
    world.wait(0.2)
    world.model.close()
    world.wait(0.3)
    assert world.action().clients == ()


class Model:
    """Actions as the test sets them."""

    def __init__(self) -> None:
        self.version = 1
        self.browser = TypeBrowser("action")
        self.watched = False
        self.state = ""
        self.asked: list[tuple[object, ...]] = []

    def shown(self) -> list[ActionEntry]:
        if not self.watched:
            return [ActionEntry(ROTATE, "turtlesim/action/RotateAbsolute", ("/turtlesim",), (), False, [], [], "", "")]
        feedback = [FieldRow("/remaining", "remaining", "float", 4, "0.5")]
        goals = [
            Goal("ab" * 16, "EXECUTING", True, feedback, []),
            Goal("cd" * 16, "SUCCEEDED", False, [], [FieldRow("/delta", "delta", "float", 4, "-1.5")]),
        ]
        request = [FieldRow("/theta", "theta", "float", 2, "0.0")]
        ends = ("/turtlesim",), ("/rqt",)
        return [ActionEntry(ROTATE, "turtlesim/action/RotateAbsolute", *ends, True, request, goals, self.state, "")]

    def watch(self, action: str, watched: bool) -> None:
        self.watched = watched
        self.version += 1

    def set_expression(self, action: str, path: str, text: str) -> None:
        self.asked.append(("set", action, path, text))

    def send(self, action: str) -> None:
        self.asked.append(("send", action))

    def cancel(self, action: str, goal: str) -> None:
        self.asked.append(("cancel", action, goal))


class _Window(ToolWindow):
    def line(self, text: str) -> str:
        """The first line of the window in which a text stands."""
        return next((line.strip("┃│ ") for line in screen_lines(self.app)[1:-1] if text in line), "")


def use(act: Callable[[_Window], Awaitable[None]], size: tuple[int, int] = (120, 40), **options: Any) -> Model:
    """Open the action browser and do something with it."""
    model = Model()
    use_window(("action_browser", "Action Type Browser", model), act, size, _Window, **options)
    return model


def test_an_action_is_opened_its_goal_filled_in_and_sent() -> None:
    async def act(window: _Window) -> None:
        assert window.line(ROTATE).split()[:2] == ["▸", ROTATE]
        await window.press("enter")
        assert window.line("theta").split() == ["theta", "float", "0.0"]
        assert window.line("abababab").split()[-1] == "EXECUTING" and "-1.5" in window.line("delta")
        await window.press("down", "down", *"1.5", "enter", "g", "x")

    assert use(act).asked == [("set", ROTATE, "/theta", "1.5"), ("send", ROTATE), ("cancel", ROTATE, "ab" * 16)]


def test_what_became_of_the_goal_is_told_in_words() -> None:
    async def act(window: _Window) -> None:
        await window.press("enter")
        for state in ("sent", "rejected", "no_server"):
            window.model.state = state
            window.model.version += 1
            await step(window.app, window.pilot)
            assert window.line(window.app.look.texts(f"actions.state.{state}"))

    use(act)


def test_types_are_browsed_below_as_in_rqt() -> None:
    async def act(window: _Window) -> None:
        await window.press("p", *"turtlesim", "enter")
        await window.press("enter")
        assert window.line("Action Feedback").split()[-1] == "turtlesim/RotateAbsolute/Feedback"
        await window.press("end", "enter")
        assert "float" in window.text
        await window.press("escape", "d")
        assert not window.line("Action Feedback") and window.line("Action Goal")

    use(act)


@pytest.mark.parametrize("size", [(80, 24), (40, 12), (30, 10), (120, 40)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_no_line_is_wider_than_the_window(size: tuple[int, int], lang: str) -> None:
    async def act(window: _Window) -> None:
        await window.press("enter")
        assert all(cell_len(line) <= size[0] for line in screen_lines(window.app))

    use(act, size, lang=lang)
