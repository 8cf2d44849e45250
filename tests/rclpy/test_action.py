"""Actions: goals and their states, feedback, cancelling, results, names, destruction."""

from __future__ import annotations

import gc
from threading import Event, Thread
from typing import Any

import pytest
from action_msgs.msg import GoalStatus, GoalStatusArray
from action_msgs.srv import CancelGoal
from builtin_interfaces.msg import Time
from std_msgs.msg import String
from test_msgs.action import Fibonacci
from unique_identifier_msgs.msg import UUID

from rclpy.action import (
    ActionClient,
    ActionServer,
    CancelResponse,
    GoalResponse,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from rclpy.exceptions import InvalidHandle
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
from tests.support.waiting import until

ACCEPTED, EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = range(1, 7)


def uuid(number: int) -> UUID:
    return UUID(uuid=[number] * 16)


class Pair:
    """A server whose goals wait until a test says what becomes of them, and a client."""

    def __init__(self, world: Any, **options: Any) -> None:
        self.world = world
        self.node = world.node("n")
        self.goals: list[Any] = []
        self.waiting: list[Future[Any]] = []
        options.setdefault("cancel_callback", lambda _: CancelResponse.ACCEPT)
        self.server: Any = ActionServer(self.node, Fibonacci, "count", self.execute, **options)
        self.client: Any = ActionClient(self.node, Fibonacci, "count")

    async def execute(self, goal: Any) -> Any:
        self.goals.append(goal)
        future: Future[Any] = Future()
        self.waiting.append(future)
        how = await future
        getattr(goal, how)()
        return Fibonacci.Result(sequence=[goal.request.order])

    def send(self, number: int = 1, **options: Any) -> Any:
        future = self.client.send_goal_async(Fibonacci.Goal(order=number), goal_uuid=uuid(number), **options)
        return self.world.until(future)

    def end(self, how: str, index: int = 0) -> None:
        self.waiting[index].set_result(how)
        self.world.settle()


@pytest.mark.parametrize(
    ("cancel", "how", "status"),
    [
        (False, "succeed", SUCCEEDED),
        (False, "abort", ABORTED),
        (True, "canceled", CANCELED),
        (True, "succeed", SUCCEEDED),
        (True, "abort", ABORTED),
    ],
)
def test_a_goal_goes_through_its_states(world: Any, cancel: bool, how: str, status: int) -> None:
    pair = Pair(world)
    handle = pair.send(5)
    assert handle.accepted
    assert handle.goal_id == uuid(5)
    world.settle()
    (goal,) = pair.goals
    assert (goal.is_active, goal.is_cancel_requested, goal.status, handle.status) == (True, False, EXECUTING, EXECUTING)
    assert goal.request.order == 5
    assert goal.goal_id == uuid(5)
    if cancel:
        response = world.until(handle.cancel_goal_async())
        assert response.return_code == CancelGoal.Response.ERROR_NONE
        assert [each.goal_id for each in response.goals_canceling] == [uuid(5)]
        world.settle()
        assert (goal.is_active, goal.is_cancel_requested, goal.status, handle.status) == (
            True,
            True,
            CANCELING,
            CANCELING,
        )
    asked = handle.get_result_async()
    world.settle()
    assert not asked.done()
    pair.end(how)
    assert (goal.is_active, goal.is_cancel_requested, goal.status, handle.status) == (False, False, status, status)
    answer = world.until(asked)
    assert (answer.status, list(answer.result.sequence)) == (status, [5])
    assert world.until(handle.get_result_async()).status == status


@pytest.mark.parametrize(
    ("before", "step"),
    [
        ([], "canceled"),
        (["succeed"], "abort"),
        (["succeed"], "succeed"),
        (["abort"], "succeed"),
        (["abort"], "canceled"),
    ],
)
def test_a_state_that_cannot_follow_is_refused(world: Any, before: list[str], step: str) -> None:
    pair = Pair(world)
    pair.send()
    world.settle()
    goal = pair.goals[0]
    for each in before:
        getattr(goal, each)()
    with pytest.raises(RuntimeError, match="goal_handle attempted invalid transition from state"):
        getattr(goal, step)()


@pytest.mark.parametrize(
    ("answer", "accepted"), [(GoalResponse.ACCEPT, True), (GoalResponse.REJECT, False), (True, False), (None, False)]
)
def test_a_goal_callback_accepts_or_refuses(world: Any, answer: Any, accepted: bool) -> None:
    asked: list[int] = []
    pair = Pair(world, goal_callback=lambda goal: asked.append(goal.order) or answer)
    handle = pair.send(3)
    assert asked == [3]
    assert handle.accepted is accepted
    world.settle()
    assert len(pair.goals) == accepted
    assert (handle.stamp.sec > 0) == accepted


def test_callbacks_may_be_coroutines(world: Any) -> None:
    async def take(_goal: Any) -> GoalResponse:
        return GoalResponse.ACCEPT

    async def cancel(_goal: Any) -> CancelResponse:
        return CancelResponse.ACCEPT

    pair = Pair(world, goal_callback=take, cancel_callback=cancel)
    handle = pair.send()
    assert handle.accepted
    world.settle()
    assert len(world.until(handle.cancel_goal_async()).goals_canceling) == 1


def test_a_goal_is_refused_when_its_id_is_known(world: Any) -> None:
    pair = Pair(world)
    assert pair.send(1).accepted
    assert not pair.send(1).accepted
    assert pair.send(2).accepted


def test_a_server_may_execute_a_goal_later(world: Any) -> None:
    kept: list[Any] = []
    pair = Pair(world, handle_accepted_callback=kept.append)
    handle = pair.send()
    world.settle()
    assert pair.goals == []
    assert handle.status == ACCEPTED
    kept[0].execute()
    world.settle()
    assert pair.goals == kept
    assert handle.status == EXECUTING


def test_a_goal_may_be_executed_by_another_function(world: Any) -> None:
    def other(goal: Any) -> Any:
        goal.succeed()
        return Fibonacci.Result(sequence=[99])

    pair = Pair(world, handle_accepted_callback=lambda goal: goal.execute(other))
    handle = pair.send()
    assert list(world.until(handle.get_result_async()).result.sequence) == [99]
    assert pair.goals == []


def test_a_goal_that_says_nothing_is_aborted(world: Any) -> None:
    node = world.node("n")
    ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result(sequence=[4]))
    client: Any = ActionClient(node, Fibonacci, "count")
    handle = world.until(client.send_goal_async(Fibonacci.Goal()))
    answer = world.until(handle.get_result_async())
    assert (answer.status, list(answer.result.sequence)) == (ABORTED, [4])


