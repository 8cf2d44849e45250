"""tf2_echo: prints the transform between two frames again and again (tf2_ros/tf2_echo.cpp)."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from tf2_py import _rotation as rot
from tf2_ros import Buffer, TransformException

from day6_core.ros.programs.rclcpp import (
    STOPPED,
    CppException,
    create_node,
    init_and_remove_ros_arguments,
    log_interrupt,
)
from day6_core.ros.programs.tf2_ros.listening import listen
from rclpy.time import Time

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped

    from day6_core.session.session import Session
    from rclpy.node import Node

USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate]

This will echo the transform from the coordinate frame of the source_frame
to the coordinate frame of the target_frame. \n\
Note: This is the transform to get data from target_frame into the source_frame.
Default echo rate is 1 if echo_rate is not given.
"""

_FLOAT = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


class BadRate(Exception):
    """The rate isn't a number (status 2), or has text after the number (status 3)."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


def parse_rate(text: str) -> float:
    """Return the rate (Hz), read as std::stof does. Raises BadRate."""
    number = _FLOAT.match(text)
    if number is None:
        raise BadRate(2)
    if number.end() != len(text):
        raise BadRate(3)
    return float(text)


def listed(values: tuple[float, ...]) -> str:
    return "[" + ", ".join(f"{value:.3f}" for value in values) + "]"


def transform_text(found: TransformStamped) -> str:
    """Return the report of one transform: lengths in metres, angles in radians and degrees, and the matrix."""
    stamp, offset, turn = found.header.stamp, found.transform.translation, found.transform.rotation
    translation = (offset.x, offset.y, offset.z)
    rotation = (turn.x, turn.y, turn.z, turn.w)
    matrix = rot.matrix(rotation)
    angles = rot.roll_pitch_yaw(matrix)
    lines = [
        f"At time {stamp.sec}.{stamp.nanosec}",  # the original does not pad the nanoseconds
        f"- Translation: {listed(translation)}",
        f"- Rotation: in Quaternion {listed(rotation)}",
        f"- Rotation: in RPY (radian) {listed(angles)}",
        f"- Rotation: in RPY (degree) {listed(tuple(math.degrees(angle) for angle in angles))}",
        "- Matrix:",
    ]
    rows = [(*matrix[3 * row : 3 * row + 3], translation[row]) for row in range(3)]
    for row in (*rows, (0.0, 0.0, 0.0, 1.0)):
        lines.append("".join(f" {value:6.3f}" for value in row))
    return "\n".join(lines)


async def echo(session: Session, node: Node, buffer: Buffer, source: str, target: str, rate: float) -> None:
    ticks = session.every(1.0 / rate)
    clock = node.get_clock()
    logged_ns = 0
    while True:
        possible, reason = buffer.can_transform_core(source, target, Time())
        if possible:
            break
        now_ns = clock.now().nanoseconds
        if now_ns - logged_ns >= 1_000_000_000:
            logged_ns = now_ns
            node.get_logger().info(f"Waiting for transform {source} ->  {target}: {reason}")
        await anext(ticks)
    printed = False
    while True:
        try:
            session.print(transform_text(buffer.lookup_transform_core(source, target, Time())))
            printed = True
        except TransformException as error:
            now = clock.now().nanoseconds * 1e-9
            # std::cout keeps the three digits only from the first transform on.
            session.print(f"Failure at {now:.3f}" if printed else f"Failure at {now:g}")
            session.print(f"Exception thrown:{error}\nThe current list of frames is:\n{buffer.all_frames_as_string()}")
        session.stdout.flush()
        await anext(ticks)


async def main(session: Session) -> int:
    arguments = init_and_remove_ros_arguments(session)
    if len(arguments) not in (3, 4):
        session.print(USAGE, end="")
        return 1
    rate = 1.0
    if len(arguments) == 4:
        try:
            rate = parse_rate(arguments[3])
        except BadRate as error:
            session.print_error(f"Failed to convert rate argument '{arguments[3]}' to a floating-point number")
            return error.status
    if rate <= 0.0:
        raise CppException("rate must be greater than 0", "std::invalid_argument")
    node = create_node(session, "tf2_echo")
    buffer = Buffer()
    session.spawn(session.spin(node, listen(session, buffer)))
    try:
        await echo(session, node, buffer, arguments[1], arguments[2], rate)
    except STOPPED:
        log_interrupt(session)
    return 0
