"""The client of a buffer in another node (action tf2_msgs/action/LookupTransform)."""

from __future__ import annotations

import threading
import warnings
from time import sleep
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import TransformStamped
from tf2_py import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

from rclpy.clock import Clock
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_ros.buffer_interface import NO_WAIT, BufferInterface

if TYPE_CHECKING:
    from rclpy.node import Node

_PADDING = Duration(seconds=2.0)


class BufferClient(BufferInterface):
    """The lookups of `Buffer`, sent to the buffer server with the action name `ns`.

    It blocks, so another thread has to spin its node. `check_frequency` (Hz) is how often it checks the timeout;
    `timeout_padding` is added to a lookup's own timeout.
    """

    def __init__(
        self,
        node: Node,
        ns: str,
        check_frequency: float = 10.0,
        timeout_padding: Duration = _PADDING,
    ) -> None:
        # Programs that only import tf2_ros don't need actions.
        from tf2_msgs.action import LookupTransform

        from rclpy.action.client import ActionClient

        BufferInterface.__init__(self)
        self.node = node
        self._goal_class = LookupTransform.Goal
        self.action_client: Any = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def lookup_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform between two frames. Raises the errors of `Buffer.lookup_transform`, and TimeoutException."""
        from builtin_interfaces.msg import Time as TimeMsg

        if isinstance(time, TimeMsg):
            warnings.warn(
                "Passing a builtin_interfaces.msg.Time argument is deprecated, and will be removed in the near future."
                " Use rclpy.time.Time instead.",
                stacklevel=2,
            )
            stamp = time
        elif isinstance(time, Time):
            stamp = time.to_msg()
        else:
            raise TypeError("Must pass a rclpy.time.Time object.")
        return self._send(
            self._goal_class(
                target_frame=target_frame,
                source_frame=source_frame,
                source_time=stamp,
                timeout=timeout.to_msg(),
                advanced=False,
            )
        )

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> TransformStamped:
        """Return the transform between two frames at two times; see `lookup_transform`."""
        return self._send(
            self._goal_class(
                target_frame=target_frame,
                source_frame=source_frame,
                source_time=source_time.to_msg(),
                timeout=timeout.to_msg(),
                target_time=target_time.to_msg(),
                fixed_frame=fixed_frame,
                advanced=True,
            )
        )

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether `lookup_transform` succeeds."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether `lookup_transform_full` succeeds."""
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        except TransformException:
            return False
        return True

    def _send(self, goal: Any) -> TransformStamped:
        if not self.action_client.server_is_ready():
            raise TimeoutException("The BufferServer is not ready.")
        responded = threading.Event()
        future = self.action_client.send_goal_async(goal)
        future.add_done_callback(lambda _: responded.set())
        clock = Clock()
        until = clock.now() + Duration.from_msg(goal.timeout) + self.timeout_padding
        while not responded.is_set() and clock.now() <= until:
            sleep(1.0 / self.check_frequency)
        if not future.done():
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back in the specified time."
                " Something is likely wrong with the server."
            )
        goal_handle = future.result()
        if not goal_handle.accepted:
            raise TimeoutException(
                "The LookupTransform goal sent to the BufferServer did not come back with accepted status."
                " Something is likely wrong with the server."
            )
        return self._unpacked(self.action_client._get_result(goal_handle).result)

    def _unpacked(self, result: Any) -> TransformStamped:
        error = result.error
        if error.error == error.NO_ERROR:
            return result.transform
        kinds = {
            error.LOOKUP_ERROR: LookupException,
            error.CONNECTIVITY_ERROR: ConnectivityException,
            error.EXTRAPOLATION_ERROR: ExtrapolationException,
            error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
            error.TIMEOUT_ERROR: TimeoutException,
        }
        raise kinds.get(error.error, TransformException)(error.error_string)

    def destroy(self) -> None:
        """Destroy the action client."""
        self.action_client.destroy()
