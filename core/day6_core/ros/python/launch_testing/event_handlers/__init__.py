"""The event handlers of launch tests."""

from __future__ import annotations

from launch_testing.event_handlers.stdout_ready_listener import StdoutReadyListener

__all__ = ["StdoutReadyListener"]
