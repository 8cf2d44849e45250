"""What the broadcasters and listeners of both packages do. Lengths in metres, angles in radians."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Protocol

from geometry_msgs.msg import TransformStamped, Twist
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformException, TransformListener

from day6_core.ros.programs.turtlesim_interfaces import Pose, Spawn
from rclpy.time import Time
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from collections.abc import Callable

    from day6_core.session.session import Session
    from rclpy.node import Node

CARROT_PERIOD = 0.1


def quaternion(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Return x, y, z, w of a rotation about the fixed axes x, y, z, in this order."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def transform(
    node: Node, parent: str, child: str, place: tuple[float, float, float], angles: tuple[float, float, float]
) -> TransformStamped:
    """Return the transform of `child` in `parent` now."""
    stamped = TransformStamped(child_frame_id=child)
    stamped.header.stamp = node.get_clock().now().to_msg()
    stamped.header.frame_id = parent
    translation, rotation = stamped.transform.translation, stamped.transform.rotation
    translation.x, translation.y, translation.z = place
    rotation.x, rotation.y, rotation.z, rotation.w = quaternion(*angles)
    return stamped


class Broadcaster(Protocol):
    """A broadcaster of either client library."""

    def __init__(self, node: Node) -> None: ...

    def sendTransform(self, transform: TransformStamped) -> None: ...


def broadcast_turtle(node: Node, kind: type[Broadcaster] = TransformBroadcaster) -> None:
    """Broadcast the frame of the turtle named by the parameter `turtlename`, whenever it publishes its pose."""
    name = node.declare_parameter("turtlename", "turtle").value
    broadcaster = kind(node)

    def tell(pose: Pose) -> None:
        broadcaster.sendTransform(transform(node, "world", name, (pose.x, pose.y, 0.0), (0.0, 0.0, pose.theta)))

    node.create_subscription(Pose, f"/{name}/pose", tell, 1)


def static_words(session: Session, package: str) -> list[str] | None:
    """Return the seven arguments of `static_turtle_tf2_broadcaster`, None if there are not seven; tells what is wrong."""
    words = remove_ros_args(args=session.argv)[1:]
    seconds, nanoseconds = divmod(session.clock.now_ns(), 1_000_000_000)
    stamp = f"[{seconds}.{nanoseconds:09d}] [logger]"
    if len(words) != 7:
        session.print_error(
            f"[INFO] {stamp}: Invalid number of parameters. Usage: \n"
            f"$ ros2 run {package} static_turtle_tf2_broadcaster child_frame_name x y z roll pitch yaw"
        )
        return None
    if words[0] == "world":
        session.print_error(f'[INFO] {stamp}: Your static turtle name cannot be "world"')
    return words


def broadcast_static(
    node: Node, child: str, numbers: list[float], kind: type[Broadcaster] = StaticTransformBroadcaster
) -> Broadcaster:
    """Broadcast once where `child` is in `world`: x, y, z, roll, pitch, yaw."""
    broadcaster = kind(node)
    x, y, z, roll, pitch, yaw = numbers
    broadcaster.sendTransform(transform(node, "world", child, (x, y, z), (roll, pitch, yaw)))
    return broadcaster


def broadcast_carrot(
    node: Node, place: Callable[[], tuple[float, float, float]], kind: type[Broadcaster] = TransformBroadcaster
) -> None:
    """Broadcast ten times a second where the carrot is that hangs before turtle1."""
    broadcaster = kind(node)
    node.create_timer(
        CARROT_PERIOD,
        lambda: broadcaster.sendTransform(transform(node, "turtle1", "carrot1", place(), (0.0, 0.0, 0.0))),
    )


class Spawner:
    """Spawns a turtle, checking once a second whether it exists yet."""

    def __init__(self, node: Node, name: str) -> None:
        self._node = node
        self._name = name
        self._client = node.create_client(Spawn, "spawn")
        self._future: Any = None
        self.done = False

    def step(self) -> None:
        info = self._node.get_logger().info
        if self._future is not None:
            if self._future.done():
                info(f"Successfully spawned {self._future.result().name}")
                self.done = True
            else:
                info("Spawn is not finished")
        elif self._client.service_is_ready():
            self._future = self._client.call_async(Spawn.Request(name=self._name, x=4.0, y=2.0, theta=0.0))
        else:
            info("Service is not ready")


class Follower:
    """Spawns turtle2 and drives it towards the frame named by the parameter `target_frame`, once a second anew."""

    FOLLOWING = "turtle2"

    def __init__(self, node: Node, listen: Callable[[Buffer, Node], object] = TransformListener) -> None:
        self._node = node
        self._target = node.declare_parameter("target_frame", "turtle1").value
        self._buffer = Buffer()
        self._listener = listen(self._buffer, node)
        self._spawner = Spawner(node, self.FOLLOWING)
        self._publisher = node.create_publisher(Twist, f"{self.FOLLOWING}/cmd_vel", 1)
        node.create_timer(1.0, self._step)

    def _step(self) -> None:
        if not self._spawner.done:
            self._spawner.step()
            return
        try:
            found = self._buffer.lookup_transform(self.FOLLOWING, self._target, Time())
        except TransformException as error:
            self._node.get_logger().info(f"Could not transform {self.FOLLOWING} to {self._target}: {error}")
            return
        x, y = found.transform.translation.x, found.transform.translation.y
        twist = Twist()
        twist.angular.z = 1.0 * math.atan2(y, x)
        twist.linear.x = 0.5 * math.hypot(x, y)
        self._publisher.publish(twist)
