"""rclpy.init in cells, which are run again and again: without signal handlers, and twice is once."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

import rclpy


class InitInCells:
    """Stands before `rclpy.init` until `restore`; `tell` is called the first time that it has nothing to do."""

    def __init__(self, tell: Callable[[], None]) -> None:
        self._init = rclpy.init
        self._tell: Callable[[], None] | None = tell
        rclpy.init = self._standing_before(rclpy.init)

    def restore(self) -> None:
        """Put the real one back."""
        rclpy.init = self._init

    def _standing_before(
        self, init: Callable[..., rclpy.InitContextManager]
    ) -> Callable[..., rclpy.InitContextManager]:
        @wraps(init)
        def init_in_cells(**keywords: object) -> rclpy.InitContextManager:
            if _is_done(keywords.get("context"), keywords.get("domain_id")):
                if self._tell is not None:
                    self._tell()
                    self._tell = None
                return _running()
            if keywords.get("signal_handler_options") is None:
                keywords["signal_handler_options"] = rclpy.SignalHandlerOptions.NO
            return init(**keywords)

        return init_in_cells


def _is_done(context: object, domain_id: object) -> bool:
    """Whether this is asked of the default context for the domain it is in."""
    default = rclpy.get_default_context()
    return context in (None, default) and default.ok() and domain_id in (None, default.get_domain_id())


def _running() -> rclpy.InitContextManager:
    """What the first init returned: with it, too, a `with` block ends ROS at its end."""
    found = object.__new__(rclpy.InitContextManager)
    found.context = rclpy.get_default_context()
    found.installed_signal_handlers = False
    return found