def test_a_goal_that_fails_is_aborted_with_an_empty_result(world: Any, capfd: Any) -> None:
    node = world.node("n")

    def fail(_: Any) -> Any:
        raise ValueError("broken")

    ActionServer(node, Fibonacci, "count", fail)
    client: Any = ActionClient(node, Fibonacci, "count")
    handle = world.until(client.send_goal_async(Fibonacci.Goal()))
    answer = world.until(handle.get_result_async())
    assert (answer.status, list(answer.result.sequence)) == (ABORTED, [])
    assert "ValueError: broken" in capfd.readouterr().err


# cancelling


def test_a_refused_cancellation_changes_nothing(world: Any) -> None:
    pair = Pair(world, cancel_callback=None)
    handle = pair.send()
    world.settle()
    response = world.until(handle.cancel_goal_async())
    assert list(response.goals_canceling) == []
    assert pair.goals[0].status == EXECUTING


def test_a_goal_can_be_cancelled_only_while_it_is_active(world: Any) -> None:
    pair = Pair(world)
    handle = pair.send()
    world.settle()
    pair.end("succeed")
    response = world.until(handle.cancel_goal_async())
    assert response.return_code == CancelGoal.Response.ERROR_GOAL_TERMINATED
    assert list(response.goals_canceling) == []


