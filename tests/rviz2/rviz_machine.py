"""A machine with RViz on it: time is stepped, threads (numpy, robots, meshes) are waited for with a deadline."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import TransformStamped
from std_msgs.msg import String
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.manager import RViz
from rclpy.qos import DurabilityPolicy, QoSProfile
from tests.support.stepped_machine import Running, SteppedMachine

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

ONE_LINK = '<robot name="r"><link name="base_link"/></robot>'


class RVizMachine(SteppedMachine):
    """`open()` starts RViz and returns its model; the other methods are what happens on the graph."""

    def __init__(self) -> None:
        super().__init__()
        self.running: Running | None = None
        self._publishers: dict[str, Any] = {}
        self._static: Any = None
        self._moving: Any = None

    def open(self, *args: str) -> RViz:
        self.running = self.start("rviz2", "rviz2", *args, screen=True)
        self.until(lambda: self.display.windows)
        window = self.display.windows[-1]
        assert window.kind == "rviz2"
        self.rviz: RViz = window.model
        return self.rviz

    def settle(self, seconds: float = 0.2) -> None:
        self.advance(seconds)

    def do(self, action: Callable[[], Any]) -> Any:
        """Let RViz do something, as a window asks for it."""
        results: list[Any] = []
        self.rviz.request(lambda: results.append(action()))
        self.settle()
        assert results, self.running and self.running.errors
        return results[0]

    def add(self, type_name: str, topic: str = "") -> Any:
        return self.do(lambda: self.rviz.add_display(type_name, topic))

    def fix(self, frame: str) -> None:
        self.rviz.edit(self.rviz.fixed, frame)
        self.settle()

    # -- the graph -----------------------------------------------------------------------------------------------------

    def stamp(self, ns: int | None = None) -> Any:
        from rclpy.time import Time

        return Time(nanoseconds=ns).to_msg() if ns is not None else self.node.get_clock().now().to_msg()

    def transform(
        self, parent: str, child: str, xyz: tuple[float, float, float] = (0, 0, 0), static: bool = True
    ) -> None:
        stamped = TransformStamped()
        stamped.header.frame_id, stamped.child_frame_id = parent, child
        stamped.header.stamp = self.stamp()
        translation = stamped.transform.translation
        translation.x, translation.y, translation.z = map(float, xyz)
        stamped.transform.rotation.w = 1.0
        if static:
            self._static = self._static or StaticTransformBroadcaster(self.node)
            self._static.sendTransform(stamped)
        else:
            self._moving = self._moving or TransformBroadcaster(self.node)
            self._moving.sendTransform(stamped)
        self.settle()

    def publish(self, topic: str, message: Any, qos: Any = 10) -> None:
        if topic not in self._publishers:
            self._publishers[topic] = self.node.create_publisher(type(message), topic, qos)
            self.settle()
        self._publishers[topic].publish(message)
        self.settle()

    def describe(self, urdf: str) -> None:
        """Publish a robot description, as robot_state_publisher does."""
        self.publish("/robot_description", String(data=urdf), LATCHED)

    def robot(self, urdf: str = ONE_LINK) -> Any:
        """A RobotModel that has read a description."""
        self.describe(urdf)
        display = self.add("RobotModel", "/robot_description")
        self.until(lambda: display.status("URDF") is not None)
        self.settle()
        return display


def lines(display: Display) -> dict[str, tuple[str, str]]:
    """All statuses of a display: name -> (word, text)."""
    found = {}
    for line in display.statuses.children:
        status = display.statuses.line(line.name)
        assert status is not None
        found[line.name] = status
    return found
