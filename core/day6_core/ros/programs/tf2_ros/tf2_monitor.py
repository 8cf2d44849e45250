"""tf2_monitor: how late and how often transforms come (tf2_ros/tf2_monitor.cpp)."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, TransformException

from day6_core.ros.programs.rclcpp import (
    STOPPED,
    CppException,
    create_node,
    init_and_remove_ros_arguments,
    log_interrupt,
)
from day6_core.ros.programs.tf2_ros.listening import listen
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time

if TYPE_CHECKING:
    from collections.abc import Iterable

    from day6_core.session.session import Session
    from rclpy.node import Node

AUTHORITY = "<no authority available>"
"""ROS 2 does not report who sent a message."""

KEPT = 1000
"""Number of delays that are averaged."""

PERIOD_S = 0.5
ROUNDS = 20
"""Results are printed when more than this many periods have passed."""

LOWPASS = 0.01


class Delays:
    """Delays of transforms (seconds between their stamp and their arrival), by frame and of whole messages."""

    def __init__(self) -> None:
        self.of_frame: dict[str, deque[float]] = {}
        self.of_messages: deque[float] = deque(maxlen=KEPT)
        self.arrivals: deque[float] = deque(maxlen=KEPT)

    def take(self, message: TFMessage, now: float) -> None:
        """Note a message that came at `now` (seconds)."""
        total = 0.0
        for transform in message.transforms:
            stamp = transform.header.stamp
            delay = now - (stamp.sec + stamp.nanosec * 1e-9)
            total += delay
            self.of_frame.setdefault(transform.child_frame_id, deque(maxlen=KEPT)).append(delay)
        self.of_messages.append(total / max(1, len(message.transforms)))
        self.arrivals.append(now)

    def frame_lines(self, chain: list[str] | None) -> list[str]:
        """Return a line per frame, or per frame of a chain."""
        lines = []
        for frame, delays in sorted(self.of_frame.items()):
            times = 1 if chain is None else chain.count(frame)
            average, longest = _summary(delays)
            line = f"Frame: {frame}, published by {AUTHORITY}, Average Delay: {average:g}, Max Delay: {longest:g}"
            lines += [line] * times
        return lines

    def broadcaster_lines(self) -> list[str]:
        """Return a line about all messages, none if there were none."""
        if not self.arrivals:
            return []
        rate = len(self.arrivals) / max(0.00000001, self.arrivals[-1] - self.arrivals[0])
        average, longest = _summary(self.of_messages)
        return [f"Node: {AUTHORITY} {rate:g} Hz, Average Delay: {average:g} Max Delay: {longest:g}"]


def _summary(delays: deque[float]) -> tuple[float, float]:
    return sum(delays) / len(delays), max(0.0, *delays)


class Monitor:
    """The node's part: hears transforms and prints results. `frames` are the two of a chain, or None for all."""

    def __init__(self, session: Session, node: Node, buffer: Buffer, frames: tuple[str, str] | None) -> None:
        self._session = session
        self._node = node
        self._buffer = buffer
        self._frames = frames
        self._chain: list[str] | None = None
        self._delays = Delays()

    async def run(self) -> None:
        if self._frames is not None:
            await self._find_chain(*self._frames)
        latched = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._node.create_subscription(TFMessage, "/tf", self._on_transforms, QoSProfile(depth=100))
        self._node.create_subscription(TFMessage, "/tf_static", self._on_transforms, latched)
        what = "all frames" if self._frames is None else " -> ".join(self._frames)
        self._print([f"Gathering data on {what} for 10 seconds..."])
        average = longest = 0.0
        rounds = 0
        while True:
            rounds += 1
            if self._frames is not None:
                delay = self._net_delay(*self._frames)
                average = LOWPASS * delay + (1 - LOWPASS) * average
                longest = max(longest, delay)
            await self._session.sleep(PERIOD_S)
            if rounds > ROUNDS:
                rounds = 0
                self._report(average, longest)

    async def _find_chain(self, first: str, second: str) -> None:
        logged_ns = 0
        while True:
            possible, reason = self._buffer.can_transform_core(first, second, Time())
            if possible:
                break
            now_ns = self._node.get_clock().now().nanoseconds
            if now_ns - logged_ns >= 1_000_000_000:
                logged_ns = now_ns
                self._node.get_logger().info(f"Waiting for transform {first} ->  {second}: {reason}")
            await self._session.sleep(PERIOD_S)
        self._chain = self._buffer._chain(second, Time(), first, Time(), second)

    def _on_transforms(self, message: TFMessage) -> None:
        self._delays.take(message, self._now())

    def _now(self) -> float:
        return float(self._node.get_clock().now().nanoseconds) * 1e-9

    def _net_delay(self, first: str, second: str) -> float:
        try:
            stamp = self._buffer.lookup_transform_core(first, second, Time()).header.stamp
        except TransformException as error:
            raise CppException(str(error), f"tf2::{type(error).__name__}") from error
        return self._now() - float(stamp.sec + stamp.nanosec * 1e-9)

    def _report(self, average: float, longest: float) -> None:
        if self._frames is None:
            self._print(["", "", "", "RESULTS: for all Frames"])
        else:
            first, second = self._frames
            self._print(
                ["", "", "", f"RESULTS: for {first} to {second}", f"Chain is: {' -> '.join(self._chain or [])}"]
            )
            self._print([f"Net delay     avg = {average:g}: max = {longest:g}"])
        self._print(["", "Frames:", *self._delays.frame_lines(self._chain)])
        self._session.print_error("\nAll Broadcasters:")
        self._print(self._delays.broadcaster_lines())

    def _print(self, lines: Iterable[str]) -> None:
        for line in lines:
            self._session.print(line)
        self._session.stdout.flush()


async def main(session: Session) -> int:
    arguments = init_and_remove_ros_arguments(session)
    node = create_node(session, "tf2_monitor_main")
    if len(arguments) not in (1, 3):
        node.get_logger().info("TF_Monitor: usage: tf2_monitor framea frameb")
        return 255
    frames = (arguments[1], arguments[2]) if len(arguments) == 3 else None
    buffer = Buffer(node=node)
    session.spawn(session.spin(node, listen(session, buffer)))
    try:
        await Monitor(session, node, buffer, frames).run()
    except STOPPED:
        log_interrupt(session)
    return 0