@pytest.mark.parametrize(
    ("number", "until", "code", "meant"),
    [
        (2, None, CancelGoal.Response.ERROR_NONE, [2]),
        (9, None, CancelGoal.Response.ERROR_UNKNOWN_GOAL_ID, []),
        (0, None, CancelGoal.Response.ERROR_NONE, [1, 2, 3]),
        (0, 2, CancelGoal.Response.ERROR_NONE, [1, 2]),
        (3, 1, CancelGoal.Response.ERROR_NONE, [1, 3]),
    ],
)
def test_id_and_time_of_a_request_choose_the_goals(
    world: Any, number: int, until: int | None, code: int, meant: list[int]
) -> None:
    pair = Pair(world)
    stamps = {}
    for each in (1, 2, 3):
        stamps[each] = pair.send(each).stamp
        world.run(1.0)
    asker = pair.node.create_client(CancelGoal, "count/_action/cancel_goal")
    request = CancelGoal.Request()
    request.goal_info.goal_id = uuid(number)
    request.goal_info.stamp = Time() if until is None else stamps[until]
    response = world.until(asker.call_async(request))
    assert response.return_code == code
    assert sorted(each.goal_id.uuid[0] for each in response.goals_canceling) == meant
    assert [goal.request.order for goal in pair.goals if goal.is_cancel_requested] == meant


# what the client hears


def test_feedback_comes_to_the_goal_it_is_about(world: Any) -> None:
    pair = Pair(world)
    heard: dict[int, list[list[int]]] = {1: [], 2: []}
    for number in (1, 2):
        pair.send(
            number, feedback_callback=lambda message, to=heard[number]: to.append(list(message.feedback.sequence))
        )
    world.settle()
    for goal in pair.goals:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[goal.request.order]))
    world.settle()
    assert heard == {1: [[1]], 2: [[2]]}
    with pytest.raises(TypeError):
        pair.goals[0].publish_feedback(Fibonacci.Result())


def test_feedback_ends_with_the_result(world: Any) -> None:
    pair = Pair(world)
    heard: list[Any] = []
    handle = pair.send(1, feedback_callback=heard.append)
    world.settle()
    asked = handle.get_result_async()
    goal = pair.goals[0]
    pair.end("succeed")
    world.until(asked)
    goal.publish_feedback(Fibonacci.Feedback())
    world.settle()
    assert heard == []


def test_the_states_of_all_goals_are_published(world: Any) -> None:
    pair = Pair(world)
    heard: list[GoalStatusArray] = []
    from rclpy.qos import qos_profile_action_status_default

    pair.node.create_subscription(
        GoalStatusArray, "count/_action/status", heard.append, qos_profile_action_status_default
    )
    pair.send(1)
    pair.send(2)
    world.settle()
    pair.end("succeed")
    latest = {bytes(each.goal_info.goal_id.uuid)[0]: each.status for each in heard[-1].status_list}
    assert latest == {1: GoalStatus.STATUS_SUCCEEDED, 2: GoalStatus.STATUS_EXECUTING}


def test_who_changes_a_state_that_was_published_changes_nobody_elses(world: Any) -> None:
    pair = Pair(world)
    from rclpy.qos import qos_profile_action_status_default

    def spoil(message: GoalStatusArray) -> None:
        for each in message.status_list:
            each.status, each.goal_info.stamp.sec = GoalStatus.STATUS_UNKNOWN, 7
            each.goal_info.goal_id.uuid[:] = 0
        message.status_list = []

    heard: list[GoalStatusArray] = []

    def listen(callback: Any) -> None:
        pair.node.create_subscription(
            GoalStatusArray, "count/_action/status", callback, qos_profile_action_status_default
        )

    listen(spoil)
    handle = pair.send(1)
    world.settle()
    listen(spoil)  # late: gets what was kept
    world.settle()
    listen(heard.append)
    world.settle()
    (state,) = heard[-1].status_list
    assert (bytes(state.goal_info.goal_id.uuid)[0], state.status) == (1, GoalStatus.STATUS_EXECUTING)
    assert state.goal_info.stamp.sec != 7 and handle.status == GoalStatus.STATUS_EXECUTING
    pair.end("succeed")
    assert handle.status == GoalStatus.STATUS_SUCCEEDED


def test_the_result_of_an_unknown_goal_is_unknown(world: Any) -> None:
    pair = Pair(world)
    asker = pair.node.create_client(Fibonacci.Impl.GetResultService, "count/_action/get_result")
    answer = world.until(asker.call_async(Fibonacci.Impl.GetResultService.Request(goal_id=uuid(9))))
    assert answer.status == GoalStatus.STATUS_UNKNOWN


