"""`ros2 run turtlebot3_teleop teleop_keyboard`: w, a, d, x change the speed step by step; the robot gets there gently.

Names, keys, steps and limits are those of turtlebot3_teleop. The environment variable TURTLEBOT3_MODEL is needed there;
here a `burger` is taken when it is missing. TwistStamped is published, as from Jazzy on, ten times a second.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry_msgs.msg import TwistStamped

from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from day6_core.session.session import Session

HELP = """
Control Your TurtleBot3!
---------------------------
Moving around:
        w
   a    s    d
        x

w/x : increase/decrease linear velocity (Burger : ~ 0.22, Waffle and Waffle Pi : ~ 0.26)
a/d : increase/decrease angular velocity (Burger : ~ 2.84, Waffle and Waffle Pi : ~ 1.82)

space key, s : force stop

CTRL-C to quit
"""

LIMITS = {"burger": (0.22, 2.84), "waffle": (0.26, 1.82), "waffle_pi": (0.26, 1.82)}
"""Largest linear (m/s) and angular (rad/s) velocity of each model."""

LINEAR_STEP, ANGULAR_STEP = 0.01, 0.1
KEYS = {
    "w": (LINEAR_STEP, 0.0),
    "x": (-LINEAR_STEP, 0.0),
    "a": (0.0, ANGULAR_STEP),
    "d": (0.0, -ANGULAR_STEP),
}
PERIOD = 0.1
HELP_EVERY = 20


class Teleop:
    """The node, the wanted velocity, and the published one, which follows it by half a step per message."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self.node = session.create_node("teleop_keyboard")
        self._publisher = self.node.create_publisher(TwistStamped, "cmd_vel", QoSProfile(depth=10))
        model = session.env.get("TURTLEBOT3_MODEL", "burger")
        self._limits = LIMITS.get(model, LIMITS["waffle"])
        self._wanted = [0.0, 0.0]
        self._commanded = [0.0, 0.0]
        self._presses = 0

    def press(self, key: str) -> None:
        if key in KEYS:
            for index, (step, limit) in enumerate(zip(KEYS[key], self._limits, strict=True)):
                self._wanted[index] = min(max(self._wanted[index] + step, -limit), limit)
            self._presses += 1
            self._print()
            if self._presses == HELP_EVERY:
                self._session.print(HELP)
                self._presses = 0
        elif key in " s":
            self._wanted, self._commanded = [0.0, 0.0], [0.0, 0.0]
            self._print()

    def tick(self) -> None:
        """Come nearer to what is wanted by half a step, and publish."""
        for index, step in enumerate((LINEAR_STEP / 2, ANGULAR_STEP / 2)):
            gap = self._wanted[index] - self._commanded[index]
            self._commanded[index] += min(max(gap, -step), step)
        self.publish(*self._commanded)

    def publish(self, linear: float, angular: float) -> None:
        message = TwistStamped()
        message.header.stamp = self.node.get_clock().now().to_msg()
        message.twist.linear.x, message.twist.angular.z = linear, angular
        self._publisher.publish(message)

    def _print(self) -> None:
        linear, angular = self._wanted
        self._session.print(f"currently:\tlinear velocity {linear}\t angular velocity {angular} ")


async def main(session: Session) -> int:
    if not session.stdin.isatty():
        session.print_error("termios.error: (25, 'Inappropriate ioctl for device')")
        return 1
    with session.stdin.raw():
        teleop = Teleop(session)
        session.spawn(session.spin(teleop.node))
        session.print(HELP)
        session.spawn(_publish(session, teleop))
        try:
            while keys := await session.stdin.read_key():
                for key in keys:
                    teleop.press(key)
                teleop.tick()
        except KeyboardInterrupt:
            pass
        finally:
            teleop.publish(0.0, 0.0)
    return 0


async def _publish(session: Session, teleop: Teleop) -> None:
    async for _ in session.every(PERIOD):
        teleop.tick()
