"""Executors as programs use them: their nodes, one callback at a time, timeouts, groups, custom executors, wait sets."""

from __future__ import annotations

import time
from contextlib import suppress
from threading import Barrier, Event, Thread
from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.executors import (
    ConditionReachedException,
    ExternalShutdownException,
    MultiThreadedExecutor,
    ShutdownException,
    SingleThreadedExecutor,
    TimeoutException,
    TimeoutObject,
    await_or_execute,
)
from rclpy.experimental import EventsExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation as low_level
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.task import Future
from rclpy.waitable import NumberOfEntities, Waitable
from tests.support.waiting import until


def test_a_node_is_in_one_executor(world: Any) -> None:
    first, second = (SingleThreadedExecutor(context=world.context) for _ in range(2))
    node = Node("n", context=world.context)
    assert node.executor is None
    assert first.add_node(node)
    assert not first.add_node(node)
    assert (node.executor, first.get_nodes()) == (first, [node])
    assert second.add_node(node)
    assert (node.executor, first.get_nodes(), second.get_nodes()) == (second, [], [node])
    second.remove_node(node)
    second.remove_node(node)
    assert second.get_nodes() == []
    node.executor = first
    assert first.get_nodes() == [node]
    node.executor = None
    assert (node.executor, first.get_nodes()) == (None, [])
    assert first.context is world.context