@pytest.mark.parametrize(
    ("timeout", "seconds", "known"),
    [(10, 9.99, True), (10, 10.01, False), (3, 2.9, True), (3, 3.1, False), (0, 0.001, False)],
)
def test_a_result_is_kept_for_its_time(world: Any, timeout: int, seconds: float, known: bool) -> None:
    pair = Pair(world, result_timeout=timeout)
    handle = pair.send()
    world.settle()
    pair.end("succeed")
    world.run(seconds)
    expected = GoalStatus.STATUS_SUCCEEDED if known else GoalStatus.STATUS_UNKNOWN
    assert world.until(handle.get_result_async()).status == expected


def test_all_results_are_forgotten_in_the_end(world: Any) -> None:
    pair = Pair(world, result_timeout=10)
    handles = [pair.send(1), pair.send(2)]
    world.settle()
    pair.end("succeed", 0)
    world.run(6.0)
    pair.end("abort", 1)
    world.run(9.9)
    assert world.until(handles[1].get_result_async()).status == ABORTED
    world.run(0.2)
    assert [world.until(each.get_result_async()).status for each in handles] == [0, 0]


def test_a_result_cannot_be_kept_for_less_than_no_time(world: Any) -> None:
    with pytest.raises(ValueError, match="Failed to create action server: timer period must be non-negative"):
        Pair(world, result_timeout=-1)


def test_goals_are_equal_by_their_ids(world: Any) -> None:
    pair = Pair(world)
    one, two = pair.send(1), pair.send(2)
    world.settle()
    assert one != two
    assert one == one
    assert one != 5
    assert pair.goals[0] != pair.goals[1]
    assert pair.goals[0] != 5
    assert repr(one) == f"ClientGoalHandle <id={uuid(1).uuid}, accepted=True, status={EXECUTING}>"


def test_ids_are_made_by_chance(world: Any) -> None:
    pair = Pair(world)
    handles = [world.until(pair.client.send_goal_async(Fibonacci.Goal())) for _ in range(2)]
    ids = [bytes(each.goal_id.uuid) for each in handles]
    assert ids[0] != ids[1]
    assert {each[6] >> 4 for each in ids} == {4}
    assert {each[8] >> 6 for each in ids} == {2}


# wrong use


@pytest.mark.parametrize("side", [ActionServer, ActionClient])
def test_an_action_needs_a_type_and_a_name(world: Any, side: Any) -> None:
    node = world.node("n")
    more = [lambda _: None] if side is ActionServer else []
    with pytest.raises(
        ValueError, match=r"Failed to create action (server|client) due to invalid topic name 'bad name'"
    ):
        side(node, Fibonacci, "bad name", *more)
    with pytest.raises(AttributeError):
        side(node, int, "count", *more)


def test_a_goal_must_be_one_of_the_action(world: Any) -> None:
    client: Any = ActionClient(world.node("n"), Fibonacci, "count")
    for send in (client.send_goal_async, client.send_goal):
        with pytest.raises(TypeError, match="Expected goal type"):
            send(Fibonacci.Result())


def test_the_callback_that_executes_must_be_one(world: Any) -> None:
    with pytest.raises(TypeError, match="Failed to register goal execution callback: not callable"):
        ActionServer(world.node("n"), Fibonacci, "count", 5)  # type: ignore[arg-type]


# the graph


def test_actions_are_found_in_the_graph(world: Any) -> None:
    asker, worker = world.node("asker"), world.node("worker", namespace="lab")
    server: Any = ActionServer(worker, Fibonacci, "count", lambda _: Fibonacci.Result())
    client: Any = ActionClient(asker, Fibonacci, "/lab/count")
    asker.create_publisher(String, "feedback", 1)
    world.settle()
    expected = [("/lab/count", ["test_msgs/action/Fibonacci"])]
    assert get_action_names_and_types(asker) == expected
    assert get_action_server_names_and_types_by_node(asker, "worker", "/lab") == expected
    assert get_action_client_names_and_types_by_node(asker, "asker", "/") == expected
    assert get_action_server_names_and_types_by_node(asker, "asker", "/") == []
    assert get_action_client_names_and_types_by_node(asker, "worker", "/lab") == []
    with pytest.raises(RuntimeError):
        get_action_server_names_and_types_by_node(asker, "nobody", "/")
    server.destroy()
    client.destroy()
    world.settle()
    assert get_action_names_and_types(asker) == []
    asker.destroy_node()
    with pytest.raises(InvalidHandle):
        get_action_client_names_and_types_by_node(asker, "worker", "/lab")


