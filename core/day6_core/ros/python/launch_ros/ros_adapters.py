"""The launch's own node, created on demand: for lifecycle nodes and timers in ROS time."""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_KEY = "ros_adapter"


class ROSAdapter:
    """A node `launch_ros_<pid>` in its own ROS context, spun by a thread."""

    def __init__(self, *, argv: Sequence[str] | None = None, autostart: bool = True) -> None:
        self.__argv = list(argv or ())
        self.__ros_node: Any = None
        self.__thread: threading.Thread | None = None
        if autostart:
            self.start()

    @property
    def argv(self) -> list[str]:
        return self.__argv

    @property
    def ros_node(self) -> Any:
        return self.__ros_node

    @property
    def ros_context(self) -> Any:
        return self.__context

    @property
    def ros_executor(self) -> Any:
        return self.__executor

    def start(self) -> None:
        """Create the node and spin it. Raises RuntimeError if it is running already."""
        if self.__ros_node is not None:
            raise RuntimeError("Cannot start a ROS adapter that is already running")
        import rclpy
        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor

        self.__context = Context()
        rclpy.init(args=self.__argv, context=self.__context)
        self.__ros_node = rclpy.create_node(f"launch_ros_{os.getpid()}", context=self.__context)
        self.__executor = SingleThreadedExecutor(context=self.__context)
        self.__executor.add_node(self.__ros_node)
        self.__thread = threading.Thread(target=self.__run, name="launch-ros", daemon=True)
        self.__thread.start()

    def __run(self) -> None:
        from rclpy.executors import ExternalShutdownException

        try:
            while self.__context.ok():
                self.__executor.spin_once(timeout_sec=1.0)
        except ExternalShutdownException:
            return

    def shutdown(self) -> None:
        """Destroy the node. Raises RuntimeError if there is none."""
        if self.__ros_node is None or self.__thread is None:
            raise RuntimeError("Cannot shutdown a ROS adapter that is not running")
        self.__context.try_shutdown()
        self.__thread.join(5.0)
        self.__ros_node.destroy_node()
        self.__ros_node = None


def get_ros_adapter(context: LaunchContext) -> ROSAdapter:
    """Return the launch's adapter; the first call creates it, the launch's shutdown ends it."""
    adapter: ROSAdapter | None = context.get_locals_as_dict().get(_KEY)
    if adapter is None:
        from launch.event_handlers.on_shutdown import OnShutdown

        new_adapter = adapter = ROSAdapter(argv=list(context.argv))
        context.extend_globals({_KEY: adapter})
        context.register_event_handler(OnShutdown(on_shutdown=lambda event, context: new_adapter.shutdown()))
    return adapter


def get_ros_node(context: LaunchContext) -> Any:
    """Return the launch's own node."""
    return get_ros_adapter(context).ros_node
