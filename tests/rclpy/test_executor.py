"""How executors run callbacks: order, rounds, timers by the clock they were given, waking, exceptions."""

from __future__ import annotations

import threading
import time
from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import Trigger

from day6_core.graph import Graph
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from tests.support.waiting import share_of_a_core, until

SECOND = 1_000_000_000


def test_what_is_ready_together_runs_timers_first_then_subscriptions_guards_clients_and_services(world: Any) -> None:
    node = world.node("n")
    ran: list[str] = []

    def serve(_request: Any, response: Any) -> Any:
        ran.append("service")
        return response

    node.create_service(Trigger, "s", serve)
    client = node.create_client(Trigger, "s")
    guard = node.create_guard_condition(lambda: ran.append("guard"))
    node.create_subscription(String, "b", lambda _: ran.append("b"), 10)
    node.create_subscription(String, "a", lambda _: ran.append("a"), 10)
    publishers = [node.create_publisher(String, name, 10) for name in "ab"]
    timer = node.create_timer(1.0, lambda: ran.append("timer"))
    client.call_async(Trigger.Request())
    guard.trigger()
    for publisher in publishers:
        publisher.publish(String())
    world.time.elapsed += SECOND
    world.executor._run_ready()
    timer.cancel()
    assert ran == ["timer", "b", "a", "guard", "service"]


def test_each_subscription_gets_one_message_a_round(world: Any) -> None:
    node = world.node("n")
    heard: list[str] = []
    for name in "xy":
        node.create_subscription(String, name, lambda m, name=name: heard.append(name + m.data), 10)
    for name in "yx":
        publisher = node.create_publisher(String, name, 10)
        for number in "12":
            publisher.publish(String(data=number))
    assert world.executor._run_ready()
    assert heard == ["x1", "y1"]
    assert world.executor._run_ready()
    assert heard == ["x1", "y1", "x2", "y2"]
    assert not world.executor._run_ready()


