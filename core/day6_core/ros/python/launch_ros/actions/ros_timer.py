"""Visits other actions after a span of ROS time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._loop import Timer
from launch.actions.timer_action import TimerAction
from launch.frontend.expose import expose_action

from launch_ros.ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_action("ros_timer")
class ROSTimer(TimerAction):
    """A `TimerAction` on the clock of the launch's own node: simulated time after `SetUseSimTime(True)`."""

    def _start(self, context: LaunchContext, seconds: float) -> Timer:
        node = get_ros_node(context)
        loop: Any = context.asyncio_loop
        timer = Timer(lambda: self._fire(context))

        def begin() -> None:
            """Begin to count when the whole description has been visited: a `SetUseSimTime` may come after the timer."""
            if context.is_shutdown:
                return
            ros_timer: Any = None

            def fire() -> None:
                ros_timer.cancel()
                loop.call_soon_threadsafe(timer.fire)

            ros_timer = node.create_timer(seconds, fire, clock=node.get_clock())

        loop.call_soon(begin)
        return timer