def test_endpoints_that_nobody_holds_any_more_leave_the_graph(world: Any) -> None:
    from rclpy.action._protocol import ActionEndpoints

    node = world.node("n")
    ends = ActionEndpoints(node.handle, Fibonacci, "count", "failed")
    ends.publisher("feedback", Fibonacci.Impl.FeedbackMessage, QoSProfile(depth=1))
    world.settle()
    assert get_action_names_and_types(node) == [("/count", ["test_msgs/action/Fibonacci"])]
    node.handle.remove_user(ends)
    del ends
    gc.collect()
    world.settle()
    assert get_action_names_and_types(node) == []


def test_a_server_is_there_while_all_of_it_is(world: Any) -> None:
    node = world.node("n")
    client: Any = ActionClient(node, Fibonacci, "count")
    assert not client.server_is_ready()
    assert not client.wait_for_server(0.01)
    node.create_service(Fibonacci.Impl.SendGoalService, "count/_action/send_goal", lambda _, response: response)
    assert not client.server_is_ready()
    server: Any = ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result())
    assert client.wait_for_server(5)
    assert client in node.waitables
    assert server in node.waitables
    server.destroy()
    world.settle()
    assert server not in node.waitables
    assert not client.server_is_ready()
    client.destroy()
    assert client not in node.waitables
    with pytest.raises(RuntimeError):
        client.send_goal_async(Fibonacci.Goal())


def test_an_action_is_remapped(world: Any) -> None:
    node = world.node("n", cli_args=["--ros-args", "-r", "count/_action/feedback:=elsewhere"])
    ActionClient(node, Fibonacci, "count")
    assert node.count_subscribers("elsewhere") == 1
    assert node.count_subscribers("count/_action/status") == 1


def test_an_action_consists_of_known_entities(world: Any) -> None:
    pair = Pair(world)
    assert pair.server.get_num_entities().num_services == 3
    assert pair.server.get_num_entities().num_timers == 1
    assert pair.client.get_num_entities().num_clients == 3
    assert pair.client.get_num_entities().num_subscriptions == 2
    assert pair.server.action_type is Fibonacci


def test_a_call_that_blocks_returns_the_result(world: Any) -> None:
    from threading import Thread

    pair = Pair(world, handle_accepted_callback=lambda goal: goal.execute(ended))

    def ended(goal: Any) -> Any:
        goal.succeed()
        return Fibonacci.Result(sequence=[7])

    answers: list[Any] = []
    thread = Thread(target=lambda: answers.append(pair.client.send_goal(Fibonacci.Goal())), daemon=True)
    thread.start()
    for _ in range(10_000):
        world.settle()
        thread.join(0.001)
        if not thread.is_alive():
            break
    assert [(each.status, list(each.result.sequence)) for each in answers] == [(SUCCEEDED, [7])]


def test_an_action_tells_of_the_calls_of_its_services(world: Any) -> None:
    from rclpy.qos import QoSProfile
    from rclpy.service_introspection import ServiceIntrospectionState

    pair = Pair(world)
    events: list[Any] = []
    event_type = Fibonacci.Impl.SendGoalService.Event
    pair.node.create_subscription(event_type, "count/_action/send_goal/_service_event", events.append, 10)
    for side in (pair.server, pair.client):
        side.configure_introspection(pair.node.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.CONTENTS)
    world.settle()
    pair.send(3)
    world.settle()
    events.sort(key=lambda event: event.info.event_type)
    assert [event.info.event_type for event in events] == [0, 1, 2, 3]
    assert [event.request[0].goal.order for event in events[:2]] == [3, 3]
    assert [event.response[0].accepted for event in events[2:]] == [True, True]
    for side in (pair.server, pair.client):
        side.configure_introspection(pair.node.get_clock(), QoSProfile(depth=10), ServiceIntrospectionState.OFF)
    events.clear()
    pair.send(4)
    world.settle()
    assert events == []


@pytest.mark.parametrize("name", ["cancel_goal", "get_result"])
def test_blocking_calls_of_a_goal_wait_for_the_answer(world: Any, name: str) -> None:
    from threading import Thread

    pair = Pair(world)
    handle = pair.send()
    world.settle()
    if name == "get_result":
        pair.end("succeed")
    answers: list[Any] = []
    thread = Thread(target=lambda: answers.append(getattr(handle, name)()), daemon=True)
    thread.start()
    for _ in range(10_000):
        world.settle()
        thread.join(0.001)
        if not thread.is_alive():
            break
    (answer,) = answers
    assert len(answer.goals_canceling) == 1 if name == "cancel_goal" else answer.status == SUCCEEDED