def test_a_timer_fires_exactly_at_each_whole_period_of_the_session_clock(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    node.create_timer(0.016, lambda: ticks.append(world.time.elapsed))
    world.run(1.008)
    assert ticks == [16_000_000 * number for number in range(1, 64)]


def test_periods_that_were_missed_are_left_out(world: Any) -> None:
    node = world.node("n")
    ticks: list[int] = []
    node.create_timer(1.0, lambda: ticks.append(world.time.elapsed))
    world.time.elapsed = round(3.5 * SECOND)
    world.settle()
    world.run(1.0)
    assert ticks == [round(3.5 * SECOND), 4 * SECOND]


def test_the_next_deadline_is_that_of_the_earliest_timer_and_none_without_timers(world: Any) -> None:
    node = world.node("n")
    assert world.executor._next_deadline() is None
    node.create_timer(2.0, lambda: None)
    early = node.create_timer(0.5, lambda: None)
    assert world.executor._next_deadline() == SECOND // 2
    early.cancel()
    assert world.executor._next_deadline() == 2 * SECOND
    early.reset()
    assert world.executor._next_deadline() == SECOND // 2


def test_the_wake_callback_is_called_when_something_becomes_ready(world: Any) -> None:
    node = world.node("n")
    node.create_subscription(String, "c", lambda _: None, 10)
    publisher = node.create_publisher(String, "c", 10)
    world.settle()
    woken: list[int] = []
    world.executor._set_wake(lambda: woken.append(1))
    publisher.publish(String())
    assert woken
    world.settle()
    woken.clear()
    node.create_timer(1.0, lambda: None)
    assert woken, "a new earliest timer changes the deadline"
    world.executor._set_wake(None)
    woken.clear()
    publisher.publish(String())
    assert not woken


def test_an_exception_of_a_callback_comes_out_and_the_group_is_free_again(world: Any) -> None:
    node = world.node("n")
    heard: list[str] = []

    def callback(message: String) -> None:
        heard.append(message.data)
        if message.data == "bad":
            raise ValueError(message.data)

    node.create_subscription(String, "c", callback, 10)
    publisher = node.create_publisher(String, "c", 10)
    publisher.publish(String(data="bad"))
    publisher.publish(String(data="good"))
    with pytest.raises(ValueError, match="bad"):
        world.settle()
    world.settle()
    assert heard == ["bad", "good"]


def test_messages_of_a_node_without_executor_wait_for_it(world: Any) -> None:
    node = world.node("n")
    heard: list[str] = []
    node.create_subscription(String, "c", lambda m: heard.append(m.data), 10)
    publisher = node.create_publisher(String, "c", 10)
    world.executor.remove_node(node)
    publisher.publish(String(data="kept"))
    world.settle()
    assert heard == []
    other = SingleThreadedExecutor(context=world.context)
    other.add_node(node)
    assert other._run_ready()
    assert heard == ["kept"]
    assert node.executor is other


def test_a_node_that_moves_in_the_middle_of_a_round_loses_nothing(world: Any) -> None:
    node = world.node("n")
    heard: list[str] = []
    for name in "abc":
        node.create_subscription(String, name, lambda _m, name=name: heard.append(name), 10)
        node.create_publisher(String, name, 10).publish(String())
    world.executor.spin_once(timeout_sec=0)
    other = SingleThreadedExecutor(context=world.context)
    other.add_node(node)
    while other._run_ready():
        continue
    assert sorted(heard) == ["a", "b", "c"]


def test_a_coroutine_waits_for_a_future_without_holding_up_others(world: Any) -> None:
    node = world.node("n")
    gate: Future[str] = Future()
    seen: list[Any] = []

    async def patient() -> None:
        seen.append("waiting")
        seen.append(await gate)

    task = world.executor.create_task(patient)
    world.settle()
    assert seen == ["waiting"]
    assert not world.executor._run_ready(), "a waiting coroutine is not polled"
    node.create_timer(1.0, lambda: gate.set_result("open") if not gate.done() else None)
    world.run(1.0)
    assert seen == ["waiting", "open"]
    assert task.done()


def test_a_mutually_exclusive_group_keeps_the_next_callback_back_until_a_coroutine_has_ended(world: Any) -> None:
    node = world.node("n")
    gate: Future[None] = Future()
    order: list[str] = []

    async def callback(message: String) -> None:
        order.append(f"in {message.data}")
        await gate
        order.append(f"out {message.data}")

    node.create_subscription(String, "c", callback, 10, callback_group=MutuallyExclusiveCallbackGroup())
    publisher = node.create_publisher(String, "c", 10)
    publisher.publish(String(data="1"))
    publisher.publish(String(data="2"))
    world.settle()
    assert order == ["in 1"]
    gate.set_result(None)
    world.settle()
    assert order == ["in 1", "out 1", "in 2", "out 2"]


def _machine_context() -> Context:
    context = Context()
    context._graph = Graph()
    context.init([])
    return context


def test_a_message_from_another_thread_wakes_a_waiting_executor_at_once() -> None:
    context = _machine_context()
    node = Node("n", context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    delays: list[float] = []
    sent = [0.0]
    node.create_subscription(String, "c", lambda _: delays.append((time.monotonic() - sent[0]) * share_of_a_core()), 10)
    publisher = node.create_publisher(String, "c", 10)
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    for number in range(1, 21):
        until(lambda: executor._waiting)
        sent[0] = time.monotonic()
        publisher.publish(String())
        until(lambda number=number: len(delays) == number)
    executor.shutdown()
    thread.join(5)
    assert not thread.is_alive()
    assert sorted(delays)[10] < 0.02
    context.shutdown()


def test_reentrant_callbacks_run_at_the_same_time_in_a_multi_threaded_executor() -> None:
    context = _machine_context()
    node = Node("n", context=context)
    together = threading.Barrier(2, timeout=5)
    met: list[int] = []

    def callback(_message: String) -> None:
        together.wait()
        met.append(1)

    group = ReentrantCallbackGroup()
    node.create_subscription(String, "c", callback, 10, callback_group=group)
    publisher = node.create_publisher(String, "c", 10)
    executor = MultiThreadedExecutor(2, context=context)
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    publisher.publish(String())
    publisher.publish(String())
    until(lambda: len(met) == 2)
    executor.shutdown()
    thread.join(5)
    context.shutdown()


def test_an_exception_in_a_worker_thread_comes_out_of_spin() -> None:
    context = _machine_context()
    node = Node("n", context=context)
    executor = MultiThreadedExecutor(2, context=context)
    executor.add_node(node)
    caught: list[BaseException] = []

    def fail() -> None:
        raise KeyError("boom")

    def spin() -> None:
        try:
            executor.spin()
        except KeyError as error:
            caught.append(error)

    thread = threading.Thread(target=spin, daemon=True)
    thread.start()
    node.create_guard_condition(fail).trigger()
    thread.join(5)
    assert caught and caught[0].args == ("boom",)
    executor.shutdown()
    context.shutdown()


def test_a_shutdown_of_the_context_ends_a_waiting_spin() -> None:
    context = _machine_context()
    executor = SingleThreadedExecutor(context=context)
    outcome: list[type[BaseException] | None] = []

    def spin() -> None:
        try:
            executor.spin()
            outcome.append(None)
        except ExternalShutdownException as error:
            outcome.append(type(error))

    thread = threading.Thread(target=spin, daemon=True)
    thread.start()
    until(lambda: executor._waiting)
    context.shutdown()
    thread.join(5)
    assert outcome == [ExternalShutdownException]


def test_two_threads_that_spin_one_executor_are_told_so() -> None:
    context = _machine_context()
    executor = SingleThreadedExecutor(context=context)
    thread = threading.Thread(target=executor.spin_once, daemon=True)
    thread.start()
    until(lambda: executor._waiting)
    with pytest.raises(ValueError, match="generator already executing"):
        executor.spin_once()
    executor.shutdown()
    thread.join(5)
    context.shutdown()


def test_a_programs_own_waitable_runs_when_its_guard_condition_was_triggered(world: Any) -> None:
    from rclpy.guard_condition import GuardCondition
    from rclpy.waitable import NumberOfEntities, Waitable

    class Bell(Waitable[int]):
        def __init__(self, node: Node) -> None:
            super().__init__(node.default_callback_group)
            self.guard = GuardCondition(None, None, context=node.context)
            self.index = -1
            self.rung = 0

        def get_num_entities(self) -> NumberOfEntities:
            return NumberOfEntities(num_gcs=1)

        def add_to_wait_set(self, wait_set: Any) -> None:
            self.index = wait_set.add_guard_condition(self.guard.handle)

        def is_ready(self, wait_set: Any) -> bool:
            return bool(wait_set.is_ready("guard_condition", self.index))

        def take_data(self) -> int:
            return 1

        async def execute(self, taken_data: int) -> None:
            self.rung += taken_data

    node = world.node("n")
    bell = Bell(node)
    node.add_waitable(bell)
    world.settle()
    assert bell.rung == 0
    bell.guard.trigger()
    world.settle()
    world.settle()
    assert bell.rung == 1
