"""`ros2 run teleop_twist_keyboard teleop_twist_keyboard`: a Twist for every key (teleop_twist_keyboard.py).

Parameters: `stamped` (publish TwistStamped), `frame_id` (of those), and, as newer versions have them, `speed` and `turn`
to begin with. As in the original every key publishes, also one that only changes the speed, and a key that means
nothing stops the robot.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist, TwistStamped

if TYPE_CHECKING:
    from day6_core.session.session import Session

HELP = """
This node takes keypresses from the keyboard and publishes them
as Twist/TwistStamped messages. It works best with a US keyboard layout.
---------------------------
Moving around:
   u    i    o
   j    k    l
   m    ,    .

For Holonomic mode (strafing), hold down the shift key:
---------------------------
   U    I    O
   J    K    L
   M    <    >

t : up (+z)
b : down (-z)

anything else : stop

q/z : increase/decrease max speeds by 10%
w/x : increase/decrease only linear speed by 10%
e/c : increase/decrease only angular speed by 10%

CTRL-C to quit
"""

MOVES = {  # key -> x, y, z, turn
    "i": (1, 0, 0, 0),
    "o": (1, 0, 0, -1),
    "j": (0, 0, 0, 1),
    "l": (0, 0, 0, -1),
    "u": (1, 0, 0, 1),
    ",": (-1, 0, 0, 0),
    ".": (-1, 0, 0, 1),
    "m": (-1, 0, 0, -1),
    "O": (1, -1, 0, 0),
    "I": (1, 0, 0, 0),
    "J": (0, 1, 0, 0),
    "L": (0, -1, 0, 0),
    "U": (1, 1, 0, 0),
    "<": (-1, 0, 0, 0),
    ">": (-1, -1, 0, 0),
    "M": (-1, 1, 0, 0),
    "t": (0, 0, 1, 0),
    "b": (0, 0, -1, 0),
}

SPEEDS = {  # key -> factor of the linear, of the angular speed
    "q": (1.1, 1.1),
    "z": (0.9, 0.9),
    "w": (1.1, 1.0),
    "x": (0.9, 1.0),
    "e": (1.0, 1.1),
    "c": (1.0, 0.9),
}

HELP_EVERY = 15
"""Changes of speed after which the help is printed again."""


class Teleop:
    """The node, the speeds, and the direction of the last key."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self.node = node = session.create_node("teleop_twist_keyboard")
        self._stamped = node.declare_parameter("stamped", False).value
        self._frame = node.declare_parameter("frame_id", "").value
        self._speed = float(node.declare_parameter("speed", 0.5).value)
        self._turn = float(node.declare_parameter("turn", 1.0).value)
        if self._frame and not self._stamped:
            raise ValueError("'frame_id' can only be set when 'stamped' is True")
        self._publisher = node.create_publisher(TwistStamped if self._stamped else Twist, "cmd_vel", 10)
        self._direction = (0, 0, 0, 0)
        self._changes = 0

    def greet(self) -> None:
        self._session.print(HELP)
        self._session.print(self._speeds())

    def press(self, key: str) -> None:
        """Do what a key (one character) is for, and publish."""
        if key in MOVES:
            self._direction = MOVES[key]
        elif key in SPEEDS:
            linear, angular = SPEEDS[key]
            self._speed *= linear
            self._turn *= angular
            self._session.print(self._speeds())
            if self._changes == HELP_EVERY - 1:
                self._session.print(HELP)
            self._changes = (self._changes + 1) % HELP_EVERY
        else:
            self._direction = (0, 0, 0, 0)
        self.publish(*self._direction)

    def publish(self, x: float, y: float, z: float, turn: float) -> None:
        """Publish a direction at the present speeds."""
        message: Any = TwistStamped() if self._stamped else Twist()
        twist = message
        if self._stamped:
            twist = message.twist
            message.header.stamp = self.node.get_clock().now().to_msg()
            message.header.frame_id = self._frame
        twist.linear.x, twist.linear.y, twist.linear.z = x * self._speed, y * self._speed, z * self._speed
        twist.angular.z = turn * self._turn
        self._publisher.publish(message)

    def _speeds(self) -> str:
        return f"currently:\tspeed {self._speed}\tturn {self._turn} "


async def main(session: Session) -> int:
    if not session.stdin.isatty():
        session.print_error("termios.error: (25, 'Inappropriate ioctl for device')")
        return 1
    with session.stdin.raw():
        teleop = Teleop(session)
        session.spawn(session.spin(teleop.node))
        teleop.greet()
        try:
            while keys := await session.stdin.read_key():
                for key in keys:
                    teleop.press(key)
        except KeyboardInterrupt:
            pass  # its own Ctrl-C: it ends quietly
        finally:
            teleop.publish(0, 0, 0, 0)
    return 0
