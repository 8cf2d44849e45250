"""Measures the rclpy that this interpreter has and prints JSON: `bench.py --real` puts two of them side by side.

python rclpy_side.py [SECONDS for each measurement] [timer | sleep]

`timer` and `sleep` measure only how exactly a timer of 100 Hz comes, and a loop that sleeps: they are run at the same time.
"""

import itertools
import json
import statistics
import sys
import time

from geometry_msgs.msg import Twist
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import SetBool
from test_msgs.action import Fibonacci

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

GOALS = 200
SECONDS = float(sys.argv[1]) if len(sys.argv) > 1 else 2.0
PATIENCE = 5.0


def memory_kib():
    with open("/proc/self/status", encoding="utf-8") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))


def spin_until(executor, condition):
    end = time.perf_counter() + PATIENCE
    while not condition() and time.perf_counter() < end:
        executor.spin_once(timeout_sec=0.1)


def with_node(measure, *arguments):
    node, executor = Node(measure.__name__), SingleThreadedExecutor()
    executor.add_node(node)
    try:
        return measure(node, executor, *arguments)
    finally:
        executor.remove_node(node)
        node.destroy_node()


def publish_to_callback(node, executor, message, subscriptions):
    """Seconds from `publish` until every subscription's callback has run, median."""
    got = [0]

    def count(_):
        got[0] += 1

    topic = f"bench_{type(message).__name__}_{subscriptions}"
    held = [node.create_subscription(type(message), topic, count, 10) for _ in range(subscriptions)]
    publisher = node.create_publisher(type(message), topic, 10)
    spin_until(executor, lambda: publisher.get_subscription_count() == len(held))
    times = []
    end = time.perf_counter() + SECONDS
    while time.perf_counter() < end:
        wanted, began = got[0] + subscriptions, time.perf_counter()
        publisher.publish(message)
        spin_until(executor, lambda wanted=wanted: got[0] >= wanted)
        times.append(time.perf_counter() - began)
    return statistics.median(times)


def service(node, executor):
    """Seconds of a call with its answer, median."""

    def switch(request, response):
        response.success = request.data
        return response

    node.create_service(SetBool, "bench_switch", switch)
    client = node.create_client(SetBool, "bench_switch")
    client.wait_for_service(timeout_sec=PATIENCE)
    times = []
    end = time.perf_counter() + SECONDS
    while time.perf_counter() < end:
        began = time.perf_counter()
        future = client.call_async(SetBool.Request(data=True))
        executor.spin_until_future_complete(future, timeout_sec=PATIENCE)
        assert future.result().success
        times.append(time.perf_counter() - began)
    return statistics.median(times)


def action(node, executor):
    """Seconds from sending a goal until its result is there, median of as many goals: each is told of in all later states."""

    def execute(goal):
        goal.succeed()
        return Fibonacci.Result(sequence=[0, 1])

    server = ActionServer(node, Fibonacci, "bench_fib", execute)
    client = ActionClient(node, Fibonacci, "bench_fib")
    client.wait_for_server(timeout_sec=PATIENCE)
    times = []
    for _ in range(GOALS):
        began = time.perf_counter()
        accepted = client.send_goal_async(Fibonacci.Goal(order=2))
        executor.spin_until_future_complete(accepted, timeout_sec=PATIENCE)
        result = accepted.result().get_result_async()
        executor.spin_until_future_complete(result, timeout_sec=PATIENCE)
        assert list(result.result().result.sequence) == [0, 1]
        times.append(time.perf_counter() - began)
    client.destroy()
    server.destroy()
    return statistics.median(times)


def timer_jitter(node, executor):
    """Seconds by which the periods of a 100 Hz timer miss 10 ms: (median, 99th percentile)."""
    stamps = []
    node.create_timer(0.01, lambda: stamps.append(time.perf_counter()))
    end = time.perf_counter() + 2 * SECONDS
    while time.perf_counter() < end:
        executor.spin_once(timeout_sec=0.1)
    return missed(stamps)


def sleep_jitter():
    """The same of a loop that only sleeps until each period is over: what the machine itself lets a program have."""
    stamps = []
    due = time.perf_counter()
    end = due + 2 * SECONDS
    while due < end:
        due += 0.01
        time.sleep(max(0.0, due - time.perf_counter()))
        stamps.append(time.perf_counter())
    return missed(stamps)


def missed(stamps):
    by = sorted(abs(b - a - 0.01) for a, b in itertools.pairwise(stamps))
    return statistics.median(by), by[int(len(by) * 0.99)]


def hundred_nodes():
    """Seconds to make 100 nodes, and the KiB they take."""
    before, began = memory_kib(), time.perf_counter()
    nodes = [Node(f"bench_{number}") for number in range(100)]
    seconds, memory = time.perf_counter() - began, memory_kib() - before
    for node in nodes:
        node.destroy_node()
    return seconds, memory


def measured():
    joints = JointState(name=[f"joint_{n}" for n in range(10)], position=[0.1] * 10, velocity=[0.1] * 10)
    found = {"memory": memory_kib()}
    found["hundred_nodes"], found["hundred_nodes_memory"] = hundred_nodes()
    for name, message in (("String", String(data="x" * 20)), ("Twist", Twist()), ("JointState", joints)):
        found[f"publish_{name}"] = with_node(publish_to_callback, message, 1)
    for subscriptions in (10, 100):
        found[f"fan_out_{subscriptions}"] = with_node(publish_to_callback, String(data="x" * 20), subscriptions)
    found["service"] = with_node(service)
    found["action"] = with_node(action)
    return found


def main():
    rclpy.init()
    only = sys.argv[2] if len(sys.argv) > 2 else ""
    found = with_node(timer_jitter) if only == "timer" else sleep_jitter() if only == "sleep" else measured()
    rclpy.shutdown()
    print(json.dumps(found))


if __name__ == "__main__":
    main()
