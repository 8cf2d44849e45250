"""Lifecycle nodes: states, transitions and what follows them, services, publishers that speak only while active."""

from __future__ import annotations

from typing import Any

import pytest
from lifecycle_msgs import srv
from lifecycle_msgs.msg import Transition, TransitionEvent
from std_msgs.msg import String

from rclpy.lifecycle import LifecycleNode, LifecycleNodeMixin, ManagedEntity, SimpleManagedEntity
from rclpy.lifecycle import Node as SameNode
from rclpy.lifecycle.managed_entity import TransitionCallbackReturn
from rclpy.node import Node

SUCCESS, FAILURE, ERROR = (
    TransitionCallbackReturn.SUCCESS,
    TransitionCallbackReturn.FAILURE,
    TransitionCallbackReturn.ERROR,
)
STATES = {1: "unconfigured", 2: "inactive", 3: "active", 4: "finalized"}
PATHS = {1: [], 2: ["configure"], 3: ["configure", "activate"], 4: ["shutdown"]}


class Recorder(LifecycleNode):
    """Notes its callbacks, and answers them as it was told."""

    def __init__(self, world: Any, answers: dict[str, Any] | None = None, **keywords: Any) -> None:
        self.answers = answers or {}
        self.ran: list[tuple[str, str]] = []
        super().__init__("life", context=world.context, **keywords)
        world.executor.add_node(self)


def _noted(name: str) -> Any:
    def callback(self: Recorder, state: Any) -> Any:
        self.ran.append((name, state.label))
        answer = self.answers.get(name)
        if isinstance(answer, Exception):
            raise answer
        return getattr(LifecycleNode, f"on_{name}")(self, state) if answer is None else answer

    return callback


for _name in ("configure", "cleanup", "shutdown", "activate", "deactivate", "error"):
    setattr(Recorder, f"on_{_name}", _noted(_name))


class Asker:
    """A node that asks the services of a lifecycle node."""

    def __init__(self, world: Any) -> None:
        self.world = world
        self.node = world.node("asker")

    def ask(self, srv_type: Any, name: str, **fields: Any) -> Any:
        client = self.node.create_client(srv_type, f"/life/{name}")
        response = self.world.until(client.call_async(srv_type.Request(**fields)))
        self.node.destroy_client(client)
        return response

    def state(self) -> int:
        state = self.ask(srv.GetState, "get_state").current_state
        assert STATES[state.id] == state.label
        return int(state.id)


@pytest.mark.parametrize(
    ("start", "transition", "goal"),
    [
        (1, "configure", 2),
        (2, "activate", 3),
        (3, "deactivate", 2),
        (2, "cleanup", 1),
        (1, "shutdown", 4),
        (2, "shutdown", 4),
        (3, "shutdown", 4),
    ],
)
@pytest.mark.parametrize(
    ("answer", "error_answer"),
    [(SUCCESS, SUCCESS), (FAILURE, SUCCESS), (ERROR, SUCCESS), (ERROR, FAILURE), (ValueError(), ERROR)],
)
def test_a_transition_ends_where_its_callback_says(
    world: Any, start: int, transition: str, goal: int, answer: Any, error_answer: Any
) -> None:
    node = Recorder(world)
    asker = Asker(world)
    for step in PATHS[start]:
        assert getattr(node, f"trigger_{step}")() == SUCCESS
    node.answers = {transition: answer, "error": error_answer}
    node.ran.clear()
    outcome = getattr(node, f"trigger_{transition}")()
    failed = isinstance(answer, Exception) or answer == ERROR
    assert outcome == (ERROR if failed else answer)
    assert node.ran == [(transition, STATES[start])] + ([("error", STATES[start])] if failed else [])
    if failed:
        expected = 1 if error_answer == SUCCESS else 4
    elif answer == FAILURE:
        expected = 4 if transition == "shutdown" else start
    else:
        expected = goal
    assert asker.state() == expected


