"""What a program measures of itself for the inspector, in one process and with time that only the test moves."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from tests.rclpy.conftest import World
from tests.support.waiting import PATIENCE

HALF = 0.5


class Questions:
    """Asks a world's nodes again and again, as the inspector does, by a clock that the test moves."""

    def __init__(self, world: World) -> None:
        from rclpy._day6 import signs

        self._signs = signs
        signs._lately.__init__()  # type: ignore[misc]
        self.world = world
        self.now = 1000.0
        self.since: dict[object, float] = {}

    def ask(self) -> dict[str, dict[str, Any]]:
        nodes = self.world.context._living_nodes()
        found = self._signs.signs_of(nodes, self.now, lambda key: self.now - self.since.setdefault(key, self.now))
        return {each["kind"]: each["values"] for each in found}

    def over(self, seconds: float, meanwhile: Callable[[], object] = lambda: None) -> dict[str, dict[str, Any]]:
        """Ask every half second; `meanwhile` is called before each question."""
        found = self.ask()
        for _ in range(round(seconds / HALF)):
            meanwhile()
            self.now += HALF
            found = self.ask()
        return found


@pytest.fixture
def questions(world: World, monkeypatch: pytest.MonkeyPatch) -> Questions:
    """Who is asked reads our test modules, too, and begins to trace callbacks; afterwards all is as before."""
    from rclpy._day6 import swallowed
    from rclpy.executors import Executor

    monkeypatch.setattr(Executor, "_execute", swallowed._plain)
    monkeypatch.setattr(swallowed, "_read", set())
    monkeypatch.setattr(swallowed, "_functions", {})
    return Questions(world)


def test_a_timer_that_keeps_its_period_is_no_sign_and_one_that_cannot_is_measured(questions: Questions) -> None:
    world = questions.world
    node = world.node("mine")

    def slow() -> None:
        world.time.elapsed += 250_000_000

    def busy() -> None:
        end = world.time.elapsed + round(HALF * 1e9)
        while world.time.elapsed < end:
            if not world.executor._run_ready():
                world.time.elapsed += 10_000_000

    node.create_timer(0.1, lambda: None)
    assert "late" not in questions.over(3.0, lambda: world.run(HALF))
    node.create_timer(0.05, slow)
    late = questions.over(5.0, busy)["late"]
    assert late["wanted"] == pytest.approx(20.0) or late["wanted"] == pytest.approx(10.0)
    assert late["share"] > 0.4 and late["rate"] < 6


def test_what_only_happened_once_is_no_sign(questions: Questions) -> None:
    """The computer was busy, or the program was stopped for a while."""
    world = questions.world
    world.node("mine").create_timer(0.05, lambda: None)
    questions.over(2.5, lambda: world.run(HALF))
    world.time.elapsed += 800_000_000
    assert "late" not in questions.over(2.5, lambda: world.run(HALF))


def test_messages_that_were_overwritten_are_counted(questions: Questions) -> None:
    from std_msgs.msg import String

    world = questions.world
    node = world.node("mine")
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda message: None, 10)

    def much() -> None:
        for _ in range(100):
            publisher.publish(String())
        world.settle()

    losses = questions.over(2.5, much)["losses"]
    assert losses["topic"] == "/chatter" and losses["count"] == 400 and losses["lost"] == 360 and losses["share"] == 0.9
    assert "losses" not in questions.over(2.5, lambda: (publisher.publish(String()), world.settle()))


def test_what_a_callback_makes_anew_grows(questions: Questions) -> None:
    from std_msgs.msg import String

    node = questions.world.node("mine")
    grows = questions.over(2.5, lambda: [node.create_publisher(String, "chatter", 10) for _ in range(2)])["grows"]
    assert grows["kind"] == "publishers" and grows["name"] == "/chatter" and grows["least"] >= 4
    assert "grows" not in questions.over(2.5)


