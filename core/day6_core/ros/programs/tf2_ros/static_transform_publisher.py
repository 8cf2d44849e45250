"""static_transform_publisher: broadcasts one fixed frame (tf2_ros/static_transform_broadcaster_program.cpp)."""

from __future__ import annotations

import random
import re
import string
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from tf2_py import _rotation as rot

from day6_core.ros.programs.rclcpp import (
    STOPPED,
    CppException,
    create_node,
    init_and_remove_ros_arguments,
    log_interrupt,
)
from day6_core.ros.programs.tf2_ros.broadcasting import StaticTransformBroadcaster
from day6_core.ros.programs.tf2_ros.listening import log_without_node
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from day6_core.session.session import Session

USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW] [--roll ROLL] \
[--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

A command line utility for manually sending a static transform.

If no translation or orientation is provided, the identity transform will be published.

The translation offsets are in meters.

The rotation may be provided with roll, pitch, yaw euler angles in radians, or as a quaternion.

required arguments:
  --frame-id FRAME_ID parent frame
  --child-frame-id CHILD_FRAME_ID child frame id

optional arguments:
  --x X                 x component of translation
  --y Y                 y component of translation
  --z Z                 z component of translation
  --qx QX               x component of quaternion rotation
  --qy QY               y component of quaternion rotation
  --qz QZ               z component of quaternion rotation
  --qw QW               w component of quaternion rotation
  --roll ROLL           roll component Euler rotation
  --pitch PITCH         pitch component Euler rotation
  --yaw YAW             yaw component Euler rotation
"""

TRANSLATION = ("x", "y", "z")
QUATERNION = ("qx", "qy", "qz", "qw")
EULER = ("roll", "pitch", "yaw")
FRAMES = ("frame-id", "child-frame-id")

OLD_STYLE = {
    8: (*TRANSLATION, "yaw", "pitch", "roll", *FRAMES),
    9: (*TRANSLATION, *QUATERNION, *FRAMES),
}
"""What arguments without names mean, by their number."""

_FLOAT = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|\s*[+-]?(inf(inity)?|nan)", re.IGNORECASE)


class BadArguments(Exception):
    """The command line cannot be understood; the text says why."""


@dataclass
class Arguments:
    """One transform as the command line gives it: metres, a quaternion (x, y, z, w), names of frames."""

    translation: rot.Vector = rot.ORIGIN
    rotation: rot.Quaternion = rot.IDENTITY
    frame_id: str = ""
    child_frame_id: str = ""
    is_old_style: bool = False
    wants_help: bool = False


def number(option: str, text: str) -> float:
    """Return a number, read as std::stod does: what follows it does not matter. Raises BadArguments."""
    found = _FLOAT.match(text)
    if found is None:
        raise BadArguments(f"Failed to parse {option} argument as float")
    return float(found.group())


def parse(words: list[str], arguments: Arguments) -> None:
    """Read the words after the program's name into `arguments`. Raises BadArguments."""
    numbers: dict[str, float] = {}
    frames: dict[str, str] = {}
    nameless: list[str] = []
    rest = iter(range(len(words)))
    for place in rest:
        word = words[place]
        name = word[2:] if word.startswith("--") else ""
        if word in ("-h", "--help"):
            arguments.wants_help = True
        elif name in (*TRANSLATION, *QUATERNION, *EULER, *FRAMES):
            if next(rest, None) is None:
                raise BadArguments(f"Not enough arguments for {word}")
            if name in FRAMES:
                frames[name] = words[place + 1]
            else:
                numbers[name] = number(word, words[place + 1])
        else:
            nameless.append(word)
    if arguments.wants_help:
        return
    if _any(EULER, numbers) and _any(QUATERNION, numbers):
        raise BadArguments("Cannot specify both quaternion and Euler rotations")
    if len(nameless) in OLD_STYLE:
        arguments.is_old_style = True
        if frames or _any(TRANSLATION, numbers) or _any(QUATERNION, numbers):
            raise BadArguments("Cannot specify both new-style (flags) and old-style (arguments)")
        for name, text in zip(OLD_STYLE[len(nameless)], nameless, strict=True):
            if name in FRAMES:
                frames[name] = text
            else:
                numbers[name] = number(name, text)
    elif nameless:
        raise BadArguments("Extra unparsed arguments on command-line")
    _fill(arguments, numbers, frames)


def _any(names: tuple[str, ...], given: dict[str, float]) -> bool:
    return any(name in given for name in names)


def _fill(arguments: Arguments, numbers: dict[str, float], frames: dict[str, str]) -> None:
    x, y, z = (numbers.get(name, 0.0) for name in TRANSLATION)
    arguments.translation = (x, y, z)
    if _any(EULER, numbers):
        roll, pitch, yaw = (numbers.get(name, 0.0) for name in EULER)
        arguments.rotation = rot.from_roll_pitch_yaw(roll, pitch, yaw)
    if _any(QUATERNION, numbers):
        qx, qy, qz = (numbers.get(name, 0.0) for name in QUATERNION[:3])
        arguments.rotation = (qx, qy, qz, numbers.get("qw", 1.0))
    arguments.frame_id, arguments.child_frame_id = (frames.get(name, "") for name in FRAMES)
    if not arguments.frame_id:
        raise BadArguments("Frame id must not be empty")
    if not arguments.child_frame_id:
        raise BadArguments("Child frame id must not be empty")


def publish(session: Session, arguments: Arguments) -> Any:
    """Make the node, with the transform as parameters that cannot be changed, and publish it. Returns the node."""
    values: dict[str, float | str] = {}
    values.update(zip(("translation.x", "translation.y", "translation.z"), arguments.translation, strict=True))
    values.update(zip(("rotation.x", "rotation.y", "rotation.z", "rotation.w"), arguments.rotation, strict=True))
    values.update({"frame_id": arguments.frame_id, "child_frame_id": arguments.child_frame_id})
    suffix = "".join(random.choices(string.ascii_letters + string.digits, k=16))
    overrides: list[Parameter[Any]] = [Parameter(name, value=value) for name, value in values.items()]
    node = create_node(session, f"static_transform_publisher_{suffix}", parameter_overrides=overrides)
    stamp = node.get_clock().now().to_msg()
    for name, value in values.items():
        node.declare_parameter(name, value, ParameterDescriptor(read_only=True))
    if arguments.frame_id == arguments.child_frame_id:
        node.get_logger().error(
            f"cannot publish static transform from '{arguments.frame_id}' to '{arguments.child_frame_id}', exiting"
        )
        raise CppException("child_frame_id cannot equal frame_id")
    message = TransformStamped(child_frame_id=arguments.child_frame_id)
    message.header.stamp = stamp
    message.header.frame_id = arguments.frame_id
    offset, turn = message.transform.translation, message.transform.rotation
    offset.x, offset.y, offset.z = arguments.translation
    turn.x, turn.y, turn.z, turn.w = arguments.rotation
    StaticTransformBroadcaster(node).sendTransform(message)
    return node


async def main(session: Session) -> int:
    arguments = Arguments()
    problem = None
    try:
        parse(init_and_remove_ros_arguments(session)[1:], arguments)
    except BadArguments as error:
        problem = str(error)
    if arguments.is_old_style:
        log_without_node(session, "WARN", "Old-style arguments are deprecated; see --help for new-style arguments")
    if problem is not None:
        log_without_node(session, "ERROR", f"error parsing command line arguments: {problem}")
    if problem is not None or arguments.wants_help:
        session.print(USAGE, end="")
        return 0 if problem is None else 1
    node = publish(session, arguments)
    quoted = [", ".join(f"'{value:f}'" for value in part) for part in (arguments.translation, arguments.rotation)]
    node.get_logger().info(
        f"Spinning until stopped - publishing transform\ntranslation: ({quoted[0]})\nrotation: ({quoted[1]})\n"
        f"from '{arguments.frame_id}' to '{arguments.child_frame_id}'"
    )
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0
