"""What one turtle offers to ROS: its topics, services and the action, all named after it (turtlesim/turtle.cpp)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist

from day6_core.ros.programs.turtlesim._qos import TOPIC_QOS
from day6_core.ros.programs.turtlesim.model import TurtleTopics
from day6_core.ros.programs.turtlesim_interfaces import (
    Color,
    Pose,
    RotateAbsolute,
    SetPen,
    TeleportAbsolute,
    TeleportRelative,
)
from rclpy.action import ActionServer, CancelResponse
from rclpy.action.server import GoalEvent
from rclpy.task import Future

if TYPE_CHECKING:
    from collections.abc import Callable

    from day6_core.ros.programs.turtlesim.model import Rotation, Turtle, TurtleStep
    from rclpy.action.server import ServerGoalHandle
    from rclpy.node import Node

RESULT_ROUNDS = 3
"""Rounds of the executor in which a finished execution's result gets to those who wait for it."""


class TurtleInterface:
    """Passes messages to `turtle` and publishes what its steps did. `now_ns` tells the time the turtle moves by.

    Raises CppException for a turtle whose name cannot be part of a topic.
    """

    def __init__(self, node: Node, turtle: Turtle, now_ns: Callable[[], int]) -> None:
        self._node = node
        self._now_ns = now_ns
        self._turtle = turtle
        self._goal: ServerGoalHandle[Any, Any, Any] | None = None
        self._results: dict[bytes, Future[Any]] = {}
        self._pose = Pose()
        self._color = Color()
        name = turtle.name
        self._commands = node.create_subscription(Twist, f"{name}/cmd_vel", self._command, TOPIC_QOS)
        self._poses = node.create_publisher(Pose, f"{name}/pose", TOPIC_QOS)
        self._colors = node.create_publisher(Color, f"{name}/color_sensor", TOPIC_QOS)
        self._services = [
            node.create_service(SetPen, f"{name}/set_pen", self._set_pen),
            node.create_service(TeleportRelative, f"{name}/teleport_relative", self._teleport_relative),
            node.create_service(TeleportAbsolute, f"{name}/teleport_absolute", self._teleport_absolute),
        ]
        self._rotations: ActionServer[Any, Any, Any] = ActionServer(
            node,
            RotateAbsolute,
            f"{name}/rotate_absolute",
            self._wait_for_end,
            handle_accepted_callback=self._rotate,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def topics(self) -> TurtleTopics:
        """The turtle's topics, with those who publish its velocities now."""
        command = self._commands.topic_name
        senders = self._node.get_publishers_info_by_topic(command)
        names = {f"{each.node_namespace.rstrip('/')}/{each.node_name}" for each in senders}
        return TurtleTopics(self._poses.topic_name, command, tuple(sorted(names)))

    def destroy(self) -> None:
        """Take everything out of the graph."""
        if self._goal is None:
            self._rotations.destroy()
        else:
            self._drop_rotation(self._goal)
        for service in self._services:
            self._node.destroy_service(service)
        self._node.destroy_publisher(self._colors)
        self._node.destroy_publisher(self._poses)
        self._node.destroy_subscription(self._commands)

    def before_step(self) -> None:
        """Cancel the turtle's rotation if a client requested it."""
        rotation = self._turtle.rotation
        if rotation is not None and self._goal is not None and self._goal.is_cancel_requested:
            rotation.canceling = True

    def publish(self, step: TurtleStep) -> None:
        """Report a step: the rotation's progress, the wall, then pose and colour."""
        if step.rotation is not None:
            self._report_rotation(step.rotation)
        if step.wall is not None:
            x, y = step.wall
            self._node.get_logger().warning(f"Oh no! I hit the wall! (Clamping from [x={x:f}, y={y:f}])")
        pose, color = self._pose, self._color
        pose.x, pose.y, pose.theta, pose.linear_velocity, pose.angular_velocity = step.pose
        self._poses.publish(pose)
        color.r, color.g, color.b = step.colour
        self._colors.publish(color)

    @property
    def is_attended(self) -> bool:
        """Whether it matters to anybody when exactly the pose and the colour are published."""
        return self._poses._is_attended() or self._colors._is_attended()

    def publish_unheard(self, times: int) -> None:
        """Publish the same pose and colour so many times, which nobody hears."""
        self._poses._publish_unheard(times)
        self._colors._publish_unheard(times)

    # -- topics and services -------------------------------------------------------------------------------------------

    def _command(self, twist: Twist) -> None:
        holonomic = self._node.has_parameter("holonomic") and self._node.get_parameter("holonomic").value
        aborted = self._turtle.command(
            twist.linear.x, twist.angular.z, self._now_ns(), linear_y=twist.linear.y if holonomic else None
        )
        if aborted is not None:
            self._node.get_logger().warning("Velocity command received during rotation goal. Aborting goal")
            self._end_rotation(aborted)

    def _set_pen(self, request: Any, response: Any) -> Any:
        self._turtle.set_pen(request.r, request.g, request.b, request.width, request.off)
        return response

    def _teleport_relative(self, request: Any, response: Any) -> Any:
        self._turtle.teleport_relative(request.linear, request.angular)
        return response

    def _teleport_absolute(self, request: Any, response: Any) -> Any:
        self._turtle.teleport_absolute(request.x, request.y, request.theta)
        return response

    # -- the action ----------------------------------------------------------------------------------------------------

    def _rotate(self, goal: ServerGoalHandle[Any, Any, Any]) -> None:
        aborted = self._turtle.abort()
        if aborted is not None:
            self._node.get_logger().warning(
                "Rotation goal received before a previous goal finished. Aborting previous goal"
            )
            self._end_rotation(aborted)
        self._goal = goal
        self._results[_id_of(goal)] = Future()
        self._turtle.rotate(goal.request.theta)
        goal.execute()

    async def _wait_for_end(self, goal: ServerGoalHandle[Any, Any, Any]) -> Any:
        """Run as the goal's execution: the ticks turn the turtle, this hands over the result when they are through."""
        key = _id_of(goal)
        try:
            return await self._results[key]
        finally:
            del self._results[key]

    def _report_rotation(self, rotation: Rotation) -> None:
        logger = self._node.get_logger()
        if rotation.outcome == "canceled":
            logger.info("Rotation goal canceled")
        elif self._goal is not None:
            self._goal.publish_feedback(RotateAbsolute.Feedback(remaining=rotation.remaining))
            if rotation.outcome == "succeeded":
                logger.info("Rotation goal completed successfully")
        if rotation.outcome is not None:
            self._end_rotation(rotation)

    def _end_rotation(self, rotation: Rotation | None) -> None:
        goal, self._goal = self._goal, None
        if goal is None or rotation is None:
            return
        {"succeeded": goal.succeed, "canceled": goal.canceled, "aborted": goal.abort}[rotation.outcome or "aborted"]()
        self._results[_id_of(goal)].set_result(RotateAbsolute.Result(delta=rotation.delta))

    def _drop_rotation(self, goal: ServerGoalHandle[Any, Any, Any]) -> None:
        """The turtle is removed during a goal: rclcpp cancels a goal whose handle is no longer held."""
        self._turtle.abort()
        self._goal = None
        if not goal.is_cancel_requested:
            goal._update_state(GoalEvent.CANCEL_GOAL)
        goal.canceled()
        self._results[_id_of(goal)].set_result(RotateAbsolute.Result())
        self._destroy_rotations_after(RESULT_ROUNDS)

    def _destroy_rotations_after(self, rounds: int) -> None:
        executor = self._node.executor
        if rounds and executor is not None:
            executor.create_task(self._destroy_rotations_after, rounds - 1)
        else:
            self._rotations.destroy()


def _id_of(goal: ServerGoalHandle[Any, Any, Any]) -> bytes:
    return bytes(goal.goal_id.uuid)