def test_one_spin_runs_one_callback(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []
    for number in range(3):
        node.create_guard_condition(lambda number=number: ran.append(number)).trigger()
    for count in range(1, 4):
        world.executor.spin_once(timeout_sec=0)
        assert len(ran) == count
    world.executor.spin_once(timeout_sec=0)
    assert ran == [0, 1, 2]


def test_entities_of_one_kind_run_node_by_node_in_the_order_in_which_they_were_made(world: Any) -> None:
    nodes = {name: world.node(name) for name in ("a", "b")}
    ran: list[str] = []
    guards = [
        node.create_guard_condition(lambda told=f"{name}{number}": ran.append(told))
        for number in (1, 2)
        for name, node in nodes.items()
    ]
    for guard in reversed(guards):
        guard.trigger()
    world.settle()
    assert ran in (["a1", "a2", "b1", "b2"], ["b1", "b2", "a1", "a2"])


def test_a_spin_without_work_ends_with_its_timeout() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    clock = Node("n", context=context).get_clock()
    start = clock.now()
    executor.spin_once(timeout_sec=0.05)
    assert (clock.now() - start).nanoseconds >= 50_000_000
    start = clock.now()
    executor.spin_until_future_complete(Future(), timeout_sec=0.05)
    assert (clock.now() - start).nanoseconds >= 50_000_000
    context.shutdown()


@pytest.mark.parametrize("outcome", ["result", "exception", "cancel"])
@pytest.mark.parametrize("kind", [SingleThreadedExecutor, MultiThreadedExecutor, EventsExecutor])
def test_a_spin_ends_when_its_future_is_done(kind: Any, outcome: str) -> None:
    context = Context()
    context.init([])
    executor = kind(context=context)
    node = Node("n", context=context)
    executor.add_node(node)
    # One without an executor that is cancelled while somebody waits for it: real rclpy 9.1.2 waits for ever, too.
    future: Future[int] = Future(executor=executor)
    ends = {
        "result": lambda: future.set_result(1),
        "exception": lambda: future.set_exception(ValueError()),
        "cancel": future.cancel,
    }
    timer = node.create_timer(0.005, lambda: timer.cancel() or ends[outcome]())
    thread = Thread(target=executor.spin_until_future_complete, args=(future,), daemon=True)
    thread.start()
    until(lambda: not thread.is_alive())
    assert future.done() or future.cancelled()
    assert future.exception() is None or outcome == "exception"
    executor.shutdown()
    context.shutdown()


def test_who_is_woken_between_its_look_and_its_wait_looks_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rclpy._day6.rounds._LONGEST_WAIT_NS", 3600 * 10**9)  # then it would look again in any case
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    looks: list[bool] = []

    def condition() -> bool:
        looks.append(bool(looks))
        executor.wake()  # what another thread does when it has made it true, a moment after the look
        return looks[-1]

    def wait() -> None:
        with suppress(ConditionReachedException):
            executor.wait_for_ready_callbacks(condition=condition)

    thread = Thread(target=wait, daemon=True)
    thread.start()
    until(lambda: not thread.is_alive())
    assert looks[:2] == [False, True]
    context.shutdown()


def test_an_executor_that_was_shut_down_runs_nothing(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []
    node.create_guard_condition(lambda: ran.append(1)).trigger()
    assert world.executor.shutdown()
    assert world.executor.get_nodes() == []
    world.executor.spin()
    assert ran == []
    with SingleThreadedExecutor(context=world.context) as executor:
        executor.add_node(node)
    assert executor.get_nodes() == []


def test_no_executor_without_a_context() -> None:
    context = Context()
    with pytest.raises(RuntimeError, match="Context must be initialized"):
        SingleThreadedExecutor(context=context)
    context.init([])
    context.shutdown()
    with pytest.raises(RuntimeError, match="the given context is not valid"):
        SingleThreadedExecutor(context=context)


def test_an_executor_of_threads_has_at_least_one() -> None:
    context = Context()
    context.init([])
    with pytest.raises(ValueError, match="max_workers must be greater than 0"):
        MultiThreadedExecutor(0, context=context)
    with pytest.warns(UserWarning, match="MultiThreadedExecutor is used with a single thread"):
        MultiThreadedExecutor(1, context=context).shutdown()
    context.shutdown()


def test_callbacks_of_a_group_exclude_each_other_and_others_do_not() -> None:
    context = Context()
    context.init([])
    node = Node("n", context=context)
    executor = MultiThreadedExecutor(3, context=context)
    executor.add_node(node)
    held, others = Event(), Event()
    ran: list[str] = []
    group = MutuallyExclusiveCallbackGroup()

    def hold() -> None:
        ran.append("hold")
        held.wait(10)
        ran.append("release")

    def after() -> None:
        ran.append("after")
        others.set()

    node.create_guard_condition(hold, group).trigger()
    node.create_guard_condition(after, group).trigger()
    free = node.create_guard_condition(lambda: ran.append("free") or held.set(), ReentrantCallbackGroup())
    thread = Thread(target=executor.spin, daemon=True)
    thread.start()
    free.trigger()
    assert others.wait(10)
    assert ran == ["hold", "free", "release", "after"] or ran[0] == "free"
    assert ran.index("release") < ran.index("after")
    executor.shutdown()
    context.shutdown()
    thread.join(10)


def test_a_group_knows_its_entities_and_who_may_run(world: Any) -> None:
    node = world.node("n")
    exclusive, reentrant = MutuallyExclusiveCallbackGroup(), ReentrantCallbackGroup()
    one, two = (node.create_guard_condition(lambda: None, exclusive) for _ in range(2))
    free = node.create_guard_condition(lambda: None, reentrant)
    assert exclusive.has_entity(one)
    assert not exclusive.has_entity(free)
    assert node.default_callback_group.has_entity(node.create_timer(1.0, lambda: None))
    assert exclusive.beginning_execution(one)
    assert not exclusive.can_execute(two)
    assert not exclusive.beginning_execution(two)
    assert not world.executor.can_execute(two)
    exclusive.ending_execution(one)
    assert exclusive.can_execute(two)
    assert reentrant.beginning_execution(free)
    assert reentrant.beginning_execution(free)
    assert reentrant.can_execute(free)
    reentrant.ending_execution(free)
    assert world.executor.can_execute(free)


def test_a_custom_executor_is_told_what_to_run(world: Any) -> None:
    executor = SingleThreadedExecutor(context=world.context)
    node = Node("n", context=world.context)
    executor.add_node(node)
    ran: list[str] = []
    guard = node.create_guard_condition(lambda: ran.append("guard"))
    guard.trigger()
    task, entity, found = executor.wait_for_ready_callbacks(timeout_sec=1)
    assert (entity, found, ran) == (guard, node, [])
    task()
    assert ran == ["guard"]
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(timeout_sec=0)
    with pytest.raises(ConditionReachedException):
        executor.wait_for_ready_callbacks(timeout_sec=1, condition=lambda: True)
    own = executor.create_task(lambda: ran.append("task"))
    task, entity, found = executor.wait_for_ready_callbacks(timeout_sec=1)
    assert (task, entity, found) == (own, None, None)
    executor.shutdown()
    with pytest.raises(ShutdownException):
        executor.wait_for_ready_callbacks(timeout_sec=0)


def test_a_timeout_can_be_changed() -> None:
    timeout = TimeoutObject(1.5)
    assert timeout.timeout == 1.5
    timeout.timeout = 2.5
    assert timeout.timeout == 2.5


def test_a_function_or_a_coroutine_is_run() -> None:
    async def double(number: int) -> int:
        return number * 2

    async def main() -> list[int]:
        return [await await_or_execute(double, 4), await await_or_execute(lambda number: number + 1, 4)]

    coroutine = main()
    with pytest.raises(StopIteration) as end:
        coroutine.send(None)
    assert end.value.value == [8, 5]


def test_an_external_shutdown_ends_a_spin() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    outcome: list[str] = []

    def spin() -> None:
        try:
            executor.spin_once(timeout_sec=10)
        except ExternalShutdownException:
            outcome.append("told")

    thread = Thread(target=spin, daemon=True)
    thread.start()
    thread.join(0.05)
    context.shutdown()
    thread.join(10)
    assert outcome == ["told"]


# waitables and wait sets


def test_numbers_of_entities_are_added() -> None:
    numbers = NumberOfEntities(1, 2, 3, 4, 5, 6)
    fields = ("subscriptions", "guard_conditions", "timers", "clients", "services", "events")
    assert [getattr(numbers, f"num_{name}") for name in fields] == [1, 2, 3, 4, 5, 6]
    total = numbers + NumberOfEntities(10, 20, 30, 40, 50, 60)
    assert [getattr(total, f"num_{name}") for name in fields] == [11, 22, 33, 44, 55, 66]
    total += numbers
    assert repr(total) == "<NumberOfEntities(12, 24, 36, 48, 60, 72)>"
    assert repr(NumberOfEntities()) == "<NumberOfEntities(0, 0, 0, 0, 0, 0)>"


class Ear(Waitable[Any]):
    """Waits for a subscription, a timer, a service and a client by their handles."""

    def __init__(self, node: Any, handles: dict[str, Any]) -> None:
        super().__init__(node.default_callback_group)
        self.handles = handles
        self.indices: dict[str, int] = {}
        self.heard: list[str] = []

    def __enter__(self) -> None:
        pass

    def __exit__(self, *_: object) -> None:
        pass

    def get_num_entities(self) -> NumberOfEntities:
        counts = {f"num_{short}": int(kind in self.handles) for kind, short in SHORT.items()}
        return NumberOfEntities(**counts)

    def add_to_wait_set(self, wait_set: Any) -> None:
        for kind, handle in self.handles.items():
            self.indices[kind] = getattr(wait_set, f"add_{kind}")(handle)

    def is_ready(self, wait_set: Any) -> bool:
        self.ready = [kind for kind, index in self.indices.items() if wait_set.is_ready(kind, index)]
        return bool(self.ready)

    def take_data(self) -> Any:
        for kind in self.ready:
            handle = self.handles[kind]
            if kind == "subscription":
                handle.take_message(String, False)
            elif kind == "timer":
                handle.call_timer()
            elif kind == "service":
                handle.service_take_request(Trigger.Request)
            elif kind == "client":
                handle.take_response(Trigger.Response)
        return list(self.ready)

    async def execute(self, taken_data: Any) -> None:
        self.heard.extend(taken_data)


class GuardEar(Waitable[Any]):
    """Calls a function when its guard condition was triggered."""

    def __init__(self, node: Node, callback: Any) -> None:
        super().__init__(node.default_callback_group)
        self.guard = low_level.GuardCondition(node.context.handle)
        self.trigger = self.guard.trigger_guard_condition
        self.callback = callback
        node.add_waitable(self)

    def add_to_wait_set(self, wait_set: Any) -> None:
        self.index = wait_set.add_guard_condition(self.guard)

    def is_ready(self, wait_set: Any) -> bool:
        return bool(wait_set.is_ready("guard_condition", self.index))

    def take_data(self) -> Any:
        pass

    async def execute(self, taken_data: Any) -> None:
        self.callback()


SHORT = {"subscription": "subs", "timer": "timers", "service": "services", "client": "clients"}


def test_a_waitable_waits_for_handles(world: Any) -> None:
    node = world.node("n")
    qos = QoSProfile(depth=5).get_c_qos_profile()
    handles = {
        "subscription": low_level.Subscription(node.handle, String, "t", qos),
        "service": low_level.Service(node.handle, Trigger, "s", qos),
        "client": low_level.Client(node.handle, Trigger, "s", qos),
        "timer": low_level.Timer(node.get_clock().handle, world.context.handle, 1_000_000_000, True),
    }
    ear = Ear(node, handles)
    node.add_waitable(ear)
    world.settle()
    assert ear.heard == []
    node.create_publisher(String, "t", 5).publish(String())
    world.settle()
    assert ear.heard == ["subscription"]
    assert handles["client"].service_server_is_available()
    assert handles["client"].send_request(Trigger.Request()) == 1
    world.settle()
    assert ear.heard == ["subscription", "service"]
    world.run(1.1)
    assert ear.heard == ["subscription", "service", "timer"]
    world.run(1.0)
    assert ear.heard == ["subscription", "service", "timer", "timer"]
    node.remove_waitable(ear)
    assert ear not in node.waitables
    with pytest.raises(ValueError):
        node.remove_waitable(ear)


@pytest.mark.parametrize("spinner", [SingleThreadedExecutor, EventsExecutor])
@pytest.mark.parametrize("kind", ["waitable", "guard condition"])
def test_what_is_removed_by_a_callback_that_was_ready_with_it_does_not_run(world: Any, kind: str, spinner: Any) -> None:
    node, heard = Node("n", context=world.context), []

    def made(name: str, and_then: Any = None) -> Any:
        def callback() -> None:
            heard.append(name)
            if and_then is not None:
                and_then()

        guard = node.create_guard_condition(callback) if kind != "waitable" else GuardEar(node, callback)
        guard.trigger()
        return guard

    remove = node.remove_waitable if kind == "waitable" else node.destroy_guard_condition
    made("first", lambda: remove(second))
    second = made("second")
    remove(made("gone before the first wait"))
    executor = spinner(context=world.context)
    executor.add_node(node)
    for _ in range(4):
        executor.spin_once(timeout_sec=0)
    assert heard == ["first"]
    if kind == "waitable":
        node.add_waitable(second)
        executor.spin_once(timeout_sec=0)
        assert heard == ["first", "second"]
    executor.shutdown()
    node.destroy_node()


def test_a_service_is_answered_by_hand(world: Any) -> None:
    node = world.node("n")
    qos = QoSProfile(depth=5).get_c_qos_profile()
    service = low_level.Service(node.handle, Trigger, "s", qos)
    client = low_level.Client(node.handle, Trigger, "s", qos)
    world.settle()
    assert service.service_take_request(Trigger.Request) == (None, None)
    assert client.take_response(Trigger.Response) == (None, None)
    number = client.send_request(Trigger.Request())
    world.settle()
    request, info = service.service_take_request(Trigger.Request)
    assert isinstance(request, Trigger.Request)
    assert info.request_id.sequence_number == number
    service.service_send_response(Trigger.Response(message="yes"), info.request_id)
    world.settle()
    info, response = client.take_response(Trigger.Response)
    assert (info.request_id.sequence_number, response.message) == (number, "yes")
    assert info.source_timestamp > 10**18
    assert service.name == client.service_name == "/s"


def test_a_timer_is_called_by_hand(world: Any) -> None:
    clock = world.node("n").get_clock()
    timer = low_level.Timer(clock.handle, world.context.handle, 50_000_000, True)
    assert timer.get_timer_period() == 50_000_000
    assert not timer.is_timer_ready()
    world.run(0.06)
    assert timer.is_timer_ready()
    timer.call_timer()
    assert not timer.is_timer_ready()
    assert 0 < timer.time_until_next_call() <= 50_000_000
    assert timer.time_since_last_call() < 50_000_000
    timer.change_timer_period(10)
    assert timer.get_timer_period() == 10
    timer.cancel_timer()
    assert timer.is_timer_canceled()
    assert timer.time_until_next_call() is None
    with pytest.raises(RuntimeError, match=r"Timer has been canceled|timer is canceled"):
        timer.call_timer()
    timer.reset_timer()
    assert not timer.is_timer_canceled()
    off = low_level.Timer(clock.handle, world.context.handle, 50, False)
    assert off.is_timer_canceled()


def test_a_wait_set_is_full_some_time_and_can_be_cleared(world: Any) -> None:
    node = world.node("n")
    qos = QoSProfile(depth=5).get_c_qos_profile()
    wait_set = low_level.WaitSet(1, 1, 1, 1, 1, 0, world.context.handle)
    handles = {
        "subscription": low_level.Subscription(node.handle, String, "t", qos),
        "guard_condition": low_level.GuardCondition(world.context.handle),
        "timer": low_level.Timer(node.get_clock().handle, world.context.handle, 1_000_000, True),
        "client": low_level.Client(node.handle, Trigger, "s", qos),
        "service": low_level.Service(node.handle, Trigger, "s", qos),
    }
    for kind, handle in handles.items():
        add = getattr(wait_set, f"add_{kind}")
        assert add(handle) == 0
        words = kind.replace("_", " ")
        with pytest.raises(RuntimeError, match=f"failed to add {words} to wait set: {kind}s set is full"):
            add(handle)
    handles["guard_condition"].trigger_guard_condition()
    wait_set.wait(0)
    assert wait_set.is_ready("guard_condition", 0)
    assert wait_set.get_ready_entities("guard_condition") == [handles["guard_condition"].pointer]
    assert not wait_set.is_ready("service", 0)
    with pytest.raises(IndexError, match="wait set index too big"):
        wait_set.is_ready("subscription", 1)
    with pytest.raises(RuntimeError, match="'nothing' is not a known entity"):
        wait_set.is_ready("nothing", 0)
    handles["client"].send_request(Trigger.Request())
    wait_set.clear_entities()
    for kind, handle in handles.items():
        assert getattr(wait_set, f"add_{kind}")(handle) == 0
    wait_set.wait(50_000_000)
    assert wait_set.is_ready("service", 0)


def test_who_waits_for_a_timer_comes_back_when_the_time_is_over() -> None:
    context = Context()
    context.init([])
    node = Node("n", context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    fired: list[int] = []
    node.create_timer(30.0, lambda: fired.append(1))
    start = time.monotonic()
    executor.spin_once(timeout_sec=0.05)
    assert 0.05 <= time.monotonic() - start < 15 and not fired
    node.create_timer(0.05, lambda: fired.append(2))
    executor.spin_once(timeout_sec=30.0)
    assert time.monotonic() - start < 15 and fired == [2]
    context.shutdown()


def test_a_wait_set_sleeps_while_it_waits(world: Any) -> None:
    wait_set = low_level.WaitSet(0, 0, 0, 0, 0, 0, world.context.handle)
    before = time.thread_time()
    wait_set.wait(500_000_000)
    assert time.thread_time() - before < 0.25


def test_a_wait_set_waits_for_its_time(world: Any) -> None:
    from time import monotonic

    wait_set = low_level.WaitSet(0, 1, 0, 0, 0, 0, world.context.handle)
    guard = low_level.GuardCondition(world.context.handle)
    wait_set.add_guard_condition(guard)
    start = monotonic()
    wait_set.wait(30_000_000)
    assert monotonic() - start >= 0.03
    assert not wait_set.is_ready("guard_condition", 0)
    thread = Thread(target=lambda: (Event().wait(0.02), guard.trigger_guard_condition()))
    thread.start()
    wait_set.wait(10_000_000_000)
    thread.join()
    assert wait_set.is_ready("guard_condition", 0)
    assert monotonic() - start < 9


def test_another_kind_of_spin_looks_anew_at_what_is_ready(world: Any) -> None:
    node = world.node("n")
    ran: list[str] = []
    for name in ("first", "second"):
        node.create_guard_condition(lambda name=name: ran.append(name)).trigger()
    world.executor.spin_once(timeout_sec=0)
    assert ran == ["first"]
    timer = node.create_timer(0.0, lambda: timer.cancel() or ran.append("timer"))
    world.executor.spin_once(timeout_sec=0.5)
    assert ran == ["first", "timer"], "the timer comes before what was left of the round"
    world.executor.spin_once(timeout_sec=0.5)
    assert ran == ["first", "timer", "second"]


def test_what_was_ready_stays_ready_while_a_node_is_away(world: Any) -> None:
    one, two = world.node("one"), world.node("two")
    ran: list[str] = []
    for name, node in (("one", one), ("two", two)):
        node.create_subscription(String, "t", lambda _, name=name: ran.append(name), 10)
    one.create_publisher(String, "t", 10).publish(String())
    world.executor.remove_node(one)
    world.settle()
    assert ran == ["two"]
    world.executor.add_node(one)
    world.settle()
    assert ran == ["two", "one"]


def test_one_callback_of_a_future_is_spun(world: Any) -> None:
    node = world.node("n")
    ran: list[int] = []
    guards = [node.create_guard_condition(lambda: ran.append(1)) for _ in range(2)]
    for guard in guards:
        guard.trigger()
    world.executor.spin_once_until_future_complete(Future(), timeout_sec=0)
    assert ran == [1]


def test_an_exception_of_a_task_comes_out(world: Any) -> None:
    def fail() -> None:
        raise KeyError("x")

    world.executor.create_task(fail)
    with pytest.raises(KeyError):
        world.settle()


def test_a_timer_without_a_callback_ends_the_spin(world: Any) -> None:
    node = world.node("n")
    node.create_timer(0.0, None)
    with pytest.raises(UnboundLocalError, match="cannot access local variable 'arg_name'"):
        world.executor.spin_once(timeout_sec=1)


def test_a_coroutine_is_given_to_a_custom_executor_too(world: Any) -> None:
    executor = SingleThreadedExecutor(context=world.context)
    node = Node("n", context=world.context)
    executor.add_node(node)
    gate: Future[str] = Future()
    ran: list[Any] = []

    async def wait() -> None:
        ran.append(await gate)

    group = MutuallyExclusiveCallbackGroup()
    node.create_guard_condition(wait, group).trigger()
    task, entity, _ = executor.wait_for_ready_callbacks(timeout_sec=1)
    task()
    assert ran == []
    assert not group.can_execute(entity)
    gate.set_result("open")
    task()
    assert ran == ["open"]
    assert group.can_execute(entity)


def test_a_spin_after_the_shutdown_says_so(world: Any) -> None:
    world.context.shutdown()
    with pytest.raises((RuntimeError, ExternalShutdownException)):
        world.executor.spin_once(timeout_sec=0)
    world.executor.spin()


def test_a_rate_whose_timer_is_gone_cannot_sleep(world: Any) -> None:
    node = world.node("n")
    rate = node.create_rate(10.0)
    (timer,) = node.timers
    node.destroy_timer(timer)
    rate.destroy()
    with pytest.raises(RuntimeError, match="Rate cannot sleep because it has been destroyed"):
        rate.sleep()


def test_who_waits_does_not_turn_in_circles() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    asked: list[int] = []
    with pytest.raises(TimeoutException):
        executor.wait_for_ready_callbacks(timeout_sec=0.1, condition=lambda: bool(asked.append(1)))
    assert len(asked) < 10
    context.shutdown()


def test_what_was_ready_is_run_where_the_node_went(world: Any) -> None:
    one, other = (SingleThreadedExecutor(context=world.context) for _ in range(2))
    node = Node("n", context=world.context)
    ran: list[str] = []
    guards = {name: node.create_guard_condition(lambda name=name: ran.append(name)) for name in "abcd"}
    one.add_node(node)
    for name in "abc":
        guards[name].trigger()
    one.spin_once(timeout_sec=0)
    guards["d"].trigger()
    assert ran == ["a"]
    other.add_node(node)
    for _ in range(5):
        other.spin_once(timeout_sec=0)
    assert sorted(ran) == ["a", "b", "c", "d"], "what lay in the first executor's round has gone with the node"
    one.spin_once(timeout_sec=0)
    assert len(ran) == 4
    guards["a"].trigger()
    one.add_node(node)
    one.spin_once(timeout_sec=0)
    assert ran[4:] == ["a"]


def test_timers_go_with_their_node(world: Any) -> None:
    one, other = (SingleThreadedExecutor(context=world.context) for _ in range(2))
    node = Node("n", context=world.context)
    ran: list[int] = []
    node.create_timer(1.0, lambda: ran.append(world.time.elapsed))
    one.add_node(node)
    one.spin_once(timeout_sec=0)
    other.add_node(node)
    world.time.elapsed += 1_500_000_000
    one.spin_once(timeout_sec=0)
    assert ran == []
    other.spin_once(timeout_sec=0)
    assert ran == [1_500_000_000]
    other.remove_node(node)
    world.time.elapsed += 1_000_000_000
    other.spin_once(timeout_sec=0)
    assert len(ran) == 1
    one.add_node(node)
    one.spin_once(timeout_sec=0)
    assert len(ran) == 2


@pytest.mark.parametrize("kind", ["timer", "guard condition", "timeout"])
def test_a_wait_set_wakes_for_the_first_of_what_it_waits_for(kind: str) -> None:
    context = Context()
    context.init([])
    clock = Clock(clock_type=ClockType.STEADY_TIME)
    wait_set = low_level.WaitSet(0, 1, 3, 0, 0, 0, context.handle)
    guard = low_level.GuardCondition(context.handle)
    wait_set.add_guard_condition(guard)
    hour = 3600 * 1_000_000_000
    soon = 20_000_000 if kind == "timer" else 2 * hour
    timers = [low_level.Timer(clock.handle, context.handle, period, True) for period in (hour, soon, 3 * hour)]
    for timer in timers:
        wait_set.add_timer(timer)
    timers[2].cancel_timer()
    thread = Thread(target=wait_set.wait, args=(10_000_000 if kind == "timeout" else hour,), daemon=True)
    thread.start()
    if kind == "guard condition":
        guard.trigger_guard_condition()
    thread.join(30)
    assert not thread.is_alive()
    assert [wait_set.is_ready("timer", index) for index in range(3)] == [False, kind == "timer", False]
    assert wait_set.is_ready("guard_condition", 0) is (kind == "guard condition")
    assert wait_set.get_ready_entities("timer") == [timers[1].pointer] * (kind == "timer")
    wait_set.wait(0)
    assert not wait_set.is_ready("guard_condition", 0), "it was ready once"
    context.shutdown()


def test_an_executor_of_threads_waits_at_its_end_for_what_runs_unless_told_otherwise() -> None:
    for waits in (True, False):
        context = Context()
        context.init([])
        executor = MultiThreadedExecutor(2, context=context)
        node = Node("n", context=context)
        executor.add_node(node)
        begun, free, ended = Event(), Event(), Event()

        def work(begun: Event = begun, free: Event = free, ended: Event = ended) -> None:
            begun.set()
            free.wait(30)
            ended.set()

        node.create_guard_condition(work).trigger()
        late: list[int] = []
        node.create_guard_condition(lambda late=late: late.append(1))
        executor.spin_once(timeout_sec=5)
        assert begun.wait(30)
        closing = Thread(target=executor.shutdown, kwargs={"wait_for_threads": waits}, daemon=True)
        closing.start()
        closing.join(0.1 if waits else 30)
        assert closing.is_alive() is waits
        assert not ended.is_set()
        free.set()
        closing.join(30)
        assert ended.wait(30)
        assert executor.get_nodes() == []
        executor.spin_once(timeout_sec=0)
        assert late == []
        context.shutdown()


def test_what_a_callback_raises_in_a_thread_comes_out_of_a_later_spin() -> None:
    context = Context()
    context.init([])
    executor = MultiThreadedExecutor(2, context=context)
    node = Node("n", context=context)
    executor.add_node(node)
    failed = Event()

    def fail() -> None:
        failed.set()
        raise KeyError("lost")

    idle = node.create_guard_condition(lambda: None)

    def spin() -> bool:
        idle.trigger()
        try:
            executor.spin_once(timeout_sec=0.01)
        except KeyError as error:
            return error.args == ("lost",)
        return False

    assert not spin()
    node.create_guard_condition(fail).trigger()
    assert until(spin)
    assert failed.is_set()
    assert not any(spin() for _ in range(3)), "it is told once"
    executor.shutdown()
    context.shutdown()


def test_what_an_executor_of_somebody_elses_marks_is_unmarked(world: Any) -> None:
    node = world.node("n")
    entities = (
        node.create_subscription(String, "t", print, 1),
        node.create_client(Trigger, "s"),
        node.create_service(Trigger, "s", print),
        node.create_timer(1.0, print),
        node.create_guard_condition(print),
        Ear(node, {}),
    )
    assert [entity._executor_event for entity in entities] == [False] * len(entities)


def test_a_false_alarm_is_no_work(world: Any) -> None:
    node = world.node("n")
    ran: list[str] = []
    subscription = node.create_subscription(String, "t", lambda _: ran.append("heard"), 10)
    guard = node.create_guard_condition(lambda: ran.append("guard"))
    for _ in range(2):
        node.create_publisher(String, "t", 10).publish(String())
    guard.trigger()
    subscription.destroy()
    world.executor.spin_once(timeout_sec=0)
    assert ran == ["guard"]
    guard.trigger()
    guard.callback = None
    world.executor.spin_once(timeout_sec=0)
    timer = node.create_timer(0.0, lambda: ran.append("timer"))
    timer.cancel()
    world.executor.spin_once(timeout_sec=0)
    assert ran == ["guard"]


def test_a_cancelled_task_is_not_run_and_a_waiting_one_goes_on_when_it_can(world: Any) -> None:
    ran: list[str] = []
    gate: Future[str] = Future()

    async def wait(name: str) -> str:
        ran.append(name)
        ran.append(name + await gate)
        return name

    cancelled = world.executor.create_task(wait, "a")
    cancelled.cancel()
    world.settle()
    assert (ran, cancelled.cancelled()) == ([], True)
    waiting, dropped = (world.executor.create_task(wait, name) for name in "bc")
    world.settle()
    assert ran == ["b", "c"]
    assert not world.executor._run_ready(), "who waits is not asked again"
    dropped.cancel()
    gate.set_result("!")
    world.settle()
    assert ran == ["b", "c", "b!"]
    assert (waiting.result(), dropped.cancelled()) == ("b", True)


def test_an_executor_of_somebody_elses_takes_what_is_ready_one_by_one(world: Any) -> None:
    executor = SingleThreadedExecutor(context=world.context)
    node = Node("n", context=world.context)
    executor.add_node(node)
    ran: list[str] = []
    guards = [node.create_guard_condition(lambda name=name: ran.append(name)) for name in "ab"]
    for guard in guards:
        guard.trigger()
    found = []
    for task, entity, owner in executor._wait_for_ready_callbacks(timeout_sec=0):
        task()
        found.append((entity, owner))
        if len(found) == 2:
            break
    assert (ran, found) == (["a", "b"], [(guard, node) for guard in guards])
    executor.create_task(ran.append, "task")
    task, entity, owner = executor.wait_for_ready_callbacks(timeout_sec=0)
    task()
    assert (ran[2:], entity, owner) == (["task"], None, None)


def test_two_threads_of_one_executor_share_the_work() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    node = Node("n", context=context)
    executor.add_node(node)
    both = Barrier(2)
    guards = [node.create_guard_condition(lambda: both.wait(30), ReentrantCallbackGroup()) for _ in range(2)]
    threads = [Thread(target=executor.spin_once, args=(limit,), daemon=True) for limit in (30.0, 31.0)]
    for thread in threads:
        thread.start()
    for guard in guards:
        guard.trigger()
    for thread in threads:
        thread.join(30)
    assert not any(thread.is_alive() for thread in threads), "each has run one of the callbacks, at the same time"
    assert not both.broken
    executor.shutdown()
    context.shutdown()


def test_a_thread_may_go_on_asking_while_another_one_waits_for_something_else() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    other = Thread(target=executor.spin_once, args=(30.0,), daemon=True)
    other.start()
    until(lambda: executor._waiting)
    for _ in range(3):
        executor.spin_once(timeout_sec=0)
    assert other.is_alive()
    executor.shutdown()
    other.join(30)
    context.shutdown()


def test_two_threads_cannot_ask_one_executor_for_the_same() -> None:
    context = Context()
    context.init([])
    executor = SingleThreadedExecutor(context=context)
    told: list[str] = []

    def spin() -> None:
        try:
            executor.spin_once(timeout_sec=30.0)
        except ValueError as error:
            told.append(str(error))

    threads = [Thread(target=spin, daemon=True) for _ in range(2)]
    for thread in threads:
        thread.start()
    until(lambda: told)
    assert told == ["generator already executing"]
    executor.shutdown()
    for thread in threads:
        thread.join(30)
        assert not thread.is_alive()
    assert len(told) == 1
    context.shutdown()
