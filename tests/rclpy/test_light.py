"""A student's process starts light: no big imports, little memory, cheap nodes."""

from __future__ import annotations

import os
import sys
import time
from typing import Any

import pytest

from day6_core.ros.environment import program_environment
from tests.support.waiting import run

_NODE = """
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
rclpy.init()
node = Node('n')
publisher = node.create_publisher(String, 'c', 10)
node.create_subscription(String, 'c', lambda m: None, 10)
publisher.publish(String(data='x'))
rclpy.spin_once(node, timeout_sec=0)
node.get_logger().info('x')
"""


def _run(code: str) -> str:
    env = program_environment()
    env["DAY6_LINK"] = "off"
    done = run([sys.executable, "-c", code], env=env)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.process
def test_a_node_needs_neither_numpy_nor_asyncio_nor_yaml() -> None:
    loaded = set(_run(_NODE + "print('\\n'.join(sys.modules))").split())
    heavy = {"numpy", "asyncio", "yaml", "zenoh", "textual", "rich", "concurrent.futures", "json", "uuid"}
    assert loaded & heavy == set()


@pytest.mark.process
@pytest.mark.skipif(not os.path.exists("/proc/self/status"), reason="memory is read from /proc")
def test_a_process_with_a_node_stays_under_24_megabytes() -> None:
    code = _NODE + "print(next(line for line in open('/proc/self/status') if line.startswith('VmRSS')))"
    kilobytes = int(_run(code).split()[1])
    assert kilobytes < 24 * 1024


def test_a_further_node_costs_less_than_two_milliseconds(world: Any) -> None:
    from rclpy.node import Node

    nodes = [Node("warm_up", context=world.context)]
    times = []
    for number in range(30):
        start = time.thread_time()
        nodes.append(Node(f"n{number}", context=world.context))
        times.append(time.thread_time() - start)
    assert min(times) < 0.002, "in the quietest moment"


@pytest.mark.process
def test_the_names_of_rclpy_modules_appear_as_in_real_rclpy() -> None:
    code = """
import rclpy
def has(name):
    try: getattr(rclpy, name)
    except AttributeError: return False
    return True
print([name for name in ('qos', 'parameter', 'task', 'utilities', 'exceptions', 'node', 'executors', 'logging') if has(name)])
from rclpy.node import Node
print([name for name in ('node', 'executors', 'logging', 'timer', 'clock', 'event_handler', 'action') if has(name)])
"""
    before, after = _run(code).splitlines()
    assert before == "['qos', 'parameter', 'task', 'utilities', 'exceptions']"
    assert after == "['node', 'executors', 'logging', 'timer', 'clock', 'event_handler']"
