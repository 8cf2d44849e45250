"""Recording and playing on the stepped machine, as commands are typed."""

from __future__ import annotations

import re

import yaml
from std_msgs.msg import Int32


def counter(topic="count", hertz=10.0, qos=10):
    """A node that publishes 0, 1, 2 … with so many messages a second."""

    def build(node):
        publisher = node.create_publisher(Int32, topic, qos)
        node.count = 0

        def tick():
            publisher.publish(Int32(data=node.count))
            node.count += 1

        node.timer = node.create_timer(1 / hertz, tick)

    return build


def counted_bag(machine):
    """Record /count for two seconds on a machine, then let nobody publish any more."""
    node = machine.node("counter", counter())
    record(machine, "--topics", "/count")
    node.destroy_timer(node.timer)
    return machine


def lines(text: str) -> list[str]:
    """A log without its stamps."""
    return [re.sub(r"\[\d+\.\d{9}\] ", "", line) for line in text.splitlines()]


def record(machine, *words, seconds=2.05):
    command = machine.start("bag", "record", "-o", "bag", *words)
    for _ in range(round(seconds / 0.05)):
        command.step(0.05)
    command.interrupt()
    return command


def play(machine, *words):
    return machine.start("bag", "play", "bag", "--disable-keyboard-controls", *words)


def heard(machine, kind=Int32, topic="count", qos=100):
    found = []
    machine.node(f"ear_{topic.strip('/').replace('/', '_')}", lambda node: node.create_subscription(
        kind, topic, lambda message: found.append((machine.clock.steady_ns(), message)), qos
    ))  # fmt: skip
    return found


def wait_for_end(command, seconds=20.0):
    for _ in range(round(seconds / 0.01)):
        if command.status is not None:
            return
        command.step(0.01)
    raise AssertionError("it goes on and on")


def information(machine):
    return yaml.safe_load((machine.cwd / "bag" / "metadata.yaml").read_text())["rosbag2_bagfile_information"]


def call(machine, node, service, name, **fields):
    future = node.create_client(service, name).call_async(service.Request(**fields))
    for _ in range(100):
        machine.step(0.001)
        if future.done():
            return future.result()
    raise AssertionError(f"no answer from {name}")
