"""Calls of services from programs that wait for the answer."""

from __future__ import annotations

from typing import Any

import rclpy


def call(node: Any, kind: Any, name: str, request: Any, seconds: float | None = None) -> Any:
    """Wait for a service, call it and return the response. Raises RuntimeError if it isn't there within `seconds`, or fails."""
    client = node.create_client(kind, name)
    try:
        if not client.wait_for_service(timeout_sec=seconds):
            raise RuntimeError(f"No service '{name}' found")
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future)
        if future.result() is None:
            raise RuntimeError(f"Exception while calling service '{name}': {future.exception()}")
        return future.result()
    finally:
        node.destroy_client(client)