def test_goals_end_with_the_context(world: Any) -> None:
    pair = Pair(world)
    pair.send()
    world.settle()
    (goal,) = pair.goals
    world.context.shutdown()
    for use in (goal.succeed, goal.abort, lambda: goal.publish_feedback(Fibonacci.Feedback())):
        with pytest.raises(RuntimeError):
            use()
    with pytest.raises(RuntimeError):
        pair.client.server_is_ready()


def test_a_goal_that_ends_while_its_cancellation_is_judged_is_not_cancelled(world: Any) -> None:
    def judge(goal: Any) -> CancelResponse:
        goal.succeed()
        return CancelResponse.ACCEPT

    pair = Pair(world, cancel_callback=judge)
    handle = pair.send()
    world.settle()
    response = world.until(handle.cancel_goal_async())
    assert list(response.goals_canceling) == []
    assert pair.goals[0].status == SUCCEEDED


def test_requests_of_all_kinds_are_answered_in_one_go(world: Any) -> None:
    pair = Pair(world)
    handles = [pair.send(number) for number in (1, 2)]
    world.settle()
    for number in (0, 1):
        pair.end("succeed", number)
    futures = [handle.get_result_async() for handle in handles for _ in range(2)]
    futures += [handle.cancel_goal_async() for handle in handles]
    futures.append(pair.client.send_goal_async(Fibonacci.Goal(order=3), goal_uuid=uuid(3)))
    world.settle()
    assert all(future.done() for future in futures)
    assert [list(future.result().result.sequence) for future in futures[:4]] == [[1], [1], [2], [2]]
    assert futures[-1].result().accepted


def test_two_servers_answer_and_the_second_answer_is_ignored(world: Any) -> None:
    pair = Pair(world)
    other = world.node("other")
    ActionServer(other, Fibonacci, "count", lambda goal: goal.succeed() or Fibonacci.Result())
    heard: list[str] = []
    from rcl_interfaces.msg import Log

    other.create_subscription(Log, "/rosout", lambda log: heard.append(log.msg), 10)
    world.settle()
    assert pair.send().accepted
    world.settle()
    assert "Ignoring unexpected goal response. There may be more than one action server for the action 'count'" in heard


def test_a_destroyed_server_answers_nothing(world: Any) -> None:
    pair = Pair(world)
    future = pair.client.send_goal_async(Fibonacci.Goal())
    pair.server.destroy()
    world.settle()
    assert not future.done()
    assert pair.node.count_services("count/_action/send_goal") == 0
    assert pair.node.count_publishers("count/_action/feedback") == 0


def test_the_client_of_a_destroyed_node_is_not_ready(world: Any) -> None:
    node = world.node("n")
    client: Any = ActionClient(node, Fibonacci, "count")
    node.destroy_node()
    with pytest.raises(RuntimeError):
        client.server_is_ready()


def test_a_destroyed_client_refuses_every_use(world: Any) -> None:
    pair = Pair(world)
    goal = pair.send()
    assert pair.client.server_is_ready()
    with pair.client:
        pair.client.destroy()
    for use, told in (
        (
            lambda: pair.client.send_goal_async(Fibonacci.Goal()),
            r"^Failed to send goal request: action client pointer is invalid, at /project/src/rcl_action/action_client",
        ),
        (
            pair.client.server_is_ready,
            r"^Failed to check if action server is available: rcl node pointer is invalid, at /project/src/rcl/node.c:386",
        ),
        (lambda: pair.client.wait_for_server(0), r"^Failed to check if action server is available: rcl node pointer"),
        (goal.cancel_goal_async, "^cannot use Destroyable because destruction was requested"),
        (goal.get_result_async, "^cannot use Destroyable because destruction was requested"),
        (pair.client.__enter__, "^cannot use Destroyable because destruction was requested"),
    ):
        with pytest.raises(RuntimeError, match=told):
            use()
    with pytest.raises(ValueError):
        pair.client.destroy()
    pair.end("succeed")