@pytest.mark.parametrize(
    ("start", "transition"),
    [
        (1, "activate"),
        (1, "deactivate"),
        (1, "cleanup"),
        (2, "configure"),
        (2, "deactivate"),
        (3, "configure"),
        (3, "activate"),
        (3, "cleanup"),
        (4, "configure"),
    ],
)
def test_a_transition_that_cannot_be_is_an_error(world: Any, start: int, transition: str) -> None:
    node = Recorder(world)
    for step in PATHS[start]:
        getattr(node, f"trigger_{step}")()
    node.ran.clear()
    assert getattr(node, f"trigger_{transition}")() == ERROR
    assert node.ran == []
    assert Asker(world).state() == start


def test_what_is_finalized_cannot_be_shut_down_again(world: Any) -> None:
    node = Recorder(world)
    node.trigger_shutdown()
    with pytest.raises(RuntimeError, match="Shutdown transtion not possible"):
        node.trigger_shutdown()


@pytest.mark.parametrize(
    ("start", "number", "label", "success", "after"),
    [
        (1, 1, "", True, 2),
        (1, 0, "configure", True, 2),
        (2, 3, "", True, 3),
        (2, 2, "", True, 1),
        (3, 4, "", True, 2),
        (1, 5, "", True, 4),
        (2, 6, "", True, 4),
        (3, 7, "", True, 4),
        (3, 0, "shutdown", True, 4),
        (1, 3, "", False, 1),
        (1, 6, "", False, 1),
        (1, 99, "", False, 1),
        (1, 1, "activate", False, 1),
        (1, 3, "configure", True, 2),
        (1, 0, "nothing", False, 1),
    ],
)
def test_a_transition_is_asked_for_by_number_or_label(
    world: Any, start: int, number: int, label: str, success: bool, after: int
) -> None:
    node = Recorder(world)
    asker = Asker(world)
    for step in PATHS[start]:
        getattr(node, f"trigger_{step}")()
    response = asker.ask(srv.ChangeState, "change_state", transition=Transition(id=number, label=label))
    assert response.success is success
    assert asker.state() == after


def test_an_unknown_label_is_warned_of_and_an_unknown_number_an_error_too(world: Any) -> None:
    Recorder(world)
    asker = Asker(world)
    for number, label in ((99, ""), (1, "nonsense")):
        asker.ask(srv.ChangeState, "change_state", transition=Transition(id=number, label=label))
    assert [line.rstrip().partition("] [")[2].partition("] [")[2] for line in world.log] == [
        "rcl_lifecycle]: No transition matching 99 found for current state unconfigured",
        "life]: Unable to start transition 99 from current state (1, 'unconfigured')",
        "rcl_lifecycle]: No transition matching nonsense found for current state unconfigured",
    ]


def test_a_request_that_fails_says_so(world: Any) -> None:
    Recorder(world, {"configure": FAILURE})
    response = Asker(world).ask(srv.ChangeState, "change_state", transition=Transition(id=1))
    assert response.success is False


ALL_STATES = [
    (0, "unknown"),
    (1, "unconfigured"),
    (2, "inactive"),
    (3, "active"),
    (4, "finalized"),
    (10, "configuring"),
    (11, "cleaningup"),
    (12, "shuttingdown"),
    (13, "activating"),
    (14, "deactivating"),
    (15, "errorprocessing"),
]


def test_all_states_are_told(world: Any) -> None:
    Recorder(world)
    states = Asker(world).ask(srv.GetAvailableStates, "get_available_states").available_states
    assert [(each.id, each.label) for each in states] == ALL_STATES


