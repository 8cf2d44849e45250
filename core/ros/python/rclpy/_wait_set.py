"""What a program's own waitable sees as rcl's wait set: the entities it consists of, and which of them are ready."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy._rclpy_pybind11 import RCLError


class WaitSet:
    """Collects the handles a waitable adds. `announce` is called whenever one of them becomes ready."""

    def __init__(self, announce: Callable[..., None]) -> None:
        self._announce = announce
        self._entities: dict[str, list[Any]] = {}

    def _add(self, kind: str, member: Any) -> int:
        members = self._entities.setdefault(kind, [])
        members.append(member)
        return len(members) - 1

    def add_guard_condition(self, handle: Any) -> int:
        """Add a guard condition by its handle; returns its index for `is_ready`."""
        guard: Any = handle._entity()
        guard._notify = self._announce
        return self._add("guard_condition", guard)

    def _add_endpoint(self, kind: str, handle: Any) -> int:
        handle._endpoint.on_ready = self._announce
        return self._add(kind, handle._endpoint)

    def add_subscription(self, handle: Any) -> int:
        """Add a subscription by its handle; returns its index for `is_ready`."""
        return self._add_endpoint("subscription", handle)

    def add_service(self, handle: Any) -> int:
        """Add a service by its handle; returns its index for `is_ready`."""
        return self._add_endpoint("service", handle)

    def add_client(self, handle: Any) -> int:
        """Add a client by its handle; returns its index for `is_ready`."""
        return self._add_endpoint("client", handle)

    def add_timer(self, handle: Any) -> int:
        """Raise RCLError: a waitable that wants a timer makes one on its node."""
        raise RCLError("Couldn't add timer to wait set: timers of waitables are unsupported")

    def is_ready(self, kind: str, index: int) -> bool:
        """Say whether an entity is ready. `kind` is guard_condition, subscription, service or client."""
        member: Any = self._entities[kind][index]
        ready = member._executor_triggered if kind == "guard_condition" else member.queue
        return bool(ready)

    def reset(self) -> None:
        """Forget that guard conditions were triggered, as each wait of rcl does."""
        for guard in self._entities.get("guard_condition", ()):
            guard._executor_triggered = False
