"""The end of programs: of one that destroys nothing (no object of ours may complain), and of one with a goal at work."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from day6_core.ros.environment import program_environment

pytestmark = pytest.mark.process

ACTION_IN_FLIGHT = """
import builtins
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node

def work(goal):
    goal.succeed()
    return Fibonacci.Result()

rclpy.init()
node = Node("both")
server = ActionServer(node, Fibonacci, "fibonacci", work)
client = ActionClient(node, Fibonacci, "fibonacci")
sent = client.send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin_until_future_complete(node, sent)
result = sent.result().get_result_async()
# What is held here outlives every module.
builtins.kept = [node, server, client, result]
"""

EVERY_KIND_OF_ENDPOINT = """
import rclpy
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.parameter_event_handler import ParameterEventHandler
from std_msgs.msg import String
from std_srvs.srv import Trigger

class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.me = self
        self.parts = [
            self.create_publisher(String, "out", 10),
            self.create_subscription(String, "out", print, 10),
            self.create_service(Trigger, "stop", lambda request, response: response),
            self.create_client(Trigger, "stop"),
            self.create_timer(1.0, self.get_name),
            self.create_guard_condition(self.get_name),
            self.create_rate(10),
            ParameterEventHandler(self),
        ]

rclpy.init()
robot = Robot()
camera = LifecycleNode("camera")
camera.trigger_configure()
robot.parts[3].call_async(Trigger.Request())
robot.parts[0].publish(String(data="left in a queue"))
"""

GOAL_AT_SHUTDOWN = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node

def tell(step):
    try:
        step()
    except Exception as error:
        print(f"{type(error).__name__}: {error}")

def work(goal):
    rclpy.shutdown()
    tell(lambda: goal.publish_feedback(Fibonacci.Feedback()))
    tell(goal.succeed)
    print(goal.status)
    return Fibonacci.Result()

rclpy.init()
node = Node("both")
server = ActionServer(node, Fibonacci, "fibonacci", work)
ActionClient(node, Fibonacci, "fibonacci").send_goal_async(Fibonacci.Goal(order=3))
rclpy.spin(node)
"""

NODE_IN_AN_EXECUTOR = """
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

class Robot(Node):
    def __del__(self):
        print("bye")

rclpy.init()
robot = Robot("robot")
executor = SingleThreadedExecutor()
executor.add_node(robot)
executor.spin_once(timeout_sec=0.01)
print("end")
"""


@pytest.mark.parametrize("link", ["on", "off"])
def test_a_node_that_is_left_over_is_destroyed_before_python_ends(link: str, tmp_path: Path) -> None:
    done = run(NODE_IN_AN_EXECUTOR, tmp_path, DAY6_LINK=link)
    assert (done.stdout, done.stderr) == ("end\nbye\n", "")


@pytest.mark.parametrize("program", [ACTION_IN_FLIGHT, EVERY_KIND_OF_ENDPOINT])
@pytest.mark.parametrize("end", ["", "rclpy.shutdown()", "raise SystemExit(0)"])
def test_a_program_that_just_ends_says_nothing_at_its_end(program: str, end: str, tmp_path: Path) -> None:
    # -X dev: also what Python says of files that are still open.
    done = run(f"{program}\n{end}\n", tmp_path, "-X", "dev")
    assert (done.stderr, done.returncode) == ("", 0)


def test_a_goal_that_is_being_executed_learns_from_its_feedback_that_ros_is_over(tmp_path: Path) -> None:
    # As recorded with the real rclpy: otherwise Ctrl-C would wait for the goal's end.
    done = run(GOAL_AT_SHUTDOWN, tmp_path)
    invalid = "feedback publisher is invalid, at /project/src/rcl_action/action_server.c:1040"
    assert done.stdout.splitlines() == [
        f"RCLError: Failed to publish feedback with an action server: {invalid}",
        f"RCLError: Failed get goal status array: {invalid}",
        "4",
    ], done.stderr


def run(program: str, home: Path, *options: str, **env: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *options, "-c", program],
        env={**program_environment(), "HOME": str(home), **env},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