@pytest.mark.parametrize(
    ("start", "transitions"),
    [
        (1, [(1, "configure", 1, 10), (5, "shutdown", 1, 12)]),
        (2, [(2, "cleanup", 2, 11), (3, "activate", 2, 13), (6, "shutdown", 2, 12)]),
        (3, [(4, "deactivate", 3, 14), (7, "shutdown", 3, 12)]),
        (4, []),
    ],
)
def test_the_transitions_that_may_be_made_now_are_told(
    world: Any, start: int, transitions: list[tuple[int, str, int, int]]
) -> None:
    node = Recorder(world)
    for step in PATHS[start]:
        getattr(node, f"trigger_{step}")()
    found = Asker(world).ask(srv.GetAvailableTransitions, "get_available_transitions").available_transitions
    assert (
        sorted((t.transition.id, t.transition.label, t.start_state.id, t.goal_state.id) for t in found) == transitions
    )
    labels = dict(ALL_STATES)
    assert all(each.start_state.label == labels[each.start_state.id] for each in found)
    assert all(each.goal_state.label == labels[each.goal_state.id] for each in found)


def test_the_whole_graph_of_transitions_is_told(world: Any) -> None:
    Recorder(world)
    found = Asker(world).ask(srv.GetAvailableTransitions, "get_transition_graph").available_transitions
    names = {10: "success", 20: "success", 30: "success", 40: "success", 50: "success", 60: "success"}
    edges = {(t.transition.id, t.transition.label, t.start_state.id, t.goal_state.id) for t in found}
    outcomes = {
        10: (10, 2, 1, 15),
        20: (11, 1, 2, 15),
        30: (13, 3, 2, 15),
        40: (14, 2, 3, 15),
        50: (12, 4, 4, 15),
        60: (15, 1, 4, 4),
    }
    expected = {(1, "configure", 1, 10), (2, "cleanup", 2, 11), (3, "activate", 2, 13), (4, "deactivate", 3, 14)}
    expected |= {(4 + start, "shutdown", start, 12) for start in (1, 2, 3)}
    for first, (start, *goals) in outcomes.items():
        for index, word in enumerate((names[first], "failure", "error")):
            expected.add((first + index, f"transition_{word}", start, goals[index]))
    assert edges == expected
    assert len(found) == len(expected)


def test_every_transition_is_an_event(world: Any) -> None:
    node = Recorder(world)
    asker = Asker(world)
    heard: list[tuple[str, str]] = []
    asker.node.create_subscription(
        TransitionEvent, "/life/transition_event", lambda e: heard.append((e.start_state.label, e.goal_state.label)), 10
    )
    world.settle()
    node.trigger_configure()
    node.answers = {"activate": ERROR}
    node.trigger_activate()
    world.settle()
    assert heard == [
        ("unconfigured", "configuring"),
        ("configuring", "inactive"),
        ("inactive", "activating"),
        ("activating", "errorprocessing"),
        ("errorprocessing", "unconfigured"),
    ]


def test_a_node_without_an_interface_still_tells_its_transitions(world: Any) -> None:
    node = LifecycleNode("quiet", context=world.context, enable_communication_interface=False)
    services = [name for name, _ in node.get_service_names_and_types_by_node("quiet", "/")]
    assert not any("state" in name or "transition" in name for name in services)
    heard: list[str] = []
    world.node("listener").create_subscription(
        TransitionEvent, "/quiet/transition_event", lambda event: heard.append(event.goal_state.label), 10
    )
    assert node.trigger_configure() == SUCCESS
    world.settle()
    assert heard == ["configuring", "inactive"]
    with pytest.raises(TypeError, match="incompatible constructor arguments"):
        LifecycleNode("wrong", context=world.context, enable_communication_interface="no")  # type: ignore[arg-type]


def test_the_lifecycle_is_for_nodes_only() -> None:
    assert SameNode is LifecycleNode
    assert issubclass(LifecycleNode, Node)
    with pytest.raises(RuntimeError, match="LifecycleNodeMixin uses Node fields so Node needs to bein"):
        LifecycleNodeMixin()


# managed entities


class Follower(ManagedEntity):
    """Notes what it follows."""

    def __init__(self, answer: Any = SUCCESS) -> None:
        self.answer = answer
        self.followed: list[tuple[str, str]] = []


def _followed(name: str) -> Any:
    def callback(self: Follower, state: Any) -> Any:
        self.followed.append((name, state.label))
        return self.answer

    return callback