def test_a_node_that_makes_all_it_needs_at_its_beginning_does_not_grow(questions: Questions) -> None:
    from std_msgs.msg import String

    questions.ask()
    node = questions.world.node("mine")
    for number in range(30):
        node.create_publisher(String, f"topic{number}", 10)
    assert "grows" not in questions.over(3.0)


def test_parameters_tell_an_empty_list_and_a_text_made_too_early(questions: Questions) -> None:
    from rclpy.parameter import Parameter

    node = questions.world.node("mine")
    node.declare_parameter("speeds", [1.0])
    node.declare_parameter("names", Parameter.Type.STRING_ARRAY)
    assert questions.ask() == {}
    node.declare_parameter("list", [])
    assert questions.ask()["empty_list"] == {"name": "list"}
    node.declare_parameter("speed", "<launch.substitutions.launch_configuration.LaunchConfiguration object at 0x7f>")
    assert questions.ask()["launch_text"]["name"] == "speed"


# -- exceptions that nobody sees -----------------------------------------------------------------------------------------


def silent(message: object) -> None:
    try:  # noqa: SIM105
        message.text  # noqa: B018
    except:  # noqa: E722
        pass


def logged(message: object) -> None:
    try:
        try:
            message.text  # noqa: B018
        except AttributeError as error:
            print(error)
    except Exception:
        pass


def expected(message: object) -> None:
    try:  # noqa: SIM105
        [][1]
    except IndexError:
        pass


def test_a_synchronizer_is_told_of_while_it_calls_back(questions: Questions) -> None:
    import message_filters
    from message_filters._signs import of_synchronizers
    from sensor_msgs.msg import Range

    node = questions.world.node("mine")
    inputs = [message_filters.Subscriber(node, Range, topic) for topic in ("left", "right")]
    synchronizer = message_filters.TimeSynchronizer(inputs, 5)
    told: list[object] = []
    asker = threading.Thread(target=lambda: told.extend(of_synchronizers(node)), daemon=True)
    with synchronizer.lock:  # it is held while the callback runs, which may be for ever
        asker.start()
        asker.join(PATIENCE)
        assert told


@pytest.mark.parametrize(("callback", "is_told"), [(silent, True), (logged, False), (expected, False)])
def test_an_exception_is_swallowed_where_a_handler_does_nothing(
    questions: Questions, callback: Callable[[object], None], is_told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    from std_msgs.msg import String

    from rclpy._day6 import swallowed

    functions = {(__file__, line): each for line, each in swallowed._silent_in(__file__).items()}
    monkeypatch.setattr(swallowed, "_functions", functions)
    monkeypatch.setattr(swallowed, "_read_files", lambda: None)
    monkeypatch.setattr(swallowed.sys, "gettrace", lambda: None)  # who measures the tests' coverage traces, too
    node = questions.world.node("mine")
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", callback, 10)

    def say() -> None:
        publisher.publish(String())
        questions.world.settle()

    tracer = threading._trace_hook  # type: ignore[attr-defined]
    try:
        found = questions.over(2.0, say)
    finally:
        sys.settrace(tracer)
    assert ("swallowed" in found) is is_told
    if is_told:
        told = found["swallowed"]
        assert told["count"] == told["calls"] == 4 and told["error"].startswith(
            "AttributeError: 'String' object has no"
        )


def test_nobody_is_traced_any_more_some_seconds_after_the_last_question(monkeypatch: pytest.MonkeyPatch) -> None:
    from rclpy._day6 import swallowed
    from rclpy.executors import Executor

    monkeypatch.setattr(swallowed, "_plain", lambda executor, entity: True)
    monkeypatch.setattr(Executor, "_execute", swallowed._watched)
    monkeypatch.setattr(swallowed, "_traced", {id(swallowed): swallowed.CALLBACKS})
    monkeypatch.setattr(swallowed, "_asked", time.monotonic() - swallowed.FOR_S - 1)
    assert swallowed._watched(None, swallowed)  # type: ignore[arg-type]
    assert Executor._execute is swallowed._plain
