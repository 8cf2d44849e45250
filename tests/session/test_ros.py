"""A cooperative program with nodes: spinning, waiting, the world clock, the end."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import Graph
from day6_core.session.clock import WorldClock
from day6_core.session.program import Program
from day6_core.session.scheduler import Scheduler
from day6_core.session.session import Main, Session
from day6_core.session.streams import Captured


class Machine:
    def __init__(self) -> None:
        self.scheduler = Scheduler(WorldClock(wall=None, epoch_ns=1_700_000_000_000_000_000))
        self.graph = Graph(0)
        self.out, self.err = Captured(), Captured()

    def start(self, main: Main, *argv: str) -> Program:
        session = Session(
            self.scheduler, self.graph, list(argv) or ["program"], env={}, stdout=self.out, stderr=self.err
        )
        program = Program(session, main)
        self.scheduler.advance()
        return program

    def node_names(self) -> list[str]:
        return sorted(node.name for node in self.graph.nodes)


@pytest.fixture
def machine() -> Machine:
    return Machine()


async def talker(session: Session) -> None:
    from std_msgs.msg import String

    node = session.create_node("talker")
    publisher = node.create_publisher(String, "chatter", 10)
    count = 0

    def tick() -> None:
        nonlocal count
        count += 1
        publisher.publish(String(data=f"hello {count}"))

    node.create_timer(0.5, tick)
    await session.spin(node)


async def listener(session: Session) -> None:
    from std_msgs.msg import String

    node = session.create_node("listener")
    node.create_subscription(
        String, "chatter", lambda message: session.print(session.clock.steady_ns(), message.data), 10
    )
    await session.spin(node)


def test_a_timer_fires_at_its_exact_times_and_is_heard_at_once(machine: Machine) -> None:
    machine.start(talker)
    machine.start(listener)
    machine.scheduler.advance(1.6)
    assert machine.out.text.splitlines() == ["500000000 hello 1", "1000000000 hello 2", "1500000000 hello 3"]


def test_ctrl_c_comes_out_of_spin_and_the_node_is_gone(machine: Machine) -> None:
    program = machine.start(talker)
    assert machine.node_names() == ["talker"]
    program.interrupt()
    machine.scheduler.advance()
    assert program.status == 130
    assert machine.node_names() == []
    assert machine.err.text == ""


def test_an_exception_of_a_callback_comes_out_of_spin_and_ends_this_program_only(machine: Machine) -> None:
    async def broken(session: Session) -> None:
        node = session.create_node("broken")

        def tick() -> None:
            raise ZeroDivisionError("division by zero")

        node.create_timer(0.1, tick)
        await session.spin(node)

    program = machine.start(broken)
    other = machine.start(talker)
    machine.scheduler.advance(1)
    assert program.status == 1
    assert machine.err.text == "program: division by zero\n"
    assert other.status is None
    assert machine.node_names() == ["talker"]


def test_ros_arguments_of_the_command_line_reach_the_node(machine: Machine) -> None:
    machine.start(talker, "talker", "--ros-args", "-r", "__node:=other", "-r", "chatter:=news")
    assert machine.node_names() == ["other"]


def test_logs_go_to_the_programs_own_error_stream_with_the_worlds_time(machine: Machine) -> None:
    async def main(session: Session) -> None:
        session.create_node("speaker").get_logger().info("hello")

    machine.start(main)
    assert machine.err.text == "[INFO] [1700000000.000000000] [speaker]: hello\n"


def test_spin_until_gives_a_services_answer_or_gives_up(machine: Machine) -> None:
    from std_srvs.srv import Trigger

    async def server(session: Session) -> None:
        node = session.create_node("server")

        def answer(request: Any, response: Any) -> Any:
            response.message = "yes"
            return response

        node.create_service(Trigger, "ask", answer)
        await session.spin(node)

    async def client(session: Session) -> None:
        node = session.create_node("client")
        session.executor.add_node(node)
        asker = node.create_client(Trigger, "ask")
        future = asker.call_async(Trigger.Request())
        session.print(await session.spin_until(future, timeout=1.0))
        session.print(future.result().message)
        nobody = node.create_client(Trigger, "nobody")
        session.print(await session.spin_until(nobody.call_async(Trigger.Request()), timeout=1.0))
        session.print(session.clock.steady_ns())

    machine.start(server)
    program = machine.start(client)
    machine.scheduler.advance(2)
    assert program.status == 0, machine.err.text
    assert machine.out.text.splitlines() == ["True", "yes", "False", "1000000000"]


def test_a_future_can_be_awaited_while_a_child_task_spins(machine: Machine) -> None:
    from std_srvs.srv import Trigger

    async def both(session: Session) -> None:
        node = session.create_node("both")
        node.create_service(Trigger, "ask", lambda request, response: response)
        session.spawn(session.spin(node))
        answer = await node.create_client(Trigger, "ask").call_async(Trigger.Request())
        session.print(type(answer).__name__)

    program = machine.start(both)
    machine.scheduler.advance(0.1)
    assert program.status == 0, machine.err.text
    assert machine.out.text == "Trigger_Response\n"


def test_spin_returns_when_the_context_is_shut_down(machine: Machine) -> None:
    async def main(session: Session) -> int:
        node = session.create_node("short")
        node.create_timer(0.1, session.context.shutdown)
        await session.spin(node)
        return 5

    program = machine.start(main)
    machine.scheduler.advance(1)
    assert program.status == 5


def test_spin_some_takes_at_most_one_message_of_each_subscription(machine: Machine) -> None:
    from std_msgs.msg import Int32

    async def main(session: Session) -> None:
        node = session.create_node("both")
        session.executor.add_node(node)
        publisher = node.create_publisher(Int32, "numbers", 10)
        heard: list[int] = []
        node.create_subscription(Int32, "numbers", lambda message: heard.append(message.data), 10)
        for number in range(3):
            publisher.publish(Int32(data=number))
        session.spin_some()
        session.print(heard)
        session.spin_some()
        session.print(heard)

    program = machine.start(main)
    assert program.status == 0, machine.err.text
    assert machine.out.text.splitlines() == ["[0]", "[0, 1]"]


def test_a_stopped_node_neither_publishes_nor_hears(machine: Machine) -> None:
    program = machine.start(talker)
    machine.start(listener)
    machine.scheduler.advance(0.6)
    program.stop()
    machine.scheduler.advance(5)
    assert machine.out.text.splitlines() == ["500000000 hello 1"]
    program.resume()
    machine.scheduler.advance(1)
    assert len(machine.out.text.splitlines()) > 1