for _name in ("configure", "cleanup", "shutdown", "activate", "deactivate", "error"):
    setattr(Follower, f"on_{_name}", _followed(_name))


def test_managed_entities_follow_their_node(world: Any) -> None:
    node = Recorder(world)
    follower = Follower()
    node.add_managed_entity(follower)
    for step in ("configure", "activate", "deactivate", "cleanup", "shutdown"):
        assert getattr(node, f"trigger_{step}")() == SUCCESS
    assert follower.followed == [
        ("configure", "unconfigured"),
        ("activate", "inactive"),
        ("deactivate", "active"),
        ("cleanup", "inactive"),
        ("shutdown", "unconfigured"),
    ]
    with pytest.raises(TypeError, match=r"Expected a rclpy.lifecycle.ManagedEntity instance."):
        node.add_managed_entity(5)  # type: ignore[arg-type]


@pytest.mark.parametrize(("answer", "outcome", "state"), [(FAILURE, FAILURE, 1), (ERROR, ERROR, 4), ("yes", ERROR, 4)])
def test_an_entity_that_cannot_follow_stops_the_transition(world: Any, answer: Any, outcome: Any, state: int) -> None:
    node = Recorder(world)
    node.add_managed_entity(Follower(answer))
    assert node.trigger_configure() == outcome
    assert Asker(world).state() == state


def test_an_entity_is_by_default_content() -> None:
    entity = ManagedEntity()
    for name in ("configure", "cleanup", "shutdown", "activate", "deactivate", "error"):
        assert getattr(entity, f"on_{name}")(None) == SUCCESS


def test_a_simple_entity_works_while_it_is_enabled() -> None:
    said: list[str] = []

    class Speaker(SimpleManagedEntity):
        @SimpleManagedEntity.when_enabled
        def speak(self, word: str, *, twice: bool = False) -> None:
            """Say it."""
            said.append(word * (1 + twice))

        @SimpleManagedEntity.when_enabled(when_not_enabled=lambda: said.append("not now"))
        def shout(self) -> None:
            said.append("HEY")

    speaker = Speaker()
    assert not speaker.is_activated
    speaker.speak("a")
    speaker.shout()
    assert speaker.on_activate(None) == SUCCESS  # type: ignore[arg-type]
    assert speaker.is_activated
    speaker.speak("b", twice=True)
    speaker.shout()
    assert speaker.on_deactivate(None) == SUCCESS  # type: ignore[arg-type]
    assert not speaker.is_activated
    speaker.speak("c")
    assert said == ["not now", "bb", "HEY"]
    silent = speaker.when_enabled(lambda _self: said.append("never"))
    silent(speaker)
    assert len(said) == 3, "an object has the decorator too"
    assert Speaker.speak.__doc__ == "Say it."


def test_a_lifecycle_publisher_is_silent_while_its_node_is_not_active(world: Any) -> None:
    node = Recorder(world)
    heard: list[str] = []
    publisher = node.create_lifecycle_publisher(String, "chatter", 10)
    world.node("listener").create_subscription(String, "/chatter", lambda message: heard.append(message.data), 10)
    for word, step in (("1", "configure"), ("2", "activate"), ("3", "deactivate"), ("4", "cleanup")):
        publisher.publish(String(data=word))
        getattr(node, f"trigger_{step}")()
    publisher.publish(String(data="5"))
    world.settle()
    assert heard == ["3"]
    assert node.count_publishers("/chatter") == 1
    assert node.destroy_lifecycle_publisher(publisher)
    assert node.count_publishers("/chatter") == 0
    assert not node.destroy_lifecycle_publisher(publisher)
    with pytest.raises(TypeError, match=r"unexpected keyword argument 'publisher_class'"):
        node.create_lifecycle_publisher(String, "chatter", 10, publisher_class=object)


def test_a_state_machine_is_ready_with_its_node(world: Any) -> None:
    assert Recorder(world)._state_machine.initialized