def test_a_destroyed_server_ends_its_goals_quietly(world: Any) -> None:
    pair = Pair(world)
    pair.send()
    world.settle()
    (goal,) = pair.goals
    with pair.server:
        pair.server.destroy()
    assert (goal.status, goal.is_active) == (GoalStatus.STATUS_UNKNOWN, False)
    goal.publish_feedback(Fibonacci.Feedback())
    with pytest.raises(TypeError):
        goal.publish_feedback(Fibonacci.Result())
    goal.succeed()
    with pytest.raises(RuntimeError, match="cannot use Destroyable because destruction was requested"):
        pair.server.__enter__()
    with pytest.raises(ValueError):
        pair.server.destroy()
    assert not pair.client.server_is_ready()
    pair.end("succeed")
    world.run(1000)


def test_callbacks_of_a_server_are_replaced_and_taken_back(world: Any) -> None:
    pair = Pair(world)
    answers: list[str] = []
    pair.server.register_goal_callback(lambda _: GoalResponse.REJECT)
    assert not pair.send(1).accepted
    pair.server.register_goal_callback(None)
    assert pair.send(2).accepted
    pair.server.register_cancel_callback(lambda _: answers.append("asked") or CancelResponse.ACCEPT)
    handle = pair.send(3)
    assert len(world.until(handle.cancel_goal_async()).goals_canceling) == 1
    pair.server.register_cancel_callback(None)
    other = pair.send(4)
    assert len(world.until(other.cancel_goal_async()).goals_canceling) == 0
    assert answers == ["asked"]
    pair.server.register_handle_accepted_callback(lambda _: answers.append("later"))
    before = len(pair.goals)
    assert pair.send(5).accepted
    world.settle()
    assert (len(pair.goals), answers) == (before, ["asked", "later"])
    pair.server.register_handle_accepted_callback(None)
    pair.send(6)
    world.settle()
    assert len(pair.goals) == before + 1
    with pytest.raises(TypeError, match="Failed to register goal execution callback: not callable"):
        pair.server.register_execute_callback("text")
    assert pair.server.action_type is Fibonacci


def test_a_wait_for_a_server_ends_with_its_time_or_when_it_comes(world: Any) -> None:
    client = ActionClient(world.node("n"), Fibonacci, "count")
    assert not client.wait_for_server(0)
    assert not client.wait_for_server(0.01)
    found: list[bool] = []
    listening = Event()
    listen = world.graph.add_listener
    world.graph.add_listener = lambda heard: listening.set() or listen(heard)
    thread = Thread(target=lambda: found.append(client.wait_for_server(30)), daemon=True)
    thread.start()
    until(lambda: listening.is_set() or not thread.is_alive())
    assert found == []
    ActionServer(world.node("m"), Fibonacci, "count", print)
    thread.join(30)
    assert found == [True]
    assert client.wait_for_server()


PARTS = {
    "send_goal": ("SendGoalService", True),
    "cancel_goal": ("CancelGoalService", True),
    "get_result": ("GetResultService", True),
    "feedback": ("FeedbackMessage", False),
    "status": ("GoalStatusMessage", False),
}


@pytest.mark.parametrize("missing", PARTS)
def test_a_server_that_lacks_a_part_is_not_ready(world: Any, missing: str) -> None:
    node = world.node("n")
    client = ActionClient(node, Fibonacci, "count")

    def make(part: str) -> None:
        name, is_service = PARTS[part]
        topic = f"count/_action/{part}"
        kind = getattr(Fibonacci.Impl, name)
        if is_service:
            node.create_service(kind, topic, print)
        else:
            latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            node.create_publisher(kind, topic, latched if part == "status" else 10)

    for part in PARTS:
        if part != missing:
            make(part)
    assert not client.server_is_ready()
    assert not client.wait_for_server(0.001)
    make(missing)
    assert client.server_is_ready()


def test_feedback_after_a_signal_ends_the_goal(world: Any) -> None:
    pair = Pair(world)
    pair.send()
    world.settle()
    world.interrupt()
    for use, told in (
        (
            lambda: pair.goals[0].publish_feedback(Fibonacci.Feedback()),
            "^Failed to publish feedback with an action server: ",
        ),
        (pair.goals[0].succeed, "^Failed get goal status array: "),
        (pair.client.server_is_ready, "^Failed to check if action server is available: rcl node's context is invalid"),
    ):
        with pytest.raises(RuntimeError, match=told):
            use()
