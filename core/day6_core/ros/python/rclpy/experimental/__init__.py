"""What may still change: an executor, and (since Lyrical) the node for asyncio."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.experimental.events_executor import EventsExecutor as EventsExecutor

if TYPE_CHECKING:
    from rclpy.experimental.async_node import AsyncNode as AsyncNode


def __getattr__(name: str) -> Any:
    from day6_core.ros import differences

    if name == "AsyncNode" and differences.value("rclpy.async_node"):
        from rclpy.experimental.async_node import AsyncNode

        return AsyncNode
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
