"""Two students' programs in two processes: what is built on topics and services crosses the link for free."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

import pytest

from tests.link.link_harness import HOUR_OF_LEASE, ROOT, World
from tests.support.waiting import communicate, until

pytestmark = pytest.mark.process

SERVER = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from rclpy.task import Future
from std_msgs.msg import Empty

rclpy.init()
node = Node("fibonacci_server", namespace="/team")
node.declare_parameter("answer", 42)
heard_all = Future()
latched = QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL)
node.create_subscription(Empty, "heard_all", heard_all.set_result, latched)

async def execute(goal):
    feedback = Fibonacci.Feedback(sequence=[0, 1])
    for _ in range(1, goal.request.order):
        feedback.sequence.append(feedback.sequence[-1] + feedback.sequence[-2])
        goal.publish_feedback(feedback)
    await heard_all  # as in ROS, a result that overtakes feedback ends its delivery
    goal.succeed()
    return Fibonacci.Result(sequence=feedback.sequence)

server = ActionServer(node, Fibonacci, "fibonacci", execute)
rclpy.spin(node)
"""
ACTION_CLIENT = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from std_msgs.msg import Empty

rclpy.init()
node = Node("asker", namespace="/team")
client = ActionClient(node, Fibonacci, "fibonacci")
latched = QoSProfile(depth=1, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL)
heard_all = node.create_publisher(Empty, "heard_all", latched)
assert client.wait_for_server()
parts = []

def on_feedback(message):
    parts.append(len(message.feedback.sequence))
    if len(parts) == 4:
        heard_all.publish(Empty())

sent = client.send_goal_async(Fibonacci.Goal(order=5), feedback_callback=on_feedback)
rclpy.spin_until_future_complete(node, sent)
result = sent.result().get_result_async()
rclpy.spin_until_future_complete(node, result)
print(result.result().status, list(result.result().result.sequence), parts)
"""
PARAMETER_CLIENT = """
import rclpy
from rcl_interfaces.srv import GetParameters
from rclpy.node import Node

rclpy.init()
node = Node("asker")
client = node.create_client(GetParameters, "/team/fibonacci_server/get_parameters")
assert client.wait_for_service()
answer = client.call_async(GetParameters.Request(names=["answer"]))
rclpy.spin_until_future_complete(node, answer)
print(answer.result().values[0].integer_value)
print(("fibonacci_server", "/team") in node.get_node_names_and_namespaces())
"""
LATE_JOINER = """
import rclpy
from day6_core.link import link_of
from rclpy.qos import QoSDurabilityPolicy, QoSProfile
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("map_server")
latched = QoSProfile(depth=10, durability=QoSDurabilityPolicy.TRANSIENT_LOCAL)
node.create_publisher(String, "map", latched).publish(String(data="kept"))
end = node.create_publisher(String, "end", 1)
got = []
node.create_subscription(String, "end", lambda m: got.append(m.data), 1)
node.create_subscription(String, "map", lambda m: got.append(m.data), latched)
# The publisher's cache answers this as it answered the subscription before, in that order.
session = link_of(node.context._graph)._session
print(len(list(session.get("0/map/**/@adv/**?_anyke"))))
while "end" not in got:
    rclpy.spin_once(node)
    if "kept" in got:
        end.publish(String(data="end"))
print(got)
"""

INTERRUPTED = """
import signal, sys, threading
from day6_core import inbox
from day6_core.graph.endpoints import Service
from day6_core.link.announcing import Announcements
import rclpy
from rclpy.node import Node

def interrupt():
    if rclpy.ok():
        signal.raise_signal(signal.SIGINT)

class Declared(dict):
    def __setitem__(self, subject, tokens):
        if isinstance(subject, Service):
            interrupt()
        super().__setitem__(subject, tokens)

def put(self, item, put=inbox.Inbox.put):
    if threading.current_thread() is threading.main_thread():
        interrupt()
    put(self, item)

rclpy.init()
if sys.argv[1:] == ["called back"]:
    inbox.Inbox.put = put
else:
    init = Announcements.__init__
    def made(self, *arguments):
        init(self, *arguments)
        self._declared = Declared()
    Announcements.__init__ = made
Node("talker")
print("made")
"""
"""Ctrl-C in the worst moments: while Zenoh calls back in the main thread, and while it has just declared something."""


class Run(Protocol):
    """Starts a program, with `words` as its arguments."""

    def __call__(self, source: str, *words: str, stderr: int | None = None) -> subprocess.Popen[str]: ...


@pytest.fixture
def run(world: World, tmp_path: Path) -> Iterator[Run]:
    started: list[subprocess.Popen[str]] = []

    def start(source: str, *words: str, stderr: int | None = None) -> subprocess.Popen[str]:
        path = os.pathsep.join([str(ROOT / "core" / "ros" / "python"), *sys.path])
        settings = {"DAY6_RUNTIME_DIR": str(world.runtime), "DAY6_LINK": "on", "PYTHONPATH": path}
        file = tmp_path / f"program{len(started)}.py"
        file.write_text(source)
        program = subprocess.Popen(
            [sys.executable, str(file), *words],
            env={**os.environ, **settings},
            stdout=subprocess.PIPE,
            stderr=stderr,
            text=True,
        )
        started.append(program)
        return program

    yield start
    for program in started:
        program.kill()
        program.communicate()


def test_an_action_crosses_with_goal_feedback_and_result(run: Run) -> None:
    run(SERVER)
    output, _ = communicate(run(ACTION_CLIENT))
    assert output == "4 [0, 1, 1, 2, 3, 5] [3, 4, 5, 6]\n"


def test_a_parameter_is_read_from_another_process(run: Run) -> None:
    run(SERVER)
    output, _ = communicate(run(PARAMETER_CLIENT))
    assert output == "42\nTrue\n"


def test_a_late_joiner_in_the_publishers_own_process_gets_what_was_kept_once(run: Run) -> None:
    output, _ = communicate(run(LATE_JOINER))
    assert output == "1\n['kept', 'end']\n"


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to one process")
def test_ctrl_c_takes_a_programs_nodes_away_at_once(world: World, run: Run) -> None:
    desk = world.here()
    server = run(HOUR_OF_LEASE + SERVER)
    assert until(lambda: desk.nodes() == ["/team/fibonacci_server"])
    assert until(lambda: desk.endpoints("/team/fibonacci/_action/get_result"))
    server.send_signal(signal.SIGINT)
    assert until(lambda: desk.nodes() == [])
    communicate(server)
    assert server.returncode != 0


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to one process")
@pytest.mark.parametrize("moment", ["called back", "declared"])
def test_ctrl_c_while_a_node_is_announced_is_a_keyboard_interrupt(run: Run, moment: str) -> None:
    program = run(INTERRUPTED, moment, stderr=subprocess.PIPE)
    output, errors = communicate(program)
    assert errors.rstrip().endswith("KeyboardInterrupt") and errors.count("Traceback") == 1, errors
    assert (output, program.returncode) == ("", -signal.SIGINT)
