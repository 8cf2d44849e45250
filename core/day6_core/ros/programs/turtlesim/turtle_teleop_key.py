"""turtle_teleop_key: drives turtle1 from the keyboard (turtlesim/teleop_turtle_key.cpp).

Keys are read byte by byte, as the original reads them, so an arrow is the last byte of its escape sequence: 0x41 to
0x44. That is why a capital A, B, C or D (Caps Lock) drives the turtle too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist

from day6_core.ros.differences import value
from day6_core.ros.programs.rclcpp import CppException, create_node
from day6_core.ros.programs.turtlesim._qos import TOPIC_QOS
from day6_core.ros.programs.turtlesim_interfaces import RotateAbsolute
from rclpy.action import ActionClient

if TYPE_CHECKING:
    from day6_core.session.session import Session

_HELP = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use {turns} keys to rotate to absolute orientations. '{cancel}' to cancel a rotation.
'{quit}' to quit.
"""

ARROWS = {  # key byte -> name, linear, angular
    "A": ("UP", 1.0, 0.0),
    "B": ("DOWN", -1.0, 0.0),
    "C": ("RIGHT", 0.0, -1.0),
    "D": ("LEFT", 0.0, 1.0),
}

HEADINGS = {  # key -> radians; on the keyboard they lie around f as on a compass
    "g": 0.0,
    "t": 0.7854,
    "r": 1.5708,
    "e": 2.3562,
    "d": 3.1416,
    "c": -2.3562,
    "v": -1.5708,
    "b": -0.7854,
}


class Teleop:
    """The node: what each key does."""

    def __init__(self, session: Session) -> None:
        self.node = create_node(session, "teleop_turtle")
        self.node.declare_parameter("scale_angular", 2.0)
        self.node.declare_parameter("scale_linear", 2.0)
        self._twists = self.node.create_publisher(Twist, "turtle1/cmd_vel", TOPIC_QOS)
        self._rotations: ActionClient[Any, Any, Any] = ActionClient(
            self.node, RotateAbsolute, "turtle1/rotate_absolute"
        )
        self._goal: Any = None

    def press(self, key: str) -> bool:
        """Handle a key (one character); return False for the one that quits. Other keys do nothing."""
        debug = self.node.get_logger().debug
        debug(f"value: 0x{ord(key):02X}\n")
        if key in ARROWS:
            name, linear, angular = ARROWS[key]
            debug(name)
            self._drive(linear, angular)
        elif key in HEADINGS:
            debug(key.upper())
            self._rotate(HEADINGS[key])
        elif key == "f":
            debug("F")
            self._cancel()
        elif key == "q":
            debug("quit")
            return False
        return True

    def _drive(self, linear: float, angular: float) -> None:
        twist = Twist()
        twist.angular.z = self.node.get_parameter("scale_angular").value * angular
        twist.linear.x = self.node.get_parameter("scale_linear").value * linear
        self._twists.publish(twist)

    def _rotate(self, theta: float) -> None:
        goal = RotateAbsolute.Goal()
        goal.theta = theta
        self._rotations.send_goal_async(goal).add_done_callback(self._answered)

    def _answered(self, future: Any) -> None:
        self.node.get_logger().debug("Goal response received")
        goal = future.result()
        self._goal = goal if goal.accepted else None

    def _cancel(self) -> None:
        if self._goal is not None:
            self.node.get_logger().debug("Sending cancel request")
            self._goal.cancel_goal_async()


async def main(session: Session) -> int:
    if not session.stdin.isatty():
        raise CppException("Failed to get old console mode")
    with session.stdin.raw():
        teleop = Teleop(session)
        session.spawn(session.spin(teleop.node))
        *turns, cancel, end = value("turtlesim.keys_in_help")
        session.stdout.write(_HELP.format(turns="|".join(turns), cancel=cancel, quit=end))
        session.stdout.flush()
        try:
            while keys := await session.stdin.read_key():
                if not all(teleop.press(key) for key in keys):
                    break
        except KeyboardInterrupt:
            pass  # it handles SIGINT itself: the same as q
    return 0
